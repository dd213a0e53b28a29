"""Poincaré sections against closed forms, and against heavy sampling of a chaotic top."""

import diffrax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import systems
from polhode.errors import InvalidInput, NotConverged
from polhode.taylor import runs

MOMENTS, MOMENTUM = (1.0, 2.0, 3.5), np.array([0.3, 2.0, 0.1])
BODY = systems.FreeRigidBody(MOMENTS)
MOTION = ph.FreeMotion(MOMENTS, momentum=MOMENTUM)
SPAN = (0.0, 60.0)


@pytest.mark.parametrize("direction", ["rising", "falling", "either"])
@pytest.mark.parametrize("forth", [1.0, -1.0])
def test_a_free_body_crosses_twice_a_period(direction, forth):
    """L₂ is a multiple of sn, whose zeros are half a period apart."""
    found = ph.section(BODY, MOMENTUM, lambda t, point: point[1], forth * np.array(SPAN), direction)
    exact = MOTION.momentum(found.times)
    assert np.abs(exact[:, 1]).max() < 1e-12 and np.abs(found.states - exact).max() < 1e-12
    gap = MOTION.period / (2.0 if direction == "either" else 1.0)
    assert np.abs(forth * np.diff(found.times) / gap - 1.0).max() < 1e-12
    assert abs(len(found.times) - SPAN[1] / gap) <= 1.0 and found.end == forth * SPAN[1] and found.event is None
    later = MOTION.momentum(found.times + forth * 1e-3)[:, 1]
    assert direction == "either" or (np.sign(later) == (1.0 if direction == "rising" else -1.0)).all()


@pytest.mark.parametrize(
    ("until", "room"), [(3.0, 8), pytest.param(30.0, runs.LIMITS.first_crossings, marks=pytest.mark.long)]
)
def test_zeros_close_together_and_many(until, room, monkeypatch):
    """Zeros of cos 40t, up to ninety to a step of the body, more than room is made for; and few, where so many do."""
    monkeypatch.setattr(runs, "LIMITS", runs.LIMITS._replace(first_crossings=room))
    waves = lambda t, point: jnp.cos(40.0 * t) + 0.0 * point[0]  # noqa: E731
    found = ph.section(BODY, MOMENTUM, waves, (0.0, until), "either")
    assert found.times == pytest.approx((np.arange(len(found.times)) + 0.5) * np.pi / 40.0, rel=1e-12)
    assert len(found.times) == int(until * 40.0 / np.pi + 0.5) > room
    few = ph.section(BODY, MOMENTUM, waves, (0.0, until), "either", most=7)
    assert (few.times == found.times[:7]).all() and few.states.shape == (7, 3)


@pytest.mark.long
def test_a_chaotic_top_is_that_of_close_samples():
    top = systems.HeavyTop((1.0, 2.0, 3.5), 1.3, (0.6, 0.0, 0.8))
    start = top.pack(attitude=(1.0, 0.0, 0.0, 0.0), angular_velocity=(0.3, 1.0, 0.1))
    found = ph.section(top, start, lambda t, state: state[9], (0.0, 12.0), "either")
    dense = ph.simulate(top, start, np.linspace(0.0, 12.0, 6001), diffrax.Dopri8(), estimate_error=False)
    height = dense.states[:, 9]
    where = np.flatnonzero(np.sign(height[1:]) != np.sign(height[:-1]))
    share = height[where] / (height[where] - height[where + 1])
    assert found.times == pytest.approx(dense.times[where] + share * 2e-3, abs=1e-5)
    assert np.abs(found.states[:, 9]).max() < 1e-14


class Falling(systems.FreeRigidBody):
    @property
    def events(self):
        return {"half over": lambda t, state: state[..., 1] - 0.5}


def test_an_event_ends_the_search():
    found = ph.section(Falling(MOMENTS), MOMENTUM, lambda t, point: point[1] - 1.0, SPAN, "falling")
    assert found.event == "half over" and len(found.times) == 1 and found.times[0] < found.end < SPAN[1]
    assert MOTION.momentum(found.end)[1] == pytest.approx(0.5, abs=1e-13)


@pytest.mark.parametrize(("change", "said"), [
    ({"state": np.ones((2, 3))}, "`state` must be one state"), ({"times": (1.0, 1.0)}, "`times` must be"),
    ({"times": (0.0, np.inf)}, "`times` must be"), ({"direction": "up"}, '`direction` must be one of "rising"'),
    ({"state": 1e-200 * MOMENTUM}, "`state` must be of a size within"),
    ({"most": 0}, "`most` must be a whole number, at least 1"),
    ({"surface": lambda t, point: jnp.floor(point[0]) - 0.5}, "needs Taylor series, .* Simulate it with close samples"),
    ({"surface": lambda t, point: point}, r"`surface` must be one real number .*got shape \(3,\). Choose"),
    ({"surface": lambda t, point: point[0] > 0.0}, "got one of type bool. Give what is compared instead"),
    ({"surface": lambda t, point: point[0] > 0.0, "direction": "either"}, "got one of type bool"),
    ({"surface": lambda t, point: point[0] + 1j}, "the real or the imaginary part"),
    ({"surface": lambda t, point: None}, "got None. Write it with jax.numpy"),
    ({"surface": lambda t, point: jnp.log(point[0] - 9.0)}, "`surface` must be a finite number.*got nan at the start"),
])  # fmt: skip
def test_what_makes_no_section(change, said):
    given = {"state": MOMENTUM, "surface": lambda t, point: point[0], "times": SPAN} | change
    with pytest.raises(InvalidInput, match=said):
        ph.section(BODY, **given)


class Blowing(systems.base.AbstractSystem):
    def vector_field(self, t, state):
        return state**2

    def invariants(self, state):
        return {}


def test_a_singularity_is_said():
    with pytest.raises(NotConverged, match="singularity before 2 s"):
        ph.section(Blowing(), [1.0], lambda t, state: state[0] - 3.0, (0.0, 2.0))


def test_a_section_goes_on_from_each_of_its_points():
    """The start is a crossing of the section before, which misses the surface by a rounding, and does not count."""
    oscillator = ph.systems.LiePoisson(ph.algebra.Heisenberg(1), lambda m: 0.5 * (m[0] ** 2 + m[1] ** 2))
    surface, first = (lambda t, m: m[0] - 0.5), None
    whole = ph.section(oscillator, [1.0, 0.0, 1.0], surface, (0.0, 100.0))
    for time, state in zip(whole.times[:-1], whole.states[:-1], strict=True):
        first = ph.section(oscillator, state, surface, (float(time), 100.0)).times[0]
        assert abs(first - time - 2.0 * np.pi) < 1e-12

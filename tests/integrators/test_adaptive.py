"""Systems that are no Lie–Poisson ones: time in the rates, events, balances, batches."""

from collections.abc import Callable
from typing import Any

import diffrax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput, NotConverged
from polhode.motion import Ending
from polhode.systems import AbstractSystem, Balance
from sweeping import first

CLOSE = 1e-10  # some hundred steps at 1e-12, and what interpolation between them adds


class Driven(AbstractSystem):
    """ẍ = −x + cos 2t, the driven oscillator; the drive's power is known."""

    def vector_field(self, t: Any, state: Any) -> Any:
        return jnp.stack([state[..., 1], jnp.cos(2.0 * t) - state[..., 0]], axis=-1)

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}

    def balances(self, t: Any, state: Any) -> dict[str, Balance]:
        return {"energy": Balance(0.5 * jnp.sum(state**2, axis=-1), state[..., 1] * jnp.cos(2.0 * t))}


class Falling(AbstractSystem):
    """z̈ = −2 down to z = 0, or up to z = 1.5."""

    explosive: bool = False

    def vector_field(self, t: Any, state: Any) -> Any:
        pull = state[..., 0] ** 2 * 1e3 if self.explosive else -2.0 + 0.0 * state[..., 0]
        return jnp.stack([state[..., 1], pull], axis=-1)

    def invariants(self, state: Any) -> dict[str, Any]:
        return {"energy": 0.5 * state[..., 1] ** 2 + 2.0 * state[..., 0]}

    @property
    def events(self) -> dict[str, Callable[[Any, Any], Any]]:
        if self.explosive:
            return {}
        return {"ground": lambda t, state: state[0], "ceiling": lambda t, state: 1e3 * (1.5 - state[0])}


class WrongRate(Driven):
    def balances(self, t: Any, state: Any) -> dict[str, Balance]:
        right = super().balances(t, state)["energy"]
        return {"energy": Balance(right.value, right.rate * (1.0 + 1e-8))}


def exact(t, x, v):
    """Return the driven oscillator's x, whose particular solution is −cos 2t / 3."""
    return (x + 1 / 3) * np.cos(t) + v * np.sin(t) - np.cos(2 * t) / 3


@pytest.mark.sweep
def test_rates_may_depend_on_time_and_states_may_be_a_batch(stepper):
    times = np.linspace(0.0, 20.0, 41)
    starts = np.array([[[1.0, 0.0], [0.3, -0.4]]])
    found = ph.simulate(Driven(), starts, times, stepper)
    assert found.states.shape == (1, 2, 41, 2) and found.received["energy"].shape == (1, 2, 41)
    for k in range(2):
        assert np.abs(found.states[0, k, :, 0] - exact(times, *starts[0, k])).max() < CLOSE
    assert found.drift["energy"].max() < CLOSE
    assert found.attitude is None and str(found.outcome) == "successful"
    back = ph.simulate(Driven(), found.states[0, 0, -1], times[::-1], diffrax.Dopri5(), step=0.1)
    assert np.abs(back.states[-1] - starts[0, 0]).max() < 10 * CLOSE
    assert ph.as_dataset(found)["state"].dims == ("batch_0", "batch_1", "time", "component_0")


@pytest.mark.sweep
def test_a_wrong_rate_is_seen_in_the_balance(stepper):
    found = ph.simulate(WrongRate(), [1.0, 0.0], np.linspace(0.0, 20.0, 41), stepper)
    assert found.drift["energy"] > 5 * CLOSE


@pytest.mark.parametrize(
    ("speed", "event", "when"), [(1.0, "ground", (1 + 5**0.5) / 2), (2.0, "ceiling", 1 - 0.5**0.5)]
)
def test_the_first_event_ends_the_motion(speed, event, when, stepper):
    found = ph.simulate(Falling(), [1.0, speed], np.linspace(0.0, 3.0, 31), stepper)
    assert found.outcome.event == event and abs(found.times[-1] - when) < 1e-14
    assert len(found.times) == len(found.states) == np.ceil(10 * when) + 1
    assert np.abs(found.states[:, 0] - (1.0 + speed * found.times - found.times**2)).max() < 1e-14


@pytest.mark.parametrize("last", first(1, [1e300, 1e12]))
def test_an_event_ends_the_motion_however_late_the_last_time_is(last, stepper):
    """The shortest step was a rounding of the last time, so that a late one stopped the motion before its event."""
    found = ph.simulate(Falling(), [1.0, 1.0], [0.0, last], stepper)
    assert found.outcome.event == "ground" and abs(found.times[-1] - (1 + 5**0.5) / 2) < CLOSE
    # of adaptive steps nothing but the start can be compared
    assert found.error_estimate < CLOSE if stepper is None else found.error_estimate is None


@pytest.mark.long
def test_implicit_methods_go_the_same_way():
    times = np.linspace(0.0, 2.0, 3)
    found = ph.simulate(Driven(), [1.0, 0.0], times, diffrax.Kvaerno5(), tolerance=1e-7)
    assert np.abs(found.states[:, 0] - exact(times, 1.0, 0.0)).max() < 1e-5


def test_what_runs_away_says_so(stepper):
    with pytest.raises(NotConverged, match="singularity"):
        ph.simulate(Falling(explosive=True), [1.0, 1.0], [0.0, 1.0], stepper)
    found = ph.simulate(Falling(explosive=True), [1.0, 1.0], [0.0, 1.0], stepper, throw=False)
    assert found.outcome.ending is Ending.NOT_CONVERGED


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ph.simulate(Falling(), [0.0, 1.0], [0.0, 1.0]), "at or past the event.*ground"),
        (lambda: ph.simulate(Falling(), [[1.0, 1.0], [0.0, 1.0]], [0.0, 1.0]), "in 1 of 2 copies, first .1,., at"),
        (lambda: ph.simulate(Falling(), [np.inf, 1.0], [0.0, 1.0]), "finite"),
        (lambda: ph.simulate(Falling(), [1.0, 1.0], [0.0, 1.0], order=4), "`order`"),
        (lambda: ph.simulate(Falling(), [1.0, 1.0], [0.0, 1.0], ph.integrators.Splitting), "not a Lie–Poisson system"),
        (lambda: ph.simulate(Falling(), [1.0, 1.0], [0.0, 1.0], diffrax.Euler()), "estimate the error.*Euler does not"),
        (lambda: ph.simulate(Falling(), [1.0, 1.0], [0.0, 1.0], diffrax.KenCarp4()), "as one.*Kvaerno5"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()

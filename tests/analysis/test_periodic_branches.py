"""Branches of periodic motions, against fields whose cycles and multipliers are known, and against closed forms."""

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import systems
from polhode.analysis import continue_periodic, floquet, periodic_branches
from polhode.errors import InvalidInput, NotConverged
from sweeping import first

EXACT = 1e-10
TURN = 2  # rad/s of the cycles, so that their period is π


class Cycle(systems.AbstractSystem):
    """A cycle in a plane, r' = r f(μ, r²), with what ``beside`` says of numbers beside it."""

    mu: jnp.ndarray = eqx.field(converter=jnp.asarray)
    radial: object = eqx.field(static=True)
    beside: object = eqx.field(static=True, default=lambda mu, along, rest: [])

    def vector_field(self, t, state):
        x, y, *rest = state
        square = x * x + y * y
        growth, along = self.radial(self.mu, square), (x / jnp.sqrt(square), y / jnp.sqrt(square))
        return jnp.stack([growth * x - TURN * y, growth * y + TURN * x, *self.beside(self.mu, along, rest)])

    def invariants(self, state):
        return {}


def circle(mu, square):
    return 1.0 - square


def growing(mu, square):
    return mu - square


def folded(mu, square):
    return mu + square - square * square


def splitting(mu, along, rest):
    return [(mu - 0.317) * rest[0] - rest[0] ** 3]


def shedding(mu, along, rest):
    return [(mu - 0.317) * rest[0] - 0.7 * rest[1], (mu - 0.317) * rest[1] + 0.7 * rest[0]]


def twisted(mu, along, rest):
    """Two directions that turn by half a turn a period: multipliers −e^(λ π) of λ = μ − 0.317 and −0.7."""
    (c, s), (a, b) = along, rest
    mean, half = 0.5 * (mu - 0.317 - 0.7), 0.5 * (mu - 0.317 + 0.7)
    slower, faster = mean - half * c, mean + half * c
    return [faster * a + (half * s - 0.5 * TURN) * b, (half * s + 0.5 * TURN) * a + slower * b]


# with how many numbers there are, and how near a place is found: two multipliers of 1 are off by the root of a rounding
BESIDE = {"branch point": (splitting, 1, 1e-5), "period doubling": (twisted, 2, 1e-8), "torus": (shedding, 2, 1e-8)}


@pytest.mark.long
def test_a_cycle_grows_as_it_should():
    """r² = μ, with the multiplier e^(−2 μ T)."""
    found = continue_periodic(lambda mu: Cycle(mu, growing), (0.1, 0.3), [0.31, 0.0], 3.1)
    assert found.values[[0, -1]] == pytest.approx([0.1, 0.3], abs=1e-15) and not found.bifurcations
    assert set(found.verdicts) == {"spectrally stable"} and (np.diff(found.values) > 0.0).all()
    for value, motion in zip(found.values, found.motions, strict=True):
        assert abs(np.linalg.norm(motion.state) - np.sqrt(value)) < EXACT and abs(motion.period - np.pi) < EXACT
        assert np.abs(np.sort(motion.multipliers.real) - [np.exp(-2.0 * value * np.pi), 1.0]).max() < EXACT


@pytest.mark.sweep
def test_a_branch_goes_round_its_fold():
    """f = μ + r² − r⁴: cycles on r² = ½ ± ½ √(1 + 4 μ), which meet at μ = −¼."""
    outer = np.sqrt(0.5 + 0.5 * np.sqrt(0.6))
    found = continue_periodic(lambda mu: Cycle(mu, folded), (-0.1, -1.0), [outer, 0.0], 3.1)
    assert [b.kind for b in found.bifurcations] == ["fold"] and abs(found.bifurcations[0].value + 0.25) < EXACT
    assert abs(np.sum(found.bifurcations[0].motion.state ** 2) - 0.5) < 1e-4
    assert found.verdicts[0] == "spectrally stable" and found.verdicts[-1] == "unstable"
    assert abs(np.sum(found.motions[-1].state ** 2) - (0.5 - 0.5 * np.sqrt(0.6))) < EXACT and found.values[-1] == -0.1


@pytest.mark.long
@pytest.mark.parametrize("kind", first(1, BESIDE))
def test_bifurcations_are_found_where_they_are(kind):
    beside, count, near = BESIDE[kind]
    found = continue_periodic(lambda mu: Cycle(mu, circle, beside), (0.1, 0.6), [1.0, *[0.0] * (count + 1)], 3.1)
    assert [b.kind for b in found.bifurcations] == [kind] and abs(found.bifurcations[0].value - 0.317) < near
    assert found.verdicts[0] == "spectrally stable" and found.verdicts[-1] == "unstable"


@pytest.mark.long
def test_a_branch_that_is_not_halved_is_seen(monkeypatch):
    monkeypatch.setattr(periodic_branches, "LIMITS", periodic_branches.LIMITS._replace(max_halvings=3))
    with pytest.raises(AssertionError):
        test_bifurcations_are_found_where_they_are("torus")


@pytest.mark.sweep
def test_the_free_body_at_held_energy_and_momentum():
    """Periods of the closed form, of the same |L| and energy all along."""
    make = lambda third: systems.FreeRigidBody((1.0, 2.0, third))  # noqa: E731
    found = continue_periodic(make, (3.0, 3.4), [0.3, 0.1, 2.0], 9.5)
    start, levels = make(3.0), []
    for value, motion in zip(found.values, found.motions, strict=True):
        exact = ph.FreeMotion((1.0, 2.0, value), momentum=motion.state)
        assert abs(motion.period / exact.period - 1.0) < EXACT
        levels.append([float(x) for x in make(value).invariants(motion.state).values()])
    wanted = [float(x) for x in start.invariants(found.motions[0].state).values()]
    assert np.abs(np.array(levels) / wanted - 1.0).max() < EXACT and found.values[-1] == 3.4


@pytest.mark.sweep
def test_a_driven_oscillator_answers():
    """x'' + δ x' + k x = cos t, with a period that is known; states and multipliers in closed form."""
    delta = 0.2

    class Driven(systems.AbstractSystem):
        k: jnp.ndarray = eqx.field(converter=jnp.asarray)

        def vector_field(self, t, state):
            return jnp.stack([state[1], jnp.cos(t) - delta * state[1] - self.k * state[0]])

        def invariants(self, state):
            return {}

    found = continue_periodic(Driven, (3.0, 2.0), [0.4, 0.0], 2.0 * np.pi, fixed=True)
    assert found.values[-1] == 2.0 and (found.periods == 2.0 * np.pi).all()
    for k, motion in zip(found.values, found.motions, strict=True):
        size = (k - 1.0) ** 2 + delta**2
        assert np.abs(motion.state - [(k - 1.0) / size, delta / size]).max() < 1e-9
        root = np.emath.sqrt(delta**2 / 4.0 - k) + 0j
        wanted = np.exp(2.0 * np.pi * np.array([-delta / 2.0 + root, -delta / 2.0 - root]))
        assert np.abs(np.sort_complex(motion.multipliers) - np.sort_complex(wanted)).max() < 1e-9


def test_a_motion_of_one_value_alone_is_refused():
    """A symmetric top's nutation and spin are in resonance at one weight, where all integrals stay as they are."""
    make = lambda weight: systems.HeavyTop((1.0, 1.0, 0.5), weight)  # noqa: E731
    with pytest.raises(NotConverged, match="does not go on to other values of the parameter"):
        continue_periodic(make, (1.0, 1.1), [0.3, 0.0, 2.0, 0.6, 0.0, 0.8], 3.0)


@pytest.mark.long
def test_no_system_outside_of_the_range_is_asked_for_at_its_beginning():
    def make(mu):
        if mu < 0.1:
            raise InvalidInput("there is none")
        return Cycle(mu, growing)

    assert continue_periodic(make, (0.1, 0.2), [0.31, 0.0], 3.1).values[-1] == 0.2


def test_a_branch_that_ends_nowhere_says_so(monkeypatch):
    monkeypatch.setattr(periodic_branches, "LIMITS", periodic_branches.LIMITS._replace(max_motions=4))
    with pytest.warns(UserWarning, match=r"could not be followed beyond the value 0\.\d+: what comes after"):
        continue_periodic(lambda mu: Cycle(mu, growing), (0.1, 1.0), [0.31, 0.0], 3.1)


@pytest.mark.parametrize(("call", "error", "words"), [
    (lambda make: continue_periodic(make, (0.1, 0.1), [0.3, 0.0], 3.1), InvalidInput, "`limits` must be two"),
    (lambda make: continue_periodic(make, (0.1, np.nan), [0.3, 0.0], 3.1), InvalidInput, "`limits` must be two"),
    (lambda make: continue_periodic(make, (0.1, 1.0), [0.3, 0.0], -1.0), InvalidInput, "`period` must be"),
    (lambda make: continue_periodic(make, (0.1, 1.0), [9.0, 0.0], 0.3), NotConverged, "no periodic motion|equilib"),
])  # fmt: skip
def test_what_cannot_be_followed_is_refused(call, error, words):
    with pytest.raises(error, match=words):
        call(lambda mu: Cycle(mu, growing))


@pytest.mark.long
def test_multipliers_are_those_of_the_motion_alone():
    found = continue_periodic(lambda mu: Cycle(mu, circle, BESIDE["torus"][0]), (0.1, 0.2), [1.0, 0, 0, 0], 3.1)
    alone = floquet.periodic_motion(Cycle(0.2, circle, BESIDE["torus"][0]), found.motions[-1].state, 3.14)
    assert np.abs(alone.multipliers - found.motions[-1].multipliers).max() < 1e-9

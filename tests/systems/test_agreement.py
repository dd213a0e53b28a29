"""A system that disagrees with itself is refused, one that depends on time is honoured."""

import math
from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import algebra as lie
from polhode.errors import InvalidInput
from polhode.integrators import IsospectralMidpoint, LieMidpoint, MuntheKaas, SphericalMidpoint, Splitting
from polhode.motion import Ending
from polhode.systems import FreeRigidBody, LiePoisson
from polhode.systems._agreement import check_agreement
from specimens import in_su3

MOMENTS = np.array([1.0, 2.0, 3.0])
MOMENTUM = np.array([0.3, 1.8, 1.5])
TIMES = [0.0, 1.0]
REFERENCE = 1e-13  # tolerance of SciPy's DOP853
SLOPE = 0.3
THERE_AND_BACK = 1e-13  # a few dozen roundings


class ExtraTerm(FreeRigidBody):
    """Changes the energy alone."""

    def energy(self, point):
        return super().energy(point) + 0.1 * point[..., 0]


class OtherVelocity(FreeRigidBody):
    """Changes the velocity alone."""

    def velocity(self, point):
        return super().velocity(point) + jnp.array([0.0, 0.1, 0.0])


class InheritedFlows(ExtraTerm):
    """Changes energy and velocity, and inherits the flows."""

    def velocity(self, point):
        return super().velocity(point) + jnp.array([0.1, 0.0, 0.0])


class OwnFlows(InheritedFlows):
    """Says that it has no flows."""

    @property
    def flows(self):
        return {}


class OtherSign(FreeRigidBody):
    """Runs back in time, with flows that run forward."""

    @property
    def sign(self):
        return 1


class Driven(FreeRigidBody):
    """Turned from outside about an axis, more and more; not said that energy is not kept."""

    def generator(self, t, point):
        return super().generator(t, point) + 0.3 * jnp.sin(2.0 * jnp.pi * t) * jnp.array([1.0, 0.0, 0.5])


class DrivenTruly(Driven):
    @property
    def conserves_energy(self):
        return False


class DrivenFreely(DrivenTruly):
    @property
    def flows(self):
        return {}


class Distorted(FreeRigidBody):
    """A term that the flows do not know, and that vanishes at the start."""

    def energy(self, point):
        return super().energy(point) + 0.05 * point[..., 0] ** 4

    def velocity(self, point):
        return super().velocity(point) + 0.2 * point**3 * jnp.array([1.0, 0.0, 0.0])


class OwnField(FreeRigidBody):
    """Says its rate of change itself."""

    def vector_field(self, t, state):
        return super().vector_field(t, state) + 0.3 * jnp.cos(t) * jnp.cross(state, jnp.array([0.0, 0.0, 1.0]))


class OldGenerator(FreeRigidBody):
    def generator(self, point):  # type: ignore[override]
        return self.velocity(point)


def body(kind: Any) -> Any:
    return kind(MOMENTS)


@pytest.mark.long_cases("DrivenTruly-NoneType-str", "OwnField-LieMidpoint-str", "OwnField-Splitting-str")
@pytest.mark.parametrize(
    ("system", "method", "words"),
    [
        (body(ExtraTerm), None, "`velocity` is from FreeRigidBody, `energy` is from ExtraTerm"),
        (body(ExtraTerm), diffrax.Dopri8(), "gradient of `energy`"),
        (body(OtherVelocity), None, "gradient of `energy`"),
        (body(InheritedFlows), None, "`flows` is from FreeRigidBody.*LieMidpoint"),
        (body(InheritedFlows), Splitting, "add up to the motion"),
        (body(OtherSign), None, "add up to the motion"),
        (body(Driven), LieMidpoint, "`conserves_energy` be False"),
        (body(DrivenTruly), None, "at all times"),
        (body(OwnField), LieMidpoint, "overrides `vector_field`.*generator\\(t, point\\).*Dopri8"),
        (body(OwnField), Splitting, "overrides `vector_field`"),
        (body(OldGenerator), LieMidpoint, "generator\\(t, point\\)"),
    ],
    ids=lambda value: getattr(value, "__name__", type(value).__name__),
)
@pytest.mark.usefixtures("any_type")
def test_what_disagrees_is_refused(system, method, words):
    with pytest.raises(InvalidInput, match=words):
        ph.simulate(system, MOMENTUM, TIMES, method)


def test_what_agrees_at_the_start_alone_is_refused():
    with pytest.raises(InvalidInput, match="add up to the motion"):
        ph.simulate(body(Distorted), np.array([0.0, 1.0, 1.5]), TIMES)


@pytest.mark.long
def test_a_field_of_its_own_goes_the_adaptive_way():
    found = ph.simulate(body(OwnField), MOMENTUM, [0.0, 20.0])
    assert np.abs(found.states[-1] - driven_end(0.3, (0.0, 0.0, 1.0), np.cos, 20.0)).max() < 1e-9


@pytest.mark.parametrize("system", [body(OwnFlows), body(DrivenFreely)], ids=lambda system: type(system).__name__)
def test_a_subclass_in_agreement_passes(system):
    check_agreement(system, jnp.asarray(MOMENTUM), TIMES, by_flows=bool(system.flows))


def driven_end(strength, axis, wave, span):
    """Return the end of L̇ = L × (L/I + strength · wave(t) · axis), by SciPy."""
    turn = lambda t, L: np.cross(L, L / MOMENTS + strength * wave(t) * np.asarray(axis))  # noqa: E731
    return solve_ivp(turn, (0.0, span), MOMENTUM, "DOP853", rtol=REFERENCE, atol=REFERENCE).y[:, -1]


class DrivenMatrices(LiePoisson):
    """su(3) turned from outside."""

    def generator(self, t, point):
        turn = self.algebra.from_vector(jnp.arange(8.0) / 8.0)
        return super().generator(t, point) + jnp.cos(3.0 * t) * turn

    @property
    def conserves_energy(self):
        return False


made: Any = DrivenMatrices
MATRICES = made(lie.SU(3), in_su3)
MATRIX = np.asarray(MATRICES.algebra.from_dual_vector(np.random.default_rng(3).normal(size=8)))
SPAN = 3.0


def matrix_end():
    field = jax.jit(MATRICES.vector_field)

    def turn(t, packed):
        point = packed.view(complex).reshape(3, 3)
        return np.asarray(field(t, point)).ravel().view(float)

    packed = MATRIX.astype(complex).ravel().view(float)
    solved = solve_ivp(turn, (0.0, SPAN), packed, "DOP853", rtol=REFERENCE, atol=REFERENCE)
    return solved.y[:, -1].copy().view(complex).reshape(3, 3)


def check_order(system, state, method, order, end):
    run = lambda h: ph.simulate(system, state, [0.0, SPAN], method, step=h, order=order).states[-1]  # noqa: E731
    errors = [np.abs(run(h) - end).max() for h in (0.1, 0.05, 0.025)]
    assert np.log2(errors[-2] / errors[-1]) == pytest.approx(order, abs=SLOPE), errors


@pytest.mark.long
@pytest.mark.parametrize(
    ("method", "order"),
    [
        (LieMidpoint, 4), pytest.param(MuntheKaas, 4, marks=pytest.mark.sweep),
        *(pytest.param(method, 2, marks=pytest.mark.sweep) for method in (LieMidpoint, MuntheKaas, SphericalMidpoint)),
    ],
    ids=lambda value: getattr(value, "__name__", str(value)),
)  # fmt: skip
def test_order_with_a_drive_that_depends_on_time(method, order):
    end = driven_end(0.3, (1.0, 0.0, 0.5), lambda t: np.sin(2.0 * np.pi * t), SPAN)
    check_order(body(DrivenFreely), MOMENTUM, method, order, end)


@pytest.mark.sweep
@pytest.mark.parametrize("method", [IsospectralMidpoint, LieMidpoint, MuntheKaas])
def test_order_of_driven_matrices(method):
    check_order(MATRICES, MATRIX, method, 4, matrix_end())


@pytest.mark.long
def test_a_driven_motion_runs_back():
    run = lambda state, times: ph.simulate(  # noqa: E731
        body(DrivenFreely), state, times, LieMidpoint, step=0.05, order=4
    )
    there = run(MOMENTUM, [0.3, 5.0])
    back = run(there.states[-1], [5.0, 0.3])
    assert np.abs(back.states[-1] - MOMENTUM).max() < THERE_AND_BACK


@pytest.mark.sweep
def test_a_drive_between_the_moments_looked_at_is_not_split():
    """Inherited flows would leave it out: a structural rule, as any sampling can be missed.

    By default the motion is that of the free body at ∫ (1 + pulse) dt, and 100 · 0.05 √π more by the end.
    """

    class Pulsed(FreeRigidBody):
        def generator(self, t, point):
            pulse = 100.0 * jnp.exp(-(((t - 13.37) / 0.05) ** 2)) * (jnp.abs(t - 13.37) < 0.3)
            return (1.0 + pulse) * super().generator(t, point)

    pulsed, start = Pulsed((1.0, 2.0, 3.3)), [0.3, 1.8, 1.5]
    with pytest.raises(InvalidInput, match="`flows`"):
        ph.simulate(pulsed, start, [0.0, 20.0], Splitting)
    found = ph.simulate(pulsed, start, [0.0, 20.0])
    exact = ph.FreeMotion((1.0, 2.0, 3.3), momentum=start).momentum(20.0 + 5.0 * np.sqrt(np.pi) * math.erf(6.0))
    assert np.abs(found.states[-1] - exact).max() < 1e-12
    assert ph.simulate(pulsed, [0.3, 1.8, 1.5], [0.0, 1.0], LieMidpoint).outcome.ending is Ending.COMPLETED

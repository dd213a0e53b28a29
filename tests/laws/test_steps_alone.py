"""Steps of every orbit solver alone under jit, vmap, jvp and grad.

Loops of unknown length have derivatives of either mode, of reverse mode by going back; fixed points have both.
"""

import diffrax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode import algebra as lie
from polhode import fields, integrators, systems
from registered import public_classes
from transformed import check_alone

RNG = np.random.default_rng(6)
H, SECOND = 0.1, 2
BODY = systems.FreeRigidBody((1.0, 2.0, 3.0))
CHAIN = systems.LiePoisson(lie.Power(lie.SO3(), 2), lambda w: -jnp.dot(w[0], w[1]) - 0.3 * w[0, 2] ** 2)
LATTICE = fields.SpinLattice(fields.Lattice([[1.0]], shape=(4,)), bonds=[fields.Bond(0, 0, (1,), 1.0)])
SOLVERS = [
    integrators.Splitting(BODY, H, SECOND), integrators.LieMidpoint(BODY, H, SECOND),
    integrators.LieMidpoint(BODY, H, SECOND, "exp"), integrators.MuntheKaas(BODY, H, SECOND),
    integrators.SphericalMidpoint(CHAIN, H, SECOND),
    fields.SublatticeTurns(LATTICE, H, np.arange(4).reshape(4, 1, 1, 1) % 2),
    fields.NoiseDriftNoise(CHAIN, H, fields.Bath(0.3, 0.2, 1)),
    fields.TransportNoise(BODY, H, 0.2 * np.eye(3)),
    integrators.IsospectralMidpoint(systems.Manakov((1.0, 2.0, 3.0)), H, SECOND),
]  # fmt: skip
NO_ARRAYS = {"order", "memory", "init", "func", "change_by"}
"""What is a number, zeros, or diffrax's own term; and ``change``, from which ``change_by`` differs by the noise."""


def named(solver):
    return type(solver).__name__ + (" by exp" if getattr(solver, "coordinates", "") == "exp" else "")


def starts(solver):
    algebra = solver.system.algebra
    return np.asarray(algebra.from_dual_vector(RNG.normal(size=(3, algebra.dim))))


def at_once(solvers, every=SOLVERS):
    return [pytest.param(s, id=named(s), marks=[] if s in solvers else [pytest.mark.sweep]) for s in every]


NOISY = fields.NoiseDriftNoise | fields.TransportNoise
SMOOTH = [s for s in SOLVERS if not isinstance(s, NOISY)]
"""Noise is keyed by time, of which it is no continuous function."""


def test_no_solver_is_forgotten():
    noisy = fields.NoiseDriftNoise, fields.TransportNoise
    classes = public_classes(integrators, integrators.AbstractOrbitSolver, *noisy)
    no_steps = {integrators.AbstractOrbitSolver, fields.Bath, integrators.Taylor}
    assert classes - no_steps == {type(solver) for solver in SOLVERS}


@pytest.mark.long
@pytest.mark.parametrize("solver", at_once(SOLVERS[1:2]))
def test_change_alone(solver):
    step = lambda t, h, state: solver.change(t, h, state).state  # noqa: E731
    if isinstance(solver, NOISY):
        check_alone(lambda state: step(0.3, H, state), starts(solver), batched=False)
    else:
        check_alone(step, RNG.uniform(size=3), RNG.uniform(0.05, 0.2, 3), starts(solver), batched=False)


@pytest.mark.sweep
@pytest.mark.parametrize("solver", at_once(SOLVERS[:1], SMOOTH))
def test_advance_alone(solver):
    """Two or three steps each; the copies of a batch take as many as each needs."""
    run = lambda start, span, state: solver.advance(start, span, state, solver.memory(state))[0]  # noqa: E731
    spans = np.array([0.15, 0.25, -0.15])
    check_alone(run, RNG.uniform(size=3), spans, starts(solver), batched=False)


@pytest.mark.parametrize("solver", at_once([], SMOOTH))
def test_diffrax_step_alone(solver):
    term = diffrax.ODETerm(lambda t, state, args: solver.system.vector_field(t, state))

    def step(start, end, state):
        memory = solver.init(term, start, end, state, None)
        return solver.step(term, start, end, state, None, memory, False)[0]

    begin = RNG.uniform(size=3)
    check_alone(step, begin, begin + np.array([0.15, 0.25, 0.15]), starts(solver), batched=False)

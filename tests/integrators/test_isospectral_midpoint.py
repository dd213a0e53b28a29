"""The isospectral midpoint by products of matrices: its equation, long steps, copies of a batch, hints, derivatives."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import root

import polhode as ph
from polhode import algebra as lie
from polhode import fields, systems
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import IsospectralMidpoint
from polhode.integrators._fixed_point import fixed_point

RNG = np.random.default_rng(7)
ALGEBRAS = [lie.SO(5), lie.SOpq(3, 1), lie.SU(3), lie.U(2), lie.Sp(2), fields.QuantizedSphere(4)]


def quadratic(algebra):
    """H with another weight for every coordinate."""
    weights = jnp.linspace(1.0, 2.0, algebra.dim)
    return systems.LiePoisson(algebra, lambda m: 0.5 * jnp.sum(weights * algebra.to_dual_vector(m) ** 2))


def point_of(algebra, size=1.0):
    return algebra.from_dual_vector(jnp.asarray(size * RNG.normal(size=algebra.dim) / np.sqrt(algebra.dim)))


AT_ONCE = ("SU(3)", "SO(3,1)")


@pytest.mark.long_after(1)
@pytest.mark.parametrize("algebra", [pytest.param(a, id=a.name, marks=[] if a.name in AT_ONCE else [pytest.mark.sweep])
                                     for a in ALGEBRAS])  # fmt: skip
def test_a_step_solves_its_equation(algebra):
    """Against Newton's method on all entries of W̃, which knows neither products nor Cayley's map."""
    system, state, h = quadratic(algebra), point_of(algebra), 0.2
    n, is_complex, unit = algebra.size, algebra.dtype == jnp.complex128, getattr(algebra, "hbar", 1.0)
    velocity = jax.jit(system.velocity)

    def matrix(vector):
        return (vector[: n * n] + 1j * vector[n * n :] if is_complex else vector).reshape(n, n)

    def both_ends(middle):
        # the generator of a dual element, of which a trace is no part
        trace = np.trace(middle) / n * np.eye(n) if isinstance(algebra, lie.SU | fields.QuantizedSphere) else 0.0
        y = 0.5 * h / unit * np.asarray(velocity(jnp.asarray(middle - trace))).conj().T
        one = np.eye(n)
        return (one - y) @ middle @ (one + y), (one + y) @ middle @ (one - y)

    def missing(vector):
        off = (both_ends(matrix(vector))[0] - np.asarray(state)).ravel()
        return np.concatenate([off.real, off.imag]) if is_complex else off.real

    start = np.asarray(state).ravel()
    found = root(missing, np.concatenate([start.real, start.imag]) if is_complex else start, tol=1e-13)
    assert np.abs(missing(found.x)).max() < 1e-13
    change = jax.jit(IsospectralMidpoint(system, h, 2).change)(0.0, h, state)
    assert bool(change.converged)
    wanted = both_ends(matrix(found.x))[1]
    assert np.abs(np.asarray(state + change.state) - wanted).max() < 1e-13
    assert np.abs(wanted - np.asarray(state)).max() > 1e-3


@pytest.mark.sweep
def test_long_steps_go_by_linear_systems():
    """A generator that does not depend on the state turns by Cayley's map, however far: there products diverge."""
    algebra = lie.SO(4)
    turn = jnp.asarray(RNG.normal(size=6))
    system = systems.LiePoisson(algebra, lambda m: jnp.sum(turn * algebra.to_dual_vector(m)))
    state, h = point_of(algebra), 3.0
    step = IsospectralMidpoint(system, h, 2)
    with pytest.warns(UserWarning, match="a step of"):
        run = ph.simulate(system, state, [0.0, h, 2 * h], step, estimate_error=False)
    x = h * algebra.from_vector(turn)
    wanted = state
    for k in range(2):
        wanted = algebra.coadjoint_action(algebra.cayley(x), wanted)
        assert np.abs(run.states[k + 1] - wanted).max() < 1e-13

    def by_products(middle):
        _, commutator, rest = algebra.cayley_terms(x, middle)
        return state + commutator + rest

    assert not bool(fixed_point(by_products, state, jnp.max(jnp.abs(state))).converged)


@pytest.mark.long
def test_a_step_without_a_solution_in_reach_is_an_error():
    system = quadratic(lie.SU(3))
    state = point_of(system.algebra, 30.0)
    with pytest.warns(UserWarning, match="a step of"), pytest.raises(NotConverged, match="IsospectralMidpoint step"):
        ph.simulate(system, state, [0.0, 5.0], IsospectralMidpoint, step=5.0, order=2)


@pytest.mark.long
def test_every_copy_ends_by_its_own_scale():
    system, h = quadratic(lie.SU(3)), 0.02
    states = jnp.stack([point_of(system.algebra, size) for size in (1e-9, 1.0, 20.0, 0.0)])
    step = jax.jit(IsospectralMidpoint(system, h, 2).change)
    together = step(0.0, h, states)
    alone = [step(0.0, h, state) for state in states]
    assert bool(together.converged)
    assert int(together.iterations) == max(int(one.iterations) for one in alone) > int(alone[0].iterations)
    for change, one in zip(together.state, alone, strict=True):
        assert np.abs(change - one.state).max() <= 4e-16 * np.abs(one.state).max()


@pytest.mark.long
def test_a_fixed_point_with_one_size_for_all_would_stop_too_early():
    """What the tolerance is for: 1e-9 beside 1, and slower than that, keeps less than half of its digits."""
    target, share = jnp.array([[1e-9], [1.0]]), jnp.array([[0.5], [0.01]])
    toward = lambda x: share * x + (1.0 - share) * target  # noqa: E731
    errors = [jnp.abs(fixed_point(toward, jnp.zeros((2, 1)), scale).value - target)[0, 0] / 1e-9
              for scale in (target[:, 0], jnp.asarray(1.0))]  # fmt: skip
    assert errors[0] < 1e-14 and errors[1] > 1e-9


@pytest.mark.long
def test_hints_save_iterations_and_change_nothing():
    system, h, count = quadratic(lie.SU(3)), 0.05, 30

    @jax.jit
    def run(state, hinted):
        solver = IsospectralMidpoint(system, h, 2)

        def step(carried, _):
            state, hint = carried
            change, later = solver.change_with_hint(0.0, h, state, hint)
            hint = jax.tree.map(lambda new, old: jnp.where(hinted, new, old), later, hint)
            return (state + change.state, hint), change.iterations

        (end, _), iterations = jax.lax.scan(step, (state, solver.no_hint(state)), length=count)
        return end, iterations

    state = point_of(system.algebra)
    (by_hints, few), (cold, many) = run(state, True), run(state, False)
    assert np.abs(by_hints - cold).max() < 1e-14
    assert int(few[3:].sum()) < 0.8 * int(many[3:].sum())


@pytest.mark.parametrize("order", [pytest.param(2, marks=pytest.mark.sweep), pytest.param(4, marks=pytest.mark.sweep)])
def test_gradients_go_back_past_hints(order):
    """A thousand steps: those forward have hints, those on the way back have none."""
    system = quadratic(lie.SU(2))
    state, way = (np.asarray(point_of(system.algebra)) for _ in range(2))

    @jax.jit
    def height(share):
        start = jnp.asarray(state) + share * way
        found = ph.solve(system, start, jnp.linspace(0.0, 50.0, 3), IsospectralMidpoint, 0.05, order=order)
        return found.end_state[0, 0].imag

    forward = jax.jvp(height, (0.1,), (1.0,))[1]
    assert float(jax.grad(height)(0.1)) == pytest.approx(float(forward), rel=1e-11)


def test_algebras_without_the_products_are_refused():
    with pytest.raises(InvalidInput, match=r"needs so\(n\).*SL\(2\)"):
        IsospectralMidpoint(systems.LiePoisson(lie.SL(2), lambda m: jnp.sum(m**2)), 0.1)
    with pytest.raises(InvalidInput, match="needs so"):
        IsospectralMidpoint(systems.FreeRigidBody((1.0, 2.0, 3.0)), 0.1)

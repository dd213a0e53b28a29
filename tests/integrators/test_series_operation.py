"""Taylor series within functions that JAX compiles, batches and differentiates, against closed forms."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import celestial, spacecraft, systems
from polhode.errors import InvalidInput
from polhode.integrators import LieMidpoint, Taylor
from polhode.integrators import _series_derivatives as series_derivatives
from polhode.motion import Status
from polhode.taylor import machine

MOMENTS, START = jnp.array([1.0, 2.0, 3.0]), jnp.array([0.3, 1.8, 1.5])
BODY, TIMES = systems.FreeRigidBody(MOMENTS), jnp.linspace(0.0, 5.0, 6)


def moved(moments, momentum, times=TIMES):
    body = eqx.tree_at(lambda b: b.moments, BODY, moments)
    return ph.solve(body, momentum, times, Taylor).saved


def exact(moments, momentum, times=TIMES):
    return ph.FreeMotion(moments, momentum=momentum, epoch=times[0]).momentum(times)


@pytest.mark.long
def test_values_are_those_of_the_motion_compiled_or_not():
    for solve in (moved, jax.jit(moved)):
        assert np.abs(solve(MOMENTS, START) - exact(MOMENTS, START)).max() < 2e-15
    found = ph.solve(BODY, START, TIMES, Taylor)
    assert found.status == Status.COMPLETED and found.end == 5.0 and found.event == -1 and found.steps > 10
    assert np.abs(found.end_state - exact(MOMENTS, START)[-1]).max() < 2e-15


@pytest.mark.long_cases("jacfwd-moments", "jacfwd-start")
@pytest.mark.parametrize("by", [0, 1], ids=["moments", "start"])
@pytest.mark.parametrize("mode", [jax.jacfwd, jax.jacrev])
def test_derivatives_are_those_of_the_closed_form(by, mode):
    found, wanted = jax.jit(mode(moved, by))(MOMENTS, START), jax.jacfwd(exact, by)(MOMENTS, START)
    assert np.abs(found - wanted).max() < 1e-12


@pytest.mark.long_cases("value", "jit", "jit of jacfwd")
@pytest.mark.parametrize("of", [lambda f: f, jax.jit, jax.jacrev, lambda f: jax.jit(jax.jacfwd(f))],
                         ids=["value", "jit", "jacrev", "jit of jacfwd"])  # fmt: skip
def test_series_stay_on_the_host_where_closed_forms_are_compiled(of):
    """As they are where JAX has a GPU: series are kernels of Numba, which JAX cannot compile."""
    with ph.closed_forms("compiled"):
        found = of(lambda momentum: moved(MOMENTS, momentum))(START)
    wanted = of(lambda momentum: exact(MOMENTS, momentum))(START)
    assert np.abs(found - wanted).max() < 1e-12


@pytest.mark.long
def test_derivatives_by_every_time():
    """By the first time as well, from which the motion begins."""
    found = jax.jacrev(lambda times: moved(MOMENTS, START, times))(TIMES)
    wanted = jax.jacfwd(lambda times: exact(MOMENTS, START, times))(TIMES)
    assert np.abs(found - wanted).max() < 1e-12 and np.abs(found[0]).max() == 0.0


@pytest.mark.long_cases("[0.0, 0.0, 3.0]", "[0.0, 2.0, 0.0]")
@pytest.mark.parametrize("momentum", [[0.0, 0.0, 3.0], [0.0, 2.0, 0.0], [1e-13, 2.0, 0.0]], ids=str)
def test_derivatives_where_nothing_moves(momentum):
    """There the motion's own series ends at once, and no step is too long for it; tangents turn or grow."""
    start, times = jnp.array(momentum), jnp.array([0.0, 20.0])
    found = jax.jacfwd(moved, 1)(MOMENTS, start, times)
    wanted = jax.jacfwd(exact, 1)(MOMENTS, start, times)
    assert np.abs(found - wanted).max() < 1e-14 * np.abs(wanted).max()


@pytest.mark.sweep
def test_second_derivatives():
    weigh = lambda solve: lambda x: jnp.sum(solve(MOMENTS, x)[-1] * jnp.array([1.0, -0.5, 0.3]))  # noqa: E731
    found, wanted = jax.hessian(weigh(moved))(START), jax.hessian(weigh(exact))(START)
    assert np.abs(found - wanted).max() < 1e-8 * np.abs(wanted).max()


def test_forward_derivatives_of_forward_ones():
    """The operation gets its arguments as a tuple, or as a list within others."""
    along = lambda f: lambda x: jax.jvp(f, (x,), (jnp.ones(3),))[1]  # noqa: E731
    weigh = lambda x: moved(MOMENTS, x)[-1] @ jnp.array([1.0, -0.5, 0.3])  # noqa: E731
    assert jax.eval_shape(along(along(weigh)), START).shape == ()


@pytest.mark.long
def test_batches_are_their_copies():
    starts, moments = jnp.stack([START, 3.0 * START]), jnp.stack([MOMENTS, MOMENTS[::-1]])
    for k, (m, x) in enumerate(zip(moments, starts, strict=True)):
        both = jax.vmap(moved)(moments, starts)
        np.testing.assert_array_equal(both[k], moved(m, x))
    np.testing.assert_array_equal(ph.solve(BODY, starts, TIMES, Taylor).saved[1], moved(MOMENTS, starts[1]))


def test_what_is_saved_may_be_less_or_a_function():
    every = ph.solve(BODY, START, TIMES, Taylor, save=2)
    np.testing.assert_array_equal(every.saved, moved(MOMENTS, START)[::2])
    np.testing.assert_array_equal(every.times, TIMES[::2])
    sizes = ph.solve(BODY, START, TIMES, Taylor, save=lambda t, x: x @ x).saved
    largest = ph.solve(BODY, START, TIMES, Taylor, save=ph.Fold(lambda v, t, x: jnp.maximum(v, x @ x), 0.0)).saved
    assert sizes.shape == (6,) and largest == sizes.max()


@pytest.mark.sweep
def test_what_balances_received_is_integrated_and_differentiated():
    """A body that is braked loses what its drag takes: T and what it received differ by a constant, at any drag."""

    braked = spacecraft.RigidBody((1.0, 2.0, 3.0), torques=[spacecraft.LinearDrag((0.1, 0.1, 0.1))])

    def left(drag):
        body = eqx.tree_at(lambda b: b.torques[0].coefficient, braked, drag * jnp.ones(3))
        found = ph.solve(body, body.pack(angular_velocity=(0.3, 0.9, 0.5)), TIMES, Taylor)
        energy = jax.vmap(lambda t, x: body.balances(t, x)["kinetic_energy"].value)(TIMES, found.saved)
        return found.received["kinetic_energy"], energy - found.received["kinetic_energy"]

    received, constant = left(0.1)
    slopes, none = jax.jacfwd(left)(0.1)
    assert received[-1] < -0.1 and np.ptp(constant) < 1e-15 and slopes[-1] < -0.1 and np.abs(none).max() < 1e-14


@pytest.mark.sweep
def test_complex_states():
    system = systems.LiePoisson(ph.algebra.SU(2), lambda m: jnp.real(1j * (m[..., 0, 0] - m[..., 1, 1])))
    of = ph.algebra.SU(2).from_dual_vector
    end = lambda x: ph.solve(system, of(x), TIMES, Taylor).end_state  # noqa: E731
    steps = lambda x: ph.solve(system, of(x), TIMES, LieMidpoint).end_state  # noqa: E731
    x = jnp.array([0.3, 0.4, 0.5])
    assert np.abs(end(x) - steps(x)).max() < 1e-13


@pytest.mark.sweep
def test_derivatives_of_complex_states():
    system = systems.LiePoisson(ph.algebra.SU(2), lambda m: jnp.real(1j * (m[..., 0, 0] - m[..., 1, 1])))
    of = ph.algebra.SU(2).from_dual_vector
    end = lambda x: ph.solve(system, of(x), TIMES, Taylor).end_state  # noqa: E731
    steps = lambda x: ph.solve(system, of(x), TIMES, LieMidpoint).end_state  # noqa: E731
    x = jnp.array([0.3, 0.4, 0.5])
    parts = lambda f: lambda x: jnp.stack([jnp.real(f(x)), jnp.imag(f(x))])  # noqa: E731
    assert np.abs(jax.jacfwd(parts(end))(x) - jax.jacfwd(parts(steps))(x)).max() < 1e-12


class Growing(systems.AbstractSystem):
    rate: jax.Array

    def vector_field(self, t, state):
        return self.rate * state**2

    def invariants(self, state):
        return {}


@pytest.mark.long
def test_what_runs_away_says_so():
    found = jax.jit(lambda r: ph.solve(Growing(r), jnp.ones(1), jnp.array([0.0, 0.5, 1.5]), Taylor))(jnp.asarray(1.0))
    assert found.status == Status.NOT_CONVERGED and np.isnan(found.end)
    assert abs(found.saved[1, 0] - 2.0) < 1e-14 and not np.isfinite(found.saved[2, 0])
    nothing = ph.solve(Growing(jnp.asarray(jnp.nan)), jnp.ones(1), jnp.array([0.0, 0.5]), Taylor)
    assert nothing.status == Status.NOT_CONVERGED


class Ending(Growing):
    @property
    def events(self):
        return {"end": lambda t, state: 2.0 - state[0]}


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ph.solve(Ending(jnp.asarray(1.0)), jnp.ones(1), TIMES, Taylor), "as it has events or jumps"),
        (lambda: ph.solve(celestial.SpinOrbit(0.3, 0.1), jnp.ones(2), TIMES, Taylor),
         "no Taylor series in its numbers"),
        (lambda: jax.jit(lambda x: ph.solve(BODY, START, TIMES, Taylor, tolerance=x).saved)(1e-8), "known numbers"),
        (lambda: ph.solve(BODY, START, TIMES, Taylor(12), order=8), "already has one"),
    ],
)
def test_what_it_cannot_do_is_refused(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


BRAKED = spacecraft.RigidBody((1.0, 2.0, 3.0), torques=[spacecraft.LinearDrag((0.1, 0.1, 0.1))])


def gradients(loss, *arguments):
    """Return a gradient in reverse mode, and in forward mode, one array each."""
    flat = lambda found: jnp.concatenate([jnp.ravel(x) for x in jax.tree.leaves(found)])  # noqa: E731
    which = tuple(range(len(arguments)))
    return tuple(flat(jax.jit(mode(loss, which))(*arguments)) for mode in (jax.grad, jax.jacfwd))


@pytest.fixture
def backs(monkeypatch):
    """How many copies came back, and how many of them were taken."""
    seen, real = [], series_derivatives.weights_back

    def watched(*given):
        found = real(*given)
        seen.extend(found[-1].tolist())
        return found

    monkeypatch.setattr(series_derivatives, "weights_back", watched)
    series_derivatives.make_operation.cache_clear()
    yield seen
    series_derivatives.make_operation.cache_clear()


def test_gradients_come_back_along_the_motion(backs):
    """Of three states, by the moments, against the closed form's own derivatives; weights of all samples count."""
    weights = jnp.asarray(np.random.default_rng(3).normal(size=(6, 3)))
    found = jax.jit(jax.grad(lambda m, x: jnp.sum(weights * moved(m, x)), (0, 1)))(MOMENTS, START)
    wanted = jax.grad(lambda m, x: jnp.sum(weights * exact(m, x)), (0, 1))(MOMENTS, START)
    for a, b in zip(found, wanted, strict=True):
        assert np.abs(a - b).max() < 1e-13 * np.abs(b).max()
    assert backs == [True]


@pytest.mark.long_cases("jit", "vmap")
@pytest.mark.parametrize("of", [lambda g: g, jax.jit, lambda g: lambda x: jax.vmap(g)(jnp.stack([x, 2.0 * x]))[0]],
                         ids=["grad", "jit", "vmap"])  # fmt: skip
def test_gradients_of_a_system_without_numbers_of_its_own(of, backs):
    """A Hamiltonian that is a function with its moments inside leaves nothing but the start to differentiate by."""
    body = systems.LiePoisson(ph.algebra.SO3(), lambda L: 0.5 * jnp.sum(L**2 / jnp.array([1.0, 2.0, 3.0])))
    found = of(jax.grad(lambda x: ph.solve(body, x, [0.0, 5.0], Taylor).end_state[0]))(START)
    wanted = jax.grad(lambda x: exact(MOMENTS, x)[-1, 0])(START)
    assert np.abs(found - wanted).max() < 1e-13 * np.abs(wanted).max() and all(backs) and backs


@pytest.mark.long
def test_gradients_of_a_batch_whose_system_all_share(backs):
    starts = jnp.stack([START, 3.0 * START, jnp.array([0.0, 0.0, 2.0])])  # the last one stands still
    loss = lambda m, x: jnp.sum(jnp.sin(moved(m, x)[..., -1, :]))  # noqa: E731
    found, wanted = gradients(loss, MOMENTS, starts)
    assert np.abs(found - wanted).max() < 1e-13 * np.abs(wanted).max() and backs == [True] * 3
    each = jax.jit(jax.vmap(jax.grad(loss, (0, 1)), (None, 0)))(MOMENTS, starts)
    assert np.abs(each[0].sum(axis=0) - found[:3]).max() < 1e-13 * np.abs(wanted).max()
    assert np.abs(each[1].ravel() - found[3:]).max() < 1e-13 * np.abs(wanted).max()


@pytest.mark.long
def test_gradients_of_what_is_received_and_by_times(backs):
    def loss(drag, times):
        body = eqx.tree_at(lambda b: b.torques[0].coefficient, BRAKED, drag * jnp.ones(3))
        found = ph.solve(body, body.pack(angular_velocity=(0.3, 0.9, 0.5)), times, Taylor)
        return jnp.sum(found.received["kinetic_energy"][1:] ** 2) + jnp.sum(found.saved[-1])

    found, wanted = gradients(loss, jnp.asarray(0.1), TIMES)
    assert np.abs(found - wanted).max() < 1e-12 * np.abs(wanted).max() and backs == [True]


@pytest.mark.long
@pytest.mark.parametrize(("drag", "taken"), [(5.0, [True]), (2e4, [False])], ids=["parts", "tangents"])
def test_what_has_lost_its_past_finds_it_again_or_goes_ahead(backs, drag, taken):
    """Against time, damping makes of a rounding whatever it likes: the way back is compared with the way ahead."""

    def loss(drag):
        body = eqx.tree_at(lambda b: b.torques[0].coefficient, BRAKED, drag * jnp.ones(3))
        times = jnp.array([0.0, 0.1 / known, 20.0])
        return jnp.sum(ph.solve(body, body.pack(angular_velocity=(0.3, 0.9, 0.5)), times, Taylor).saved)

    known = drag  # so that times do not change with it
    found, wanted = gradients(loss, jnp.asarray(drag))
    assert np.abs(found - wanted).max() < 1e-9 * np.abs(wanted).max() and backs == taken


def test_gradients_depend_on_the_way_back(monkeypatch):
    """Where weights of the state move half as fast, the gradient is another one."""
    field, half = series_derivatives.Returning.vector_field, np.array([1.0] * 3 + [0.5] * 3 + [1.0] * 6)
    monkeypatch.setattr(series_derivatives.Returning, "vector_field", lambda self, t, y: half * field(self, t, y))
    machine._machines.cache_clear()
    machine._write_unless_traced.cache_clear()
    series_derivatives.make_operation.cache_clear()
    try:
        found, wanted = gradients(lambda x: moved(MOMENTS, x)[-1, 0], START)
    finally:
        machine._machines.cache_clear()
        machine._write_unless_traced.cache_clear()
        series_derivatives.make_operation.cache_clear()
    assert np.abs(found - wanted).max() > 0.01


@pytest.mark.parametrize("many", [1, 3, 9])
def test_changes_in_few_directions_go_along_one_by_one(many, monkeypatch):
    """In more than four, the Jacobian takes less."""
    taken, real = [], series_derivatives.Motion.jacobian
    watched = lambda self, *given: taken.append(1) or real(self, *given)  # noqa: E731
    monkeypatch.setattr(series_derivatives.Motion, "jacobian", watched)
    rng = np.random.default_rng(7)
    ways = jnp.asarray(rng.normal(size=(many, 3))), jnp.asarray(rng.normal(size=(many, 3)))
    along = lambda solve: jax.jit(jax.vmap(lambda dm, dx: jax.jvp(solve, (MOMENTS, START), (dm, dx))[1]))  # noqa: E731
    series_derivatives.make_operation.cache_clear()
    found, wanted = along(moved)(*ways), along(exact)(*ways)
    series_derivatives.make_operation.cache_clear()
    assert np.abs(found - wanted).max() < 1e-13 * np.abs(wanted).max() and bool(taken) == (many > 4)


@pytest.mark.sweep
def test_a_change_that_comes_from_nothing():
    """An upright top does not feel its weight at first, only once it has turned away."""
    top = systems.HeavyTop((1.0, 2.0, 3.5), 1.3, (0.0, 0.0, 1.0))
    start = jnp.asarray(top.pack(attitude=(1.0, 0.0, 0.0, 0.0), angular_velocity=(0.3, 1.0, 0.1)))
    end = lambda mgl: ph.solve(eqx.tree_at(lambda t: t.mgl, top, mgl), start, [0.0, 2.0], Taylor).end_state  # noqa: E731
    found = jax.jvp(end, (1.3,), (1.0,))[1]
    wanted = (end(1.3 + 1e-5) - end(1.3 - 1e-5)) / 2e-5
    assert 0.1 < np.abs(wanted).max() and np.abs(found - wanted).max() < 1e-8


@pytest.mark.long
def test_changes_of_a_batch_whose_system_all_share():
    starts, way = jnp.stack([START, 3.0 * START]), jnp.array([0.3, -0.2, 0.1])
    found = jax.jvp(lambda m: moved(m, starts), (MOMENTS,), (way,))[1]
    for k, start in enumerate(starts):
        wanted = jax.jvp(lambda m, x=start: exact(m, x), (MOMENTS,), (way,))[1]
        assert np.abs(found[k] - wanted).max() < 1e-13 * np.abs(wanted).max()


def test_gradients_of_what_is_no_number_are_none():
    found = jax.jit(jax.grad(lambda x: jnp.sum(moved(MOMENTS, x))))(jnp.array([jnp.nan, 1.0, 1.0]))
    assert np.isnan(found).all()
    late = jax.jit(jax.grad(lambda x, t: jnp.sum(moved(MOMENTS, x, t))))(START, jnp.array([0.0, 2.0, 1.0]))
    assert np.isnan(late).all()

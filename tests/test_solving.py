"""solve: the same runs as simulate, pure, with derivatives of either mode; what it saves, and how copies end."""

from collections.abc import Callable
from typing import Any

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import fields, systems
from polhode.errors import InvalidInput
from polhode.integrators import LieMidpoint, MuntheKaas, Splitting
from polhode.motion import Ending, Status
from polhode.systems import AbstractSystem
from sweeping import first

MOMENTS, START = (1.0, 2.0, 3.0), np.array([0.3, 1.8, 1.5])
BODY = systems.FreeRigidBody(MOMENTS)
TIMES = np.linspace(0.0, 2.0, 9)
STEP = 0.1
SAME = 1e-14  # the same operations, compiled in another loop
CLOSE = 1e-10  # order 8 with such steps, or tolerance 1e-12, and the derivatives of that, by either mode
ADAPTIVE = diffrax.Dopri5()  # of fewer stages than Dopri8, and so compiled sooner
METHODS = [None, LieMidpoint, ADAPTIVE]
WEIGHTS = np.random.default_rng(1).normal(size=(len(TIMES), 3))


class Falling(AbstractSystem):
    """z̈ = −2 down to z = 0, or up to z = 1.5."""

    def vector_field(self, t: Any, state: Any) -> Any:
        return jnp.stack([state[..., 1], -2.0 + 0.0 * state[..., 0]], axis=-1)

    def invariants(self, state: Any) -> dict[str, Any]:
        return {"energy": 0.5 * state[..., 1] ** 2 + 2.0 * state[..., 0]}

    @property
    def events(self) -> dict[str, Callable[[Any, Any], Any]]:
        return {"ground": lambda t, state: state[0], "ceiling": lambda t, state: 1e3 * (1.5 - state[0])}


def solved(state, method=None, **more):
    step = None if method is ADAPTIVE else STEP
    return ph.solve(BODY, state, TIMES, method, step=step, **more)


def weighed(state, method):
    return jnp.sum(solved(state, method).saved * WEIGHTS)


def slopes_of(function, point):
    """Return the gradient by differences of fourth order, of closed forms: exact to 1e-12 or so."""
    h, point = 1e-3, np.asarray(point, dtype=float)
    near = lambda way: 8.0 * (function(point + h * way) - function(point - h * way))  # noqa: E731
    far = lambda way: function(point + 2.0 * h * way) - function(point - 2.0 * h * way)  # noqa: E731
    return np.array([(near(way) - far(way)) / (12.0 * h) for way in np.eye(len(point))])


def exactly_weighed(momentum):
    return np.sum(ph.FreeMotion(MOMENTS, momentum=momentum).momentum(TIMES) * WEIGHTS)


@pytest.mark.long
@pytest.mark.parametrize("method", [Splitting, pytest.param(LieMidpoint, marks=pytest.mark.sweep), ADAPTIVE])
def test_solve_is_simulate(method):
    """With a step or a tolerance, and with the default step of every copy of a batch."""
    states = np.stack([START, 3.0 * START])
    for more in [{}] if method is ADAPTIVE else [{"step": STEP}, {}]:
        wanted = ph.simulate(BODY, states, TIMES, method, estimate_error=False, **more)
        found = ph.solve(BODY, states, TIMES, method, **more)
        assert np.abs(found.saved - wanted.states).max() < SAME * 10
        assert found.steps.max() == wanted.statistics["steps"]
        assert (found.status == Status.COMPLETED).all() and (found.end == TIMES[-1]).all()
        assert np.abs(found.end_state - found.saved[:, -1]).max() < SAME * np.abs(found.saved).max()


@pytest.mark.sweep
@pytest.mark.parametrize("method", first(2, METHODS))
def test_derivatives_of_either_mode_are_those_of_the_closed_form(method):
    """Under jit of vmap."""
    states, ways = np.stack([START, -0.5 * START]), np.array([[0.3, -0.2, 0.5], [0.1, 0.9, -0.4]])

    def both(state, way):
        function = lambda x: weighed(x, method)  # noqa: E731
        return jax.grad(function)(state), *jax.jvp(function, (state,), (way,))

    slopes, value, change = jax.jit(jax.vmap(both))(jnp.asarray(states), jnp.asarray(ways))
    wanted = np.stack([slopes_of(exactly_weighed, state) for state in states])
    assert np.abs(value - np.array([exactly_weighed(state) for state in states])).max() < CLOSE
    assert np.abs(slopes - wanted).max() < CLOSE
    assert np.abs(change - np.sum(wanted * ways, axis=1)).max() < CLOSE


@pytest.mark.sweep
def test_derivatives_of_a_batch_within():
    states = np.stack([START, -0.5 * START])
    slopes = jax.grad(lambda s: jnp.sum(solved(s).saved * WEIGHTS))(jnp.asarray(states))
    assert np.abs(slopes - np.stack([slopes_of(exactly_weighed, state) for state in states])).max() < CLOSE


@pytest.mark.sweep
def test_derivatives_by_the_arrays_in_a_system_and_by_times():
    weights = jnp.asarray([0.3, 0.9, -0.4])

    def last(numbers):
        body = eqx.tree_at(lambda s: s.moments, BODY, numbers[:3])
        times = jnp.asarray([0.0, 0.5]) * numbers[3]
        return ph.solve(body, START, times, ADAPTIVE).saved[-1] @ weights

    def exactly(numbers):
        return ph.FreeMotion(numbers[:3], momentum=START).momentum(0.5 * numbers[3]) @ np.asarray(weights)

    numbers = jnp.asarray([*MOMENTS, 2.0])
    wanted = slopes_of(exactly, numbers)
    assert np.abs(jax.grad(last)(numbers) - wanted).max() < CLOSE
    assert np.abs(jax.jacfwd(last)(numbers) - wanted).max() < CLOSE


@pytest.mark.sweep
def test_derivatives_by_default_steps_and_second_ones():
    """The default step is a number of the state, by which the steps are counted and not differentiated."""
    by_default = lambda s: ph.solve(BODY, s, TIMES, LieMidpoint, order=2).saved[-1, 0]  # noqa: E731
    start = jnp.asarray(START)
    slope, change = jax.grad(by_default)(start), jax.jvp(by_default, (start,), (WEIGHTS[0],))[1]
    assert abs(change - slope @ WEIGHTS[0]) < SAME * 10 and abs(change) > 0.01
    twice = lambda s: solved(s, ADAPTIVE).saved[-1, 0]  # noqa: E731
    with pytest.raises(InvalidInput, match="first derivatives only"):
        jax.eval_shape(jax.hessian(twice), start)


@pytest.mark.long
@pytest.mark.parametrize(("method", "every"), [(Splitting, 3), (ADAPTIVE, 2)])
def test_every_nth_is_that_of_the_whole(method, every):
    whole, thin = solved(START, method), solved(START, method, save=every)
    assert np.abs(thin.saved - whole.saved[::every]).max() < SAME and (thin.times == TIMES[::every]).all()
    assert thin.steps == whole.steps and np.abs(thin.end_state - whole.end_state).max() < SAME
    more = {"step": STEP} if method is Splitting else {}
    starts = np.stack([START, 2.0 * START])
    long, short = (ph.simulate(BODY, starts, TIMES, method, save=k, **more) for k in (1, every))
    assert np.abs(short.states - long.states[:, ::every, :]).max() < SAME
    assert (short.times == TIMES[::every]).all() and short.statistics["steps"] == long.statistics["steps"]
    assert short.invariants["energy"].shape == short.states.shape[:-1]
    assert np.max(short.error_estimate) < CLOSE


@pytest.mark.long_cases("method1")
@pytest.mark.parametrize("method", [None, ADAPTIVE])
def test_a_function_of_the_states_is_that_of_saved_states(method):
    states = np.stack([START, 2.0 * START])
    observe = lambda t, L: {"power": L[0] * t, "above": L[1] > 0.0}  # noqa: E731
    found, whole = solved(states, method, save=observe), solved(states, method).saved
    assert np.abs(found.saved["power"] - whole[..., 0] * TIMES).max() < SAME * 10
    assert (found.saved["above"] == (whole[..., 1] > 0.0)).all() and found.received == {}


@pytest.mark.sweep
def test_a_fold_keeps_one_value_however_many_times_there_are():
    largest = ph.Fold(lambda value, t, L: jnp.maximum(value, L), jnp.full(3, -jnp.inf))
    few = solved(START, save=largest)
    assert np.abs(few.saved - solved(START).saved.max(axis=0)).max() < SAME
    shapes = [
        jax.eval_shape(lambda s, n=n: ph.solve(BODY, s, np.linspace(0.0, 2.0, n), step=STEP, save=largest), START).saved
        for n in (9, 90_000)
    ]
    assert [x.shape for x in shapes] == [(3,), (3,)]
    mean = ph.Fold(lambda value, t, L: value + L @ WEIGHTS[0], 0.0)
    slopes = jax.grad(lambda s: solved(s, save=mean).saved)(jnp.asarray(START))
    wanted = jax.grad(lambda s: jnp.sum(solved(s).saved @ WEIGHTS[0]))(jnp.asarray(START))
    assert np.abs(slopes - wanted).max() < CLOSE


@pytest.mark.sweep
def test_every_copy_of_a_batch_ends_at_its_own_event():
    times = np.linspace(0.0, 1.7, 18)
    starts = np.array([[[1.0, 1.0], [1.0, 2.0], [0.3, 0.1], [1.0, 1.3]]])  # ground, ceiling, ground sooner, none
    ended = ["ground", "ceiling", "ground", None]
    found, plain = ph.simulate(Falling(), starts, times, ADAPTIVE), ph.solve(Falling(), starts, times, ADAPTIVE)
    assert found.states.shape == (1, 4, 18, 2) and found.outcome.ending is Ending.EVENT
    assert str(found.outcome) == "ground or ceiling: in 3 of 4 copies"
    assert found.ends is not None
    for k, event in enumerate(ended):
        alone = ph.simulate(Falling(), starts[0, k], times)  # by series
        assert alone.outcome.event == event == found.ends.outcome((0, k)).event
        last = found.ends.time[0, k]
        assert abs(last - alone.times[-1]) < SAME and np.abs(found.ends.state[0, k] - alone.states[-1]).max() < SAME
        before = np.flatnonzero(times < last) if event else slice(None)
        assert np.abs(found.states[0, k][before] - alone.states[: len(times[before])]).max() < SAME
        assert not event or np.isinf(found.states[0, k][times > last]).all()
        assert found.drift["energy"][0, k] < CLOSE and found.error_estimate[0, k] < CLOSE
        assert plain.status[0, k] == (Status.EVENT if event else Status.COMPLETED)
        assert plain.end[0, k] == last and (plain.end_state[0, k] == found.ends.state[0, k]).all()
        assert plain.event[0, k] == (-1 if event is None else ["ground", "ceiling"].index(event))


@pytest.mark.sweep
def test_derivatives_of_the_time_of_an_event():
    """A stone from height z at rest falls for √z, at 2√z: derivatives 1/(2√z) and −1/√z."""
    height = jnp.asarray([0.3, 0.7])

    def fall(z):
        found = ph.solve(Falling(), jnp.stack([z, 0.0 * z]), TIMES)
        return found.end, found.end_state[1]

    time, speed = jax.vmap(fall)(height)
    assert np.abs(time - np.sqrt(height)).max() < SAME and np.abs(speed + 2.0 * np.sqrt(height)).max() < SAME * 10
    wanted = 0.5 / np.sqrt(height), -1.0 / np.sqrt(height)
    for derivative in (jax.jacrev, jax.jacfwd):
        found = jax.jit(jax.vmap(derivative(fall)))(height)
        assert max(np.abs(found[k] - wanted[k]).max() for k in range(2)) < CLOSE


@pytest.mark.long
@pytest.mark.filterwarnings("ignore:a step of")
def test_status_of_copies_of_equal_steps():
    states, times = np.array([0.1 * START, 20.0 * START]), [0.0, 10.0, 20.0]
    found = ph.simulate(BODY, states, times, LieMidpoint, step=2.5, throw=False)
    assert found.ends is not None and found.ends.status.tolist() == [Status.COMPLETED, Status.NOT_CONVERGED]
    assert found.ends.outcome(1).ending is Ending.NOT_CONVERGED and np.isnan(found.ends.time[1])
    plain = ph.solve(BODY, states, times, LieMidpoint, step=2.5)
    assert plain.status.tolist() == found.ends.status.tolist() and not np.isfinite(plain.end_state[1]).any()
    assert np.abs(plain.end_state[0] - found.ends.state[0]).max() < SAME


@pytest.mark.long
def test_uneven_times_and_backwards():
    times = np.array([0.0, 0.05, 0.35, 1.0])
    found = ph.solve(BODY, START, times, MuntheKaas, step=STEP)
    assert found.steps == 1 + 3 + 7
    assert np.abs(found.saved - ph.simulate(BODY, START, times, MuntheKaas, step=STEP).states).max() < SAME
    back = ph.solve(BODY, found.end_state, times[::-1], MuntheKaas, step=0.01)
    assert np.abs(back.end_state - START).max() < 1e-5


@pytest.mark.parametrize("size", [1e-170, 1e170])
def test_times_whose_squares_leave_the_numbers(size):
    """They were said not to advance."""
    found = ph.solve(BODY, START / size, size * np.array([0.0, 0.5, 1.0]), MuntheKaas, step=size * STEP)
    assert np.abs(size * found.saved - ph.solve(BODY, START, [0.0, 0.5, 1.0], MuntheKaas, step=STEP).saved).max() < SAME


def test_traced_numbers_that_make_no_sense_give_none():
    found = jax.jit(lambda h: ph.solve(BODY, START, TIMES, step=h).saved[-1])(-0.1)
    assert not np.isfinite(found).any()


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"step": 0.0}, "`step` must be one positive"),
        ({"step": np.array([0.1, 0.2])}, "`step` must be one positive"),
        ({"tolerance": 1e-6}, "goes with diffrax's solvers"),
        ({"method": ADAPTIVE, "tolerance": -1.0}, "`tolerance` must be one positive"),
        ({"method": ADAPTIVE, "save": ph.Fold(lambda v, t, x: v, 0.0)}, "as a Fold goes with"),
        ({"save": 0}, "every how many-th"),
        ({"save": 9}, "1 to 8; got 9"),
        ({"times": [0.0, 1.0, 0.5]}, "one direction.*; got 0.5 after 1.0 at index 2"),
        ({"times": [0.0, np.inf]}, "must be finite .*; got inf at index 1"),
        ({"times": ["a", "b"]}, "must be numbers"),
        ({"times": [[0.0, 1.0]]}, "at least two times"),
        ({"state": np.ones(5)}, r"shape \(…, 3\)"),
        ({"method": Splitting(BODY, jnp.asarray(0.1)), "step": 0.1}, "made with its own"),
        ({"method": Splitting(systems.HeavyTop(MOMENTS, 1.0), jnp.asarray(0.1))}, "another system"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(more, words):
    given = {"state": START, "times": TIMES} | more
    with pytest.raises(InvalidInput, match=words):
        ph.solve(BODY, **given)


@pytest.mark.usefixtures("any_type")
def test_simulate_refuses_functions_and_says_who_takes_them():
    with pytest.raises(InvalidInput, match=r"polhode\.solve.* takes functions"):
        ph.simulate(BODY, START, TIMES, save=lambda t, L: L)  # pyright: ignore[reportArgumentType]


def fluid_in_three_parts():
    fluid = fields.SphereFluid(6)
    return fluid, fluid.random([0.0, 1.0, 1.0, 0.5], seed=1), ph.integrators.IsospectralMidpoint, {"order": 2}


def body_in_three_parts():
    return BODY, np.stack([START, 3.0 * START]), None, {}


@pytest.mark.long
@pytest.mark.parametrize("given", first(1, [body_in_three_parts, fluid_in_three_parts]))
def test_a_run_goes_on_from_what_was_saved_to_the_same_bits(given, tmp_path):
    system, state, method, more = given()
    times = np.linspace(0.0, 3.0, 31)
    whole = ph.solve(system, state, times, method, 0.05, **more)
    now, memory, steps = state, None, 0
    for begin, end in ((0, 7), (7, 18), (18, 30)):
        found = ph.solve(system, now, times[begin : end + 1], method, 0.05, memory=memory, **more)
        eqx.tree_serialise_leaves(tmp_path / "run.eqx", (found.end_state, found.memory))
        now, memory = eqx.tree_deserialise_leaves(tmp_path / "run.eqx", (found.end_state, found.memory))
        steps = found.steps
    assert np.array_equal(now, whole.end_state) and np.array_equal(steps, whole.steps)
    for one, other in zip(jax.tree.leaves(memory), jax.tree.leaves(whole.memory), strict=True):
        assert np.array_equal(one, other)
    afresh = ph.solve(system, found.end_state, times[:2], method, 0.05, **more).memory
    assert not np.array_equal(afresh.steps, steps)


def test_the_memory_of_another_method_is_refused():
    system, state, method, _ = fluid_in_three_parts()
    memory = ph.solve(BODY, START, TIMES).memory
    with pytest.raises(InvalidInput, match="`memory` must be that of a run of IsospectralMidpoint"):
        ph.solve(system, state, TIMES, method, 0.05, order=2, memory=memory)
    with pytest.raises(InvalidInput, match="start over"):
        ph.solve(BODY, START, TIMES, ADAPTIVE, memory=memory)


class Turning(AbstractSystem):
    """A circle, at a rate that a function of the state gives."""

    rate: Any

    def vector_field(self, t: Any, state: Any) -> Any:
        return self.rate(state) * jnp.stack([state[1], -state[0]])

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}


def turned(rate, method, enclosed):
    """Return cos 2r; the rate r is a variable of the function, or its argument."""
    function = (lambda state: rate) if enclosed else jax.tree_util.Partial(lambda rate, state: rate, rate)
    return ph.solve(Turning(function), jnp.array([1.0, 0.0]), [0.0, 2.0], method).end_state[0]


def spun(rate, method, enclosed):
    """The same of two components that turn about the third."""
    energy = lambda rate, L: rate * L[2] + 0.0 * L[0]  # noqa: E731
    function = (lambda L: energy(rate, L)) if enclosed else jax.tree_util.Partial(energy, rate)
    system = systems.LiePoisson(ph.algebra.SO3(), function)
    return ph.solve(system, jnp.array([1.0, 0.0, 0.3]), [0.0, 2.0], method).end_state[0]


BY = {"grad": jax.grad, "jacfwd": jax.jacfwd, "jit of grad": lambda f: jax.jit(jax.grad(f)),
      "grad of jit": lambda f: jax.grad(jax.jit(f)),
      "grad of vmap": lambda f: jax.grad(lambda x: jax.vmap(f)(x * jnp.ones(2))[0])}  # fmt: skip


@pytest.mark.long_cases("jacfwd", "jit of grad", "grad of jit", "grad of vmap")
@pytest.mark.parametrize("by", BY)
@pytest.mark.parametrize("method", [ADAPTIVE, ph.integrators.Taylor], ids=["adaptive", "Taylor"])
def test_derivatives_by_what_a_function_encloses_are_refused(method, by):
    """They would be without the part that goes by the function."""
    with pytest.raises(InvalidInput, match=r"must not enclose a number that JAX traces.*Partial\(function"):
        BY[by](lambda rate: turned(rate, method, True))(0.7)


@pytest.mark.long_cases("jacfwd", "jit of grad", "grad of jit", "grad of vmap")
@pytest.mark.parametrize("by", BY)
@pytest.mark.parametrize("method", [LieMidpoint, ph.integrators.Taylor], ids=["equal steps", "Taylor"])
def test_derivatives_go_by_what_a_hamiltonian_encloses(method, by):
    """A system reads the numbers in its Hamiltonian as data: as if they were given next to it."""
    by_variable, by_argument = (BY[by](lambda rate, how=how: spun(rate, method, how))(0.7) for how in (True, False))
    assert np.abs(by_variable - by_argument) < 1e-12 and np.abs(by_variable + 2.0 * np.sin(1.4)) < 1e-3


@pytest.mark.long
@pytest.mark.parametrize(("end", "method"), [(turned, ADAPTIVE), (spun, LieMidpoint)], ids=["adaptive", "equal steps"])
def test_values_may_depend_on_what_a_function_encloses(end, method):
    """Compiled, or one of a batch."""
    close = 1e-3 if end is spun else 1e-10
    for rate in (jax.jit, jax.vmap)[: 2 if end is spun else 1]:
        found = rate(lambda rate: end(rate, method, True))(0.7 * jnp.ones((2,) if rate is jax.vmap else ()))
        assert np.abs(found - np.cos(1.4)).max() < close

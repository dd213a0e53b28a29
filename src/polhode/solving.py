"""``solve``: from a system, a state and times to states, as a pure function that JAX compiles and differentiates.

``polhode.simulation`` makes a checked ``Trajectory`` of the same runs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode import integrators
from polhode._base.arrays import in_jax_numpy, is_positive, is_traced, is_tracing, require_doubles
from polhode.errors import InvalidInput, shown
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._adaptive import TOLERANCE
from polhode.integrators._choice import choose_solver, step_angle, turning_rates
from polhode.integrators._enclosed import refuse_derivatives_by_enclosed
from polhode.integrators._sampled import Observe, Sampled, as_floats, sample_by_either_mode
from polhode.integrators._series import Taylor
from polhode.integrators._step_results import Memory
from polhode.integrators.probing import find_undeclared_jumps, name_jumps
from polhode.motion._outcome import Status
from polhode.motion._plan import Stepping
from polhode.planning import check_every
from polhode.systems._checks import advancing_times
from polhode.systems._forms import refuse_other_objects
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.taylor.runs import choose_precision
from polhode.types import Array, ArrayLike, Double, Float64, Integer, Real


class Fold(NamedTuple):
    """A reduction while a motion runs, of which only the last value is kept.

    Attributes:
        function: (value, time, state) → value, a nest of arrays of fixed shapes; called at every sample.
        start: the value before the first sample.
    """

    function: Callable[[Any, Float64[Array, ""], Double[Array, "..."]], Any]
    start: Any


class Solution(NamedTuple):
    """A motion as plain arrays.

    Attributes:
        times: (K,) [s] of what is saved.
        saved: states (batch…, K, …); what a function of them gave, with the same leading axes; or what a ``Fold`` came
            to, (batch…, …). Infinite after the end of a copy.
        received: name → what each balance received since the first time, (batch…, K); empty where no states are saved.
        status: (batch…) numbers of ``polhode.motion.Status``.
        event: (batch…) which of ``system.events`` ended the copy, −1 where none did.
        end: (batch…) [s] the event's own time, or the last; NaN where the solver failed.
        end_state: (batch…, …) the state then.
        steps: (batch…) how many were taken.
        iterations: (batch…) evaluations in implicit steps.
        memory: what a method of ours carries along, a nest of arrays; with ``end_state`` all that it takes to go on to
            the same bits. None of diffrax's solvers.
    """

    times: Float64[Array, "kept"]
    saved: Any
    received: Mapping[str, Float64[Array, "*batch kept"]]
    status: Integer[Array, "*batch"]
    event: Integer[Array, "*batch"]
    end: Float64[Array, "*batch"]
    end_state: Double[Array, "..."]
    steps: Integer[Array, "*batch"]
    iterations: Integer[Array, "*batch"]
    memory: Memory | None = None


@refuse_derivatives_by_enclosed
def solve(
    system: AbstractSystem,
    state: Real[ArrayLike, "..."],
    times: Real[ArrayLike, "time"],
    method: type[integrators.AbstractOrbitSolver | Taylor] | diffrax.AbstractSolver[Any] | Taylor | None = None,
    step: Real[ArrayLike, ""] | None = None,
    order: int | None = None,
    tolerance: Real[ArrayLike, ""] | None = None,
    save: int | Observe | Fold | None = None,
    memory: Memory | None = None,
) -> Solution:
    """Return the motion of a system from a state at the first time, as a pure function of arrays.

    Its steps are those of ``simulate`` by the same method. It works under ``jax.jit``, ``vmap`` and derivatives of
    either mode, by the state, by the times and by the arrays in the system. It raises for wrong shapes, but not for
    what numbers do: status says how each copy ended, and numbers that make no sense give states that are not finite.

    Reverse-mode derivatives of methods of ours go back from one of the times to the one before by steps of the other
    sign, instead of storing the path: the memory does not grow with the steps between two times. Recovered states are
    compared with the motion every 64 steps at most, and computed again from checkpoints where it is off by more than 32
    ulps of its size. Second derivatives are forward ones of either mode. Those of diffrax's solvers go back from
    checkpoints, and have first derivatives only. What a function encloses is not differentiated by, but in a
    Hamiltonian of ``LiePoisson``: give parameters as fields of a system or of an ``equinox.Module``. The exact flows of
    bodies with a potential have forward derivatives only; ``LieMidpoint`` has both. Where rates jump with the state, as
    by a sign, derivatives leave out that the time of the jump moves, and are wrong; corners are right.
    ``analysis.monodromy`` has such jumps.

    Steps end at the system's ``jumps`` under every transformation. Others are sought, as by ``simulate``, only where
    state, times and system are known numbers, and at the start alone.

    Args:
        system: what moves.
        state: (batch…, …) packed, as for ``simulate``.
        times: (T,) [s], in one direction.
        method: a class or object of ``polhode.integrators``, or any diffrax solver; by default what ``simulate`` takes
            where there is no Taylor series. ``Taylor`` runs on the host, also when called from compiled functions,
            and has first derivatives by tangents, all in one run, and second ones by differences of these. It takes
            systems without events and jumps, whose rates have series in the numbers of their fields too.
        step: largest step [s]; by default from each copy's fastest rotation at the start.
        order: of the method, by default its own.
        tolerance: of a step of diffrax's solvers, relative, by default 1e-12; of Taylor's a known number, by default
            below rounding.
        save: every how many-th of the times to save; or a function of time and one state, whose values are saved
            instead; or a ``Fold``, whose result does not grow with the times, and which needs one of our methods.
        memory: that of an earlier run by the same method and step, whose ``end_state`` is given as the state: then the
            motion goes on as if it had not been interrupted. Saved with ``equinox.tree_serialise_leaves``, it serves
            another day. ``steps`` and ``iterations`` count on.

    Raises:
        InvalidInput: for wrong shapes and arguments, and for known numbers that are wrong: times out of order, a step
            or tolerance that is not positive.

    >>> import polhode as ph
    >>> body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    >>> solution = solve(body, [0.3, 1.8, 1.5], jnp.linspace(0.0, 5.0, 11), save=lambda t, L: jnp.sum(L * L))
    >>> solution.saved.shape, bool(jnp.ptp(solution.saved) < 1e-13), int(solution.status)
    ((11,), True, 0)
    """
    state, times = _check(system, state, times)
    for name, value in (("step", step), ("tolerance", tolerance)):
        require_doubles(**{name: value})
        if value is not None and (jnp.ndim(value) or not (is_traced(value) or is_positive(value))):
            raise InvalidInput(f"`{name}` must be one positive finite number; got {shown(value)}.")
    every, observe = _to_save(save, len(times))
    with in_jax_numpy("systems and functions given to `solve`"):
        if not (is_tracing() or is_traced(state, times, *jax.tree.leaves(system))):
            system = name_jumps(system, find_undeclared_jumps(system, state, times))
        stepping, solver = choose_solver(system, method, order)
        if memory is not None and stepping is not Stepping.EQUAL_STEPS:
            raise InvalidInput(
                "`memory` goes with the methods of polhode.integrators that take equal steps; others start over."
            )
        if stepping is Stepping.SERIES:
            return _by_series(system, state, times, solver, step, tolerance, every, observe)
        if stepping is Stepping.EQUAL_STEPS:
            if tolerance is not None:
                raise InvalidInput("`tolerance` goes with diffrax's solvers; give `step`, or let `simulate` choose it.")
            is_made = solver is method
            return _by_equal_steps(system, state, times, solver, is_made, step, order, every, observe, memory)
        if isinstance(observe, Fold):
            raise InvalidInput(
                "`save` as a Fold goes with the methods of polhode.integrators, which step from sample to sample. Give "
                "a function of time and state instead, and reduce what it returns."
            )
        tolerance = TOLERANCE if tolerance is None else tolerance
        largest = None if step is None else jnp.asarray(step, float)
        run = _adaptively(system, solver, state, times, times[::every], largest, jnp.asarray(tolerance), observe)
        none = jnp.zeros_like(run.steps)
        return Solution(jnp.asarray(times[::every]), run.saved, run.received, run.status, run.event, run.end,
                        run.end_state, run.steps, none)


def _check(system: AbstractSystem, state: Array, times: Array) -> tuple[Array, Array]:
    refuse_other_objects(system)
    require_doubles(state=state, times=times)
    if not is_traced(state, *jax.tree.leaves(system)):
        state = jnp.asarray(system.check_state(state))
    elif isinstance(system, AbstractLiePoissonSystem):
        system.parts(state)
    if not is_traced(times):
        return state, advancing_times(times)
    times = jnp.asarray(times, float)
    if times.ndim != 1 or len(times) < 2:
        raise InvalidInput(f"`times` must be at least two times (T,); got shape {times.shape}.")
    return state, times


def _to_save(save: Any, count: int) -> tuple[int, Any]:
    """Return every how many-th time is saved, and what of the state, None for itself."""
    if save is None:
        return 1, None
    if isinstance(save, Fold) or (callable(save) and not isinstance(save, type)):
        return 1, save
    return check_every(save, count), None


@eqx.filter_jit
def _adaptively(
    system: AbstractSystem, solver: Any, state: Array, times: Array, kept: Array, largest: Array | None,
    tolerance: Array, observe: Any,
) -> Sampled:
    times, kept = jnp.asarray(times), jnp.asarray(kept)

    def one(state: Array) -> Sampled:
        return sample_by_either_mode(system, solver, state, times, kept, largest, tolerance, observe)

    for _ in range(jnp.ndim(state) - system.state_axes):
        one = jax.vmap(one)
    return one(jnp.asarray(state))


def _by_series(
    system: AbstractSystem, state: Array, times: Array, method: Taylor, step: Any, tolerance: Any, every: int,
    observe: Any,
) -> Solution:
    from polhode.integrators._series_operation import series_solution

    if is_traced(step, tolerance):
        raise InvalidInput("`step` and `tolerance` of Taylor must be known numbers, not traced ones.")
    precision = choose_precision(None if tolerance is None else float(tolerance), method.order, method.is_extended)
    motion = series_solution(system, state, times, precision, math.inf if step is None else float(step))
    axis, kept = jnp.ndim(motion.failed), jnp.asarray(times)[::every]
    saved, received = motion.states, motion.received
    if isinstance(observe, Fold):
        saved, received = _fold(observe, jnp.asarray(times), motion.states, axis), {}
    elif observe is not None:
        seen = jax.vmap(lambda t, one: as_floats(observe(t, one)))
        for _ in range(axis):
            seen = jax.vmap(seen, (None, 0))
        saved = seen(jnp.asarray(times), motion.states)
    else:
        saved = saved[(slice(None),) * axis + (slice(None, None, every),)]
        received = {name: value[..., ::every] for name, value in received.items()}
    status = jnp.where(motion.failed, Status.NOT_CONVERGED, Status.COMPLETED)
    end = jnp.where(motion.failed, jnp.nan, jnp.asarray(times)[-1])
    none = jnp.zeros_like(motion.steps)
    return Solution(kept, saved, received, status, none - 1, end, jnp.take(motion.states, -1, axis=axis), motion.steps,
                    none)


def _fold(fold: Fold, times: Array, states: Array, axis: int) -> Any:
    """Return the final value of a ``Fold`` over all samples."""

    def one(path: Array) -> Any:
        return jax.lax.scan(lambda value, at: (fold.function(value, *at), None), fold.start, (times, path))[0]

    for _ in range(axis):
        one = jax.vmap(one)
    return one(states)


# ---------------------------------------------------------------------- equal steps


def _by_equal_steps(
    system: Any, state: Array, times: Array, solver: Any, is_made: bool, step: Array | None, order: int | None,
    every: int, observe: Any, memory: Memory | None,
) -> Solution:
    if is_made:
        if step is not None or order is not None:
            raise InvalidInput("`step` and `order` go with a class of methods; the solver given was made with its own.")
        if not isinstance(system, type(solver.system)):
            raise InvalidInput("`method` was made for another system; make it with the one that is to move.")
        solver, step = eqx.tree_at(lambda s: s.system, solver, system), solver.step_size
    if memory is not None:
        memory = restore_memory(solver, state, memory)
    return _run(solver, state, jnp.asarray(times), step, every, observe, memory)


def restore_memory(solver: integrators.AbstractOrbitSolver, state: Double[Array, "..."], arrays: Any) -> Memory:
    """Return a method's memory from its arrays.

    Raises:
        InvalidInput: for arrays that are not of this method and these states.
    """
    fresh = solver.memory
    for _ in range(jnp.ndim(state) - solver.system.state_axes):
        fresh = jax.vmap(fresh)
    wanted = jax.eval_shape(fresh, jnp.asarray(state))
    try:
        stored = [jnp.asarray(x) for x in jax.tree.leaves(arrays)]
    except (TypeError, ValueError):
        raise InvalidInput(f"`memory` must be that of an earlier run, arrays; got {shown(arrays)}.") from None
    shapes = [[x.shape for x in nest] for nest in (jax.tree.leaves(wanted), stored)]
    if shapes[0] != shapes[1] or any(jnp.iscomplexobj(x) and not jnp.issubdtype(w.dtype, jnp.complexfloating)
                                     for w, x in zip(jax.tree.leaves(wanted), stored, strict=True)):
        raise InvalidInput(
            f"`memory` must be that of a run of {type(solver).__name__} from states of the same shape, at the same "
            "order; leave it out to start over."
        )
    leaves = [x.astype(w.dtype) for w, x in zip(jax.tree.leaves(wanted), stored, strict=True)]
    return jax.tree.unflatten(jax.tree.structure(wanted), leaves)


@eqx.filter_jit
def _run(
    solver: integrators.AbstractOrbitSolver, state: Array, times: Array, step: Array | None, every: int, observe: Any,
    memory: Memory | None,
) -> Solution:
    system, state = solver.system, jnp.asarray(state)
    batch = state.ndim - system.state_axes
    if step is None:
        sizes = step_angle(solver.order(None)) / turning_rates(system, state, times)
    else:
        sizes = jnp.where(jnp.asarray(step) > 0.0, step, jnp.nan) * jnp.ones(state.shape[:batch])
    sizes = jnp.minimum(jax.lax.stop_gradient(sizes), jnp.max(jnp.abs(jnp.diff(times))))

    def one(state: Array, size: Array, memory: Memory | None) -> Solution:
        return _run_one(solver, state, size, times, every, observe, memory)

    for _ in range(batch):
        one = jax.vmap(one)
    solution = one(state, sizes, memory)
    return solution._replace(times=times[::every])


def _run_one(
    solver: Any, state: Array, size: Array, times: Array, every: int, observe: Any, memory: Memory | None
) -> Solution:
    solver = eqx.tree_at(lambda s: s.step_size, solver, size)
    state = jnp.where(size > 0.0, state, jnp.nan)
    fold = isinstance(observe, Fold)
    # of a function of states, derivatives compute again what they need; of steps, they go back by themselves
    folded = jax.checkpoint(observe.function) if fold else None

    def over(carried: tuple[Any, ...], interval: Any) -> tuple[tuple[Any, ...], None]:
        (now, memory, value), (begin, span) = carried, interval
        now, memory = solver.advance(begin, span, now, memory)
        return (now, memory, value if folded is None else folded(value, begin + span, now)), None

    def look_at(t: Array, state: Array) -> Any:
        return state if observe is None else as_floats(observe(t, state))

    def together(carried: tuple[Any, ...], group: Any) -> tuple[tuple[Any, ...], Any]:
        carried, _ = jax.lax.scan(over, carried, group)
        return carried, None if fold else look_at(group[0][-1] + group[1][-1], carried[0])

    groups, intervals = (len(times) - 1) // every, (times[:-1], jnp.diff(times))
    whole = jax.tree.map(lambda x: x[: groups * every].reshape(groups, every), intervals)
    rest = jax.tree.map(lambda x: x[groups * every :], intervals)
    value = observe.function(observe.start, times[0], state) if fold else None
    begun = solver.memory(state) if memory is None else memory
    carried, saved = jax.lax.scan(together, (state, begun, value), whole)
    (last, after, value), _ = jax.lax.scan(over, carried, rest)
    if not fold:
        first = look_at(times[0], state)
        value = jax.tree.map(lambda x, xs: jnp.concatenate([x[None], xs]), first, saved)
    fine = after.fine
    return Solution(
        times, value, {}, jnp.where(fine, Status.COMPLETED, Status.NOT_CONVERGED), jnp.asarray(-1),
        jnp.where(fine, times[-1], jnp.nan), last, after.steps, after.iterations, after,
    )

"""``simulate``: from a system and a state to a trajectory."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode import integrators
from polhode._base.arrays import is_positive, known_numbers_only
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._adaptive import AdaptiveMotion, adaptive_error, solve_adaptively
from polhode.integrators._difference import EPS
from polhode.integrators._series import (
    NoSeries,
    Taylor,
    goes_by_arrays,
    has_short_series,
    is_series,
    series_to_tolerance,
    solve_by_series,
    solve_with_error,
)
from polhode.integrators.probing import find_undeclared_jumps, jumps_along, jumps_between, name_jumps
from polhode.motion._outcome import Ending, Ends, Outcome, Status
from polhode.motion._trajectory import Trajectory
from polhode.solving import (
    adaptive_solver,
    check_every,
    goes_along_orbit,
    is_adaptive,
    orbit_solver,
    restore_memory,
    step_angle,
    turning_rates,
)
from polhode.systems._agreement import check_agreement, moves_by_generator
from polhode.systems._checks import advancing_times
from polhode.systems._forms import check_finite_rates, refuse_other_objects
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.systems.trajectories import make_trajectory
from polhode.types import Array, ArrayLike, Bool, Real


class _Asked(NamedTuple):
    """The options of ``simulate`` besides system, state, times and method."""

    step: float | None
    order: int | None
    progress: Any
    throw: bool
    tolerance: float | None
    estimate_error: bool
    every: int
    resumable: bool
    memory: Sequence[Array] | None


TOO_LONG = 1.0  # rad in a step from which a given step draws a warning
PASSED = 0.1  # error of a motion whose series end at a singularity, above which it has not gone past that
LONG_RUN = 2_000_000  # steps from which progress is shown, on a terminal


@known_numbers_only
def simulate(
    system: AbstractSystem,
    state: Real[ArrayLike, "..."],
    times: Real[ArrayLike, "time"],
    method: type[integrators.AbstractOrbitSolver | Taylor] | diffrax.AbstractSolver[Any] | Taylor | None = None,
    step: float | None = None,
    order: int | None = None,
    progress: bool | Any | None = None,
    throw: bool = True,
    tolerance: float | None = None,
    estimate_error: bool = True,
    save: int = 1,
    resumable: bool = False,
    memory: Sequence[Array] | None = None,
) -> Trajectory:
    """Return the motion of a system from a state at the first time, sampled at all times.

    Methods of ours but ``Taylor`` take equal steps from each time to the next, so that samples are steps. ``Taylor``
    and diffrax's solvers step adaptively, the latter with tolerance 1e-12, and end where one of the system's events
    does: the last sample is then the event's own, and ``outcome`` names it. Each copy of a batch ends at its own event:
    its samples from there on are infinite, and ``ends`` has time and state of its end. ``polhode.solve`` makes the same
    runs but Taylor's as a pure function, and can save functions of the states instead of the states.

    Args:
        system: to simulate.
        state: packed (…, n) or (…, *element_shape): of a Lie–Poisson system a point of the dual, with the attitude in
            front where the system carries one and it is wanted. Leading axes are a batch.
        times: (T,) [s], in one direction.
        method: a class of ``polhode.integrators``, an object of one, made for this system with its own step and order,
            or any diffrax solver. By default ``Taylor``, which is exact to rounding by the fewest steps. Where rates of
            change have more than 20,000 operations, jumps along which it slides or a singularity on the way, and where
            ``step``, ``order``, ``resumable`` or ``memory`` is given, it is splitting into exact flows if a Lie–Poisson
            system has them, the spherical midpoint rule for spins, else Lie's midpoint rule; diffrax's ``Dopri8`` for
            any other system, and for one that overrides ``vector_field``.
        step: largest step [s]; by default Taylor's and diffrax's own, of other methods that in which each copy's
            fastest rotation at the start turns by 0.2 rad at order 8, 0.1 at order 6, 0.05 at lower orders.
        order: of the method, by default its own.
        progress: whether to show it on standard error, by default for long runs on a terminal; or an object with the
            methods of diffrax's progress meters, which receives it and may end the run by an exception.
        throw: raise if an implicit step fails in any copy; otherwise the outcome says so, and the states of that copy
            after it are infinite.
        tolerance: of the error relative to the state's size, instead of a step. Steps are shortened until
            ``error_estimate`` is below it. diffrax's solvers take it as the tolerance of a step.
        estimate_error: whether to run again and say by ``error_estimate`` how far the motion is from the true one. Our
            methods are run with other steps, and twice from starts a rounding away, which near a saddle grows to most
            of the error: this costs one and a half times the first run, four times where samples are a step apart.
            Adaptive steps are run with another tolerance. Pulses shorter than 1/131072 of the time need ``jumps``.
        save: every how many-th of the times is kept as a sample, so that a long run need not fill the memory; the steps
            are those to all times.
        resumable: whether the trajectory keeps its ``memory``, which needs a method of equal steps, or one state that
            moves by series of whole arrays, and a last time that is saved.
        memory: that of an earlier trajectory by the same method and step, whose last state is given: the motion then
            goes on as if it had not been interrupted, to the last bit (by series: where the times are exact in binary).
            ``write_dataset`` keeps it.

    Returns:
        Trajectory with ``invariants``, ``balances`` and their ``drift``, ``statistics`` of steps and iterations (the
        most of all copies), and ``error_estimate``.

    Raises:
        InvalidInput: for wrong shapes, a state with NaN, times out of order, a step that is not positive, or a system
            whose energy, velocity, generator and flows disagree.
        NotConverged: if an implicit step does not converge, adaptive steps shrink to nothing, or no step meets the
            tolerance.
    """
    refuse_other_objects(system)
    state, times = system.check_state(state), advancing_times(times)
    if np.ndim(state) < system.state_axes:
        raise InvalidInput(f"`state` must be a list of numbers, as [1.0]; got the single number {shown(float(state))}.")
    if 0 in np.shape(state):
        raise InvalidInput(f"`state` has no copies to move; got shape {np.shape(state)}. Give at least one.")
    for name, value, unit in (("step", step, " time [s]"), ("tolerance", tolerance, " number")):
        if value is not None and not is_positive(value):
            raise InvalidInput(f"`{name}` must be a positive finite{unit}; got {shown(value)}.")
    if tolerance is not None and tolerance < EPS:
        raise InvalidInput(
            f"`tolerance` must be at least {EPS:.2g}, a rounding; got {shown(tolerance)}. Leave it out for the default."
        )
    if step is not None and tolerance is not None and not (is_adaptive(method) or is_series(method)):
        raise InvalidInput("give `step` or `tolerance`, which chooses the step, not both.")
    every = check_every(save, len(times))
    asked = _Asked(step, order, progress, throw, tolerance, estimate_error, every, resumable, memory)
    if resumable and (len(times) - 1) % every:
        raise InvalidInput(f"`resumable` needs the last time among the saved ones; `save` {every} leaves it out.")
    with warnings.catch_warnings():
        # diffrax warns of complex states in general; our solvers' arithmetic is tested on them
        warnings.filterwarnings("ignore", message="Complex dtype support in Diffrax")
        if isinstance(system, AbstractLiePoissonSystem):
            check_agreement(system, state, times, by_flows=_would_split(system, method))
        resumed = resumable or memory is not None
        if is_series(method) and not (resumed and not goes_by_arrays(system, state)):
            return _by_series(system, state, times, method, asked)
        if method is None and (step, order) == (None, None) and (system.series_of_arrays or not resumed):
            return _by_series_or_other_steps(system, state, times, asked)
        return _by_other_steps(system, state, times, method, asked)


def _by_series_or_other_steps(system: AbstractSystem, state: Array, times: np.ndarray, asked: _Asked) -> Trajectory:
    """Move by series those copies that have one up to their end, and the others by other steps.

    So each copy moves as it does alone, whatever moves beside it.
    """
    batch = np.shape(state)[: np.ndim(state) - system.state_axes]
    without, singular = np.zeros(batch, bool), ""
    while not without.all():
        try:
            found = _by_series(system, state[~without] if without.any() else state, times, None, asked)
        except NoSeries as error:
            some = np.ones(1, bool) if error.copies is None else np.ravel(np.asarray(error.copies))
            without[~without] = some if some.any() else True
            singular = error.singular or singular
            continue
        if not without.any():
            return found
        rest = _by_steps_after_series(system, state[without], times, asked, singular)
        return _join(system, without, found, rest, asked)
    return _by_steps_after_series(system, state, times, asked, singular)


def _by_steps_after_series(
    system: AbstractSystem, state: Array, times: np.ndarray, asked: _Asked, singular: str
) -> Trajectory:  # fmt: skip
    """Move by other steps what series do not follow; where these fail at a singularity as well, it is that.

    Steps may also jump over one, and are then far off.
    """
    refusal = NotConverged(f"the motion comes to a singularity {singular}: its Taylor series end there, and other "
                           "steps do not pass it. Give an earlier last time.")  # fmt: skip
    try:
        rest = _by_other_steps(system, state, times, None, asked)
    except NotConverged as error:
        if not singular:
            raise
        raise refusal from error
    if singular and asked.throw and rest.error_estimate is not None and np.max(rest.error_estimate) > PASSED:
        raise refusal
    return rest


def _join(
    system: AbstractSystem, without: Bool[np.ndarray, "*batch"], found: Trajectory, rest: Trajectory, asked: _Asked
) -> Trajectory:  # fmt: skip
    """Return the copies of two trajectories as those of one."""

    def together(ours: Any, others: Any) -> np.ndarray:
        ours, others = np.asarray(ours), np.asarray(others)
        joined = np.empty((*without.shape, *ours.shape[1:]), np.result_type(ours, others))
        joined[~without], joined[without] = ours, others
        return joined

    ours, others = found.ends, rest.ends
    assert ours is not None and others is not None, "a batch has ends"
    status, event, time, state = (together(ours[k], others[k]) for k in range(4))
    received = {name: together(value, rest.received[name]) for name, value in found.received.items()}
    error = None
    if found.error_estimate is not None:
        unknown = np.full(len(rest.states), np.inf)
        error = together(found.error_estimate, unknown if rest.error_estimate is None else rest.error_estimate)
    steps = max(run.statistics["steps"] for run in (found, rest))
    ends = Ends(status, event, time, state, ours.events)
    motion = AdaptiveMotion(np.asarray(found.times), together(found.states, rest.states), received, None,
                            status != Status.NOT_CONVERGED, steps, ends)  # fmt: skip
    return _finish(system, "the method", motion, error, asked.throw)


def _by_other_steps(system: AbstractSystem, state: Array, times: np.ndarray, method: Any, asked: _Asked) -> Trajectory:
    if isinstance(system, AbstractLiePoissonSystem) and not is_series(method):
        if goes_along_orbit(system, method):
            return _by_equal_steps(system, state, times, method, asked)
    if asked.resumable or asked.memory is not None:
        raise InvalidInput(
            "`resumable` and `memory` go with methods of equal steps, and Taylor series of large arrays; others "
            "start over."
        )
    return _by_adaptive_steps(system, state, times, method, asked)


def _find_singularity(motion: AdaptiveMotion, failed: Bool[np.ndarray, "copies"]) -> str:
    """Return between which times series end, of the copy where they do first."""
    states, times = np.asarray(motion.states), np.asarray(motion.times)
    rows = states.reshape(len(failed), len(times), -1)[failed]
    ended = int(np.argmax(~np.isfinite(rows).all(axis=(0, 2))))
    return f"between {times[max(ended - 1, 0)]:.6g} and {times[ended]:.6g} s"


def _by_adaptive_steps(
    system: AbstractSystem, state: Array, times: np.ndarray, method: Any, asked: _Asked
) -> Trajectory:
    solver = adaptive_solver(system, method, asked.order)
    motion, named = _solve_past_jumps(system, solver, state, times, _meter(asked.progress), asked)
    error: Any = None
    if asked.estimate_error and not np.any(motion.successful):
        error = np.full(np.shape(motion.successful), np.inf)
    elif asked.estimate_error and not (asked.throw and not np.all(motion.successful)):
        error = adaptive_error(named, solver, state, times, motion, asked.step, asked.tolerance, asked.every)
    if asked.throw and not np.all(motion.successful):
        check_finite_rates(system, times[0], state)
    return _finish(system, type(solver).__name__, motion, error, asked.throw)


def _by_series(system: AbstractSystem, state: Array, times: np.ndarray, method: Any, asked: _Asked) -> Trajectory:
    by_default, state = method is None, np.asarray(state)  # parts of which take JAX longer
    if by_default and not has_short_series(system, state):
        raise NoSeries(f"the rates of change of {type(system).__name__} are too many operations.")
    method = Taylor(asked.order) if method in (None, Taylor) else method
    if asked.order is not None and method.order != asked.order:
        raise InvalidInput("Give `order` only with the class `Taylor`; `Taylor(order=…)` already has one.")
    named, meter = name_jumps(system, find_undeclared_jumps(system, state, times)), _meter(asked.progress)
    if asked.tolerance is not None and asked.estimate_error:
        arguments = named, method, state, times, meter, asked.step, asked.tolerance, asked.every
        motion, error = series_to_tolerance(*arguments)
    else:
        arguments = named, method, state, times, meter, asked.step, asked.tolerance, asked.every, asked.memory
        motion, error = solve_with_error(*arguments) if asked.estimate_error else (solve_by_series(*arguments), None)
    if asked.throw and not np.all(motion.successful):
        check_finite_rates(system, times[0], state)
    if by_default and not np.all(motion.successful):
        failed = ~np.ravel(motion.successful)
        raise NoSeries("its motion comes to a singularity.", failed, singular=_find_singularity(motion, failed))
    trajectory = _finish(system, type(method).__name__, motion, error, asked.throw)
    if asked.resumable and motion.memory is None:
        raise InvalidInput("`resumable` of Taylor goes with one state of a system without events, jumps and balances.")
    return replace(trajectory, memory=motion.memory) if asked.resumable else trajectory


def _completed(system: AbstractSystem) -> Outcome:
    """Return the outcome of a run to its last time, which says what of the system's algebra is not watched."""
    algebra = getattr(system, "algebra", None)
    return Outcome(Ending.COMPLETED, message=getattr(algebra, "unwatched", ""))


def _finish(system: AbstractSystem, name: str, motion: AdaptiveMotion, error: Array | None, throw: bool) -> Trajectory:
    failed = np.argwhere(~motion.successful)
    which = "" if not np.ndim(motion.successful) or not len(failed) else (
        f" in {len(failed)} of {motion.successful.size} copies, first {_indices(failed[0])}")  # fmt: skip
    if throw and len(failed):
        raise NotConverged(
            f"{name} could not hold its tolerance after {motion.steps} steps{which}: the motion runs "
            "into a singularity, leaves the finite numbers, or its rates jump. End it earlier; let the system name the "
            "times of jumps as `jumps`; where it comes to rest at a jump, as by dry friction, make that a steep slope."
        )
    ended = np.asarray(motion.ends.status) == Status.EVENT
    if motion.event:
        outcome = Outcome(Ending.EVENT, motion.event)
    elif len(failed):
        outcome = Outcome(Ending.NOT_CONVERGED, message=f"{name} failed{which}")
    elif ended.any():
        names = [motion.ends.events[k] for k in np.unique(np.asarray(motion.ends.event)[ended])]
        said = "" if ended.all() else f"in {int(ended.sum())} of {ended.size} copies"
        outcome = Outcome(Ending.EVENT, " or ".join(names), said)
    else:
        outcome = _completed(system)
    steps, ends = {"steps": motion.steps}, motion.ends if np.ndim(motion.successful) else None
    return make_trajectory(system, motion.times, motion.states, outcome, steps, motion.received, error, ends)


def _solve_past_jumps(
    system: AbstractSystem, solver: Any, state: Array, times: np.ndarray, meter: Any, asked: _Asked
) -> tuple[AdaptiveMotion, AbstractSystem]:
    """Return the motion, and the system with those jumps named that it does not name itself.

    They are sought at the start, and again along the motion; what is found only there makes a second run.
    """
    named = name_jumps(system, find_undeclared_jumps(system, state, times))
    arguments = (solver, state, times, meter, asked.step, asked.tolerance, asked.every)
    motion = solve_adaptively(named, *arguments)
    later = jumps_along(system, motion.states, motion.times)
    known = jumps_between(times, named.jumps)
    near = np.abs(later[:, None] - known).min(axis=-1, initial=np.inf) <= 1e-14 * np.ptp(times)
    if near.all():
        return motion, named
    named = name_jumps(named, later[~near])
    return solve_adaptively(named, *arguments), named


def _by_equal_steps(
    system: AbstractLiePoissonSystem, state: Array, times: np.ndarray, method: Any, asked: _Asked
) -> Trajectory:
    from polhode.integrators._accuracy import run_to_tolerance, run_with_error
    from polhode.integrators._equal_steps import run_by_equal_steps, step_counts

    own, system = system, name_jumps(system, find_undeclared_jumps(system, state, times))
    made = isinstance(method, integrators.AbstractOrbitSolver)
    if system is not own and made and bool(eqx.tree_equal(method.system, own)):
        method = eqx.tree_at(lambda solver: solver.system, method, system)
    rates = _rates(system, state, times)
    if not np.isfinite(rates).all():
        check_finite_rates(system, times[0], state)
        raise InvalidInput(
            f"`state` is too large: the rate of turning of {type(system).__name__} at it overflows. "
            "Choose units in which it is nearer to one."
        )
    solver, sizes = _prepare(system, method, rates, times, asked)
    longest = float(np.max(sizes * rates, initial=0.0))
    if longest > TOO_LONG and asked.tolerance is None:
        at = float(np.ravel(sizes)[np.argmax(sizes * rates)])
        warnings.warn(
            f"a step of {at:.3g} s turns the fastest rotation by {longest:.3g} rad; "
            f"below {TOO_LONG * at / longest:.3g} s it is resolved.",
            stacklevel=3,
        )
    counts = step_counts(times, sizes).sum(axis=-1)
    shown = asked.progress if asked.progress is not None else counts.max() > LONG_RUN and sys.stderr.isatty()
    arguments = solver, state, times, sizes, rates
    memory = None if asked.memory is None else restore_memory(solver, state, asked.memory)
    if asked.tolerance is not None:
        if memory is not None:
            raise InvalidInput("`memory` goes with the earlier run's `step`; `tolerance` would choose another.")
        run, sizes, error = run_to_tolerance(*arguments, asked.tolerance, _meter(shown), _meter(False), asked.every)
    elif asked.estimate_error:
        run, sizes, error = run_with_error(*arguments, _meter(shown), _meter(False), asked.every, memory)
    else:
        run, error = run_by_equal_steps(*arguments, _meter(shown), asked.every, memory), None
    steps = step_counts(times, sizes).sum(axis=-1)
    statistics = {"steps": int(steps.max()), "iterations": int(run.iterations.max())}
    name, failed, ends = type(solver).__name__, np.argwhere(~run.fine), None
    if len(failed):
        which = "" if not run.fine.ndim else f" in {len(failed)} of {run.fine.size} copies, first {_indices(failed[0])}"
        if asked.throw:
            raise NotConverged(
                f"the {name} step did not converge, or the state left the finite numbers{which}. Take a shorter "
                "`step`, or an explicit method such as MuntheKaas; with `throw=False` the other copies are returned."
            )
        outcome = Outcome(Ending.NOT_CONVERGED, message=f"{name} failed{which}")
    else:
        outcome = _completed(own)
    if run.fine.ndim:
        status = np.where(run.fine, Status.COMPLETED, Status.NOT_CONVERGED)
        ends = Ends(status, np.full(status.shape, -1), np.where(run.fine, times[-1], np.nan), run.last)
    trajectory = make_trajectory(own, times[:: asked.every], run.states, outcome, statistics, {}, error, ends)
    if error is not None and "energy" in trajectory.drift:
        # runs by steps of two lengths may miss the same corner by the same; the energy shows it
        trajectory = replace(trajectory, error_estimate=np.fmax(error, trajectory.drift["energy"]))
    return replace(trajectory, memory=tuple(jax.tree.leaves(run.memory))) if asked.resumable else trajectory


def _indices(where: np.ndarray) -> str:
    return str(int(where[0])) if len(where) == 1 else str(tuple(int(k) for k in where))


def _prepare(
    system: AbstractLiePoissonSystem, method: Any, rates: Array, times: np.ndarray, asked: _Asked
) -> tuple[Any, Array]:
    """Return the solver and each copy's largest step."""
    if isinstance(method, integrators.AbstractOrbitSolver):
        if asked.step is not None or asked.order is not None or asked.tolerance is not None:
            raise InvalidInput(
                "`step`, `order` and `tolerance` go with a class of methods; the solver given was made with its own."
            )
        if not bool(eqx.tree_equal(method.system, system)):
            raise InvalidInput("`method` was made for another system; make it with the one that is simulated.")
        solver, sizes = method, np.full(rates.shape, float(method.step_size))
    else:
        solver = orbit_solver(system, method, asked.order)
        angle = step_angle(solver.order(None))
        with np.errstate(divide="ignore"):
            sizes = np.full(rates.shape, float(asked.step)) if asked.step is not None else angle / rates
    # no step is longer than from sample to sample
    return solver, np.minimum(sizes, float(np.abs(np.diff(times)).max()))


def _rates(system: AbstractLiePoissonSystem, state: Array, times: Array) -> np.ndarray:
    return np.asarray(turning_rates(system, state, jnp.asarray([times[0], times[-1]], float)), dtype=float)


def _would_split(system: AbstractLiePoissonSystem, method: Any) -> bool:
    if method is None:
        return bool(system.flows) and moves_by_generator(system)
    return isinstance(method, integrators.Splitting) or (
        isinstance(method, type) and issubclass(method, integrators.Splitting)
    )


def _meter(wanted: Any) -> Any:
    if wanted is None or isinstance(wanted, bool | np.bool_):
        return diffrax.TqdmProgressMeter() if wanted else None
    return wanted

"""``simulate``: from a system and a state to a trajectory."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode._base.long_work import as_one_work, silent
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._adaptive import AdaptiveMotion, adaptive_error, solve_adaptively
from polhode.integrators._series import NoSeries, solve_by_series
from polhode.integrators._series_error import series_to_tolerance, solve_with_error
from polhode.integrators.probing import jumps_along, jumps_between, name_jumps
from polhode.motion._outcome import Ending, Ends, Outcome, Status
from polhode.motion._plan import MotionPlan, Stepping
from polhode.motion._trajectory import Trajectory
from polhode.planning import (
    ARRAYS,
    NUMBERS,
    XLA,
    Method,
    Prepared,
    Request,
    check_request,
    prepare,
    prepare_without_series,
    without_warnings,
)
from polhode.solving import restore_memory
from polhode.systems._forms import check_finite_rates
from polhode.systems.base import AbstractSystem
from polhode.systems.trajectories import make_trajectory
from polhode.taylor.runs import choose_precision
from polhode.taylor.written_values import tell
from polhode.types import Array, ArrayLike, ArrayOrFloat, Bool, Float64, Real

TOO_LONG = 1.0  # rad in a step from which a given step draws a warning
PASSED = 0.1  # error of a motion whose series end at a singularity, above which it has not gone past that
LONG_RUN = 2_000_000  # steps from which progress is shown, on a terminal


@known_numbers_only
def simulate(
    system: AbstractSystem,
    state: Real[ArrayLike, "..."],
    times: Real[ArrayLike, "time"],
    method: Method = None,
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

    The motion goes by a plan, which ``polhode.plan`` tells beforehand and ``Trajectory.plan`` keeps. Methods of ours
    but ``Taylor`` take equal steps from each time to the next, so that samples are steps. ``Taylor`` and diffrax's
    solvers step adaptively, the latter with tolerance 1e-12, and end where one of the system's events does: the last
    sample is then the event's own, and ``outcome`` names it. Each copy of a batch ends at its own event: its samples
    from there on are infinite, and ``ends`` has time and state of its end. ``polhode.solve`` makes the same runs but
    Taylor's as a pure function, and can save functions of the states instead of the states.

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
        progress: whether to show it on standard error; by default for long runs on a terminal, and anywhere by one line
            after half a minute. Or an object with the methods of diffrax's progress meters, which receives it and may
            end the run by an exception.
        throw: raise if an implicit step fails in any copy; otherwise the outcome says so, and the states of that copy
            after it are infinite.
        tolerance: of the error relative to the state's size, instead of a step. Steps are shortened until
            ``error_estimate`` is below it. diffrax's solvers take it as the tolerance of a step.
        estimate_error: whether to run again and say by ``error_estimate`` how far the motion is from the true one. Our
            methods are run with other steps, and twice from starts a rounding away, which near a saddle grows to most
            of the error: this costs one and a half times the first run, four times where samples are a step apart; by
            series as much again, six times where errors grow or series are of whole arrays. Adaptive steps are run with
            another tolerance. Pulses shorter than 1/131072 of the time need ``jumps``.
        save: every how many-th of the times is kept as a sample, so that a long run need not fill the memory; the steps
            are those to all times.
        resumable: whether the trajectory keeps its ``memory``, which needs a method of equal steps, or one state that
            moves by series of whole arrays, and a last time that is saved.
        memory: that of an earlier trajectory by the same method and step, whose last state is given: the motion then
            goes on as if it had not been interrupted, to the last bit (by series: where the times are exact in binary).
            ``write_dataset`` keeps it.

    Returns:
        Trajectory with ``invariants``, ``balances`` and their ``drift``, ``statistics`` of steps and iterations (the
        most of all copies), ``error_estimate``, and the ``plan`` by which it went.

    Raises:
        InvalidInput: for wrong shapes, a state with NaN, times out of order, a step that is not positive, or a system
            whose energy, velocity, generator and flows disagree.
        NotConverged: if an implicit step does not converge, adaptive steps shrink to nothing, or no step meets the
            tolerance.
    """
    with silent(progress is not None), as_one_work("the motion"):
        request = check_request(
            system, state, times, method=method, step=step, order=order, tolerance=tolerance, save=save,
            resumable=resumable, memory=memory, progress=progress, throw=throw, estimate_error=estimate_error,
        )
        prepared = prepare(request)
        if prepared.plan.stepping is Stepping.SERIES and method is None:
            return _by_series_or_other_steps(request, prepared)
        return _run(request, prepared)


def _run(request: Request, prepared: Prepared) -> Trajectory:
    """Return the motion as it was planned."""
    if prepared.plan.stepping is Stepping.SERIES:
        return _by_series(request, prepared)
    with without_warnings():
        if prepared.plan.stepping is Stepping.EQUAL_STEPS:
            return _by_equal_steps(request, prepared)
        return _by_adaptive_steps(request, prepared)


def _by_series_or_other_steps(request: Request, prepared: Prepared) -> Trajectory:
    """Move by series those copies that have one up to their end, and the others by other steps.

    So each copy moves as it does alone, whatever moves beside it.
    """
    without, singular, obstacles = np.zeros(request.batch_shape, bool), "", dict[str, None]()
    while not without.all():
        some = request.of_copies(~without)
        try:
            moved = _by_series(some, prepared)
        except NoSeries as error:
            copies = np.ones(1, bool) if error.copies is None else np.ravel(np.asarray(error.copies))
            without[~without] = copies if copies.any() else True
            singular, obstacles[error.why] = error.singular or singular, None
            continue
        if not without.any():
            return moved
        rest = _by_steps_after_series(request.of_copies(without), " or ".join(obstacles), singular)
        return _join(request, without, moved, rest)
    return _by_steps_after_series(request, " or ".join(obstacles), singular)


def _by_steps_after_series(request: Request, obstacle: str, singular: str) -> Trajectory:
    """Move by other steps what series do not follow; where these fail at a singularity as well, it is that.

    Steps may also jump over one, and are then far off.
    """
    refusal = NotConverged(f"the motion comes to a singularity {singular}: its Taylor series end there, and other "
                           "steps do not pass it. Give an earlier last time.")
    try:
        rest = _run(request, prepare_without_series(request, obstacle))
    except NotConverged as error:
        if not singular:
            raise
        raise refusal from error
    if singular and request.throw and rest.error_estimate is not None and np.max(rest.error_estimate) > PASSED:
        raise refusal
    return rest


def _join(
    request: Request, without: Bool[np.ndarray, "*batch"], moved: Trajectory, rest: Trajectory
) -> Trajectory:
    """Return the copies of two trajectories as those of one."""

    def together(ours: Any, others: Any) -> np.ndarray:
        ours, others = np.asarray(ours), np.asarray(others)
        joined = np.empty((*without.shape, *ours.shape[1:]), np.result_type(ours, others))
        joined[~without], joined[without] = ours, others
        return joined

    ours, others = moved.ends, rest.ends
    assert ours is not None and others is not None, "a batch has ends"
    status, event, time, state = (together(ours[k], others[k]) for k in range(4))
    received = {name: together(value, rest.received[name]) for name, value in moved.received.items()}
    error = None
    if moved.error_estimate is not None:
        unknown = np.full(len(rest.states), np.inf)
        error = together(moved.error_estimate, unknown if rest.error_estimate is None else rest.error_estimate)
    steps = max(run.statistics["steps"] for run in (moved, rest))
    ends = Ends(status, event, time, state, ours.events)
    motion = AdaptiveMotion(np.asarray(moved.times), together(moved.states, rest.states), received, None,
                            status != Status.NOT_CONVERGED, steps, ends)
    assert moved.plan is not None
    plan = replace(moved.plan, otherwise=rest.plan)
    return _finish(request, plan, "the method", motion, error)


def _find_singularity(motion: AdaptiveMotion, failed: Bool[np.ndarray, "copies"]) -> str:
    """Return between which times series end, for the copy where they do first."""
    states, times = np.asarray(motion.states), np.asarray(motion.times)
    rows = states.reshape(len(failed), len(times), -1)[failed]
    ended = int(np.argmax(~np.isfinite(rows).all(axis=(0, 2))))
    return f"between {times[max(ended - 1, 0)]:.6g} and {times[ended]:.6g} s"


def _by_adaptive_steps(request: Request, prepared: Prepared) -> Trajectory:
    solver, state, times = prepared.solver, jnp.asarray(request.state), request.times
    motion, named = _solve_past_jumps(request, solver)
    error: Any = None
    if request.estimate_error and not np.any(motion.successful):
        error = np.full(np.shape(motion.successful), np.inf)
    elif request.estimate_error and not (request.throw and not np.all(motion.successful)):
        error = adaptive_error(named, solver, state, times, motion, request.step, request.tolerance, request.every)
    if request.throw and not np.all(motion.successful):
        check_finite_rates(request.system, times[0], state)
    return _finish(request, prepared.plan, prepared.plan.method, motion, error)


def _by_series(request: Request, prepared: Prepared) -> Trajectory:
    system, method, state = request.system, prepared.solver, request.state
    arguments = request.named, method, state, request.times, _meter(request.progress), request.step
    local = request.tolerance
    if request.tolerance is not None and request.estimate_error:
        motion, error, local = series_to_tolerance(*arguments, request.tolerance, request.every)
    else:
        run = solve_with_error if request.estimate_error else solve_by_series
        done = run(*arguments, request.tolerance, request.every, request.memory)
        motion, error = (done, None) if isinstance(done, AdaptiveMotion) else done
    if request.throw and not np.all(motion.successful):
        check_finite_rates(system, request.times[0], state)
    if request.method is None and not np.all(motion.successful):
        failed = ~np.ravel(motion.successful)
        singular = _find_singularity(motion, failed)
        raise NoSeries("its motion comes to a singularity.", f"it comes to a singularity {singular}", failed,
                       singular=singular)
    order = int(choose_precision(local, method.order, method.is_extended).order)
    plan, copies, engine = prepared.plan, motion.successful.size, ARRAYS if motion.by_arrays else NUMBERS
    if (plan.order, plan.copies, plan.engine) != (order, copies, engine):
        plan = replace(plan, order=order, copies=copies, engine=engine)
    trajectory = _finish(request, plan, plan.method, motion, error)
    if request.resumable and motion.memory is None:
        raise InvalidInput("`resumable` of Taylor goes with one state of a system without events, jumps and balances.")
    return replace(trajectory, memory=motion.memory) if request.resumable else trajectory


def _completed(system: AbstractSystem) -> Outcome:
    """Return the outcome of a run to its last time, which says what of the system's algebra is not watched."""
    algebra = getattr(system, "algebra", None)
    return Outcome(Ending.COMPLETED, message=getattr(algebra, "unwatched", ""))


def _finish(
    request: Request, plan: MotionPlan, name: str, motion: AdaptiveMotion, error: Array | None
) -> Trajectory:
    failed = ~np.asarray(motion.successful)
    which = request.name_copies(failed) if failed.any() else ""
    if request.throw and failed.any():
        raise NotConverged(
            f"{name} could not hold its tolerance after {motion.steps} steps{which}: the motion runs "
            "into a singularity, leaves the finite numbers, or its rates jump. End it earlier; let the system name the "
            "times of jumps as `jumps`; where it comes to rest at a jump, as by dry friction, make that a steep slope."
        )
    ended = np.asarray(motion.ends.status) == Status.EVENT
    if motion.event:
        outcome = Outcome(Ending.EVENT, motion.event)
    elif failed.any():
        outcome = Outcome(Ending.NOT_CONVERGED, message=f"{name} failed{which}")
    elif ended.any():
        names = [motion.ends.events[k] for k in np.unique(np.asarray(motion.ends.event)[ended])]
        said = "" if ended.all() else f"in {int(ended.sum())} of {ended.size} copies"
        outcome = Outcome(Ending.EVENT, " or ".join(names), said)
    else:
        outcome = _completed(request.system)
    steps, ends = {"steps": motion.steps}, motion.ends if np.ndim(motion.successful) else None
    told = None if plan.engine == XLA else tell(request.system, np.asarray(motion.states))
    return make_trajectory(request.system, motion.times, motion.states, outcome, steps, motion.received, error, ends,
                           plan, told)


def _solve_past_jumps(request: Request, solver: Any) -> tuple[AdaptiveMotion, AbstractSystem]:
    """Return the motion, and the system with those jumps named that it does not name itself.

    They are sought at the start, and again along the motion; what appears only there makes a second run.
    """
    system, named, times = request.system, request.named, request.times
    state, meter = jnp.asarray(request.state), _meter(request.progress)
    arguments = solver, state, times, meter, request.step, request.tolerance, request.every
    motion = solve_adaptively(named, *arguments)
    later = jumps_along(system, motion.states, motion.times)
    known = jumps_between(times, named.jumps)
    near = np.abs(later[:, None] - known).min(axis=-1, initial=np.inf) <= 1e-14 * np.ptp(times)
    if near.all():
        return motion, named
    named = name_jumps(named, later[~near])
    return solve_adaptively(named, *arguments), named


def _by_equal_steps(request: Request, prepared: Prepared) -> Trajectory:
    from polhode.integrators._accuracy import run_to_tolerance, run_with_error
    from polhode.integrators._equal_steps import run_by_equal_steps, step_counts

    (plan, solver, sizes, rates), state, times = prepared, jnp.asarray(request.state), request.times
    assert sizes is not None and rates is not None, "equal steps are prepared with these"
    if request.tolerance is None:
        _warn_of_long_steps(sizes, rates)
    counts = step_counts(times, sizes).sum(axis=-1)
    shown = request.progress if request.progress is not None else counts.max() > LONG_RUN and sys.stderr.isatty()
    arguments = solver, state, times, sizes, rates
    memory = None if request.memory is None else restore_memory(solver, state, request.memory)
    if request.tolerance is not None:
        if memory is not None:
            raise InvalidInput("`memory` goes with the earlier run's `step`; `tolerance` would choose another.")
        run, sizes, error = run_to_tolerance(*arguments, request.tolerance, _meter(shown), _meter(False), request.every)
    elif request.estimate_error:
        run, sizes, error = run_with_error(*arguments, _meter(shown), _meter(False), request.every, memory)
    else:
        run, error = run_by_equal_steps(*arguments, _meter(shown), request.every, memory), None
    plan = replace(plan, step=float(np.max(sizes)))
    statistics = {"steps": int(step_counts(times, sizes).sum(axis=-1).max()), "iterations": int(run.iterations.max())}
    failed, ends = ~np.asarray(run.fine), None
    if failed.any():
        which = request.name_copies(failed)
        if request.throw:
            raise NotConverged(
                f"the {plan.method} step did not converge, or the state left the finite numbers{which}. Take a shorter "
                "`step`, or an explicit method such as MuntheKaas; with `throw=False` the other copies are returned."
            )
        outcome = Outcome(Ending.NOT_CONVERGED, message=f"{plan.method} failed{which}")
    else:
        outcome = _completed(request.system)
    if run.fine.ndim:
        status = np.where(run.fine, Status.COMPLETED, Status.NOT_CONVERGED)
        ends = Ends(status, np.full(status.shape, -1), np.where(run.fine, times[-1], np.nan), run.last)
    trajectory = make_trajectory(request.system, times[:: request.every], run.states, outcome, statistics, {}, error,
                                 ends, plan)
    if error is not None and "energy" in trajectory.drift:
        # runs by steps of two lengths may miss the same corner by the same; the energy shows it
        trajectory = replace(trajectory, error_estimate=np.fmax(error, trajectory.drift["energy"]))
    return replace(trajectory, memory=tuple(jax.tree.leaves(run.memory))) if request.resumable else trajectory


def _warn_of_long_steps(sizes: Float64[ArrayOrFloat, "*batch"], rates: Float64[ArrayOrFloat, "*batch"]) -> None:
    longest = float(np.max(sizes * rates, initial=0.0))
    if longest > TOO_LONG:
        at = float(np.ravel(sizes)[np.argmax(sizes * rates)])
        warnings.warn(
            f"a step of {at:.3g} s turns the fastest rotation by {longest:.3g} rad; "
            f"below {TOO_LONG * at / longest:.3g} s it is resolved.",
            stacklevel=5,
        )


def _meter(wanted: Any) -> Any:
    if wanted is None or isinstance(wanted, bool | np.bool_):
        return diffrax.TqdmProgressMeter() if wanted else None
    return wanted

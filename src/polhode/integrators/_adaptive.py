"""Any system by adaptive steps, up to an event, with an estimate of the error.

The error of a step is held to the tolerance relative to each component's size and to its scale. Balances are integrated
with the motion, under the same control. Each copy of a batch has its own steps, scales and end.

Explicit methods are run some steps at a time, always by one compiled function: Python acts on
Ctrl-C, and progress is shown, only between two calls.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import _diffrax as diffrax
from polhode.integrators import _embedded as embedded
from polhode.integrators._difference import EPS, LARGE, TWO_PLACES, difference, starts_a_rounding_away
from polhode.integrators._interrupts import keep_interrupts
from polhode.integrators._sampled import (
    MOST_STEPS,
    Sampled,
    Scales,
    sample_motion,
    scale_system,
    scales,
    start,
    unscale_run,
    with_jumps,
)
from polhode.integrators._windows import inner_windows, split_into_windows
from polhode.integrators.probing import depends_on_time, jumps_between
from polhode.motion._outcome import Ends, Status
from polhode.systems._forms import distances
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Bool, Double, Float64, Integer

TOLERANCE = 1e-12  # of a step, relative; below it rounding of the stages is all that is left


class EstimateLimits(NamedTuple):
    """What bounds the error that two further runs, a tighter and a looser one, show."""

    tighter_factor: float = 10.0  # by which the tolerance of the tighter run is smaller,
    min_tolerance: float = 3e-14  # though not below what stages can hold
    max_step_share: float = 0.6  # of the motion's mean step, the longest step of the tighter run
    error_factor: float = 2.0  # of the distance of the tighter run from the motion
    looser_factor: float = 100.0  # by which the tolerance of the looser run is larger,
    min_looser_gain: float = 20.0  # and by which its error is at least
    min_error_roundings: float = 4.0  # of the last step and of the sample itself


LIMITS = EstimateLimits()


class AdaptiveMotion(NamedTuple):
    """A motion by adaptive steps, as plain arrays.

    Attributes:
        times: (K,) [s] saved samples; of one motion up to its end, the event's own time if one ended it.
        states: (batch…, K, …); infinite after the end of a copy of a batch.
        received: name → the integral of each balance since the first time, (batch…, K).
        event: name of the event that ended the one motion, or None.
        successful: (batch…) whether it reached its end.
        steps: of the copy that took most.
        ends: how each copy ended.
        memory: of one motion by series of arrays, with which it resumes bit for bit, else None.
        steps_of_copies: (batch…) how many each copy took, of a motion by series.
        by_arrays: whether it went by series of whole arrays.
    """

    times: Float64[np.ndarray, "kept"]
    states: Double[np.ndarray, "..."]
    received: Mapping[str, Float64[Array, "*batch kept"]]
    event: str | None
    successful: Bool[np.ndarray, "*batch"]
    steps: int
    ends: Ends
    memory: tuple[Array, ...] | None = None
    steps_of_copies: Integer[Array, "*batch"] | None = None
    by_arrays: bool = False


def solve_adaptively(
    system: AbstractSystem,
    solver: diffrax.AbstractSolver,
    state: Double[Array, "..."],
    times: Float64[np.ndarray, "time"],
    meter: Any = None,
    step: float | None = None,
    tolerance: float | None = None,
    every: int = 1,
) -> AdaptiveMotion:
    """Return the motion at times, or up to the first of the system's events.

    Args:
        system: its rates may depend on time.
        solver: one of diffrax's.
        state: as ``system.check_state`` gives it.
        times: (T,) [s], in one direction.
        meter: of diffrax, for progress.
        step: the largest [s].
        tolerance: of a step, relative.
        every: which of the times are saved.

    Raises:
        InvalidInput: if an event has already happened at the start.
        NotConverged: if it takes too many steps.
    """
    check_events(system, times[0], state)
    largest = None if step is None else jnp.asarray(float(step))
    if meter is None:
        meter = diffrax.NoProgressMeter()
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    states = jnp.reshape(state, (-1, *jnp.shape(state)[len(batch) :])) if batch else state
    allowed = jnp.asarray(TOLERANCE if tolerance is None else tolerance)
    kept = times[::every]
    jumps_between(times, system.jumps)  # refuses times that are not finite
    arguments = (system, solver, states, jnp.asarray(times), jnp.asarray(kept), largest, allowed, meter)
    motion = (_by_stretches if embedded.is_embedded(solver) else _at_once)(*arguments)
    motion = jax.tree.map(np.asarray, motion)  # each operation on a JAX array would be compiled by itself
    steps = int(np.max(motion.steps, initial=0))
    if steps >= MOST_STEPS:
        raise NotConverged(
            f"{MOST_STEPS:.1e} steps did not reach the last time, {times[-1]:g} s, and at most so many are taken. Give "
            "an earlier last time, which is `time.until` in a spec, or follow the motion in parts."
        )
    if batch:
        motion = jax.tree.map(lambda y: np.reshape(y, (*batch, *y.shape[1:])), motion)
    ends = Ends(motion.status, motion.event, motion.end, motion.end_state, tuple(system.events))
    fine = motion.status != Status.NOT_CONVERGED
    if batch or motion.status != Status.EVENT:
        return AdaptiveMotion(kept, motion.saved, motion.received, None, fine, steps, ends)
    last = float(motion.end)
    before = np.abs(kept - times[0]) < abs(last - times[0])
    received = {name: value[before] for name, value in motion.received.items()}
    # one row more, for the event itself
    received = {name: np.append(value, motion.end_received[name]) for name, value in received.items()}
    states = np.concatenate([motion.saved[before], motion.end_state[None]])
    event = tuple(system.events)[int(motion.event)]
    return AdaptiveMotion(np.append(kept[before], last), states, received, event, fine, steps, ends)


def adaptive_error(
    system: AbstractSystem, solver: diffrax.AbstractSolver, state: Double[Array, "..."],
    times: Float64[np.ndarray, "time"], motion: AdaptiveMotion, step: float | None = None,
    tolerance: float | None = None, kept: int = 1,
) -> Float64[Array, "*batch"] | None:
    """Return the estimated error (batch…) of a motion, from two further runs with other steps.

    Beside a saddle, small components have no part in the control of steps: they are as long as samples let them be,
    with any tolerance, and two runs with equal steps have equal errors. So one run holds a tenth of the tolerance by
    steps that are all shorter than the motion's mean step. It is more exact than the motion, and their difference is
    the motion's error, unless both are off by rounding and agree by chance. The other run holds a hundred times the
    tolerance, and its error is at least twenty times larger. Both begin a rounding away, which shows what roundings
    grow to. As they may be near the motion at a few samples by chance, they are also compared with each other in
    between. Events are not compared; where one comes before the second sample the error is None, of a copy in
    a batch infinite.
    """
    own = TOLERANCE if tolerance is None else tolerance
    mean = abs(float(motion.times[-1] - motion.times[0])) / max(motion.steps, 1)
    shorter = LIMITS.max_step_share * mean if step is None else min(LIMITS.max_step_share * mean, step)
    tighter = max(own / LIMITS.tighter_factor, min(own, LIMITS.min_tolerance))
    plans = (tighter, shorter), (LIMITS.looser_factor * own, step)
    windows = 1 if kept > 1 or system.events else inner_windows(len(times), motion.steps // len(times[1:]))
    runs = [
        _run_with_more_samples(partial(_again, system, solver, *plan, kept), start, times, windows)
        for start, plan in zip(starts_a_rounding_away(system, state, places=TWO_PLACES), plans, strict=True)
    ]
    exact, looser = (_apart(system, motion, run) for run, _ in runs)
    if exact is None or looser is None:
        return None
    (off, unknown), (far, unknown_too), between = exact, looser, np.zeros(np.shape(motion.successful))
    if (more := [states for _, states in runs if states is not None])[1:]:
        with np.errstate(invalid="ignore"):
            between = difference(system, *more)
    # where no run met a pulse all agree, which proves nothing
    roundings = motion.steps if depends_on_time(system, state) else LIMITS.min_error_roundings
    shares = LIMITS.error_factor * off, far / LIMITS.min_looser_gain, between / LIMITS.min_looser_gain
    error = np.where(off > LARGE, off, np.max([*shares, np.full(np.shape(off), EPS * roundings)], axis=0))
    fine = motion.successful & runs[0][0].successful & runs[1][0].successful
    return np.where(fine & ~np.asarray(unknown) & ~np.asarray(unknown_too), error, np.inf)


def _again(
    system: AbstractSystem, solver: diffrax.AbstractSolver, tolerance: float, longest: float | None, kept: int,
    start: Array, times: np.ndarray,
) -> AdaptiveMotion:
    return solve_adaptively(system, solver, start, times, None, longest, tolerance, kept)


def _run_with_more_samples(
    again: Callable[[Array, np.ndarray], AdaptiveMotion], start: Array, times: np.ndarray, windows: int
) -> tuple[AdaptiveMotion, np.ndarray | None]:
    """Return a run at the times, and its states at so many times as many; by windows, so that nothing is compiled.

    The states are None where a window fails, for instance where it ends at a jump of rates, which no sample does.
    """
    if windows == 1:
        return again(start, times), None
    first, *later = split_into_windows(times, windows)
    run = again(start, first)
    axis, parts = np.ndim(run.successful), [run.states]
    for part in later:
        if not np.all(run.successful):
            break
        run = again(jnp.asarray(np.take(run.states, -1, axis=axis)), part)
        parts.append(np.take(run.states, np.arange(1, len(part)), axis=axis))
    if not np.all(run.successful):
        return again(start, times), None
    states = np.concatenate(parts, axis=axis)
    at_times = np.take(states, np.arange(0, states.shape[axis], windows), axis=axis)
    return run._replace(times=times, states=at_times), states


def _apart(
    system: AbstractSystem, motion: AdaptiveMotion, other: AdaptiveMotion
) -> tuple[Array, Array] | None:
    """Return the distance of two motions (batch…) and where it is unknown; None if nothing can be compared."""
    count = min(len(motion.times), len(other.times)) - (motion.event is not None or other.event is not None)
    if count < 2:  # the start alone has no error, and says nothing
        return None
    axis = np.ndim(motion.states) - 1 - system.state_axes
    one, two = (np.take(m.states, np.arange(count), axis=axis) for m in (motion, other))
    unknown: Any = np.zeros(np.shape(motion.successful), bool)
    if axis:
        beyond = (motion.ends.beyond(motion.times) | other.ends.beyond(other.times))[..., :count]
        unknown = beyond[..., 1]
        one, two = (np.where(beyond.reshape(*beyond.shape, *(1,) * system.state_axes), 0.0, x) for x in (one, two))
    with np.errstate(invalid="ignore"):
        return difference(system, one, two), unknown


def check_events(system: AbstractSystem, t: float, state: Double[Array, "..."]) -> None:
    """Refuse states (batch…, …) at which one of the system's events has already happened."""
    if not system.events:
        return
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    left = np.asarray(_all_distances(system, jnp.asarray(t), jnp.asarray(state)))
    for name, distance in zip(system.events, np.moveaxis(left, -1, 0), strict=True):
        past = np.argwhere(~(distance > 0.0))
        if len(past):
            which = f" in {len(past)} of {math.prod(batch)} copies, first {tuple(past[0].tolist())}," if batch else ""
            if np.isnan(distance[tuple(past[0])]):
                raise InvalidInput(
                    f"an event must be a number at the start; {name} is NaN there{which.rstrip(',')}. Start where it "
                    "is positive, or write it so that it is a number everywhere."
                )
            raise InvalidInput(
                f"`state` is{which} at or past the event that ends the motion: {name}. Start before it happens."
            )


def _by_stretches(
    system: AbstractSystem, solver: Any, states: Array, times: Array, kept: Array, largest: Array | None,
    tolerance: Array, meter: Any,
) -> Sampled:
    """Return the motion of one state or of a row of them, by an explicit method."""
    by, run = _begin(system, states, times, kept)
    # steps in one call, which take from a tenth of a second to some seconds; eight copies cost about as much as one
    stretch = 20_000 // -(-(run.time.size) // 8)
    first, last = float(times[0]), float(times[-1])
    shown, before = meter.init(), np.zeros(run.time.shape)
    slow = np.zeros(run.time.shape, bool)
    with keep_interrupts() as check:
        for limit in (*range(stretch, MOST_STEPS, stretch), MOST_STEPS):
            run = _stretch(system, solver, by, run, times, kept, largest, tolerance, jnp.asarray(limit))
            status = np.asarray(run.status)
            check()
            reached = np.where(status == embedded.RUNNING, (np.asarray(run.time) - first) / (last - first), 1.0)
            # stuck if at the pace of either of two calls the rest would take more steps than are allowed, as where
            # rates jump and lead back from both sides, and steps are as short as the tolerance makes them
            endless = (1.0 - reached) * stretch > MOST_STEPS * (reached - before)
            status = np.where(endless & slow & (status == embedded.RUNNING), Status.NOT_CONVERGED, status)
            run, slow, before = run._replace(status=jnp.asarray(status)), endless, reached
            shown = meter.step(shown, jnp.asarray(reached.mean()))
            if not (status == embedded.RUNNING).any():
                break
    meter.close(shown)
    return _unscale(system, by, run)


@eqx.filter_jit
def _begin(system: AbstractSystem, states: Array, times: Array, kept: Array) -> tuple[Scales, embedded.Run]:
    def one(state: Array) -> tuple[Scales, embedded.Run]:
        by = scales(system, times[0], state)
        return by, embedded.begin(start(by, state), times, kept, lambda t, y: y)

    return _over_copies(system, states, one)(states)


@eqx.filter_jit
def _stretch(
    system: AbstractSystem, solver: Any, by: Scales, run: embedded.Run, times: Array, kept: Array,
    largest: Array | None, tolerance: Array, limit: Array,
) -> embedded.Run:
    ends, at_jumps = with_jumps(system, times)

    def one(by: Scales, run: embedded.Run) -> embedded.Run:
        return embedded.advance(run, solver, scale_system(system, by), ends, kept, largest, tolerance, limit, at_jumps)

    return (jax.vmap(one) if run.time.ndim else one)(by, run)


@eqx.filter_jit
def _unscale(system: AbstractSystem, by: Scales, run: embedded.Run) -> Sampled:
    def one(by: Scales, run: embedded.Run) -> Sampled:
        return unscale_run(system, by, run.saved, run.end, run.end_state, run.status, run.steps)

    return (jax.vmap(one) if run.time.ndim else one)(by, run)


@eqx.filter_jit
def _at_once(
    system: AbstractSystem, solver: Any, states: Array, times: Array, kept: Array, largest: Array | None,
    tolerance: Array, meter: Any,
) -> Sampled:
    """Return the motion of one state or of a row of them, by one of diffrax's other solvers."""
    one = lambda state: sample_motion(system, solver, state, times, kept, largest, tolerance, meter)  # noqa: E731
    return _over_copies(system, states, one)(states)


def _over_copies(system: AbstractSystem, states: Array, one: Any) -> Any:
    return jax.vmap(one) if jnp.ndim(states) > system.state_axes else one


@eqx.filter_jit
def _all_distances(system: AbstractSystem, t: Array, state: Array) -> Array:
    each = lambda one: distances(system, t, one)  # noqa: E731
    for _ in range(jnp.ndim(state) - system.state_axes):
        each = jax.vmap(each)
    return each(state)

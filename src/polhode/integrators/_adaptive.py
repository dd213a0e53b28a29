"""Any system by adaptive steps, up to an event, with an estimate of the error.

The error of a step is held to the tolerance relative to each component's size and to its scale. Balances are integrated
with the motion, under the same control. Each copy of a batch has its own steps, scales and end.

Explicit methods are run for one stretch of steps after another, always by the same compiled function: Python acts on
Ctrl-C, and progress is shown, only between two calls.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import _diffrax as diffrax
from polhode.integrators import _embedded as embedded
from polhode.integrators._difference import EPS, LARGE, difference, starts_a_rounding_away
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
from polhode.integrators.probing import depends_on_time, jumps_between
from polhode.motion._outcome import Ends, Status
from polhode.systems._forms import distances
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Bool, Double, Float64, Integer

TOLERANCE = 1e-12  # of a step, relative; below it rounding of the stages is all that is left
STRETCH = 20_000  # steps in one call, which take from a tenth of a second to some seconds
ENDLESS = MOST_STEPS  # that the rest would take at the pace of a stretch: a motion that two stretches find so is stuck
AS_ONE = 8  # copies of a batch that cost about as much as one
LOOSER = 100.0  # the tolerance of the second run, by which the error is estimated
GAIN = 20.0  # at least so much larger its error is
STAGES = 3.0  # as many roundings as one each of the first steps makes, in its dozen stages
SAME_STEPS = 0.9  # of the steps, from which on the samples and not the tolerance make those of the second run
CLOSE = 1e-3  # of an interval between samples; a step as short as that costs no accuracy


class AdaptiveMotion(NamedTuple):
    """What came out, on plain arrays.

    Attributes:
        times: (K,) [s] saved samples; of one motion up to its end, the event's own time if one ended it.
        states: (batch…, K, …); infinite after the end of a copy of a batch.
        received: name → what each balance received since the first time, (batch…, K).
        event: name of what ended the one motion, or None.
        successful: (batch…) whether it reached its end.
        steps: how many were taken, by the copy that took most.
        ends: how each copy ended.
        memory: of one motion by series of arrays, with which it goes on to the same bits, else None.
        steps_of_copies: (batch…) how many each copy took, of a motion by series.
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
        system: what moves; its rates may depend on time.
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
    """  # fmt: skip
    check_events(system, times[0], state)
    largest = None if step is None else jnp.asarray(float(step))
    if meter is None:
        meter = diffrax.NoProgressMeter()
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    states = jnp.reshape(state, (-1, *jnp.shape(state)[len(batch) :])) if batch else state
    allowed = jnp.asarray(TOLERANCE if tolerance is None else tolerance)
    kept = times[::every]
    jumps_between(times, system.jumps)  # refuses what is no time
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
) -> Float64[Array, "*batch"] | None:  # fmt: skip
    """Return the estimated error (batch…) of a motion, from further runs with a hundred times the tolerance.

    The error of a motion goes with the tolerance of its steps, so that a second run has nearly all of the difference,
    at about half the steps. Where samples lie so close that each is a step in both runs, every other sample of the
    second is moved next to the one after it, so that every other step is twice as long. What a rounding grows to is
    seen in two runs more, from starts that are a rounding away, as in ``accuracy``. Events are not compared; where one
    comes before the second sample the error is None, of a copy in a batch infinite.
    """
    looser = LOOSER * (TOLERANCE if tolerance is None else tolerance)

    def again(start: Array, at: np.ndarray) -> AdaptiveMotion:
        return solve_adaptively(system, solver, start, at, None, step, looser, kept)

    at, every = times, 1
    other = again(state, at)
    if len(times) > 2 and other.steps > SAME_STEPS * motion.steps:
        at, every = _in_pairs(times), 2
        other = again(state, at)
    deviation = _apart(system, motion, other, kept, every)
    if deviation is None:
        return None
    off, unknown = deviation
    grown = np.zeros(np.shape(off))
    from polhode.integrators._equal_steps import inner_windows, split_into_windows

    windows = 1 if kept > 1 or every > 1 or system.events else inner_windows(len(times), motion.steps // len(times[1:]))

    def along(start: Array) -> np.ndarray | None:
        """Return the motion at more times, as runs may be near to each other by chance at the samples only.

        None where a window fails: one may end where rates jump, which no sample does.
        """
        states = []
        for part in split_into_windows(times, windows):
            more = again(start, part)
            if not np.all(more.successful):
                return None
            states.append(more.states)
            start = jnp.asarray(np.take(more.states, -1, axis=np.ndim(off)))
        return np.concatenate(states, axis=np.ndim(off))

    inner = along(state) if windows > 1 else None
    for kicked in starts_a_rounding_away(system, state):
        states = None if inner is None else along(kicked)
        if inner is not None and states is not None:
            with np.errstate(invalid="ignore"):
                grown = np.maximum(grown, difference(system, inner, states))
            continue
        third = again(kicked, at)
        more = _apart(system, other, third, kept, 1)
        if more is not None:
            grown, unknown = np.maximum(grown, np.where(more[1], 0.0, more[0])), unknown | ~third.successful
    rounding = np.minimum(off, EPS * motion.steps)
    if depends_on_time(system, state):  # a pulse that neither run met makes them alike, which proves nothing
        rounding = np.maximum(rounding, EPS * motion.steps)
    error = np.where(off > LARGE, off, np.max([off / GAIN, rounding, STAGES * grown], axis=0))
    return np.where(motion.successful & other.successful & ~np.asarray(unknown), error, np.inf)


def _apart(
    system: AbstractSystem, motion: AdaptiveMotion, other: AdaptiveMotion, kept: int, every: int
) -> tuple[Array, Array] | None:
    """Return the distance of two motions (batch…) and where it is unknown; None if nothing can be compared."""
    count = min(len(motion.times), len(other.times)) - (motion.event is not None or other.event is not None)
    rows = np.flatnonzero(np.arange(count) * kept % every == 0)
    if len(rows) < 2:  # the start alone has no error, and says nothing
        return None
    axis = np.ndim(motion.states) - 1 - system.state_axes
    one, two = (np.take(m.states, rows, axis=axis) for m in (motion, other))
    unknown: Any = np.zeros(np.shape(motion.successful), bool)
    if axis:
        beyond = (motion.ends.beyond(motion.times) | other.ends.beyond(other.times))[..., rows]
        unknown = beyond[..., 1]
        one, two = (np.where(beyond.reshape(*beyond.shape, *(1,) * system.state_axes), 0.0, x) for x in (one, two))
    with np.errstate(invalid="ignore"):
        return difference(system, one, two), unknown


def _in_pairs(times: np.ndarray) -> np.ndarray:
    """Return as many times (T,), every other moved next to the one after it; so nothing has to be compiled again."""
    moved = times.copy()
    between = np.arange(1, len(times) - 1, 2)
    moved[between] = times[between + 1] - CLOSE * (times[between + 1] - times[between])
    return moved


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
) -> Sampled:  # fmt: skip
    """Return the motion of one state or of a row of them, by an explicit method."""
    by, run = _begin(system, states, times, kept)
    stretch = STRETCH // -(-(run.time.size) // AS_ONE)
    first, last = float(times[0]), float(times[-1])
    shown, before = meter.init(), np.zeros(run.time.shape)
    slow = np.zeros(run.time.shape, bool)
    with keep_interrupts() as check:
        for limit in (*range(stretch, MOST_STEPS, stretch), MOST_STEPS):
            run = _stretch(system, solver, by, run, times, kept, largest, tolerance, jnp.asarray(limit))
            status = np.asarray(run.status)
            check()
            reached = np.where(status == embedded.RUNNING, (np.asarray(run.time) - first) / (last - first), 1.0)
            # as where rates jump and lead back from both sides, and steps are as short as the tolerance makes them
            endless = (1.0 - reached) * stretch > ENDLESS * (reached - before)
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
) -> embedded.Run:  # fmt: skip
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
) -> Sampled:  # fmt: skip
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

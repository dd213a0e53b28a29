"""Any system by one of diffrax's own solvers with adaptive steps, up to what ends its motion.

The error of a step is held to the tolerance relative to each component's size and to its scale. Balances are integrated
with the motion, under the same control. Each copy of a batch has its own steps, scales and end.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import optimistix

from polhode.errors import InvalidInput, NotConverged
from polhode.integrators.difference import EPS, LARGE, difference
from polhode.integrators.either_mode import by_either_mode
from polhode.motion.outcome import Ends, Status
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Bool, Double, Float64, Integer

Observe = Callable[[Float64[Array, ""], Double[Array, "..."]], Any]
TOLERANCE = 1e-12  # of a step, relative; below it rounding of the stages is all that is left
MOST_STEPS = 15_000_000  # of a run, some ten minutes
LOOSER = 100.0  # the tolerance of the second run, by which the error is estimated
GAIN = 30.0  # at least so much larger its error is
SAME_STEPS = 0.9  # of the steps, from which on the samples and not the tolerance make those of the second run
CLOSE = 1e-3  # of an interval between samples; a step as short as that costs no accuracy
TIME_ROUNDING = 2e-15  # of the present time: shorter steps are rounded by a tenth, and a repeated one may be the same
SHORTEST_STEP = 1e-290  # s; at time zero steps advance however short they are
EVENT_TOLERANCE = 1e-15  # of an event's time, relative: a few roundings


class Sampled(NamedTuple):
    """What came out for one copy, or for each copy of a batch.

    Attributes:
        saved: (batch…, K, …) states at the times to save, or what was observed; infinite after the end.
        received: name → what each balance received since the first time, (batch…, K); empty with observations.
        status: (batch…) numbers of ``Status``.
        event: (batch…) which of the system's events ended it, −1 where none did.
        end: (batch…) [s] the event's own time, or the last; NaN where the solver failed.
        end_state: (batch…, …) the state then.
        end_received: name → (batch…) what each balance received until then.
        steps: (batch…) how many were taken.
    """

    saved: Any
    received: dict[str, Float64[Array, "*batch kept"]]
    status: Integer[Array, "*batch"]
    event: Integer[Array, "*batch"]
    end: Float64[Array, "*batch"]
    end_state: Double[Array, "..."]
    end_received: dict[str, Float64[Array, "*batch"]]
    steps: Integer[Array, "*batch"]


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
    """

    times: Float64[np.ndarray, "kept"]
    states: Double[Array, "..."]
    received: dict[str, Float64[Array, "*batch kept"]]
    event: str | None
    successful: Bool[np.ndarray, "*batch"]
    steps: int
    ends: Ends


class EventBisection(optimistix.Bisection):
    """Bisection until the time is known to rounding, whatever the scale of the function that vanishes there."""

    def __init__(self) -> None:
        # events fall from positive values; a copy of a batch without one runs the same search, with no change of sign
        super().__init__(rtol=EVENT_TOLERANCE, atol=0.0, flip=True)

    def terminate(
        self, fn: Any, y: Float64[Array, ""], args: Any, options: Any, state: Any, tags: Any
    ) -> tuple[Bool[Array, ""], optimistix.RESULTS]:
        width = jnp.abs(state.upper - state.lower)
        narrow = width <= self.rtol * jnp.maximum(jnp.abs(state.upper), jnp.abs(state.lower))
        return narrow, optimistix.RESULTS.successful


class PresentTimeControl(diffrax.PIDController):
    """Step control whose shortest step is a rounding of the present time, whatever the last time is.

    A motion that ends after a minute must not depend on whether it was asked for up to an hour or up to an age.
    """

    def _at(self, *times: Any) -> diffrax.PIDController:
        present = jnp.max(jnp.abs(jnp.stack([jnp.asarray(t) for t in times])))
        least = jnp.maximum(TIME_ROUNDING * present, SHORTEST_STEP)
        return diffrax.PIDController(rtol=self.rtol, atol=self.atol, dtmin=least, dtmax=self.dtmax, force_dtmin=False)

    def init(self, terms: Any, t0: Any, *args: Any, **named: Any) -> Any:
        return self._at(t0).init(terms, t0, *args, **named)

    def adapt_step_size(self, t0: Any, t1: Any, *args: Any, **named: Any) -> Any:
        return self._at(t0, t1).adapt_step_size(t0, t1, *args, **named)


class _Carried(NamedTuple):
    """State over its scales, and what the balances received over theirs."""

    state: Array
    received: dict[str, Array]


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
    _check_events(system, times[0], state)
    largest = None if step is None else jnp.asarray(float(step))
    if meter is None:
        meter = diffrax.NoProgressMeter()
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    states = jnp.reshape(state, (-1, *jnp.shape(state)[len(batch) :])) if batch else state
    allowed = jnp.asarray(TOLERANCE if tolerance is None else tolerance)
    kept = times[::every]
    run = _each_sampled if batch else _one_sampled
    found = run(system, solver, states, jnp.asarray(times), jnp.asarray(kept), largest, allowed, meter)
    found = jax.tree.map(np.asarray, found)  # each operation on a JAX array would be compiled by itself
    steps = int(np.max(found.steps, initial=0))
    if steps >= MOST_STEPS:
        raise NotConverged(
            f"{MOST_STEPS:.1e} steps did not reach the last time, {times[-1]:g} s, and at most so many are taken. Give "
            "an earlier last time, which is `time.until` in a spec, or follow the motion in parts."
        )
    if batch:
        found = jax.tree.map(lambda y: np.reshape(y, (*batch, *y.shape[1:])), found)
    ends = Ends(found.status, found.event, found.end, found.end_state, tuple(system.events))
    fine = found.status != Status.NOT_CONVERGED
    if batch or found.status != Status.EVENT:
        return AdaptiveMotion(kept, found.saved, found.received, None, fine, steps, ends)
    last = float(found.end)
    before = np.abs(kept - times[0]) < abs(last - times[0])
    received = {name: value[before] for name, value in found.received.items()}
    # one row more, for the event itself
    received = {name: np.append(value, found.end_received[name]) for name, value in received.items()}
    states = np.concatenate([found.saved[before], found.end_state[None]])
    event = tuple(system.events)[int(found.event)]
    return AdaptiveMotion(np.append(kept[before], last), states, received, event, fine, steps, ends)


def adaptive_error(
    system: AbstractSystem, solver: diffrax.AbstractSolver, state: Double[Array, "..."],
    times: Float64[np.ndarray, "time"], motion: AdaptiveMotion, step: float | None = None,
    tolerance: float | None = None, kept: int = 1,
) -> Float64[Array, "*batch"] | None:  # fmt: skip
    """Return the estimated error (batch…) of a motion, from a second run with a hundred times the tolerance.

    The error of a motion goes with the tolerance of its steps, so that the second run has nearly all of the difference,
    at about half the steps. Where samples lie so close that each is a step in both runs, every other sample of the
    second is moved next to the one after it, so that every other step is twice as long. Events are not compared; where
    one comes before the second sample the error is None, of a copy in a batch infinite.
    """
    looser = LOOSER * (TOLERANCE if tolerance is None else tolerance)
    other, every = solve_adaptively(system, solver, state, times, None, step, looser, kept), 1
    if len(times) > 2 and other.steps > SAME_STEPS * motion.steps:
        other, every = solve_adaptively(system, solver, state, _in_pairs(times), None, step, looser, kept), 2
    count = min(len(motion.times), len(other.times)) - (motion.event is not None or other.event is not None)
    rows = np.flatnonzero(np.arange(count) * kept % every == 0)
    if len(rows) < 2:  # the start alone has no error, and says nothing
        return None
    axis = np.ndim(motion.states) - 1 - system.state_axes
    one, two = (np.take(m.states, rows, axis=axis) for m in (motion, other))
    unknown = False
    if axis:
        beyond = (motion.ends.beyond(motion.times) | other.ends.beyond(other.times))[..., rows]
        unknown = beyond[..., 1]
        one, two = (np.where(beyond.reshape(*beyond.shape, *(1,) * system.state_axes), 0.0, x) for x in (one, two))
    with np.errstate(invalid="ignore"):
        off = difference(system, one, two)
    rounding = np.minimum(off, EPS * motion.steps)
    error = np.where(off > LARGE, off, np.maximum(off / GAIN, rounding))
    return np.where(motion.successful & other.successful & ~np.asarray(unknown), error, np.inf)


def _in_pairs(times: np.ndarray) -> np.ndarray:
    """Return as many times (T,), every other moved next to the one after it; so nothing has to be compiled again."""
    moved = times.copy()
    between = np.arange(1, len(times) - 1, 2)
    moved[between] = times[between + 1] - CLOSE * (times[between + 1] - times[between])
    return moved


def _check_events(system: AbstractSystem, t: float, state: Array) -> None:
    if not system.events:
        return
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    distances = np.asarray(_all_distances(system, jnp.asarray(t), jnp.asarray(state)))
    for name, distance in zip(system.events, np.moveaxis(distances, -1, 0), strict=True):
        past = np.argwhere(~(distance > 0.0))
        if len(past):
            which = f" in {len(past)} of {math.prod(batch)} copies, first {tuple(past[0].tolist())}," if batch else ""
            raise InvalidInput(
                f"`state` is{which} at or past the event that ends the motion: {name}. Start before it happens."
            )


def sampled(
    system: AbstractSystem, solver: Any, state: Double[Array, "..."], times: Float64[Array, "time"],
    kept: Float64[Array, "kept"], largest: Float64[Array, ""] | None, tolerance: Float64[Array, ""],
    meter: Any = None, observe: Observe | None = None, reverse: bool = False,
) -> Sampled:  # fmt: skip
    """Return the motion of one state, stepping at all times (T,) and saving at those to be kept (K,).

    Args:
        system: what moves.
        solver: one of diffrax's.
        state: one.
        times: (T,) [s], in one direction.
        kept: (K,) some of them.
        largest: step [s], or None.
        tolerance: of a step, relative.
        meter: of diffrax, for progress.
        observe: function of time and state to save instead of the state.
        reverse: whether derivatives are to be of reverse mode, instead of forward mode.
    """
    scale = system.scales(state)
    start = system.balances(times[0], state)
    sizes = {name: jnp.where(balance.value != 0, jnp.abs(balance.value), 1.0) for name, balance in start.items()}

    @jax.jit  # so that it is traced once, however often diffrax asks for it
    def rates(t: Array, y: _Carried, args: Any) -> _Carried:
        now = y.state * scale
        received = {name: balance.rate / sizes[name] for name, balance in system.balances(t, now).items()}
        return _Carried(system.vector_field(t, now) / scale, received)

    # one function whose zero is the first of all, as bisection seeks the zero of one
    nearest = jax.jit(lambda t, now: jnp.min(_distances(system, t, now)))

    def lowest(t: Array, y: _Carried, args: Any, **more: Any) -> Array:
        return nearest(t, y.state * scale)

    def whole(y: _Carried) -> _Carried:
        return _Carried(y.state * scale, {name: y.received[name] * size for name, size in sizes.items()})

    def seen(t: Array, y: _Carried, args: Any) -> Any:
        return whole(y) if observe is None else as_floats(observe(t, y.state * scale))

    control = PresentTimeControl(rtol=tolerance, atol=tolerance, dtmax=largest)
    # samples are steps: interpolation between steps costs three digits
    solution: Any = diffrax.diffeqsolve(
        diffrax.ODETerm(rates), solver, times[0], times[-1], None,
        _Carried(state / scale, {name: jnp.zeros_like(size) for name, size in sizes.items()}), throw=False,
        stepsize_controller=diffrax.ClipStepSizeController(control, step_ts=times),
        saveat=diffrax.SaveAt(subs=[diffrax.SubSaveAt(ts=kept, fn=seen), diffrax.SubSaveAt(t1=True)]),
        event=diffrax.Event(lowest, EventBisection(), direction=False) if system.events else None,
        max_steps=MOST_STEPS, progress_meter=diffrax.NoProgressMeter() if meter is None else meter,
        adjoint=diffrax.RecursiveCheckpointAdjoint() if reverse else diffrax.ForwardMode(),
    )  # fmt: skip
    results: Any = diffrax.RESULTS
    ended = solution.result == results.event_occurred
    fine = ended | (solution.result == results.successful)
    saved, last = solution.ys
    last = whole(jax.tree.map(lambda y: y[0], last))
    time = solution.ts[1][0]
    first = jnp.argmin(_distances(system, time, last.state)) if system.events else jnp.asarray(-1)
    return Sampled(
        saved if observe is not None else saved.state,
        {} if observe is not None else saved.received,
        jnp.where(ended, Status.EVENT, jnp.where(fine, Status.COMPLETED, Status.NOT_CONVERGED)),
        jnp.where(ended, first, -1),
        jnp.where(fine, time, jnp.nan),
        last.state,
        last.received,
        solution.stats["num_steps"],
    )


def sampled_by_either_mode(
    system: AbstractSystem, solver: Any, state: Double[Array, "..."], times: Float64[Array, "time"],
    kept: Float64[Array, "kept"], largest: Float64[Array, ""] | None, tolerance: Float64[Array, ""],
    observe: Observe | None,
) -> Sampled:  # fmt: skip
    """Return what ``sampled`` does, with derivatives of either mode."""

    def forward(given: tuple[Any, ...]) -> Sampled:
        return sampled(*given[:-1], observe=given[-1])

    def reverse(given: tuple[Any, ...]) -> Sampled:
        return sampled(*given[:-1], observe=given[-1], reverse=True)

    return by_either_mode(
        forward, reverse, (system, solver, state, times, kept, largest, tolerance, observe), "solve by adaptive steps"
    )


def as_floats(observed: Any) -> Any:
    """Return a nest of observations as arrays that can be infinite where there is none."""
    return jax.tree.map(lambda x: x if jnp.issubdtype(jnp.result_type(x), jnp.inexact) else jnp.asarray(x, float),
                        jax.tree.map(jnp.asarray, observed))  # fmt: skip


def _distances(system: AbstractSystem, t: Array, state: Array) -> Array:
    """Return the system's events at a state, positive until their zero."""
    return jnp.stack([event(t, state) for event in system.events.values()])


@eqx.filter_jit
def _all_distances(system: AbstractSystem, t: Array, state: Array) -> Array:
    distances = lambda one: _distances(system, t, one)  # noqa: E731
    for _ in range(jnp.ndim(state) - system.state_axes):
        distances = jax.vmap(distances)
    return distances(state)


_one_sampled = eqx.filter_jit(sampled)


@eqx.filter_jit
def _each_sampled(
    system: AbstractSystem, solver: Any, states: Array, times: Array, kept: Array, largest: Array | None,
    tolerance: Array, meter: Any,
) -> Sampled:  # fmt: skip
    return jax.vmap(lambda state: sampled(system, solver, state, times, kept, largest, tolerance, meter))(states)

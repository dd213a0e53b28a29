"""Any system by one of diffrax's own solvers with adaptive steps, up to what ends its motion.

The error of a step is held to the tolerance relative to each component's size and to its scale. Balances are integrated
beside the motion, under the same control. Each copy of a batch has its own steps and scales.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import optimistix

from polhode.errors import InvalidInput, NotConverged
from polhode.integrators.difference import EPS, LARGE, difference
from polhode.systems.base import AbstractSystem

Array = Any
TOLERANCE = 1e-12  # of a step, relative; below it rounding of the stages is all that is left
MOST_STEPS = 15_000_000  # of a run, some ten minutes
LOOSER = 100.0  # the tolerance of the second run, by which the error is estimated
GAIN = 30.0  # at least so much larger its error is
SAME_STEPS = 0.9  # of the steps, from which on the samples and not the tolerance make those of the second run
CLOSE = 1e-3  # of an interval between samples; a step as short as that costs no accuracy
TIME_ROUNDING = 2e-15  # of the present time: shorter steps are rounded by a tenth, and a repeated one may be the same
SHORTEST_STEP = 1e-290  # s; at time zero steps advance however short they are
EVENT_TOLERANCE = 1e-15  # of an event's time, relative: a few roundings


class AdaptiveMotion(NamedTuple):
    """What came out.

    Attributes:
        times: (T,) [s] samples up to the end; the last is the event's own time if one ended the motion.
        states: (batch…, T, …).
        received: name → what each balance received since the first time, (batch…, T).
        event: name of what ended the motion, or None.
        successful: (batch…) whether it reached its end.
        steps: how many were taken, by the copy that took most.
    """

    times: np.ndarray
    states: Array
    received: dict[str, Array]
    event: str | None
    successful: np.ndarray
    steps: int


class EventBisection(optimistix.Bisection):
    """Bisection until the time is known to rounding, whatever the scale of the function that vanishes there."""

    def __init__(self) -> None:
        super().__init__(rtol=EVENT_TOLERANCE, atol=0.0)

    def terminate(
        self, fn: Any, y: Array, args: Any, options: Any, state: Any, tags: Any
    ) -> tuple[Array, optimistix.RESULTS]:
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
    system: AbstractSystem, solver: diffrax.AbstractSolver, state: Array, times: np.ndarray, meter: Any = None,
    step: float | None = None, tolerance: float | None = None,
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

    Raises:
        InvalidInput: if an event has already happened at the start, or for a batch of states with events.
        NotConverged: if it takes too many steps.
    """  # fmt: skip
    _check_events(system, times[0], state)
    largest = None if step is None else jnp.asarray(float(step))
    if meter is None:
        meter = diffrax.NoProgressMeter()
    batch = jnp.shape(state)[: jnp.ndim(state) - system.state_axes]
    states = jnp.reshape(state, (-1, *jnp.shape(state)[len(batch) :])) if batch else state
    allowed = jnp.asarray(TOLERANCE if tolerance is None else tolerance)
    run = _solve_each if batch else _solve
    solution = run(system, solver, states, jnp.asarray(times), largest, allowed, meter)
    _check_reached(solution, times)
    results: Any = diffrax.RESULTS
    steps = int(np.max(solution.stats["num_steps"], initial=0))
    sampled, final = jax.tree.map(np.asarray, solution.ys)  # each operation on a JAX array would be compiled by itself
    if batch:
        ys = jax.tree.map(lambda y: np.reshape(y, (*batch, *y.shape[1:])), sampled)
        fine = np.reshape(np.asarray(jax.vmap(lambda r: r == results.successful)(solution.result)), batch)
        return AdaptiveMotion(times, ys.state, ys.received, None, fine, steps)
    ended = bool(solution.result == results.event_occurred)
    reached = np.isfinite(np.asarray(solution.ts[0])) if ended else np.ones(len(times), bool)
    ts, ys = times[reached], _taken(sampled, reached)
    event = None
    if ended:
        last = float(np.asarray(solution.ts[1])[0])
        state = jnp.asarray(final.state[0])
        event = min(system.events, key=lambda name: float(system.events[name](jnp.asarray(last), state)))
        before = np.abs(ts - times[0]) < abs(last - times[0])
        ts, ys = np.append(ts[before], last), _joined(_taken(ys, before), final)
    fine = np.asarray(ended or bool(solution.result == results.successful))
    return AdaptiveMotion(ts, ys.state, ys.received, event, fine, steps)


def adaptive_error(
    system: AbstractSystem, solver: diffrax.AbstractSolver, state: Array, times: np.ndarray, motion: AdaptiveMotion,
    step: float | None = None, tolerance: float | None = None,
) -> Array | None:  # fmt: skip
    """Return the estimated error (batch…) of a motion, from a second run with a hundred times the tolerance.

    The error of a motion goes with the tolerance of its steps, so that the second run has nearly all of the difference,
    at about half the steps. Where samples lie so close that each is a step in both runs, every other sample of the
    second is moved next to the one after it, so that every other step is twice as long. Events are not compared; None
    where one comes before the second sample.
    """
    looser = LOOSER * (TOLERANCE if tolerance is None else tolerance)
    other, every = solve_adaptively(system, solver, state, times, None, step, looser), 1
    if len(times) > 2 and other.steps > SAME_STEPS * motion.steps:
        other, every = solve_adaptively(system, solver, state, _in_pairs(times), None, step, looser), 2
    count = min(len(motion.times), len(other.times)) - (motion.event is not None or other.event is not None)
    if count <= every:  # the start alone has no error, and says nothing
        return None
    axis = np.ndim(motion.states) - 1 - system.state_axes
    rows = np.arange(0, count, every)
    one, two = (np.take(m.states, rows, axis=axis) for m in (motion, other))
    with np.errstate(invalid="ignore"):
        off = difference(system, one, two)
    rounding = np.minimum(off, EPS * motion.steps)
    error = np.where(off > LARGE, off, np.maximum(off / GAIN, rounding))
    return np.where(motion.successful & other.successful, error, np.inf)


def _in_pairs(times: np.ndarray) -> np.ndarray:
    """Return as many times (T,), every other moved next to the one after it; so nothing has to be compiled again."""
    moved = times.copy()
    between = np.arange(1, len(times) - 1, 2)
    moved[between] = times[between + 1] - CLOSE * (times[between + 1] - times[between])
    return moved


def _check_reached(solution: Any, times: np.ndarray) -> None:
    if int(np.max(np.asarray(solution.stats["num_steps"]))) >= MOST_STEPS:
        raise NotConverged(
            f"{MOST_STEPS:.1e} steps did not reach the last time, {times[-1]:g} s, and at most so many are taken. Give "
            "an earlier last time, which is `time.until` in a spec, or follow the motion in parts."
        )


def _check_events(system: AbstractSystem, t: float, state: Array) -> None:
    if system.events and jnp.ndim(state) > system.state_axes:
        raise InvalidInput(
            f"`state` of {type(system).__name__} must be one state, as each motion ends at a time of its own; "
            f"got shape {jnp.shape(state)}. Simulate them one by one."
        )
    for name, event in system.events.items():
        if not float(event(jnp.asarray(t), state)) > 0.0:
            raise InvalidInput(
                f"`state` is at or past the event that ends the motion: {name}. Start before it happens."
            )


def _solve_one(
    system: AbstractSystem, solver: Any, state: Array, times: Array, largest: Array | None, tolerance: Array, meter: Any
) -> Any:  # fmt: skip
    scale = system.scales(state)
    start = system.balances(times[0], state)
    sizes = {name: jnp.where(balance.value != 0, jnp.abs(balance.value), 1.0) for name, balance in start.items()}

    def rates(t: Array, y: _Carried, args: Any) -> _Carried:
        now = y.state * scale
        received = {name: balance.rate / sizes[name] for name, balance in system.balances(t, now).items()}
        return _Carried(system.vector_field(t, now) / scale, received)

    def lowest(t: Array, y: _Carried, args: Any, **more: Any) -> Array:
        # one function whose zero is the first of all, as bisection seeks the zero of one
        return jnp.min(jnp.stack([event(t, y.state * scale) for event in system.events.values()]))

    control = PresentTimeControl(rtol=tolerance, atol=tolerance, dtmax=largest)
    # samples are steps: interpolation between steps costs three digits
    solution = diffrax.diffeqsolve(
        diffrax.ODETerm(rates), solver, times[0], times[-1], None,
        _Carried(state / scale, {name: jnp.zeros_like(size) for name, size in sizes.items()}), throw=False,
        stepsize_controller=diffrax.ClipStepSizeController(control, step_ts=times),
        saveat=diffrax.SaveAt(subs=[diffrax.SubSaveAt(ts=times), diffrax.SubSaveAt(t1=True)]),
        event=diffrax.Event(lowest, EventBisection(), direction=False) if system.events else None,
        max_steps=MOST_STEPS, progress_meter=meter, adjoint=diffrax.ForwardMode(),
    )  # fmt: skip
    whole = lambda y: _Carried(y.state * scale, {name: y.received[name] * size for name, size in sizes.items()})  # noqa: E731
    saved: Any = solution.ys
    return eqx.tree_at(lambda s: s.ys, solution, [whole(y) for y in saved])


_solve = eqx.filter_jit(_solve_one)


@eqx.filter_jit
def _solve_each(
    system: AbstractSystem, solver: Any, states: Array, times: Array, largest: Array | None, tolerance: Array,
    meter: Any,
) -> Any:  # fmt: skip
    return jax.vmap(lambda state: _solve_one(system, solver, state, times, largest, tolerance, meter))(states)


def _taken(ys: _Carried, which: np.ndarray) -> _Carried:
    return _Carried(ys.state[which], {name: value[which] for name, value in ys.received.items()})


def _joined(ys: _Carried, last: _Carried) -> _Carried:
    received = {name: np.concatenate([value, last.received[name]]) for name, value in ys.received.items()}
    return _Carried(np.concatenate([ys.state, last.state]), received)

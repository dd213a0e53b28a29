"""Explicit Runge–Kutta methods with an embedded error estimate, by adaptive steps from sample to sample.

The tableau is that of a solver of diffrax, and so is the control of the steps. The loop is our own: it holds the rates
of change once, so that it is compiled in a seventh of the time that ``diffrax.diffeqsolve`` takes, and runs several
times as fast. It can be left after so many steps and be entered again.

Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I* (2nd ed.), §II.4 for the control.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import equinox.internal as eqxi
import jax
import jax.numpy as jnp
import numpy as np

from polhode.integrators import _diffrax as diffrax
from polhode.motion._outcome import Status
from polhode.types import Array, Bool, Float64, Integer

RUNNING = -1  # a run that has not ended; otherwise one of ``Status``


class StepLimits(NamedTuple):
    """Thresholds that end a run or an event's search."""

    event_tolerance: float = 1e-15  # of an event's time, relative: a few roundings
    # of the present time: a shorter step would be rounded by a tenth, and repeating it might change nothing
    min_relative_step: float = 2e-15
    min_step: float = 1e-290  # s; at time zero steps advance however short they are


LIMITS = StepLimits()

Rates = Callable[[Float64[Array, ""], Any], Any]
Margin = Callable[[Float64[Array, ""], Any], Float64[Array, ""]]
Saved = Callable[[Float64[Array, ""], Any], Any]


class Problem(NamedTuple):
    """The problem, as functions of time and state.

    Attributes:
        rates: of change.
        margin: a function that falls from positive to zero where an event ends the run, or None.
        seen: the values to save.
    """

    rates: Rates
    margin: Margin | None
    seen: Saved


class Run(NamedTuple):
    """The progress of the run of one copy.

    Attributes:
        interval: the index of the next of the times.
        place: of the next time to save.
        time: [s] reached.
        state: there, any nest of arrays.
        slope: its rate of change there, where the method's last stage gives it; otherwise of no meaning.
        step: the next one [s], signed; zero at the start, where it is not chosen yet.
        low: an event lies behind this offset from ``time`` [s] …
        high: … and not behind this one; zero while there is none.
        beyond: the state at ``high``.
        saved: a nest of arrays (K, …); infinite where not yet reached.
        steps: that were tried.
        status: ``RUNNING``, or one of ``Status``.
    """

    interval: Integer[Array, ""]
    place: Integer[Array, ""]
    time: Float64[Array, ""]
    state: Any
    slope: Any
    step: Float64[Array, ""]
    low: Float64[Array, ""]
    high: Float64[Array, ""]
    beyond: Any
    saved: Any
    steps: Integer[Array, ""]
    status: Integer[Array, ""]

    @property
    def end(self) -> Float64[Array, ""]:
        """The event's time, or the last reached [s]."""
        return self.time + self.high

    @property
    def end_state(self) -> Any:
        """The state at the end."""
        return jax.tree.map(lambda there, here: jnp.where(self.high != 0.0, there, here), self.beyond, self.state)


def is_embedded(method: Any) -> bool:
    """Return whether a solver of diffrax is an explicit Runge–Kutta method with an error estimate."""
    return isinstance(method, diffrax.AbstractERK)


def begin(state: Any, times: Float64[Array, "time"], kept: Float64[Array, "kept"], saved_of: Saved) -> Run:
    """Return a run at its start.

    Args:
        state: any nest of arrays, of about equal sizes.
        times: (T,) [s], in one direction.
        kept: (K,) some of them, with the first.
        saved_of: the values to save at a time and a state.
    """
    first = saved_of(times[0], state)
    saved = jax.tree.map(lambda x: jnp.full((kept.shape[0], *x.shape), jnp.inf, x.dtype).at[0].set(x), first)
    zero, one = jnp.zeros(()), jnp.ones((), int)
    slope = jax.tree.map(jnp.zeros_like, state)
    return Run(one, one, times[0], state, slope, zero, zero, zero, state, saved, jnp.zeros((), int),
               jnp.asarray(RUNNING))


def advance(
    run: Run, method: diffrax.AbstractERK, problem: Problem, times: Float64[Array, "time"],
    kept: Float64[Array, "kept"], largest: Float64[Array, ""] | None, tolerance: Float64[Array, ""],
    limit: Integer[Array, ""] | int, jumps: Bool[Array, "time"] | None = None,
) -> Run:
    """Return the run at its end, or after as many steps as the limit.

    Args:
        run: as ``begin`` or ``advance`` gave it.
        method: an explicit Runge–Kutta method.
        problem: to be integrated.
        times: (T,) [s] that steps end at, in one direction; of equal ones the jumps come last.
        kept: (K,) those to save at.
        largest: step [s], or None.
        tolerance: of a step, relative to each component and to one.
        limit: of the steps since the start of the run.
        jumps: which of the times rates of change jump at; None for a run without.
    """
    rates, margin, saved_of = problem
    order: Any = method.error_order(diffrax.ODETerm(lambda t, y, args: y))
    forth = jnp.sign(times[-1] - times[0])
    count = times.shape[0]

    def unfinished(run: Run) -> jax.Array:
        return (run.status == RUNNING) & (run.steps < limit)

    def body(run: Run) -> Run:
        goal = times[jnp.minimum(run.interval, count - 1)]
        seeking, probing = run.high != 0.0, (run.step == 0.0) & (run.high == 0.0)
        clipped = ~probing & ~seeking & (jnp.abs(run.step) >= jnp.abs(goal - run.time))
        middle = run.low + 0.5 * (run.high - run.low)
        time = jnp.where(clipped, goal, run.time + jnp.where(seeking, middle, run.step))
        h = time - run.time  # of the times as they are rounded, or far from zero the state would run ahead of them
        moment = _within(run.time, time, forth) if jumps is not None else lambda t: t
        later, error, slope = _take_step(method, lambda t, y: rates(moment(t), y), run.time, run.state, h, run.slope)
        size = _size(error, run.state, later, tolerance)
        fine = size < 1.0
        # a NaN counts as past: the margin ends there
        past = ~(margin(time, later) > 0.0) & (fine | seeking) if margin else jnp.asarray(False)
        advances = fine & ~past & ~seeking
        reached = advances & clipped
        place = jnp.minimum(run.place, kept.shape[0] - 1)
        saves = reached & (time == kept[place])
        # the next step
        # the error goes with h^order: Hairer, Nørsett & Wanner, §II.4
        # of a step, as PIDController has them
        safety, max_shrinking, max_growth = 0.9, 0.2, 10.0
        factor = jnp.clip(safety * size ** (-1.0 / order), jnp.where(fine, 1.0, max_shrinking),
                          jnp.where(fine, max_growth, safety))
        step = h * jnp.where(jnp.isnan(factor), max_shrinking, factor)
        # a step that was cut short at a sample says little about the next one
        step = jnp.where(fine & clipped & (jnp.abs(run.step) > jnp.abs(step)), run.step, step)
        shortest = jnp.maximum(LIMITS.min_relative_step * jnp.abs(run.time), LIMITS.min_step)
        step = jnp.where(probing, forth * jnp.maximum(_first_step(run.state, slope), shortest), step)
        if largest is not None:
            step = forth * jnp.minimum(jnp.abs(step), largest)
        stuck = ~fine & ~seeking & ~(jnp.abs(step) >= shortest)
        at_jump = jumps[jnp.minimum(run.interval, count - 1)] if jumps is not None else jnp.asarray(False)
        stuck |= ~probing & ~seeking & (h == 0.0) & ~(at_jump & clipped)  # times too coarse for the step
        # behind a jump the rates are new, and a step is chosen as at the start
        step = jnp.where(reached & at_jump, 0.0, step)
        # the event lies between two offsets, of which every trial replaces one
        low = jnp.where(seeking & ~past, h, run.low)
        high = jnp.where(past, h, run.high)
        width = LIMITS.event_tolerance * jnp.maximum(jnp.abs(run.time + low), jnp.abs(run.time + high))
        split = (h == run.low) | (h == run.high)  # no time is left between the two
        hit = (high != 0.0) & ((jnp.abs(high - low) <= width) | (seeking & split)) | (past & probing)
        status = jnp.where(reached & (run.interval == count - 1), Status.COMPLETED, run.status)
        status = jnp.where(hit, Status.EVENT, jnp.where(stuck, Status.NOT_CONVERGED, status))
        saved = _save(run.saved, place, saved_of(time, later), saves)
        chosen = lambda yes, new, old: jax.tree.map(lambda a, b: jnp.where(yes, a, b), new, old)  # noqa: E731
        return Run(
            run.interval + reached, run.place + saves, jnp.where(advances, time, run.time),
            chosen(advances, later, run.state), chosen(advances | probing, slope, run.slope),
            jnp.where(seeking, run.step, jax.lax.stop_gradient(step)), jax.lax.stop_gradient(low),
            jax.lax.stop_gradient(high), chosen(past, later, run.beyond), saved, run.steps + ~seeking, status,
        )

    # plain loops copy the saved samples at each step of a batch
    return eqxi.while_loop(unfinished, body, run, kind="lax", buffers=lambda run: run.saved)


def at_event(run: Run, rates: Rates, margin: Margin) -> tuple[Float64[Array, ""], Any]:
    """Return time [s] and state at the end of a run, with the derivatives that the event's condition gives them.

    The loop finds the event's time as a number. By the implicit function theorem it changes by −δg/ġ, where g is the
    margin, at a fixed time and along the motion.
    """
    time, state = run.end, run.end_state
    slope = rates(time, state)
    value, rate = jax.jvp(margin, (time, state), (jnp.ones_like(time), slope))
    still = jax.lax.stop_gradient
    ended = (run.status == Status.EVENT) & (rate != 0.0)
    change = jnp.where(ended, -(value - still(value)) / jnp.where(ended, still(rate), 1.0), 0.0)
    return time + change, jax.tree.map(lambda y, v: y + still(v) * change, state, slope)


def _within(begin: Array, end: Array, forth: Array) -> Callable[[Array], Array]:
    """Return a function that moves a time inside a step, so that no stage is at the other side of a jump."""
    rounding = 2e-15  # of a time
    beside = forth * jnp.maximum(rounding * jnp.maximum(jnp.abs(begin), jnp.abs(end)), LIMITS.min_step)
    low, high = forth * (begin + beside), forth * jnp.where(end == begin, begin + beside, end - beside)
    return lambda t: forth * jnp.clip(forth * t, low, jnp.maximum(low, high))


def _take_step(method: Any, rates: Rates, time: Array, state: Any, h: Array, slope: Any) -> tuple[Any, Any, Any]:
    """Return state and error of a step, and the rate of change at its last stage, from the rate at its start."""
    tableau = method.tableau
    stages = len(tableau.b_sol)
    lower = np.zeros((stages, stages))
    for row, values in enumerate(tableau.a_lower, start=1):
        lower[row, :row] = values
    weights, nodes = jnp.asarray(lower), jnp.asarray(np.append(0.0, tableau.c))
    along = lambda row, k: jnp.tensordot(row, k, axes=1)  # noqa: E731

    def stage(i: Array, slopes: Any) -> Any:
        there = jax.tree.map(lambda y, k: y + h * along(weights[i], k), state, slopes)
        return jax.tree.map(lambda k, v: k.at[i].set(v), slopes, rates(time + nodes[i] * h, there))

    slopes = jax.tree.map(lambda k: jnp.zeros((stages, *k.shape), k.dtype).at[0].set(k), slope)
    slopes = jax.lax.fori_loop(1 if tableau.fsal else 0, stages, stage, slopes)
    last = jax.tree.map(lambda k: k[-1], slopes)
    change = jax.tree.map(lambda k: h * along(jnp.asarray(tableau.b_sol), k), slopes)
    error = jax.tree.map(lambda k: h * along(jnp.asarray(tableau.b_error), k), slopes)
    return jax.tree.map(jnp.add, state, change), error, last


def _size(error: Any, before: Any, after: Any, tolerance: Array) -> Float64[Array, ""]:
    """Return the root mean square of an error over its tolerance; NaN where the step failed."""
    def part(e: Array, a: Array, b: Array) -> Array:
        return e / (tolerance * (1.0 + jnp.maximum(jnp.abs(a), jnp.abs(b))))

    return _root_mean_square(jax.lax.stop_gradient(jax.tree.map(part, error, before, after)))


def _first_step(state: Any, slope: Any) -> Float64[Array, ""]:
    """Return a length [s] for the first step, shorter than the tolerance will allow."""
    over = lambda x: jax.tree.map(lambda v, y: v / (1.0 + jnp.abs(y)), x, state)  # noqa: E731
    size, rate = _root_mean_square(over(state)), _root_mean_square(over(slope))
    zero, at_rest = 1e-17, 1e-6  # a size that counts as zero; the first step [s] then
    moves = (size > zero) & (rate > zero)
    # a hundredth of the time in which the state changes by its own size
    return jax.lax.stop_gradient(jnp.where(moves, 0.01 * size / jnp.where(moves, rate, 1.0), at_rest))


def _root_mean_square(values: Any) -> Float64[Array, ""]:
    leaves = jax.tree.leaves(values)
    total = sum(jnp.sum(jnp.real(x * jnp.conj(x))) for x in leaves)
    return jnp.sqrt(total / sum(x.size for x in leaves))


def _save(saved: Any, place: Array, now: Any, saves: Bool[Array, ""]) -> Any:
    """Return the saved samples, with the present one at its place where it is to be saved."""
    return jax.tree.map(lambda x, xs: xs.at[place].set(jnp.where(saves, x, xs[place])), now, saved)

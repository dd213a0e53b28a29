"""Motions of large arrays by Taylor series, whose coefficients JAX computes for whole arrays.

Most of the work is in products of large matrices. Steps are chosen as in ``kernel_series``, and samples are evaluated
from the series. States are not projected back onto what is conserved: only rounding moves them away from it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import compiled_quickly
from polhode.motion._outcome import Status
from polhode.systems._component_sizes import component_sizes
from polhode.systems._forms import rates_of_change
from polhode.systems.base import AbstractSystem
from polhode.taylor.array_rules import Affine, Unrolled, add_order, bound_of_argument, is_first
from polhode.taylor.expressions import Untraceable
from polhode.taylor.kernel_series import ROOT_SHARE_LEFT
from polhode.taylor.runs import Precision, Runs
from polhode.types import Array, ArrayOrFloat, Double, Float64


class ArrayLimits(NamedTuple):
    """Thresholds of steps by whole arrays."""

    min_relative_step: float = 4e-16  # of the present time: shorter steps do not advance
    min_optimized_size: int = 512  # of a state: for fewer numbers, XLA optimizes longer than ten thousand steps gain
    # of a state: for fewer numbers, XLA compiles operations written out for each order for longer than two thousand
    # steps gain: a fluid of resolution 32 compiles ten times as long for steps 1.3 times as quick
    min_written_size: int = 2048


LIMITS = ArrayLimits()


class Place(NamedTuple):
    """The beginning of a step, from which a motion resumes bit for bit.

    Attributes:
        time: [s].
        state: then.
        unit: of time in its series, a power of two [s].
    """

    time: float
    state: Double[Array, "..."]
    unit: float


class ArrayRun(NamedTuple):
    """A motion of one state.

    Attributes:
        states: (T, …) samples; infinite after the end.
        end: [s], NaN where steps shrank to nothing.
        steps: how many were taken.
        place: the beginning of the last step.
    """

    states: Double[Array, "time ..."]
    end: float
    steps: int
    place: Place


def runs_of_arrays(
    system: AbstractSystem, states: Double[Array, "copies ..."], times: Float64[np.ndarray, "time"],
    precision: Precision, longest: float = math.inf, check: Callable[[float], None] = lambda share: None,
    place: Place | None = None,
) -> tuple[Runs, Place]:
    """Return ``Runs`` as ``run_copies`` does, one copy after the other, and the beginning of the last copy's last step.

    Raises:
        Untraceable: for rates made of operations that have no rule, events, jumps, balances, or extended precision.
    """
    asked = {"events": system.events, "jumps": np.ravel(system.jumps), "balances": _balances(system, states[0])}
    more = [name for name, value in asked.items() if len(value)] + ["extended precision"] * precision.extended
    if more:
        raise Untraceable(f"so many operations that whole arrays are needed, which have no {more[0]}")
    runs = []
    for k, state in enumerate(states):
        part = lambda share, k=k: check((k + share) / len(states))  # noqa: E731
        scale = np.abs(component_sizes(system, state[None])[0])
        run = run_arrays(system, state, times, precision.order, precision.reach, longest, scale, part, place)
        runs.append(run)
    end, none = np.array([run.end for run in runs]), np.full(len(runs), -1)
    status = np.where(np.isfinite(end), Status.COMPLETED, Status.NOT_CONVERGED)
    whole, nothing = np.stack([run.states for run in runs]), np.zeros((len(runs), 0))
    steps = np.array([run.steps for run in runs])
    received = np.zeros((*whole.shape[:2], 0))
    none_beside = whole[:, :0]
    joined = Runs(whole, received, status, none, end, whole[:, -1], nothing, steps, none_beside, nothing, ())
    return joined, runs[-1].place


def _balances(system: AbstractSystem, state: Array) -> Any:
    return jax.eval_shape(lambda t, x: system.balances(t, x), jax.ShapeDtypeStruct((), float), jnp.asarray(state))


def coefficients(
    system: AbstractSystem, state: Double[Array, "*shape"], t: Float64[ArrayOrFloat, ""],
    unit: Float64[ArrayOrFloat, ""], order: int,
) -> Double[Array, "orders *shape"]:
    """Return the Taylor coefficients of a motion, of powers of the time over a unit, up to an order.

    Raises:
        Untraceable: if the rates are made of operations that have no rule.
    """
    return _coefficients_and_changes(system, state, t, unit, order)[0]


def _coefficients_and_changes(
    system: AbstractSystem, state: Array, t: Float64[ArrayOrFloat, ""], unit: Float64[ArrayOrFloat, ""], order: int
) -> tuple[Array, Array]:
    size = np.size(state)
    write = _loop_quickly if size < LIMITS.min_optimized_size else (
        _loop_thoroughly if size < LIMITS.min_written_size else _written_out)
    return write(system, state, t, unit, order)


def _write_orders(system: AbstractSystem, state: Array, t: Array, unit: Array, order: int) -> tuple[Array, Array]:
    """Return coefficients and ``changes`` by operations that are written out for each order."""
    recurrence = _Recurrence(system, state, t, unit, order)
    for k in range(1, order):
        recurrence.advance(k)
    return jnp.stack(recurrence.series[recurrence.state]), recurrence.changes(order)


def _write_loop(system: AbstractSystem, state: Array, t: Array, unit: Array, order: int) -> tuple[Array, Array]:
    """Return coefficients and ``changes`` by a loop over orders, which adds zeros too, but compiles much faster."""
    recurrence = _Recurrence(system, state, t, unit, order)
    series, unrolled = recurrence.series, recurrence.unrolled
    others = [None if unrolled.is_moving(place) else value for place, value in enumerate(series)]
    begun = {place: jnp.stack(series[place]) for place in recurrence.read_at_all_orders()}
    kept = {
        place: jnp.zeros((order + 1, *x.shape[1:]), x.dtype).at[: len(x)].set(x) for place, x in begun.items()
    }

    def advance(k: Array, kept: dict[int, Array]) -> dict[int, Array]:
        recurrence.series = [kept.get(place, value) for place, value in enumerate(others)]
        recurrence.advance(k)
        return {place: recurrence.series[place] for place in kept}

    kept = jax.lax.fori_loop(1, order, advance, kept)
    recurrence.series = [kept.get(place, value) for place, value in enumerate(others)]
    return kept[recurrence.state], recurrence.changes(order)


class _Recurrence:
    """Taylor coefficients of everything that the rates of a system are made of, order by order.

    Attributes:
        series: by place: coefficients of moving values, and constants.
        state: the place of the state.
    """

    def __init__(self, system: AbstractSystem, state: Array, t: Array, unit: Array, order: int) -> None:
        closed = jax.make_jaxpr(lambda t, x: rates_of_change(system, t, x))(t, state)
        self.unrolled, self.unit = Unrolled(closed, [True, True]), jnp.asarray(unit)
        (self.clock, self.state), (self.rates,) = self.unrolled.arguments, self.unrolled.results
        self.series: list[Any] = [self.unrolled.constants.get(place) for place in range(self.unrolled.size)]
        self.series[self.clock] = [jnp.asarray(t), self.unit, *[jnp.zeros_like(self.unit)] * (order - 1)]
        self.series[self.state] = [jnp.asarray(state)]
        self.advance(0)

    def read_at_all_orders(self) -> set[int]:
        """Return the places whose coefficients of other orders than the present one are needed."""
        places = {self.clock, self.state}
        for step in self.unrolled.steps:
            if step.rule is not None and not isinstance(step.rule, Affine):
                places.update(step.results, (step.entry.operands[k] for k in step.moving))
        return places

    def changes(self, order: int) -> Float64[Array, "functions orders"]:
        """Return bounds of the changes of arguments of roots, exponentials and sines, as parts of the largest allowed.

        The k-th of an argument's row is of its coefficient of order k; see ``kernel_series.bound_change``.
        """
        bounds = []
        for step in self.unrolled.steps:
            bound = bound_of_argument(step)
            if bound is not None:
                series = self.series[step.entry.operands[0]]
                sizes = jnp.abs(jnp.stack(series[:order]) if isinstance(series, list) else series[:order])
                most = bound or (1.0 - ROOT_SHARE_LEFT) * sizes[0]
                bounds.append(jnp.max((sizes / most).reshape(order, -1), axis=1).at[0].set(0.0))
        return jnp.stack(bounds) if bounds else jnp.zeros((0, order))

    def advance(self, k: Any) -> None:
        """Compute the coefficients of an order, and those of the state of the next one."""
        series = self.series
        for step in self.unrolled.steps:
            arguments = [series[place] for place in step.entry.operands]
            if step.rule is not None:
                own = [[] if series[place] is None else series[place] for place in step.results]
                for place, value in zip(step.results, step.rule(arguments, own, k), strict=True):
                    series[place] = add_order(series[place], value, k)
            elif is_first(k):
                for place, value in zip(step.results, step.entry.bind(arguments), strict=True):
                    series[place] = value
        rate = series[self.rates]
        if self.unrolled.is_moving(self.rates):
            rate = rate[k]
        elif not is_first(k):
            rate = jnp.zeros_like(rate)
        # ẏ = f: y_{k+1} = unit f_k/(k + 1)
        value = jnp.asarray(rate * self.unit / (k + 1), series[self.state][0].dtype)
        series[self.state] = add_order(series[self.state], value, k + 1)


_loop_quickly, _loop_thoroughly = compiled_quickly(_write_loop), eqx.filter_jit(_write_loop)
_written_out = eqx.filter_jit(_write_orders)


def run_arrays(
    system: AbstractSystem, state: Double[Array, "..."], times: Float64[np.ndarray, "time"], order: int, reach: float,
    longest: float = math.inf, scale: Double[Array, "..."] | float = 1.0,
    check: Callable[[float], None] = lambda share: None, place: Place | None = None,
) -> ArrayRun:
    """Return the motion of one state at times, which need not be the ends of steps.

    Args:
        system: without jumps.
        state: at the first time.
        times: (T,) [s], in one direction.
        order, reach: of the series, and of a step in radii of convergence.
        longest: step [s].
        scale: sizes of the components.
        check: called with the completed share.
        place: of an earlier run that ended at this start, which then goes on as if it had not been interrupted.

    Raises:
        Untraceable: if the rates are made of operations that have no rule.
    """
    first, last = float(times[0]), float(times[-1])
    forth = 1.0 if last > first else -1.0
    states = np.full((len(times), *np.shape(state)), np.inf, np.asarray(state).dtype)
    states[0] = state
    now, sample, steps = Place(first, np.asarray(state), 1.0) if place is None else place, 1, 0
    while sample < len(times):
        left = abs(last - now.time)
        series, changes, unit, h = _fit_series(system, now, forth, order, reach, left, scale)
        h = min(h, longest)
        h = _short(_bound_changes(changes, min(h, left), unit) if len(changes) else h)
        later = now.time + forth * h
        if not h > LIMITS.min_relative_step * abs(now.time):
            return ArrayRun(states, math.nan, steps, now)
        steps += 1
        while sample < len(times) and forth * times[sample] <= forth * later:
            states[sample] = _at(series, (times[sample] - now.time) / (forth * unit))
            sample += 1
        now = now._replace(unit=unit) if sample == len(times) else Place(
            later, _at(series, (later - now.time) / (forth * unit)), _power_of_two(h))
        check(min(abs(now.time - first) / abs(last - first), 1.0))
    return ArrayRun(states, last, steps, now)


def _fit_series(
    system: AbstractSystem, now: Place, forth: float, order: int, reach: float, left: float, scale: Any
) -> tuple[Array, Array, float, float]:
    """Return coefficients and ``changes`` in a unit of time that fits them, the unit, and the length of a step [s]."""
    unit, lowered, series, changes, length = now.unit, False, np.zeros(0), np.zeros(0), math.nan
    floor = 1e-3  # of the scale: a motion that dies away is computed to this part of its first size
    far = 256.0  # units: a longer step may be of coefficients that vanished
    for _ in range(100):
        times = np.float64(now.time), np.float64(forth * unit)
        series, changes = map(np.asarray, _coefficients_and_changes(system, now.state, *times, order))
        with np.errstate(all="ignore"):
            sizes = np.array([np.max(np.abs(series[k]) / scale) for k in (0, order - 2, order - 1, order)])
            start, lasts = max(float(sizes[0]), floor), sizes[1:]
            radii = (start / lasts) ** (1.0 / np.arange(order - 2, order + 1))
        length = reach * float(np.min(radii)) if np.isfinite(sizes).all() else math.nan
        if not length >= 0.0 and unit > 1e-280:
            unit, lowered = unit * 2.0**-8, True
        elif length > far and unit < left and not lowered:
            unit = min(unit * 2.0**16, 2.0 * _power_of_two(left))
        else:
            break
    return series, changes, unit, length * unit


def _bound_changes(changes: Array, h: float, unit: float) -> float:
    """Return a step, h at most, in which arguments of roots, logarithms and exponentials change by what they may."""
    powers = np.arange(changes.shape[1])
    with np.errstate(all="ignore"):
        while h > 0.0 and not np.max(changes @ (h / unit) ** powers) <= 1.0:
            h *= 0.5
    return h


def _at(series: Array, h: float) -> Array:
    """Return the state after so many units of time."""
    value = series[-1]
    for one in series[-2::-1]:
        value = value * h + one
    return value


def _short(h: float) -> float:
    """Return the step rounded down to a few bits, so that times of steps add up without rounding from any start."""
    grain = _power_of_two(h) * 2.0**-20
    return math.floor(h / grain) * grain if math.isfinite(h) and h > 0.0 else h


def _power_of_two(x: float) -> float:
    """Return the power of two at or below a positive number."""
    return math.ldexp(1.0, math.frexp(x)[1] - 1) if math.isfinite(x) else 1.0

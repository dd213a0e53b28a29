"""Finds times at which rates of change jump or start, by trying many times, as step control cannot see them.

Steps of a body that hardly moves are as long as the samples are apart, and none of their stages need lie in a pulse.
So rates that depend on time by themselves are evaluated at many times, partly random, at a fixed state. Where they
stay, and then change, is a place at which a step has to end: a jump is bisected to a rounding of its time, and a smooth
pulse gets places at its beginning, inside and at its end. What passes between two trials is not found; ``jumps`` of the
system names it.
"""

from __future__ import annotations

import dataclasses
import warnings
from functools import cache
from typing import Any, TypeVar

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import compiled_quickly
from polhode._base.arrays.traced_checks import check_traced
from polhode._base.jax_inner import partial_eval
from polhode.errors import InvalidInput, shown
from polhode.systems._component_sizes import component_sizes
from polhode.systems._forms import FURTHER, rates_of_change
from polhode.systems.base import AbstractSystem
from polhode.types import Array, ArrayLike, Bool, Double, Float64, Integer

TRIALS = 1 << 17  # times that are tried
NUMBERS = 1 << 23  # evaluated at most, times by components
TOGETHER = 512  # times evaluated in one call; any other number of them would be compiled anew
STILL = 1e-13  # of the largest rate: changes below it are rounding
MANY, ROUGH = 256, 1e-6  # edges, and changes against the largest rate: so many that are so small may be rounding
DENSE = 0.1  # of the trials between the first and the last: rounding changes that many of them, and switches do not
CLEAR = 64.0  # times the usual change by rounding, from which on a change is none of it
ABOVE = 8.0  # of the usual change between two trials, from which on something acts
INNER = np.array([0.25, 0.5, 0.75])  # places within a smooth change
INSIDE = len(INNER)  # cells between trials that it must have for them
MOST = 1 << 14  # beginnings and ends at which steps are made to end; of more a warning tells
COPIES = 8  # of a batch that are tried: the first by all trials, the others by as many together
BISECTIONS = 60
BESIDE = 4.0 * float(np.finfo(float).eps)  # of a time, within which bisection ends at a jump
SHIFT = 0.25  # of the time between two trials, by which each is moved at most
REMEMBERED = 256  # systems


System = TypeVar("System", bound=AbstractSystem)
_driven: dict[Any, bool] = {}


def jumps_between(
    times: Float64[np.ndarray, "time"], jumps: Float64[ArrayLike, "jumps"]
) -> Float64[np.ndarray, "inside"]:
    """Return those jumps, each once, that lie between the first and the last time.

    Raises:
        InvalidInput: for a jump that is not finite.
    """
    instants = np.ravel(np.asarray(jumps, dtype=float))
    if not np.isfinite(instants).all():
        raise InvalidInput(f"`jumps` must be finite times [s]; got {shown(instants[~np.isfinite(instants)][0])}.")
    low, high = min(times[0], times[-1]), max(times[0], times[-1])
    return np.unique(instants[(instants > low) & (instants < high)])


def depends_on_time(system: AbstractSystem, state: Double[Array, "..."]) -> bool:
    """Return whether the rates of change at one state may depend on the time itself.

    Systems of the same parts and shapes are looked at once.
    """
    shape = jax.ShapeDtypeStruct(jnp.shape(state), jnp.result_type(state))
    leaves, tree = jax.tree.flatten(system)
    key = (type(system), tree, shape, *((x.shape, x.dtype) if eqx.is_array(x) else x for x in leaves))
    try:
        if key not in _driven:
            if len(_driven) > REMEMBERED:
                _driven.clear()
            _driven[key] = _uses_time(system, shape)
        return _driven[key]
    except TypeError:  # a part that cannot be hashed
        return _uses_time(system, shape)


def _uses_time(system: AbstractSystem, shape: Any) -> bool:
    try:
        time = jax.ShapeDtypeStruct((), jnp.result_type(float))
        traced = jax.make_jaxpr(lambda t, y: system.vector_field(t, y))(time, shape)
    except Exception:
        return False  # the run refuses it in its own words
    check_traced(f"`vector_field` of {type(system).__name__}", traced)
    _, used = partial_eval.dce_jaxpr(traced.jaxpr, [True] * len(traced.jaxpr.outvars))
    return bool(used[0])


def find_undeclared_jumps(
    system: AbstractSystem, state: Double[Array, "..."], times: Float64[np.ndarray, "time"]
) -> Float64[np.ndarray, "found"]:
    """Return times [s] between the first and the last at which steps have to end, beside the system's own ``jumps``.

    Args:
        system: what moves.
        state: packed (batch…, …), at which rates are tried: up to eight copies of a batch, spread over it.
        times: (T,) [s], in one direction.

    Warns where there are more than steps can be made to end at.
    """
    if system.names_all_jumps:
        return np.zeros(0)
    copies = np.reshape(np.asarray(state), (-1, *np.shape(state)[np.ndim(state) - system.state_axes :]))
    ends = np.asarray(times, dtype=float)[[0, -1]]
    chosen = _choose_copies(len(copies))
    found = _together(ends, [_changes(system, copies[[k]], ends, trials) for k, trials in chosen], warned=True)
    return _without_named(system, ends, found)


def jumps_along(
    system: AbstractSystem, states: Double[np.ndarray, "..."], times: Float64[np.ndarray, "time"]
) -> Float64[np.ndarray, "found"]:
    """Return jumps as ``find_undeclared_jumps`` does, tried at the states of a motion, each up to the next time.

    Args:
        system: what moves.
        states: (batch…, T, …), of which up to eight copies count, each up to its end.
        times: (T,) [s], in one direction.
    """
    if system.names_all_jumps:
        return np.zeros(0)
    own = np.shape(states)[np.ndim(states) - system.state_axes :]
    copies, jumps = np.reshape(states, (-1, len(times), *own)), []
    for k, trials in _choose_copies(len(copies)):
        there = np.isfinite(copies[k]).reshape(len(times), -1).all(axis=-1)
        if there.sum() > 1:
            jumps.append(_changes(system, copies[k][there][:-1], times[there], trials))
    return _without_named(system, times, _together(times, jumps))


def _without_named(
    system: AbstractSystem, times: Float64[np.ndarray, "time"], found: Float64[np.ndarray, "found"]
) -> Float64[np.ndarray, "further"]:
    """Return those of the jumps found that the system does not name: bisection may end a rounding beside these."""
    named = jumps_between(times, system.jumps)
    if not len(named) or not len(found):
        return found
    place = np.searchsorted(named, found)
    near = np.stack([named[np.maximum(place - 1, 0)], named[np.minimum(place, len(named) - 1)]])
    return found[np.abs(near - found).min(axis=0) > BESIDE * np.abs(found)]


def _choose_copies(copies: int) -> list[tuple[int, int]]:
    """Return which copies of a batch are tried, and at how many times each."""
    chosen = np.unique(np.linspace(0, copies - 1, min(copies, COPIES)).round().astype(int))
    return [(int(k), TRIALS if k == 0 else TRIALS // (len(chosen) - 1)) for k in chosen]


def _together(
    times: Float64[np.ndarray, "time"], jumps: list[Any], warned: bool = False
) -> Float64[np.ndarray, "inside"]:
    """Return the jumps of several copies; a copy with too many changes gives their number."""
    many = max((x for x in jumps if isinstance(x, int)), default=0)
    if many and warned:
        warnings.warn(
            f"the torque or other rates of change switch at least {many} times between {times.min():g} s and "
            f"{times.max():g} s, and steps are not made to end at all of these times; `error_estimate` may not see it. "
            f"Give `step=` shorter than a switching lasts, as {0.1 * np.ptp(times) / many:.2g} s.",
            stacklevel=5,
        )
    return jumps_between(times, np.concatenate([np.zeros(0), *(x for x in jumps if not isinstance(x, int))]))


def _changes(
    system: AbstractSystem, states: Double[np.ndarray, "..."], times: np.ndarray, trials: int
) -> Float64[np.ndarray, "found"] | int:
    """Return where rates change with time at states (T − 1, …), each from one of the times (T,) up to the next.

    Where there are too many such places it is their number.
    """
    if not depends_on_time(system, jnp.asarray(states[0])):
        return np.zeros(0)
    spans = len(times) - 1
    each = int(np.clip(min(NUMBERS // max(np.size(states[0]), 1), trials) // spans, 2, TRIALS))
    tried = np.linspace(times[:-1], times[1:], each + 1, axis=-1)
    # at random places, as what switches at the rate of equal trials would look the same at all of them
    shifts = np.random.default_rng(0).uniform(-SHIFT, SHIFT, (spans, each - 1))
    tried[:, 1:-1] += shifts * (np.diff(times)[:, None] / each)
    rates, which = _Rates(system, np.asarray(states)), np.repeat(np.arange(spans), each)
    values = rates(np.ravel(tried), np.repeat(np.arange(spans), each + 1)).reshape(spans, each + 1, -1)
    low, high = np.ravel(tried[:, :-1]), np.ravel(tried[:, 1:])
    size = np.max(np.abs(values), initial=0.0, where=np.isfinite(values))
    # of equal times, or smooth changes about the least one would be seen and unseen by turns
    longer = np.abs(np.diff(tried, axis=1)) * (each / np.abs(np.diff(times))[:, None])
    changes = np.ravel(np.nan_to_num(np.abs(np.diff(values, axis=1)).max(axis=-1), nan=size) / longer)
    least, usual = STILL * size, float(np.median(changes))
    # what moves all the time is seen by every step; there only what stands out from its surroundings jumps
    beside = np.maximum(np.roll(changes, 2), np.roll(changes, -2))
    acts = changes > (np.maximum(least, ABOVE * np.maximum(usual, beside)) if usual > least else least)
    edges = _edges(acts)
    if len(edges) > MANY and acts.sum() > DENSE * (edges[-1] - edges[0]):
        little = float(np.median(changes[acts]))
        if little < ROUGH * size:  # rates that are small differences of large terms have the rounding of these
            acts &= changes > CLEAR * little
            edges = _edges(acts)
    begins, ends = edges[::2], edges[1::2] - 1  # first and last cell of each run in which something acts
    if len(edges) > MOST:
        return len(begins)
    if not len(begins):
        return np.zeros(0)
    # a jump lies in the first or the last cell of such a run, or stands out inside it
    cells = np.unique(np.concatenate([begins, ends, np.flatnonzero(acts & (changes > ABOVE * beside))]))
    long = ends - begins >= INSIDE
    inside = low[begins[long]] + INNER[:, None] * (high[ends[long]] - low[begins[long]])
    jumps = [_bisect(rates, low[cells], high[cells], which[cells]), low[begins], high[ends], np.ravel(inside)]
    return jumps_between(times, np.concatenate(jumps))


def _edges(acts: Bool[np.ndarray, "cells"]) -> Integer[np.ndarray, "edges"]:
    """Return where runs of cells in which something acts begin and end, by turns."""
    return np.flatnonzero(np.diff(np.concatenate([[0], acts.view(np.int8), [0]])))


class _Rates:
    """Rates of change at some states, over the sizes of the components."""

    def __init__(self, system: AbstractSystem, states: Double[np.ndarray, "..."]) -> None:
        self.system, self.states = system, states
        sizes = np.ravel(component_sizes(system, states[:1]))
        sizes = np.where(sizes > 0.0, sizes, 1.0)
        self.sizes = np.tile(sizes, 2) if np.iscomplexobj(states) else sizes

    def __call__(self, times: Float64[np.ndarray, "n"], which: Array) -> Float64[np.ndarray, "n components"]:
        """Return the rates at times, each at one of the states."""
        count = len(times)
        more = -count % TOGETHER
        rows = np.append(times, np.full(more, times[-1])).reshape(-1, TOGETHER)
        at = np.append(which, np.full(more, which[-1])).reshape(-1, TOGETHER)
        rates = [np.asarray(_evaluate(self.system, self.states[k], t)) for t, k in zip(rows, at, strict=True)]
        return np.concatenate(rates)[:count] / self.sizes


@compiled_quickly
def _evaluate(system: AbstractSystem, states: Array, times: Array) -> Array:
    rates = jax.vmap(lambda t, y: rates_of_change(system, t, y))(jnp.asarray(times), jnp.asarray(states))
    rates = rates.reshape(times.shape[0], -1)
    return jnp.concatenate([rates.real, rates.imag], axis=-1) if jnp.iscomplexobj(rates) else rates


def _bisect(rates: _Rates, low: np.ndarray, high: np.ndarray, which: np.ndarray) -> np.ndarray:
    """Return where between two times each the larger part of the change is, to a rounding: the time behind it."""
    at_low, at_high = rates(low, which), rates(high, which)
    for _ in range(BISECTIONS):
        middle = low + 0.5 * (high - low)
        value = rates(middle, which)
        before = np.abs(value - at_low).max(axis=-1) > np.abs(at_high - value).max(axis=-1)
        low, high = np.where(before, low, middle), np.where(before, middle, high)
        at_low, at_high = np.where(before[:, None], at_low, value), np.where(before[:, None], value, at_high)
        if (np.nextafter(low, high) == high).all():
            break
    return high


def name_jumps(system: System, jumps: Float64[np.ndarray, "jumps"]) -> System:
    """Return a system that moves alike and names these jumps beside its own; itself if there are none."""
    if not len(jumps):
        return system
    kind, fields = type(system), {field.name: getattr(system, field.name) for field in dataclasses.fields(system)}
    known = getattr(system, FURTHER, None)
    fields[FURTHER] = jnp.asarray(jumps if known is None else np.concatenate([known, jumps]))
    if "jumps" in fields:  # a field of its own, which takes them
        fields["jumps"] = jnp.concatenate([jnp.ravel(jnp.asarray(system.jumps, float)), jnp.asarray(jumps)])
        return _with_fields(kind, fields)
    return _with_fields(kind if known is not None else _make_naming_class(kind), fields)


def _with_fields(kind: Any, fields: dict[str, Any]) -> Any:
    made: Any = object.__new__(kind)
    for name, value in fields.items():
        object.__setattr__(made, name, value)
    return made


@cache
def _make_naming_class(kind: type[AbstractSystem]) -> type[AbstractSystem]:
    """Return the class of the same systems with further jumps, one for each class, as what it computes is compiled."""

    def jumps(self: Any) -> Array:
        own = jnp.ravel(jnp.asarray(super(made, self).jumps, float))  # a property, or an array of the class
        return jnp.concatenate([own, getattr(self, FURTHER)])

    more = {"jumps": property(jumps), FURTHER: None, "__annotations__": {FURTHER: Any}, "__module__": kind.__module__,
            "__qualname__": kind.__qualname__, "__doc__": kind.__doc__}  # fmt: skip
    making: Any = type(kind)
    made = making(kind.__name__, (kind,), more)
    return made

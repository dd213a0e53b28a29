"""Finds times at which rates of change jump or start, by trying many times, as step control cannot see them.

Steps of a body that hardly moves are as long as the samples are apart, and none of their stages need lie in a pulse.
So rates that depend on time by themselves are evaluated at many times, partly random, at a fixed state. Where they
stay, and then change, is a place at which a step has to end: a jump is bisected to a rounding of its time, and a smooth
pulse gets places at its beginning, inside and at its end. What passes between two trials is missed;
``jumps`` of the system can name it.
"""

from __future__ import annotations

import dataclasses
import warnings
from functools import cache
from typing import Any, NamedTuple, TypeVar

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_quickly
from polhode._base.arrays.traced_checks import check_traced
from polhode._base.jaxprs import depends_on
from polhode._base.kept import kept_of_object
from polhode.systems._component_sizes import component_sizes
from polhode.systems._forms import FURTHER, as_rows, facts_of, rates_of_change
from polhode.systems.base import AbstractSystem
from polhode.types import Array, ArrayLike, Bool, Double, Float64, Integer


class ProbingLimits(NamedTuple):
    """Bounds of the search, and thresholds from which on a change of rates counts as an action."""

    trials: int = 1 << 17  # times tried of the first copy of a batch, and as many of the others together
    max_values: int = 1 << 23  # evaluated for one copy, times by components
    max_copies: int = 8  # of a batch that are tried
    max_edges: int = 1 << 14  # beginnings and ends at which steps are made to end; a warning reports more
    relative_rounding: float = 1e-13  # of the largest rate: smaller changes are rounding
    activity_factor: float = 8.0  # times the usual change between two trials: larger ones are an action
    # rates that are small differences of large terms have the rounding of these: changes that are so many, so dense
    # between the first and the last, and so small against the largest rate, may be that; so much larger ones are not
    max_sparse_edges: int = 256
    max_sparse_share: float = 0.1
    max_rough_change: float = 1e-6
    roughness_factor: float = 64.0
    time_rounding: float = 4.0 * float(np.finfo(float).eps)  # of a time, within which bisection ends at a jump


LIMITS = ProbingLimits()
INNER = np.array([0.25, 0.5, 0.75])  # places within a smooth change

System = TypeVar("System", bound=AbstractSystem)
_driven: dict[Any, bool] = {}


def jumps_between(
    times: Float64[np.ndarray, "time"], jumps: Float64[ArrayLike, "jumps"]
) -> Float64[np.ndarray, "inside"]:
    """Return those jumps, each once, that lie between the first and the last time.

    Raises:
        InvalidInput: for a jump that is not finite.
    """
    instants = np.ravel(check.array("jumps", jumps, None, "s"))
    if not len(instants):
        return instants
    low, high = min(times[0], times[-1]), max(times[0], times[-1])
    return np.unique(instants[(instants > low) & (instants < high)])


def depends_on_time(system: AbstractSystem, state: Double[Array, "..."]) -> bool:
    """Return whether the rates of change at one state may depend on the time itself.

    Systems of equal parts and shapes are checked once.
    """
    return _of_shape(system, np.shape(state), state.dtype)


@kept_of_object
def _of_shape(system: AbstractSystem, shape: tuple[int, ...], kind: Any) -> bool:
    of_state = jax.ShapeDtypeStruct(shape, kind)
    leaves, tree = jax.tree.flatten(system)
    key = (type(system), tree, of_state, *((x.shape, x.dtype) if eqx.is_array(x) else x for x in leaves))
    systems_kept = 256
    try:
        if key not in _driven:
            if len(_driven) > systems_kept:
                _driven.clear()
            _driven[key] = _uses_time(system, of_state)
        return _driven[key]
    except TypeError:  # a part that cannot be hashed
        return _uses_time(system, of_state)


def _uses_time(system: AbstractSystem, shape: Any) -> bool:
    try:
        time = jax.ShapeDtypeStruct((), jnp.result_type(float))
        traced = jax.make_jaxpr(lambda t, y: system.vector_field(t, y))(time, shape)
    except Exception:
        return False  # the run refuses it in its own words
    check_traced(f"`vector_field` of {type(system).__name__}", traced)
    return depends_on(traced, 0)


def find_undeclared_jumps(
    system: AbstractSystem, state: Double[Array, "..."], times: Float64[np.ndarray, "time"]
) -> Float64[np.ndarray, "jumps"]:
    """Return times [s] between the first and the last at which steps have to end, beside the system's own ``jumps``.

    Args:
        system: whose rates are tried.
        state: packed (batch…, …), at which rates are tried: up to eight copies of a batch, spread over it.
        times: (T,) [s], in one direction.

    Warns where there are more than steps can be made to end at.
    """
    if facts_of(system).names_all_jumps:
        return np.zeros(0)
    copies = as_rows(system, state)
    ends = np.asarray(times, dtype=float)[[0, -1]]
    if not depends_on_time(system, copies[0]):  # most systems, of which not even copies need be chosen
        return _without_named(system, ends, np.zeros(0))
    chosen = _choose_copies(len(copies))
    jumps = _together(ends, [_changes(system, copies[[k]], ends, trials) for k, trials in chosen], warned=True)
    return _without_named(system, ends, jumps)


def jumps_along(
    system: AbstractSystem, states: Double[np.ndarray, "..."], times: Float64[np.ndarray, "time"]
) -> Float64[np.ndarray, "jumps"]:
    """Return jumps as ``find_undeclared_jumps`` does, tried at the states of a motion, each up to the next time.

    Args:
        system: whose rates are tried.
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
    system: AbstractSystem, times: Float64[np.ndarray, "time"], jumps: Float64[np.ndarray, "jumps"]
) -> Float64[np.ndarray, "further"]:
    """Return those of the detected jumps that the system does not name: bisection may end a rounding beside these."""
    if not len(jumps) or not len(named := jumps_between(times, facts_of(system).jumps)):
        return jumps
    place = np.searchsorted(named, jumps)
    near = np.stack([named[np.maximum(place - 1, 0)], named[np.minimum(place, len(named) - 1)]])
    return jumps[np.abs(near - jumps).min(axis=0) > LIMITS.time_rounding * np.abs(jumps)]


def _choose_copies(copies: int) -> list[tuple[int, int]]:
    """Return which copies of a batch are tried, and at how many times each."""
    chosen = np.unique(np.linspace(0, copies - 1, min(copies, LIMITS.max_copies)).round().astype(int))
    return [(int(k), LIMITS.trials if k == 0 else LIMITS.trials // (len(chosen) - 1)) for k in chosen]


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
) -> Float64[np.ndarray, "jumps"] | int:
    """Return where rates change with time at states (T − 1, …), each from one of the times (T,) up to the next.

    Where there are too many such places it is their number.
    """
    if not depends_on_time(system, states[0]):
        return np.zeros(0)
    spans = len(times) - 1
    each = int(np.clip(min(LIMITS.max_values // max(np.size(states[0]), 1), trials) // spans, 2, LIMITS.trials))
    tried = np.linspace(times[:-1], times[1:], each + 1, axis=-1)
    # at random places, as a switching at the rate of equal trials would look alike at all of them
    shifts = np.random.default_rng(0).uniform(-0.25, 0.25, (spans, each - 1))
    tried[:, 1:-1] += shifts * (np.diff(times)[:, None] / each)
    rates, which = _Rates(system, np.asarray(states)), np.repeat(np.arange(spans), each)
    values = rates(np.ravel(tried), np.repeat(np.arange(spans), each + 1)).reshape(spans, each + 1, -1)
    low, high = np.ravel(tried[:, :-1]), np.ravel(tried[:, 1:])
    size = np.max(np.abs(values), initial=0.0, where=np.isfinite(values))
    # of equal times, or smooth changes about the least one would be caught and missed by turns
    longer = np.abs(np.diff(tried, axis=1)) * (each / np.abs(np.diff(times))[:, None])
    changes = np.ravel(np.nan_to_num(np.abs(np.diff(values, axis=1)).max(axis=-1), nan=size) / longer)
    least, usual = LIMITS.relative_rounding * size, float(np.median(changes))
    # every step resolves a constant motion; beside it only a change that rises above its surroundings is a jump
    beside = np.maximum(np.roll(changes, 2), np.roll(changes, -2))
    risen = LIMITS.activity_factor * np.maximum(usual, beside)
    acts = changes > (np.maximum(least, risen) if usual > least else least)
    edges = _edges(acts)
    if len(edges) > LIMITS.max_sparse_edges and acts.sum() > LIMITS.max_sparse_share * (edges[-1] - edges[0]):
        little = float(np.median(changes[acts]))
        if little < LIMITS.max_rough_change * size:
            acts &= changes > LIMITS.roughness_factor * little
            edges = _edges(acts)
    begins, ends = edges[::2], edges[1::2] - 1  # first and last cell of each run in which something acts
    if len(edges) > LIMITS.max_edges:
        return len(begins)
    if not len(begins):
        return np.zeros(0)
    # a jump lies in the first or the last cell of such a run, or rises above its surroundings inside it
    alone = np.flatnonzero(acts & (changes > LIMITS.activity_factor * beside))
    cells = np.unique(np.concatenate([begins, ends, alone]))
    long = ends - begins >= len(INNER)
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
        count, together = len(times), 512  # of any other number each call would be compiled anew
        more = -count % together
        rows = np.append(times, np.full(more, times[-1])).reshape(-1, together)
        at = np.append(which, np.full(more, which[-1])).reshape(-1, together)
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
    for _ in range(60):  # a double has 53 bits
        middle = low + 0.5 * (high - low)
        value = rates(middle, which)
        before = np.abs(value - at_low).max(axis=-1) > np.abs(at_high - value).max(axis=-1)
        low, high = np.where(before, low, middle), np.where(before, middle, high)
        at_low, at_high = np.where(before[:, None], at_low, value), np.where(before[:, None], value, at_high)
        if (np.nextafter(low, high) == high).all():
            break
    return high


def name_jumps(system: System, jumps: Float64[np.ndarray, "jumps"]) -> System:
    """Return a system with equal rates that names these jumps beside its own; the system itself if there are none."""
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
    """Return the subclass with further jumps, one for each class, as its functions are compiled."""

    def jumps(self: Any) -> Array:
        own = jnp.ravel(jnp.asarray(super(made, self).jumps, float))  # a property, or an array of the class
        return jnp.concatenate([own, getattr(self, FURTHER)])

    more = {"jumps": property(jumps), FURTHER: None, "__annotations__": {FURTHER: Any}, "__module__": kind.__module__,
            "__qualname__": kind.__qualname__, "__doc__": kind.__doc__}  # fmt: skip
    making: Any = type(kind)
    made = making(kind.__name__, (kind,), more)
    return made

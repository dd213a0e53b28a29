"""Turns sampled states into a trajectory with the system's invariants, balances and drift."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import arrays_for_few_calls
from polhode._base.kept import kept_of_object
from polhode.motion._layout import Quantity, StateLayout
from polhode.motion._outcome import Ends, Outcome
from polhode.motion._plan import MotionPlan
from polhode.motion._trajectory import Trajectory
from polhode.systems._forms import facts_of, has_attitude
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.types import Array, Double, Float64


class RepresentableLimits(NamedTuple):
    """What decides that invariants can be computed in doubles."""

    min_size: float = 1e-150  # of a state; the squares of smaller ones lose digits, or are zero


LIMITS = RepresentableLimits()


class Told(NamedTuple):
    """What a system says of states (batch…, T, …).

    Attributes:
        invariants: by name, (batch…, T) or (batch…, T, count).
        balances: values of these.
        vectors: attitude, momentum and angular velocity.
        sizes: Σ |x ∂C/∂x| of each invariant C that is one number, at the first states.
        rows: names, values (batch…, T, K) and sizes (batch…, K) of these together; None where they are apart.
        is_finite: whether all values are known to be finite.
    """

    invariants: Mapping[str, Array]
    balances: Mapping[str, Array]
    vectors: tuple[Array | None, ...]
    sizes: Mapping[str, Array]
    rows: tuple[tuple[str, ...], Array, Array] | None = None
    is_finite: bool = False


def make_trajectory(
    system: AbstractSystem, times: Float64[np.ndarray, "time"], states: Double[Array, "..."], outcome: Outcome,
    statistics: dict[str, int], received: Mapping[str, Float64[Array, "*batch time"]],
    error_estimate: Float64[Array, "*batch"] | None = None, ends: Ends | None = None, plan: MotionPlan | None = None,
    told: Told | None = None,
) -> Trajectory:
    """Return samples (batch…, T, …) as a trajectory with the system's invariants, balances and vectors.

    Args:
        told: what the system says of the states, where that is known already.
    """
    states = np.asarray(states)
    axis = states.ndim - 1 - facts_of(system).state_axes
    if told is None:
        told = _tell(system, np.asarray(times), states, axis)
    invariants, quantities = _meaningful(system, states, told), _quantities(system)
    values: dict[str, Array] = {name: np.asarray(value) for name, value in told.balances.items()}
    got: dict[str, Array] = {name: np.asarray(value) for name, value in received.items()}
    vectors = [None if x is None else np.asarray(x) for x in told.vectors]
    beyond = None if ends is None or not ends.events else ends.beyond(times)
    drift = _drifts(invariants, told, quantities, axis, beyond)
    if got:
        with np.errstate(invalid="ignore"):  # beyond the end of a copy
            # what was received is a term of a balance, which may begin at zero
            drift |= {
                name: _drift(values[name] - value, axis, _largest(value, axis, beyond), beyond=beyond)
                for name, value in got.items()
            }
    return Trajectory(
        source=system,
        times=times,
        states=states,
        layout=_layout(system, states.shape[axis + 1 :]),
        attitude=vectors[0],
        momentum=vectors[1],
        angular_velocity=vectors[2],
        invariants=invariants,
        balances=values,
        received=got,
        drift=drift,
        quantities=dict(quantities),
        outcome=outcome,
        statistics=statistics,
        error_estimate=error_estimate,
        ends=ends,
        plan=plan,
        given_axes=_given_axes(system),
    )


@kept_of_object
def _quantities(system: AbstractSystem) -> dict[str, Quantity]:
    return system.quantities


@kept_of_object
def _given_axes(system: AbstractSystem) -> Float64[np.ndarray, "3 3"] | None:
    return None if system.given_axes is None else np.asarray(system.given_axes)


@kept_of_object
def _layout(system: AbstractSystem, shape: tuple[int, ...]) -> StateLayout:
    """Return the layout of states, of which one has this shape."""
    return system.layout(np.zeros(shape))


def _tell(system: AbstractSystem, times: Array, states: Array, axis: int) -> Told:
    said = _all_said(system, times, states)
    return Told(said.invariants, said.balances, said.vectors, _terms(system, np.take(states, 0, axis=axis)))


def _drifts(
    invariants: dict[str, Array], told: Told, quantities: dict[str, Quantity], axis: int, beyond: Array | None
) -> dict[str, Array]:
    """Return the drifts of invariants; of those that stand together all at once."""
    drift, rows = dict[str, Array](), told.rows
    if rows is not None and rows[0] and all(name in invariants for name in rows[0]):
        off = np.asarray(_drift(rows[1], axis, rows[2], True, beyond))
        drift = {name: off[..., k] if off.ndim > 1 else off[k] for k, name in enumerate(rows[0])}
    own = {name for name, quantity in quantities.items() if quantity.of_copies}
    return {
        name: drift[name] if name in drift else _drift(value, axis, told.sizes.get(name), name in own, beyond)
        for name, value in invariants.items()
    }


def _meaningful(system: AbstractSystem, states: Array, told: Told) -> dict[str, Array]:
    """Return the invariants that have values, which neither overflow nor vanish in underflow, with a warning."""
    values: dict[str, Array] = {name: np.asarray(value) for name, value in told.invariants.items()}
    if told.is_finite:
        return _without_tiny(system, states, values, [])
    # what holds on other leaves only is NaN on this one
    invariants = {name: value for name, value in values.items() if not np.isnan(value).all()}
    if not np.isfinite(states).all():
        return invariants
    if "energy" in values and "energy" not in invariants:
        warnings.warn(
            f"the energy of {type(system).__name__} is not a number along the motion, though its derivatives are: what "
            "it drifts by is not known. Check its domain, as of a logarithm of what is negative.", stacklevel=3,
        )
    infinite = [name for name, value in invariants.items() if not np.isfinite(value).all()]
    return _without_tiny(system, states, invariants, infinite)


def _without_tiny(
    system: AbstractSystem, states: Array, invariants: dict[str, Array], lost: list[str]
) -> dict[str, Array]:
    """Return invariants at finite states without those that are lost, or so small that they lose digits."""
    if not isinstance(system, AbstractLiePoissonSystem):
        return invariants
    size, least = float(np.abs(_of_point(system, states)).max(initial=0.0)), LIMITS.min_size
    if 0.0 < size < least:
        lost = [name for name, value in invariants.items() if name in lost or np.abs(value).max() < least**2]
    if lost:
        warnings.warn(
            f"{', '.join(lost)}: the values of what is conserved are beyond double precision at states of size "
            f"{size:.1e}, and are left out. Choose units in which states are nearer to one.",
            stacklevel=4,
        )
    return {name: value for name, value in invariants.items() if name not in lost} if lost else invariants


def _of_point(system: AbstractLiePoissonSystem, states: Array) -> Array:
    """Return the points of the dual in states, whose attitude stands in front of a single axis."""
    is_vector = facts_of(system).state_axes == 1
    return states[..., 4:] if is_vector and has_attitude(system, states.shape[-1]) else states


class _Said(NamedTuple):
    """What one function of JAX says of states."""

    invariants: dict[str, Array]
    balances: dict[str, Array]
    vectors: tuple[Array | None, ...]


@arrays_for_few_calls  # in one, as all of them begin with the same steps
def _all_said(system: AbstractSystem, times: Array, states: Array) -> _Said:
    return _Said(system.invariants(states), system.balance_values(times, states), tuple(system.vectors(states)))


@arrays_for_few_calls
def _terms(system: AbstractSystem, state: Array) -> dict[str, Array]:
    """Return Σ |x ∂C/∂x| of each invariant C but vectors at states: the size of its terms, which may cancel in it.

    An invariant of each of n copies depends on that copy alone, so that one derivative serves all copies; of the others
    one pass backwards gives all derivatives.
    """
    own = {name for name, quantity in system.quantities.items() if quantity.of_copies}
    own_sizes = system.invariant_sizes(state)

    def choose(x: Array, of_copies: bool) -> dict[str, Array]:
        wanted = {name: value for name, value in system.invariants(x).items() if name not in own_sizes}.items()
        return {name: value for name, value in wanted if (name in own if of_copies else not jnp.ndim(value))}

    def of_one(x: Array) -> dict[str, Array]:
        values, back = jax.vjp(lambda y: choose(y, False), x)
        # one pass backwards for all of them: one each would trace the operations of all of them each time
        rows = np.eye(len(values))
        picked = {name: jnp.asarray(rows[k], values[name].dtype) for k, name in enumerate(values)}
        sizes = jax.vmap(lambda each: jnp.sum(jnp.abs(x * back(each)[0])))(picked) if values else ()
        terms: dict[str, Array] = {name: sizes[k] for k, name in enumerate(values)}
        for name, each in (choose(x, True) if own else {}).items():
            terms[name] = _of_copies(lambda y, name=name: choose(y, True)[name], x, each.size)
        return terms

    for _ in range(jnp.ndim(state) - system.state_axes):
        of_one = jax.vmap(of_one)
    return of_one(state) | own_sizes


def _of_copies(function: Callable[[Array], Array], x: Array, copies: int) -> Array:
    """Return Σ |x ∂C/∂x| (copies,) of the invariant of each copy, one component after the other."""
    width = x.size // copies
    places = jnp.arange(x.size).reshape(x.shape) % width
    sums = jnp.zeros(copies)
    for k in range(width):
        # x_k ∂C/∂x_k of every copy at once: a derivative along the vector that has the k-th component of each
        sums = sums + jnp.abs(jax.jvp(function, (x,), (jnp.where(places == k, x, 0.0),))[1])
    return sums


def _largest(values: Array, axis: int, beyond: Array | None) -> Array:
    """Return the largest size of values (batch…, T) along the motion."""
    return np.max(np.abs(values if beyond is None else np.where(beyond, 0.0, values)), axis=axis)


def _drift(
    values: Array, axis: int, terms: Array | None = None, of_copies: bool = False, beyond: Array | None = None
) -> Array:
    """Return the largest deviation from the first sample, relative to its size, or that of its terms if larger.

    Args:
        values: (batch…, T), or with a further axis of components or copies.
        axis: that of time.
        terms: sizes of the terms.
        of_copies: whether each copy along the last axis has a drift of its own.
        beyond: (batch…, T) samples that do not count, as a copy of the batch has ended before.
    """
    vector, front = values.ndim > axis + 1 and not of_copies, (slice(None),) * axis
    first = values[(*front, slice(0, 1))]
    off, size = np.abs(values - first), np.abs(first)
    if beyond is not None:
        off = np.where(beyond.reshape(*beyond.shape, *(1,) * (off.ndim - beyond.ndim)), 0.0, off)
    if vector:
        off, size = (np.sqrt(np.add.reduce(x * x, axis=-1)) for x in (off, size))
    size = size[(*front, 0)]
    if terms is not None:
        known = np.asarray(terms)
        size = np.maximum(size, known if np.isfinite(known).all() else np.nan_to_num(known))
    return off.max(axis=axis) / np.where(size > 0, size, 1.0)

"""The distance between two motions of one system, and starts that differ by rounding alone."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any, TypeGuard

import numpy as np

from polhode.systems._component_sizes import component_sizes
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem, join_state
from polhode.types import Array, Double, Float64

LARGE = 0.05  # of the state's size: runs that differ by more are not in the regime of small errors
EPS = float(np.finfo(float).eps)
LUCK = 100.0  # by which two runs may by chance be nearer to each other than to the true motion


def difference(
    system: AbstractSystem, one: Double[Array, "*shape"], other: Double[Array, "*shape"]
) -> Float64[Array, "..."]:
    """Return the largest difference (batch…) of two motions (batch…, T, …), relative to the sizes of a state's parts.

    Parts are the attitude, of size one, and what has a unit of its own: on se(3)* the angular and the linear part, the
    point of other algebras, each component of other systems and of those that name sizes of their own.
    """
    axis = one.ndim - 1 - system.state_axes
    own = tuple(range(axis, one.ndim))
    gap, size = np.abs(one - other), np.abs(one)
    if not _has_sizes_by_algebra(system):
        shape = one.shape[axis + 1 :]
        first = np.take(one, 0, axis=axis).reshape(-1, *shape)
        scales = component_sizes(system, first)
        scales = np.where(np.isinf(scales), 0.0, scales).reshape(*one.shape[:axis], *shape)
        largest = np.maximum(size.max(axis=axis), scales)
        return np.max(gap.max(axis=axis) / np.where(largest > 0, largest, 1.0), axis=own[:-1])
    turns, shares = system.parts(one).attitude is not None, []
    for place, part in enumerate(parts_with_units(system, one)):
        largest = np.ones(size.shape[:axis]) if turns and place == 0 else size[part].max(axis=own)
        shares.append(gap[part].max(axis=own) / np.where(largest > 0, largest, 1.0))
    return np.max(shares, axis=0)


def _has_sizes_by_algebra(system: AbstractSystem) -> TypeGuard[AbstractLiePoissonSystem]:
    """Return whether the algebra tells the sizes of a state's parts, and the system names none of its own."""
    own = type(system).scales is not AbstractLiePoissonSystem.scales
    return isinstance(system, AbstractLiePoissonSystem) and not own


def parts_with_units(system: AbstractLiePoissonSystem, state: Double[Array, "..."]) -> list[Any]:
    """Return the indices of attitude, if there, and of what has a unit of its own in states (…, *shape)."""
    start = 0 if system.parts(state).attitude is None else 4
    sizes = [part.size for part in system.algebra.body_parts[:-1]]
    borders = [*([0] if start else []), *itertools.accumulate(sizes, initial=start), None]
    return [(..., slice(begin, end)) for begin, end in itertools.pairwise(borders)]


def starts_a_rounding_away(
    system: AbstractSystem, state: Double[Array, "..."], roundings: Sequence[float] = (1.0, 1.0)
) -> list[Double[Array, "..."]]:
    """Return starts (batch…, …), each off by so many roundings of each part that has a unit of its own.

    All copies of a batch are moved along the same direction, so that none depends on where it stands.
    """
    rng = np.random.default_rng(1)
    if not _has_sizes_by_algebra(system):
        own = np.shape(state)[np.ndim(state) - system.state_axes :]
        sizes = component_sizes(system, np.reshape(np.asarray(state), (-1, *own))).reshape(np.shape(state))
        sizes = np.where(np.isinf(sizes), np.abs(np.asarray(state)), sizes)
        # what is zero stays so, as it may have to be; the rest has the rounding of its part, however small it is
        sizes = np.where(np.asarray(state) != 0.0, sizes, 0.0)
        return [np.asarray(state) + EPS * many * sizes * rng.normal(size=own) for many in roundings]
    attitude, point = system.parts(np.asarray(state))
    return [
        join_state(None if attitude is None else attitude + EPS * many * _unit(rng, 4),
                   _perturb(system, point, rng, EPS * many))
        for many in roundings
    ]


def _perturb(system: AbstractLiePoissonSystem, point: Array, rng: np.random.Generator, share: float) -> Array:
    """Return a point of the dual, off by a share of its size."""
    algebra = system.algebra
    vector = np.array(algebra.to_dual_vector(point))
    for part in parts_with_units(system, point) if len(algebra.element_shape) == 1 else [(...,)]:
        largest = np.abs(vector[part]).max(axis=-1, keepdims=True)  # whose square may be no number
        size = largest * np.linalg.norm(vector[part] / np.where(largest > 0.0, largest, 1.0), axis=-1, keepdims=True)
        moved = share * size * _unit(rng, vector[part].shape[-1])
        vector[part] += moved * (vector[part] != 0.0)  # zeros stay, as a saddle may need
    return np.asarray(algebra.from_dual_vector(vector))


def _unit(rng: np.random.Generator, length: int) -> Array:
    vector = rng.normal(size=length)
    return vector / np.linalg.norm(vector)

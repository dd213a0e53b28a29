"""The distance between two motions of one system, and starts that differ by rounding alone."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from polhode.systems._component_sizes import component_sizes, has_sizes_by_algebra
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem, join_state
from polhode.types import Array, Double, Float64

LARGE = 0.05  # of the state's size: runs that differ by more are not in the regime of small errors
EPS = float(np.finfo(float).eps)
TWO_PLACES = 2.0  # by which starts are off, of estimates that take no factor of four for safety
LUCK = 100.0  # by which two runs may by chance be nearer to each other than to the true motion


def difference(
    system: AbstractSystem, one: Double[Array, "*shape"], other: Double[Array, "*shape"]
) -> Float64[Array, "..."]:
    """Return the largest difference (batch…) of two motions (batch…, T, …), relative to the sizes of a state's parts.

    Parts are the attitude, of size one, and components with a common unit: on se(3)* the angular and the linear part,
    the point of other algebras, each component of other systems and of those that name sizes of their own.
    """
    axis = one.ndim - 1 - system.state_axes
    first = np.take(one, 0, axis=axis)
    return relative_size(system, np.abs(one - other).max(axis=axis), np.abs(one).max(axis=axis), first)


def relative_size(
    system: AbstractSystem, gaps: Float64[Array, "*shape"], sizes: Float64[Array, "*shape"],
    first: Double[Array, "*shape"],
) -> Float64[Array, "..."]:
    """Return the largest of gaps between two motions (batch…), relative to the sizes of a state's parts.

    Args:
        system: whose motions they are.
        gaps: (batch…, …) the largest of each number along the motion.
        sizes: (batch…, …) the largest of each number itself.
        first: (batch…, …) state of the motion.
    """
    own = tuple(range(first.ndim - system.state_axes, first.ndim))
    if not has_sizes_by_algebra(system):
        scales = component_sizes(system, first.reshape(-1, *first.shape[own[0] :])).reshape(first.shape)
        largest = np.maximum(sizes, np.where(np.isinf(scales), 0.0, scales))
        return np.max(gaps / np.where(largest > 0, largest, 1.0), axis=own)
    turns, shares = system.parts(first).attitude is not None, []
    for place, part in enumerate(parts_with_units(system, first)):
        largest = np.ones(sizes.shape[: own[0]]) if turns and place == 0 else sizes[part].max(axis=own)
        shares.append(gaps[part].max(axis=own) / np.where(largest > 0, largest, 1.0))
    return np.max(shares, axis=0)


def parts_with_units(system: AbstractLiePoissonSystem, state: Double[Array, "..."]) -> list[Any]:
    """Return the indices of the attitude, if there, and of components with a common unit in states (…, *shape)."""
    start = 0 if system.parts(state).attitude is None else 4
    sizes = [part.size for part in system.algebra.body_parts[:-1]]
    borders = [*([0] if start else []), *itertools.accumulate(sizes, initial=start), None]
    return [(..., slice(begin, end)) for begin, end in itertools.pairwise(borders)]


def starts_a_rounding_away(
    system: AbstractSystem, state: Double[Array, "..."], of_parts: bool = False, places: float = 1.0
) -> list[Double[Array, "..."]]:
    """Return two starts (batch…, …) each of whose numbers is off by last places, or a rounding of its part's size.

    Motions from these starts have other roundings throughout, and show how a rounding of the start grows. Beside a
    saddle along an axis explicit methods compute small numbers to roundings of their own, which roundings of a whole
    part would swamp. Implicit methods iterate until changes are roundings of the largest number. All copies of a batch
    are moved alike, so that none depends on its place in the batch. What is zero stays so, as a saddle may need.
    """
    rng, point = np.random.default_rng(1), np.asarray(state)
    count = 2  # a single one may lie along the motion by chance, where nothing grows
    if not isinstance(system, AbstractLiePoissonSystem) or (of_parts and not has_sizes_by_algebra(system)):
        own = np.shape(point)[np.ndim(point) - system.state_axes :]
        moves = EPS * _sizes_by_system(system, point) if of_parts else places * _last_places(point)
        return [point + moves * (rng.normal(size=own) if of_parts else _signs(rng, own)) for _ in range(count)]
    attitude, point = system.parts(point)
    vector = np.array(system.algebra.to_dual_vector(point))
    moves = EPS * _sizes_by_part(system, point, vector) if of_parts else places * _last_places(vector)
    parts = parts_with_units(system, point) if len(system.algebra.element_shape) == 1 else [(...,)]
    starts = []
    for _ in range(count):
        perturbed = attitude
        if of_parts and attitude is not None:
            perturbed = attitude + EPS * _unit(rng, 4)
        moved = vector.copy()
        for part in parts:
            length = vector[part].shape[-1]
            moved[part] += moves[part] * (_unit(rng, length) if of_parts else _signs(rng, (length,)))
        starts.append(join_state(perturbed, np.asarray(system.algebra.from_dual_vector(moved))))
    return starts


def _last_places(numbers: Array) -> Array:
    """Return the distance of each number to the next double, zero where it is.

    It is twice the largest rounding; a share of the number, rounded, would often be four times as much.
    """
    if np.iscomplexobj(numbers):
        return _last_places(numbers.real) + 1j * _last_places(numbers.imag)
    return np.where(numbers != 0.0, np.spacing(np.abs(numbers)), 0.0)


def _sizes_by_system(system: AbstractSystem, state: Array) -> Array:
    """Return the sizes of a state's numbers that a system names, zero where a number is zero."""
    own = state.shape[np.ndim(state) - system.state_axes :]
    sizes = component_sizes(system, np.reshape(state, (-1, *own))).reshape(state.shape)
    return np.where(state != 0.0, np.where(np.isinf(sizes), np.abs(state), sizes), 0.0)


def _sizes_by_part(system: AbstractLiePoissonSystem, point: Array, vector: Array) -> Array:
    """Return the size of the part with a unit of its own for each number of a point of the dual, zero where it is."""
    sizes = np.zeros_like(vector)
    for part in parts_with_units(system, point) if len(system.algebra.element_shape) == 1 else [(...,)]:
        largest = np.abs(vector[part]).max(axis=-1, keepdims=True)  # whose square may be no number
        size = largest * np.linalg.norm(vector[part] / np.where(largest > 0.0, largest, 1.0), axis=-1, keepdims=True)
        sizes[part] = size * (vector[part] != 0.0)
    return sizes


def _signs(rng: np.random.Generator, shape: tuple[int, ...]) -> Array:
    return rng.choice([-1.0, 1.0], shape)


def _unit(rng: np.random.Generator, length: int) -> Array:
    vector = rng.normal(size=length)
    return vector / np.linalg.norm(vector)

"""The structure that systems share which differ by numbers alone, so that it is traced once for all of them."""

from __future__ import annotations

import math
from collections.abc import Hashable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.systems.base import AbstractSystem
from polhode.types import Array, Float64


class Structure:
    """A system without its numbers; two are equal if their systems differ by these alone.

    Attributes:
        key: by which structures are compared.
        rest: the system without the real numbers in its arrays.
        form: of the tree of these arrays.
        shapes: of these arrays.
        size: how many numbers there are.
    """

    def __init__(self, key: Hashable, rest: Any, form: Any, shapes: tuple[tuple[int, ...], ...]) -> None:
        self.key, self.rest, self.form, self.shapes = key, rest, form, shapes
        self.size = sum(map(math.prod, shapes))

    def with_numbers(self, numbers: Any) -> AbstractSystem:
        """Return the system with these numbers (size,), which may be traced."""
        if not self.shapes:
            return self.rest
        parts, place = [], 0
        for shape in self.shapes:
            count = math.prod(shape)
            parts.append(jnp.reshape(numbers[place : place + count], shape))
            place += count
        return eqx.combine(jax.tree.unflatten(self.form, parts), self.rest)

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Structure) and self.key == other.key


def split_numbers(system: AbstractSystem) -> tuple[Structure, list[Float64[Array, "..."]]]:
    """Return a system's structure, and the arrays of its real numbers, which may be traced.

    Raises:
        TypeError: if it has parts that cannot be hashed.
    """
    arrays, rest = eqx.partition(system, lambda x: eqx.is_inexact_array(x) and not jnp.iscomplexobj(x))
    leaves, form = jax.tree.flatten(arrays)
    others, rest_form = jax.tree.flatten(rest)
    known = tuple((x.shape, np.asarray(x).tobytes()) if hasattr(x, "shape") else x for x in others)
    shapes = tuple(np.shape(x) for x in leaves)
    key = type(system), rest_form, known, form, shapes, tuple(str(x.dtype) for x in leaves)
    hash(key)
    return Structure(key, rest, form, shapes), leaves


def take_structure(system: AbstractSystem) -> tuple[Structure, Float64[Array, "numbers"]]:
    """Return a system's structure and its numbers; the system itself where they cannot be separated."""
    try:
        structure, leaves = split_numbers(system)
    except TypeError:
        return itself(system)
    if not leaves:
        return itself(system)
    return structure, np.concatenate([np.ravel(np.asarray(x, float)) for x in leaves])


def itself(system: AbstractSystem) -> tuple[Structure, Float64[Array, "numbers"]]:
    """Return a structure that only equal systems share, without numbers."""
    try:
        hash(system)
        key: Hashable = system
    except TypeError:
        key = object()
    return Structure(("itself", key), system, None, ()), np.zeros(0)

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

NUMBERS: Any = object()
"""What stands for an array of real numbers."""


class Structure:
    """A system without its numbers; two are equal if their systems differ by these alone.

    Attributes:
        key: by which structures are compared.
        rest: the leaves of the system, with ``NUMBERS`` in place of arrays of real numbers.
        form: of its tree.
        shapes: of these arrays.
        size: how many numbers there are.
    """

    def __init__(self, key: Hashable, rest: list[Any], form: Any, shapes: tuple[tuple[int, ...], ...]) -> None:
        self.key, self.rest, self.form, self.shapes = key, rest, form, shapes
        self.size = sum(map(math.prod, shapes))

    def with_numbers(self, numbers: Any) -> AbstractSystem:
        """Return the system with these numbers (size,), which may be traced."""
        leaves, place, shapes = list(self.rest), 0, iter(self.shapes)
        for k, leaf in enumerate(leaves):
            if leaf is NUMBERS:
                shape = next(shapes)
                leaves[k] = jnp.reshape(numbers[place : place + math.prod(shape)], shape)
                place += math.prod(shape)
        return jax.tree.unflatten(self.form, leaves)

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Structure) and self.key == other.key


def split_numbers(system: AbstractSystem) -> tuple[Structure, list[Float64[Array, "..."]]]:
    """Return a system's structure, and the arrays of its real numbers, which may be traced.

    Raises:
        TypeError: if it has parts that cannot be hashed.
    """
    leaves, form = jax.tree.flatten(system)
    # in one pass, as every run of a system asks for it
    arrays, rest, known = [], [], []
    for leaf in leaves:
        kind: Any = getattr(leaf, "dtype", None)
        if eqx.is_inexact_array(leaf) and not jnp.issubdtype(kind, np.complexfloating):
            arrays.append(leaf)
            rest.append(NUMBERS)
            known.append((NUMBERS, np.shape(leaf), kind))
        else:
            rest.append(leaf)
            known.append((leaf.shape, np.asarray(leaf).tobytes()) if hasattr(leaf, "shape") else leaf)
    key = type(system), form, tuple(known)
    hash(key)
    return Structure(key, rest, form, tuple(np.shape(x) for x in arrays)), arrays


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
    return Structure(("itself", key), [system], jax.tree.structure(0), ()), np.zeros(0)

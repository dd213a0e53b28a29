"""How checks state a law, and report where it is broken."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from typing import Any

import jax
import numpy as np

from polhode._base.arrays import compiled_for_few_calls
from polhode.types import Array

Laws = dict[str, tuple[Array, Array]]  # both sides of each law


class LawBroken(AssertionError):
    """A law does not hold; the message names it, the deviation and the size of the values."""


def hold(law: str, left: Any, right: Any, tolerance: float) -> None:
    """Require two arrays, or nests of them, to agree to a tolerance relative to their size.

    Raises:
        LawBroken: otherwise, NaN included.
    """
    for a, b in zip(jax.tree.leaves(left), jax.tree.leaves(right), strict=True):
        a, b = np.asarray(a), np.asarray(b)
        if a.shape != b.shape:
            raise LawBroken(f"{law}: shapes {a.shape} and {b.shape} differ.")
        size = max(np.abs(a).max(initial=0.0), np.abs(b).max(initial=0.0), 1.0)
        off = np.abs(a - b).max(initial=0.0)
        if not off <= tolerance * size:
            raise LawBroken(f"{law}: off by {off:.3g} where the values are up to {size:.3g}.")


def hold_all(laws: Callable[..., Laws], tolerance: float, *arrays: Array) -> None:
    """Compute both sides of several laws in one compiled function, and require each of them to hold, in their order.

    Raises:
        LawBroken: naming the first that does not hold.
    """
    in_order = compiled_for_few_calls(lambda *x: OrderedDict(laws(*x)))  # JAX sorts plain dictionaries
    for law, (left, right) in in_order(*arrays).items():
        hold(law, left, right, tolerance)

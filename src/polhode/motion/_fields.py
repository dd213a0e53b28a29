"""How JAX takes a motion apart and puts it together: by its fields alone, from which everything else is computed."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

from polhode._base.arrays import is_jax, namespace
from polhode.types import Array

CORES = {"moments": 1, "momentum_at_epoch": 1, "attitude_at_epoch": 1, "axes": 2, "given_axes": 2}
"""How many axes each field has for one body."""
_known: set[type] = set()


def broadcast_fields(fields: tuple[Any, ...], cores: tuple[int, ...]) -> tuple[Any, ...]:
    """Return fields with the batch axes that all of them have together, so that ``vmap`` finds its axis in each.

    Those that JAX, or a user, fills with something else than arrays stay as they are.

    Args:
        fields: arrays, and None for those that a motion has not.
        cores: how many trailing axes of each are of one body.
    """
    held = [(x, core) for x, core in zip(fields, cores, strict=True) if x is not None]
    if not all((isinstance(x, np.ndarray) or is_jax(x)) and x.ndim >= core for x, core in held):
        return fields
    batches = {tuple(x.shape[: x.ndim - core]) for x, core in held}
    if len(batches) == 1:
        return fields
    try:
        batch = np.broadcast_shapes(*batches)
    except ValueError:
        return fields
    return tuple(x if x is None else namespace(x).broadcast_to(x, (*batch, *x.shape[x.ndim - core :]))
                 for x, core in zip(fields, cores, strict=True))


def register_fields(kind: type, body_numbers: tuple[str, ...]) -> None:
    """Let JAX, where it is loaded, pass motions of a class through its transformations."""
    if kind in _known or "jax" not in sys.modules:
        return
    import jax

    names = ("moments", *body_numbers, "momentum_at_epoch", "attitude_at_epoch", "epoch", "axes")

    def take_apart(motion: Any) -> tuple[tuple[Array | None, ...], tuple[str, ...]]:
        # the given axes are a field of their own where the motion is along others
        along_others = motion.given_axes is not motion.axes
        taken = (*names, "given_axes") if along_others else names
        fields = tuple(getattr(motion, name) for name in taken)
        if not is_jax(*fields):  # those of JAX have been broadcast, unless somebody has edited them
            fields = broadcast_fields(fields, tuple(CORES.get(name, 0) for name in taken))
        return fields, taken

    def name_parts(motion: Any) -> tuple[tuple[tuple[Any, Any], ...], tuple[str, ...]]:
        fields, taken = take_apart(motion)
        return tuple((jax.tree_util.GetAttrKey(name), x) for name, x in zip(taken, fields, strict=True)), taken

    def put_together(taken: tuple[str, ...], fields: Any) -> Any:
        motion = object.__new__(kind)
        vars(motion).update(zip(taken, fields, strict=True))
        vars(motion).setdefault("given_axes", motion.axes)
        return motion

    jax.tree_util.register_pytree_with_keys(kind, name_parts, put_together, take_apart)
    _known.add(kind)

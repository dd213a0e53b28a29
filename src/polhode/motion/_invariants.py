"""The invariants of an exact motion, and the drift of its samples."""

from __future__ import annotations

from typing import Any

from polhode.types import Array, Float64


def norm(xp: Any, vector: Float64[Array, "*batch n"]) -> Float64[Array, "*batch"]:
    """Return |v| without overflow or underflow."""
    # |v| = m |v/m| with m the largest component: squares of large components overflow, and those of small ones vanish
    largest = xp.max(xp.abs(vector), axis=-1, keepdims=True)
    unit = vector / xp.where(largest > 0, largest, 1.0)
    return largest[..., 0] * xp.sqrt(xp.sum(unit * unit, axis=-1))


def drift(
    xp: Any, value: Float64[Array, "..."], vector: bool, size: Float64[Array, "..."] | None = None
) -> Float64[Array, "..."]:
    """Return the largest deviation from the first sample relative to a size (…, 1), or to the first sample's own."""
    if vector:
        own, deviation = norm(xp, value[..., :1, :]), norm(xp, value - value[..., :1, :])
    else:
        own, deviation = xp.abs(value[..., :1]), xp.abs(value - value[..., :1])
    scale = own if size is None else size
    return xp.max(deviation / xp.where(scale > 0, scale, 1.0), axis=-1)

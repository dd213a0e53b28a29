"""What an exact motion keeps, and by how much samples of it depart from that."""

from __future__ import annotations

from typing import Any

Array = Any


def norm(xp: Any, vector: Array) -> Array:
    """Return |v| without overflow or underflow."""
    largest = xp.max(xp.abs(vector), axis=-1, keepdims=True)
    unit = vector / xp.where(largest > 0, largest, 1.0)
    return largest[..., 0] * xp.sqrt(xp.sum(unit * unit, axis=-1))


def drift(xp: Any, value: Array, vector: bool, size: Array | None = None) -> Array:
    """Return the largest deviation from the first sample relative to a size (…, 1), or to the first sample's own."""
    if vector:
        own, deviation = norm(xp, value[..., :1, :]), norm(xp, value - value[..., :1, :])
    else:
        own, deviation = xp.abs(value[..., :1]), xp.abs(value - value[..., :1])
    scale = own if size is None else size
    return xp.max(deviation / xp.where(scale > 0, scale, 1.0), axis=-1)

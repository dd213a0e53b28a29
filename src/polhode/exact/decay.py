"""Exponentials of time with all their digits, for the series of both motions."""

from __future__ import annotations

from polhode.arrays import namespace, split_halves
from polhode.types import ArrayOrFloat, Float64

Operand = Float64[ArrayOrFloat, "*#shape"]


def exponential_decay(x: Operand, rest: Operand, upper: Operand, lower: Operand) -> Float64[ArrayOrFloat, "*shape"]:
    """Return exp(−(x + rest)(upper + lower)) with the exponent's product exact in its leading part."""
    xp = namespace(x)
    high, low = split_halves(x)
    small = high * lower
    small += low * (upper + lower)
    small += rest * upper
    decay = xp.exp(-(high * upper))
    decay -= decay * (small * (1.0 - 0.5 * small))
    return decay

"""Coefficients of products of eight copies at a time, one in each lane: the same sums as in ``kernel_products``."""

from __future__ import annotations

from typing import Any

from polhode.taylor.kernel_space import Series
from polhode.taylor.program import LEFT, RIGHT, SLOTS
from polhode.taylor.vectors import spread


def block(series: Series, k: Any, first: Any, count: Any, out: Any) -> None:
    """Set the k-th coefficients of a block of products, which needs no copies of their factors."""
    whole, z = series.whole, series.z
    width = whole[SLOTS]
    lefts, rights, base = whole[LEFT] + first, whole[RIGHT] + first, k * width
    for q in range(count):
        left, right = whole[lefts + q], whole[rights + q]
        if k == 0:
            z[out + q] = z[left] * z[right]
            continue
        total, x, y = spread(0.0), left + width, right + base - width
        for _ in range(1, k):
            total = total + z[x] * z[y]
            x += width
            y -= width
        z[out + q] = total + z[base + left] * z[right] + z[left] * z[base + right]

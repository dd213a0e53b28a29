"""Coefficients of eight products of one copy at a time, one in each lane of a vector."""

from __future__ import annotations

from typing import Any

from polhode.taylor.kernel_space import Series
from polhode.taylor.program import LEFT, PRODUCTS, RIGHT, SLOTS
from polhode.taylor.vectors import gather, load, repeat, store


def block(series: Series, k: Any, first: Any, count: Any, out: Any) -> None:
    """Set the k-th coefficients of a block of products, of which the factors are kept too."""
    whole, flat, a, b = series.whole, series.flat, series.a, series.b
    products = whole[PRODUCTS]
    base, row = k * whole[SLOTS], k * products + first
    left, right = gather(flat, whole, whole[LEFT] + first, base), gather(flat, whole, whole[RIGHT] + first, base)
    store(a, row, left)
    store(b, row, right)
    if k == 0:
        store(flat, out, left * right)
        return
    # Cauchy's product Σ_{j≤k} a_j b_{k−j}: the older factors from memory, the newest last, from registers
    total, x, y = repeat(0.0), first + products, row - products
    for _ in range(1, k):
        total = total + load(a, x) * load(b, y)
        x += products
        y -= products
    store(flat, out, total + left * load(b, first) + load(a, first) * right)

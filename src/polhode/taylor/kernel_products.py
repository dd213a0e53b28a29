"""Coefficients of eight products of one copy at a time, one in each lane of a vector."""

from __future__ import annotations

from typing import Any

from polhode.taylor.kernel_space import Series
from polhode.taylor.program import LEFT, PRODUCTS, RIGHT, SLOTS
from polhode.taylor.vectors import gather, load, store


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
    # the newest from registers, the older from memory; two sums
    # Cauchy's product Σ_{j≤k} a_j b_{k−j}
    one, two = left * load(b, first), load(a, first) * right
    x, y = first + products, row - products
    for _ in range(1, k - 1, 2):
        one = one + load(a, x) * load(b, y)
        two = two + load(a, x + products) * load(b, y - products)
        x += 2 * products
        y -= 2 * products
    if k % 2 == 0:
        one = one + load(a, x) * load(b, y)
    store(flat, out, one + two)

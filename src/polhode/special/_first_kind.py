"""Carlson's R_F(x, y, 1) in double-double, for phases that must stay accurate."""

from __future__ import annotations

from polhode._base.arrays import iterate
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array


def first_kind(x: DoubleDouble, y: DoubleDouble) -> DoubleDouble:
    """Return R_F(x, y, 1) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+1)) for x, y ≥ 0, not both zero.

    Source: Carlson, Numer. Algorithms 10 (1995) 13, duplication.
    """
    one = dd.one_like(x[0])

    # R_F(a, b, c) = R_F((a+λ)/4, (b+λ)/4, (c+λ)/4), λ = √a√b + √b√c + √c√a (DLMF §19.26(iii))
    def step(now: tuple[Array, ...]) -> tuple[Array, ...]:
        a, b, c = now[0:2], now[2:4], now[4:6]
        ra, rb, rc = dd.sqrt(a), dd.sqrt(b), dd.sqrt(c)
        lam = dd.add(dd.add(dd.multiply(ra, rb), dd.multiply(rb, rc)), dd.multiply(rc, ra))
        return tuple(part for v in (a, b, c) for part in dd.scale(dd.add(v, lam), 0.25))

    # nine steps halve the exponent of the smallest ratio, the rest divide the spread by four
    now = iterate(20, step, (*x, *y, *one), like=x[0])
    a, b, c = now[0:2], now[2:4], now[4:6]
    # DLMF 19.36.1 in X = 1 − a/mean, …, with X + Y + Z = 0. After the steps |X| < 1e-7 even where x = 0 and y = 1e-300,
    # so that order 5 is enough, and the correction, below 1e-15, needs no second float.
    mean = dd.divide(dd.add(dd.add(a, b), c), dd.scale(one, 3.0))
    X, Y = (dd.subtract(one, dd.divide(v, mean))[0] for v in (a, b))
    Z = -X - Y
    E2, E3 = X * Y - Z * Z, X * Y * Z
    closing = -E2 / 10.0 + E3 / 14.0 + E2 * E2 / 24.0 - 3.0 * E2 * E3 / 44.0
    return dd.divide(dd.add(one, dd.from_float(closing)), dd.sqrt(mean))

"""The turning points of a Lagrange top, ``formulas_roots``, for arrays.

The separate root is computed by Newton's method in double-double, in a variable in which it is large.
"""

from __future__ import annotations

from typing import Any

from polhode._base.arrays import iterate, namespace
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact.lagrange_top import _formulas as formulas
from polhode.exact.lagrange_top import _formulas_integrals as formulas_integrals
from polhode.exact.lagrange_top import _formulas_rates as formulas_rates
from polhode.exact.lagrange_top import _formulas_roots as formulas_roots
from polhode.exact.lagrange_top import _formulas_setup as formulas_setup
from polhode.exact.lagrange_top._formulas_roots import Reduction, TurningPoints
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array

NEWTON_STEPS = 5  # from the float64 root; three do, two more where float64 was poor


def turning_points(top: Reduction) -> TurningPoints:
    """Return the turning points of reduced tops."""
    xp = namespace(top.reversed)
    G = top.G
    weightless = ~(G[0] > 0)
    one = dd.one_like(G[0])
    safe = dd.where(weightless, one, G)
    p2, c2 = dd.square(top.p), dd.square(top.c)
    f1, of_Y, of_s = FORMULAS.cubics(
        top.momentum[2], G, dd.divide(one, safe), top.s0, top.t0, top.u0, top.w2, top.twist, p2, c2, top.D, top.F
    )
    Y, cosine = _largest_root(xp, *(v[0] for v in of_Y))
    s, _ = _largest_root(xp, *(v[0] for v in of_s))
    upper = (cosine >= 0) | weightless
    cubic = tuple(dd.where(upper, x, y) for x, y in zip(of_Y, of_s, strict=True))
    root = _polished(xp, xp.where(upper, Y, s), cubic)
    return FORMULAS.turning_points_of(upper, root, G, safe, top.s0, top.t0, p2, c2, top.c_plus, top.F, f1)


def _largest_root(xp: Any, b: Array, c: Array, d: Array) -> tuple[Array, Array]:
    """Return the largest root of x³ + bx² + cx + d, whose roots are real, and cos 3φ of Viète's formula."""
    # Viète: x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³
    P, Q = c - b * b / 3.0, 2.0 * b**3 / 27.0 - b * c / 3.0 + d
    r = xp.sqrt(xp.maximum(-P / 3.0, 0.0 * P))
    positive = r > 0
    cosine = xp.where(positive, -0.5 * Q / xp.where(positive, r, 1.0) ** 3, 1.0)
    cosine = xp.minimum(xp.maximum(cosine, -1.0 + 0.0 * r), 1.0 + 0.0 * r)
    return 2.0 * r * xp.cos(xp.acos(cosine) / 3.0) - b / 3.0, cosine


def _polished(xp: Any, start: Array, cubic: tuple[DoubleDouble, ...]) -> DoubleDouble:
    b, c, d = cubic

    def step(x: DoubleDouble) -> DoubleDouble:
        value = dd.add(dd.multiply(dd.add(dd.multiply(dd.add(x, b), x), c), x), d)
        three = dd.scale(x, 2.0)
        slope = dd.add(dd.multiply(dd.add(dd.add(three, x), dd.scale(b, 2.0)), x), c)
        change = dd.divide(value, slope)
        return dd.where(xp.isfinite(change[0]), dd.subtract(x, change), x)

    return iterate(NEWTON_STEPS, step, dd.from_float(start), like=start)


FORMULAS = for_arrays(formulas, formulas_roots, formulas_rates, formulas_integrals, formulas_setup)

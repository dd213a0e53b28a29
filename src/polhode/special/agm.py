"""The arithmetic–geometric mean with its third-kind sum, in double-double.

Arithmetic and square roots alone give complete elliptic integrals of the first and third kind, so that the rates of
exact motion carry thirty digits and their phases stay right for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977)
231.
"""

from __future__ import annotations

from polhode.arrays import iterate_until, namespace
from polhode.special import doubledouble as dd
from polhode.special.doubledouble import DoubleDouble
from polhode.types import Array

CONVERGED = 2e-8  # the closing formulas leave an error of the fourth power
MOST_STEPS = 20


def third_kind_agm(a: DoubleDouble, g: DoubleDouble, pp: DoubleDouble) -> tuple[DoubleDouble, DoubleDouble]:
    """Return agm(a, g) and Σ Q_n, with Q_0 = 1, ε = (p²−ag)/(p²+ag), Q_{n+1} = Q_n ε/2 and p ← (p²+ag)/2p.

    Args:
        a, g: positive.
        pp: p² at the start, positive.
    """
    xp = namespace(a[0])
    q = dd.from_float(xp.ones_like(a[0]))
    _, exponent = xp.frexp(a[0])  # rates down to 1e-150, whose fourth powers would underflow
    exponent = xp.minimum(exponent, xp.zeros_like(exponent))  # scaled down, a tiny g would
    up, down = xp.ldexp(xp.ones_like(a[0]), exponent), xp.ldexp(xp.ones_like(a[0]), -exponent)
    a, g, pp = dd.scale(a, down), dd.scale(g, down), dd.scale(dd.scale(pp, down), down)
    state = iterate_until(_agm_step, _agm_finished, (*a, *g, *pp, *q, *q), at_once=3, most=MOST_STEPS)
    a, pp, q, total = state[0:2], state[4:6], state[6:8], state[8:10]
    x, e, middle = _agm_closing(*state)
    last = 0.5 * q[0] * e
    total = dd.add(total, (last + last * (0.25 * (e * e - 0.5 * x * x)), xp.zeros_like(x)))
    return dd.scale(dd.add(middle, (-0.25 * middle[0] * x * x, xp.zeros_like(x))), up), total


def _agm_step(*state: Array) -> tuple[Array, ...]:
    a, g, pp, q, total = (state[k : k + 2] for k in range(0, 10, 2))
    ag = dd.multiply(a, g)
    s = dd.add(pp, ag)
    e = dd.divide(dd.subtract(pp, ag), s)
    q = dd.scale(dd.multiply(q, e), 0.5)
    pp = dd.scale(dd.divide(dd.square(s), pp), 0.25)
    return (*dd.scale(dd.add(a, g), 0.5), *dd.sqrt(ag), *pp, *q, *dd.add(total, q))


def _agm_closing(*state: Array) -> tuple[Array, Array, DoubleDouble]:
    """Return x = (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε."""
    a, g, pp = state[0:2], state[2:4], state[4:6]
    middle = dd.scale(dd.add(a, g), 0.5)
    half = 0.5 * ((a[0] - g[0]) + (a[1] - g[1]))
    d = dd.subtract(pp, dd.square(middle))
    e = d[0] + d[1] + half * half
    return half / middle[0], e / (2.0 * middle[0] * middle[0] + e), middle


def _agm_finished(*state: Array) -> Array:
    xp = namespace(state[0])
    x, e, _ = _agm_closing(*state)
    return (xp.abs(x) < CONVERGED) & (xp.abs(e) < CONVERGED)

"""The arithmetic–geometric mean with its third-kind sum, for arrays."""

from __future__ import annotations

from polhode._base.arrays import iterate_until, namespace
from polhode.exact import _formulas as formulas
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact._formulas import CONVERGED, MOST_STEPS
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array

FORMULAS = for_arrays(formulas)


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
    state = iterate_until(_step, _is_finished, (*a, *g, *pp, *q, *q), at_once=3, most=MOST_STEPS)
    a, g, pp, q, total = _pairs(state)
    mean, total = FORMULAS.mean_closed(*FORMULAS.mean_distance(a, g, pp), q[0], total)
    return dd.scale(mean, up), total


def _pairs(state: tuple[Array, ...]) -> list[DoubleDouble]:
    return [(state[k], state[k + 1]) for k in range(0, 10, 2)]


def _step(*state: Array) -> tuple[Array, ...]:
    return tuple(x for pair in FORMULAS.mean_step(*_pairs(state)) for x in pair)


def _is_finished(*state: Array) -> Array:
    xp = namespace(state[0])
    x, e, _ = FORMULAS.mean_distance(*_pairs(state)[:3])
    return (xp.abs(x) < CONVERGED) & (xp.abs(e) < CONVERGED)

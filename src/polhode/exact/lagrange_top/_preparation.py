"""From a Lagrange top and its start to the constants of its motion: rates, theta series and phases."""

from __future__ import annotations

import math
from typing import NamedTuple

from polhode._base.arrays import barrier, compiled, namespace
from polhode.exact._array_states import ArrayStates
from polhode.exact._blocks import Columns, flatten_motion
from polhode.exact.lagrange_top import _formulas as formulas
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_roots import Reduction, TurningPoints
from polhode.exact.lagrange_top._formulas_setup import Given, Integrals
from polhode.exact.lagrange_top._reduction import reduce_top
from polhode.exact.lagrange_top._roots import FORMULAS, turning_points
from polhode.special import _doubledouble as dd
from polhode.special._first_kind import first_kind
from polhode.types import Array, Float64

STATES = ArrayStates(formulas)


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with its sources."""

    motion: Columns
    top: Reduction
    points: TurningPoints
    rates: Frequencies


def prepare(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Prepared:
    """Return the constants of motion of tops with arrays (…, 3), (…, 1), (…, 3) and (…, 4) of one batch shape."""
    top = barrier(compiled(reduce_top, moments)(moments, mgl, momentum, attitude))
    points = barrier(compiled(turning_points, moments)(top))
    rates = barrier(compiled(FORMULAS.frequencies, moments)(top, points))
    integrals = compiled(_integrals, moments)(top, points, rates)
    arguments = barrier(compiled(FORMULAS.arguments, moments)(top, points, rates, integrals))
    given = Given(top, points, rates, arguments, momentum[..., 2])
    motion, timing = barrier(compiled(FORMULAS.motion_without_phases, moments)(given))
    motion = compiled(FORMULAS.motion_with_phases, moments)(given, motion, timing)
    return Prepared(flatten_motion(motion), top, points, rates)


def _integrals(top: Reduction, points: TurningPoints, rates: Frequencies) -> Integrals:
    """Return the places of the poles and of the start, by R_F in double-double.

    All five in one run; places where an answer is not used get harmless arguments.
    """
    xp, idle = namespace(top.reversed), rates.permanent | rates.steady
    G, d, A, B, s1, s2, t1, t2 = (
        top.G, points.d, points.A, points.B, points.s1, points.s2, points.t1, points.t2,
    )  # fmt: skip
    one = dd.one_like(d[0])
    over = dd.divide
    pairs = (
        (over(d, t2), over(dd.multiply(d, points.Z_plus), dd.multiply(A, t2))),
        (over(dd.multiply(d, points.Z_minus), dd.multiply(s1, B)), over(d, s1)),
        (over(dd.multiply(G, t1), points.Z_plus), over(dd.multiply(G, t2), points.Z_plus)),
        (over(dd.multiply(G, s2), B), over(dd.multiply(G, s1), A)),
        (over(points.from_upper, d), over(points.Y, A)),
    )
    columns = []
    for x, y in pairs:
        bad = idle | ~(x[0] + y[0] > 0) | ~xp.isfinite(x[0] + y[0])
        columns.append((dd.where(bad, one, x), dd.where(bad, one, y)))
    stacked = [tuple(xp.stack([c[i][k] for c in columns]) for k in (0, 1)) for i in (0, 1)]
    values = first_kind(*stacked)
    of = [(values[0][k, ...], values[1][k, ...]) for k in range(5)]
    factors = (
        over(t1, t2), over(dd.multiply(s2, A), dd.multiply(s1, B)), over(A, points.Z_plus), over(points.Z_minus, B),
        over(points.from_lower, d),
    )  # fmt: skip
    integrals = [dd.multiply(dd.sqrt(f), v) for f, v in zip(factors, of, strict=True)]
    zero = dd.from_float(xp.zeros_like(d[0]))
    v_alpha, v_beta, w_alpha, w_beta = (x[0] for x in integrals[:4])
    v_alpha = xp.where(rates.separatrix, xp.atan2(xp.sqrt(t1[0]), xp.sqrt(d[0])), v_alpha)
    v_beta = xp.where(rates.separatrix | (s2[0] == 0), 0.0, v_beta)
    # where the tilt stays the pole is infinitely far: only e^−y = 0 enters
    still = xp.where(rates.steady, math.inf, 0.0)
    v_alpha, v_beta = (xp.where(idle, still, v) for v in (v_alpha, v_beta))
    return Integrals(v_alpha, v_beta, w_alpha, w_beta, dd.where(idle & ~(d[0] > 0), zero, integrals[4]))

"""The derivative of a Lagrange top's turning points, period, precession and spin along perturbations of its start.

With f = s t (ε + G s) − (c + a s)² = u̇², a simple root s of f moves by −δf/f'(s). Period and phases are first
derivatives of the action, so that their changes are its Hessian's, regular at the steady top too. Where a number is
infinite or undefined, or where the turning points coincide and part like a root, the derivative is NaN.
"""

from __future__ import annotations

import math
from typing import Any

from polhode._base.arrays import namespace
from polhode.exact._blocks import Vectors
from polhode.exact.lagrange_top._periods import Invariants, change_of_nutation
from polhode.exact.lagrange_top._tangent import TangentData, changed_invariants, scaled_changes
from polhode.types import Array, Float64

Number = Float64[Array, "*batch"]
Change = Float64[Array, "*shape"]  # with any axes before those of the batch
Numbers = tuple[Number, ...]  # lowest to spin_rate of ``Characteristics``


def changed_numbers(top: TangentData, numbers: Numbers, changes: Vectors) -> tuple[Change, ...]:
    """Return the changes of the numbers; I1 = I2 is one quantity, whose change is the mean of both.

    Args:
        top: with entries of the batch shape.
        numbers: the values.
        changes: of moments (…, 3), mgl (…, 1), momentum (…, 3) and attitude (…, 4); the result is linear in them.
    """
    xp = namespace(*changes)
    period, precession_rate, spin_rate = numbers[2], *numbers[5:]
    start, change, (dG, da, dI1, dI3) = scaled_changes(xp, top, changes)
    by = changed_invariants(xp, top, start, change, dG, da)
    nutation = change_of_nutation(top.whole_nutation, by)
    T, dT = nutation.period, nutation.period_change
    d_period = (T * dI1 + top.I1 * dT) / top.rate_scale
    # Δψ = θ_α − θ_β + a (I1/I3 − 1) T, where a T goes against what θ_α has of it
    ratio = top.I1 / top.I3
    d_spin = ratio * (da * T + top.L3 * dT) + top.L3 * T * (dI1 - ratio * dI3) / top.I3
    sense = xp.where(top.reversed, -1.0, 1.0)
    d_precession, d_own = nutation.turn, sense * (d_spin - da * T - 2.0 * nutation.twist - nutation.turn)
    d_lower, d_upper = _changed_turning_points(xp, top, by)
    endless = xp.where(top.permanent | top.separatrix, math.nan, 1.0)
    lowest, highest = xp.where(top.reversed, -d_upper, d_lower), xp.where(top.reversed, -d_lower, d_upper)
    rest = (
        d_period, d_precession, d_own, (d_precession - precession_rate * d_period) / period,
        (d_own - spin_rate * d_period) / period,
    )  # fmt: skip
    return lowest, highest, *(endless * x for x in rest)


def _changed_turning_points(xp: Any, top: TangentData, by: Invariants) -> tuple[Array, Array]:
    """Return the changes of u1 and u2, from f'(s1) = −d A and f'(s2) = d B."""
    moved = []
    for s, slope in ((top.s2 + top.d, -top.d * top.A), (top.s2, top.d * top.B)):
        change = s * (2.0 - s) * (by.energy + s * by.G) - 2.0 * (top.c + top.L3 * s) * (by.c + s * by.a)
        simple = (slope != 0) & ~top.permanent
        moved.append(xp.where(simple, 1.0, math.nan) * (change / xp.where(simple, slope, 1.0)))
    return moved[0], moved[1]

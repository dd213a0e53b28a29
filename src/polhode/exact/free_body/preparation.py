"""From a body and its momentum to the constants of its motion: phases, theta series and matrices.

The arguments of the theta functions come by descending Landen transformation from tangents and hyperbolic sines that
are ratios of the invariants, so neither elliptic integrals nor logarithms enter the full form.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode.arrays import choose, compiled, namespace, split_halves
from polhode.exact.blocks import Columns
from polhode.exact.free_body.frequencies import Frequencies, canonical_frequencies
from polhode.exact.free_body.reduction import Reduction, canonical_reduction
from polhode.exact.free_body.spinor import Motion, flatten, start_spinor
from polhode.rotation import product_of_parts
from polhode.special import doubledouble as dd
from polhode.special.circular import split_rate
from polhode.special.doubledouble import DoubleDouble
from polhode.special.elliptic import nome_per_parameter
from polhode.types import Array, ArrayOrFloat, Float64

HUGE = 2.0**-400, 2.0**-200  # a hyperbolic sine above the inverse of the first is scaled by the second
LOG_OF_SCALE: DoubleDouble = (138.62943611198907, -3.3555121496085278e-15)  # 200 ln 2


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with the reduction and frequencies it came from."""

    motion: Columns
    body: Reduction
    frequencies: Frequencies


def prepare(
    moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"], attitude: Float64[Array, "*batch 4"]
) -> Prepared:
    """Return the constants of motion of bodies with arrays (…, 3), (…, 3) and (…, 4) of one batch shape."""
    body = canonical_reduction(moments, momentum)
    rates = compiled(canonical_frequencies, moments)(body)
    return Prepared(compiled(_motion, moments)(body, rates, moments, momentum, attitude), body, rates)


def _motion(body: Reduction, rates: Frequencies, moments: Array, momentum: Array, attitude: Array) -> Columns:
    """Return the flattened ``Motion``."""
    xp = namespace(moments, momentum, attitude)
    constant, separatrix = rates.constant, rates.separatrix
    m, m1 = body.A[0] * body.P[0], -body.C[0] * body.S[0]
    full = constant | ((m <= m1) & ~separatrix)
    inverse = dd.divide(tuple(c + xp.zeros_like(m) for c in dd.INVERSE_TWO_PI), body.V)
    inverse = dd.scale(inverse, body.rate_scale)
    half_precession = dd.scale(dd.multiply(rates.precession, inverse), 0.5)
    turn_rate = dd.scale(dd.multiply(rates.mean, inverse), 2.0)
    quarter = dd.scale(turn_rate, 0.25)
    saddle_rate = dd.scale(dd.divide(rates.modulus_rate, body.V), body.rate_scale)
    rotation_rate = _permanent_rate(body)
    pick = lambda x, y: dd.where(full, x, y)  # noqa: E731
    first = pick(dd.subtract(half_precession, quarter), half_precession)
    first = dd.where(constant, rotation_rate, first)
    second = pick(dd.add(half_precession, quarter), dd.where(separatrix, saddle_rate, turn_rate))
    zero = xp.zeros_like(m)
    second = dd.where(constant, (zero, zero), second)

    arguments = choose(full, _full_arguments, _complementary_arguments, *_argument_columns(body, rates, m, m1))
    arguments = tuple(xp.where(constant, 1.0 if k == 2 else 0.0, x) for k, x in enumerate(arguments))
    unfinished = Motion(
        full, split_rate(*first), split_rate(*second), arguments[0:2], arguments[2:12], arguments[12:17], arguments[17],
        ((zero,) * 4,) * 4, ((zero,) * 3,) * 3,
    )  # fmt: skip
    to_attitude, to_momentum = _matrices(unfinished, body, rates, moments, momentum, attitude)
    return flatten(unfinished._replace(to_attitude=to_attitude, to_momentum=to_momentum))


def _permanent_rate(body: Reduction) -> DoubleDouble:
    """Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns."""
    omega = [dd.divide(dd.from_float(x), dd.from_float(i)) for x, i in zip(body.momentum, body.moments, strict=True)]
    size = dd.sqrt(dd.add(dd.add(dd.square(omega[0]), dd.square(omega[1])), dd.square(omega[2])))
    zero = 0.0 * size[0]
    rate = dd.multiply(size, (dd.INVERSE_TWO_PI[0] + zero, dd.INVERSE_TWO_PI[1] + zero))
    return dd.scale(dd.scale(rate, 0.5), body.rate_scale)


def _argument_columns(body: Reduction, rates: Frequencies, m: Array, m1: Array) -> tuple[Array, ...]:
    singles = (x[0] for x in (body.A, body.B, body.C, body.P, body.Q, rates.G))
    return (*singles, *body.canonical, m, m1, rates.separatrix, *rates.modulus_rate, *rates.mean, body.root_P)


def _landen(
    k: Array, dn: Array, sinh_times_cosine: Array, cosine: ArrayOrFloat, dc: Array
) -> tuple[ArrayOrFloat, ArrayOrFloat]:
    """Follow a circular and a hyperbolic amplitude down five Landen steps from the complementary modulus k.

    Returns the factor of the tangent of the circular amplitude and the hyperbolic sine of the other; its first step
    takes sinh · c, c and dc · c so that none of them needs a quotient that may be 0/0.
    """
    xp = namespace(k)
    x, y = 1.0, k
    factor, sinh = 1.0, sinh_times_cosine
    for _ in range(5):
        kappa = (x - y) / (x + y)
        x, y = 0.5 * (x + y), xp.sqrt(x * y)
        grown = 1.0 + kappa
        next_dn = xp.sqrt(1.0 - kappa * (1.0 - dn) / (1.0 + dn))
        factor = factor * (next_dn / grown)
        sinh = 2.0 * sinh / (grown * (cosine + dc))
        dc = xp.sqrt(1.0 + kappa * (dc - cosine) / (dc + cosine))
        cosine, dn = 1.0, next_dn
    return factor, sinh


def _full_arguments(*columns: Array) -> tuple[Array, ...]:
    """Return start, coefficients of A and B, and idle entries of the form for m ≤ ½."""
    A, B, C, _, Q, _, l1, l2, l3, m, m1 = columns[:11]
    xp = namespace(A)
    total = B * Q
    k = xp.sqrt(m1 / total)
    q_over_m = nome_per_parameter(m / total, k)
    q = q_over_m * (m / total)
    # √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis
    small = columns[16] / xp.sqrt(Q)
    factor, scaled = _landen(k, l3 * xp.sqrt(C / Q), xp.sqrt(B), xp.sqrt(B), xp.sqrt(C))
    grown = scaled + xp.sqrt(small * small + scaled * scaled)
    g = small / grown
    r = (A / B) * q_over_m * grown * grown
    start = xp.atan2(xp.sqrt(B) * l2 * factor, xp.sqrt(C) * l1) * (0.25 / math.pi)
    g2, q2, r2 = g * g, q * q, r * r
    q3, q4 = q2 * q, q2 * q2
    q8, gg = q4 * q4, g2 * g2
    up, down = -q * g2, -q2 * r
    up2, down2 = q4 * q2 * gg, q8 * r2
    both = up2 + down2
    of_a = (1.0 - both, up + down, 2.0 * both, up - down, 2.0 * (up2 - down2))
    up, up2, down2 = -q3 * g2, q8 * q2 * gg, q4 * r2
    both = up2 + down2
    of_b = (g * (1.0 - both), g * (up - r), 2.0 * g * both, g * (up + r), 2.0 * g * (up2 - down2))
    zero = xp.zeros_like(q)
    return (start, zero, *of_a, *of_b, *(zero,) * 6)


def _complementary_arguments(*columns: Array) -> tuple[Array, ...]:
    """Return start, harmonics, nome and parity of the form for m > ½, separatrix included."""
    _, B, C, P, Q, G, l1, l2, l3, m, m1, separatrix = columns[:12]
    xp = namespace(B)
    total = B * Q
    k = xp.where(separatrix, 1.0, xp.sqrt(m / total))
    small = xp.where(separatrix, 0.0, m1 / total)
    q = small * nome_per_parameter(small, k)
    cosine, dc, along = xp.sqrt(C) * xp.abs(l1), xp.sqrt(C) * l3 * xp.sqrt(P / Q), xp.abs(xp.sqrt(B) * l2)
    # close to the unstable axis the hyperbolic sine and its square leave the range of numbers
    huge = cosine + dc < HUGE[0] * along
    factor, sinh = _landen(k, xp.sqrt(P / B) / G, xp.where(huge, HUGE[1] * along, along), cosine, dc)
    y = xp.atan(xp.sqrt(Q / P) * factor)
    x = xp.where(huge, xp.log(2.0 * sinh), xp.asinh(sinh))
    back = xp.where(huge, 0.5 * xp.exp(x), xp.sinh(x))
    x = dd.fast_two_sum(x, (sinh - back) / xp.where(huge, back, xp.sqrt(1.0 + back * back)))
    zero = xp.zeros_like(q)
    x = dd.where(huge, dd.add(x, tuple(c + zero for c in LOG_OF_SCALE)), x)
    x = dd.scale(x, xp.where((l2 < 0) != (l1 < 0), -1.0, 1.0))
    # πK/K' = 2K/θ3², and 1/θ3² is 1 less the small correction
    pi = tuple(c + xp.zeros_like(q) for c in dd.PI)
    period = dd.divide(dd.multiply(columns[12:14], pi), columns[14:16])
    e = 2.0 * (q + q**4 + q**9)
    period = dd.add(period, (-period[0] * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), xp.zeros_like(q)))
    period = dd.where(separatrix, dd.from_float(xp.ones_like(q)), period)
    start = dd.divide(x, period)
    upper, lower = split_halves(period[0])
    angles = [(2 * n + 1) * (0.5 * y - 0.25 * math.pi) for n in range(5)]
    harmonics = (*(xp.cos(a) for a in angles), *(xp.sin(a) for a in angles))
    periodic = xp.where(separatrix, 0.0, 1.0)
    y_turns = periodic * y * (0.5 / math.pi)
    parity = xp.where(l1 < 0, 1.0, 0.0)
    return (*start, *harmonics, xp.sqrt(q), upper, lower + period[1], y_turns, periodic, parity)


def _matrices(
    motion: Motion, body: Reduction, rates: Frequencies, moments: Array, momentum: Array, attitude: Array
) -> tuple[tuple[tuple[Array, ...], ...], tuple[tuple[Array, ...], ...]]:
    """Return the matrices from spinor to attitude and from canonical direction to momentum in the given axes."""
    xp = namespace(motion.full)
    a0, a1, b0, b1 = start_spinor(motion)
    norm = xp.sqrt((a0 * a0 + a1 * a1) + (b0 * b0 + b1 * b1))
    a0, a1, b0, b1 = a0 / norm, a1 / norm, b0 / norm, b1 / norm
    # rows of (start frame)* (present frame) as functions of the spinor (Re A, Im A, Re B, Im B)
    relative = ((a0, a1, b0, b1), (-b1, b0, -a1, a0), (b0, b1, -a0, -a1), (-a1, a0, b1, -b0))
    mirror = xp.where(body.long_axis, -1.0, 1.0)
    axes = [[mirror * x for x in row] for row in body.axes]
    turned = [[_sum(axes[i][j] * relative[1 + j][k] for j in range(3)) for i in range(3)] for k in range(4)]
    axis = _rotation_axis(moments, momentum)
    constant = rates.constant
    zero, one = xp.zeros_like(a0), xp.ones_like(a0)
    start = tuple(attitude[..., k] for k in range(4))
    columns = []
    for k in range(4):
        scalar = xp.where(constant, one if k == 0 else zero, relative[0][k])
        vector = tuple(xp.where(constant, axis[i] if k == 1 else zero, turned[k][i]) for i in range(3))
        columns.append(product_of_parts(start, (scalar, *vector)))
    size = rates.G[0] * body.momentum_scale
    to_momentum = tuple(
        tuple(xp.where(constant, momentum[..., i] if j == 2 else zero, size * body.axes[i][j] + zero) for j in range(3))
        for i in range(3)
    )
    return tuple(tuple(columns[k][i] for k in range(4)) for i in range(4)), to_momentum


def _sum(terms: Any) -> Array:
    first, *rest = terms
    for term in rest:
        first = first + term
    return first


def _rotation_axis(moments: Array, momentum: Array) -> tuple[Array, ...]:
    """Return the direction of Ω along the given axes, zero at rest."""
    xp = namespace(moments)
    I, L = ([v[..., k] for k in range(3)] for v in (moments, momentum))  # noqa: E741
    largest = xp.maximum(xp.maximum(xp.abs(L[0]), xp.abs(L[1])), xp.abs(L[2]))
    largest = xp.where(largest > 0, largest, 1.0)
    least = xp.minimum(xp.minimum(I[0], I[1]), I[2])
    x, y, z = (momentum / largest * (least / moment) for momentum, moment in zip(L, I, strict=True))
    size = xp.sqrt((x * x + y * y) + z * z)
    size = xp.where(size > 0, size, 1.0)
    return x / size, y / size, z / size

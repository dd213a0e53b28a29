"""Canonical reduction of a free body: sorted axes, short-axis mode, positive third component, and its invariants.

Every body is brought to moments I1 ≤ I2 ≤ I3 with 2E I2 ≤ |L|² and L3 ≥ 0 by a proper rotation that sorts, a
mirror in which time runs backward (long-axis mode), and a half turn about the second axis. One set of formulas then
serves all. Source: van Zon & Schofield, J. Comput. Phys. 225 (2007) 145, with the cancellations removed.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    Sum,
    Truth,
    add,
    as_sum,
    binary_exponent,
    choice,
    choose,
    distil,
    join,
    larger,
    multiply,
    multiply_float,
    multiply_terms,
    root_or_zero,
    scale,
    smaller,
    square_root,
    subtract,
    times_power,
    two_product,
    two_square,
    two_sum,
    where,
)

TINY_RATIO = 2.0**-900  # of components of L, below which numbers with it are scaled up by LIFT binary places
LIFT = 100.0
SHARP = 1e-280  # products of double-doubles above it have all their digits
NEAR = 1e-2  # of the terms of S: what is left below it is summed exactly
Three = tuple[Number, Number, Number]
Axis = tuple[Number, Number, Number]  # its moment, momentum and place among the given ones


class Scaled(NamedTuple):
    """A body with sorted axes and without powers of two."""

    moments: Three  # ascending, ½ ≤ I3 < 1
    momentum: Three  # along the sorted axes, ½ ≤ max |L_i| < 1, times 2^LIFT if a component is tiny
    order: Three  # which of the given axes they are
    parity: Number  # −1 if sorting is no proper rotation; the momentum then has the other sign
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number


class Sums(NamedTuple):
    """Invariants before the mirror, each a sum of terms of one sign."""

    A: Pair
    B: Pair
    C: Pair
    P: Pair
    Q: Pair
    G2: Pair


class Reduction(NamedTuple):
    """A body in canonical form; all pairs are double-double.

    With V = I1 I2 I3: A = (I2−I1)I3, B = (I3−I2)I1, C = (I3−I1)I2, P = C L1² + B L2², Q = A L2² + C L3² and
    S = A L1² − B L3² ≤ 0 are V times the textbook quantities, which avoids all divisions; the mirror has been applied.
    """

    moments: Three  # those of ``Scaled``
    momentum: Three
    canonical: Three  # momentum after mirror and half turn, third component ≥ 0
    A: Pair
    B: Pair
    C: Pair
    P: Pair
    Q: Pair
    S: Pair
    root_S: Pair  # √−S, accurate where S itself underflows
    root_P: Number  # √P, likewise
    V: Pair
    G2: Pair  # |L|²
    long_axis: Truth  # whether the mirror was applied
    order: Three  # which of the given axes the canonical ones are
    parity: Number  # that of ``Scaled``
    half_turn: Number  # −1 where the half turn about the second axis was applied
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number


# ---------------------------------------------------------------------- order and size


def _in_order(one: Axis, other: Axis, parity: float) -> tuple[Axis, Axis, float]:
    swap = other[0] < one[0]
    return (
        (where(swap, other[0], one[0]), where(swap, other[1], one[1]), where(swap, other[2], one[2])),
        (where(swap, one[0], other[0]), where(swap, one[1], other[1]), where(swap, one[2], other[2])),
        where(swap, -parity, parity),
    )  # fmt: skip


def _size(x: float, size: float) -> float:
    return where(x == 0.0, size, abs(x))


def scaled(moments: Three, momentum: Three) -> Scaled:
    """Sort the axes by their moments, and take out powers of two."""
    x, y, parity = _in_order((moments[0], momentum[0], 0.0), (moments[1], momentum[1], 1.0), 1.0)
    y, z, parity = _in_order(y, (moments[2], momentum[2], 2.0), parity)
    x, y, parity = _in_order(x, y, parity)
    size = larger(larger(abs(x[1]), abs(y[1])), abs(z[1]))
    # a component down to the smallest number keeps its digits in what is formed of it
    smallest = smaller(smaller(_size(x[1], size), _size(y[1], size)), _size(z[1], size))
    of_momentum = binary_exponent(size) - where(smallest < TINY_RATIO * size, LIFT, 0.0)
    of_moments = binary_exponent(z[0])
    return Scaled(
        (times_power(x[0], -of_moments), times_power(y[0], -of_moments), times_power(z[0], -of_moments)),
        (
            parity * times_power(x[1], -of_momentum), parity * times_power(y[1], -of_momentum),
            parity * times_power(z[1], -of_momentum),
        ),
        (x[2], y[2], z[2]), parity, times_power(1.0, of_momentum), times_power(1.0, of_momentum - of_moments),
    )  # fmt: skip


# ---------------------------------------------------------------------- invariants


def sums_of(body: Scaled) -> Sums:
    """Return the invariants but S."""
    i1, i2, i3 = body.moments
    x, y, z = body.momentum
    a = multiply_float(two_sum(i2, -i1), i3)
    b = multiply_float(two_sum(i3, -i2), i1)
    c = multiply_float(two_sum(i3, -i1), i2)
    s1, s2, s3 = two_square(x), two_square(y), two_square(z)
    p, q = add(multiply(c, s1), multiply(b, s2)), add(multiply(a, s2), multiply(c, s3))
    return Sums(a, b, c, p, q, add(add(s1, s2), s3))


def _exponent_near_saddle(body: Scaled) -> float:
    return binary_exponent(larger(abs(body.momentum[0]), abs(body.momentum[2])))


def terms_of_distance(body: Scaled) -> tuple[Three, float, float]:
    """Return the moments, and L1 and L3 scaled up: near the saddle their squares would lose their low words."""
    exponent = _exponent_near_saddle(body)
    x, _, z = body.momentum
    return body.moments, times_power(x, -exponent), times_power(z, -exponent)


def plain_distance(a: Pair, b: Pair, x: float, z: float) -> tuple[Pair, bool]:
    """Return A x² − B z² in double-double, and whether so much cancels that it is to be summed exactly."""
    first = multiply(a, two_square(x))
    distance = subtract(first, multiply(b, two_square(z)))
    return distance, abs(distance[0]) < NEAR * first[0]


def _of_square(gap: Pair, moment: float, x: float) -> Sum:
    """Return the product of a gap, a moment and x²."""
    return multiply_terms(multiply_terms(multiply_terms(as_sum(gap), moment), x), x)


def exact_distance(moments: Three, x: float, z: float) -> Pair:
    """Return S = (I2 − I1) I3 x² − (I3 − I2) I1 z², correct to its last digit however close to the separatrix."""
    i1, i2, i3 = moments
    return distil(join(_of_square(two_sum(i2, -i1), i3, x), _of_square(two_sum(i3, -i2), -i1, z)))


def _exact(values: tuple[tuple[Three, float, float], Pair]) -> Pair:
    moments, x, z = values[0]
    return exact_distance(moments, x, z)


def _plain(values: tuple[tuple[Three, float, float], Pair]) -> Pair:
    return values[1]


def signed_distance(body: Scaled, sums: Sums) -> Pair:
    """Return A L1² − B L3², with both components scaled up."""
    terms = terms_of_distance(body)
    plain, near = plain_distance(sums.A, sums.B, terms[1], terms[2])
    return choose(near, _exact, _plain, (terms, plain))


# ---------------------------------------------------------------------- mirror and half turn


def _root_of_sum(value: float, c: float, x: float, b: float, y: float) -> float:
    """Return √(C x² + B y²), of which the sum is given but may have lost digits, or all, to underflow."""
    exponent = binary_exponent(larger(abs(x), abs(y)))
    x, y = times_power(x, -exponent), times_power(y, -exponent)
    return where(value > SHARP, square_root(value), times_power(square_root(c * x * x + b * y * y), exponent))


def reduced(body: Scaled, sums: Sums, distance: Pair) -> Reduction:
    """Apply mirror and half turn; the distance is that of ``signed_distance``."""
    long_axis = distance[0] > 0.0
    a, b = choice(long_axis, sums.B, sums.A), choice(long_axis, sums.A, sums.B)
    p, q = choice(long_axis, sums.Q, sums.P), choice(long_axis, sums.P, sums.Q)
    x, y, z = body.momentum
    x, z = where(long_axis, z, x), where(long_axis, x, z)
    half_turn = where(z < 0.0, -1.0, 1.0)
    i1, i2, i3 = body.moments
    side, near = where(long_axis, 1.0, -1.0), times_power(1.0, _exponent_near_saddle(body))
    minus_s = scale(distance, side)
    first, second, third = body.order
    return Reduction(
        body.moments, body.momentum, (x * half_turn, y, z * half_turn), a, b, sums.C, p, q,
        scale(scale(minus_s, -near), near), scale(root_or_zero(minus_s), near),
        _root_of_sum(p[0], sums.C[0], x, b[0], y), multiply_float(two_product(i1, i2), i3), sums.G2, long_axis,
        (where(long_axis, third, first), second, where(long_axis, first, third)), body.parity, half_turn,
        body.momentum_scale, body.rate_scale,
    )  # fmt: skip


def reduction(moments: Three, momentum: Three) -> Reduction:
    """Return the canonical form of a body, in any order and at any scale."""
    body = scaled(moments, momentum)
    sums = sums_of(body)
    return reduced(body, sums, signed_distance(body, sums))

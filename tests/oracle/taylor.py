"""The free rigid body by Taylor integration of its equations: the second oracle, which confirms the first.

It knows nothing of elliptic functions: power series of L' = L × Ω and q' = q Ω / 2 in fixed-point integers, with
as many terms as the precision asks for. Slow, so for moderate times only.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import ceil, isqrt, log2
from operator import mul

from flint import arb, ctx

from oracle.measures import rotation_of
from oracle.reference import Exact, Reference, exact

ACCURATE_BITS = 150
"""45 digits before the growth of rounding errors, which `growth_bits` covers."""
STEP = Fraction(1, 4)
"""|L| h / I_min of one step: the series then converge like 2^-3k or faster."""
Series = list[int]


def integrated_state(
    moments: Sequence[Exact], momentum: Sequence[Exact], t: Exact, growth_bits: int = 0
) -> Reference:
    """Return attitude and momentum direction at ``t``, from the identity at 0.

    Args:
        moments: three positive principal moments, in any order.
        momentum: angular momentum at t = 0 along the principal axes.
        t: time.
        growth_bits: bits by which the motion magnifies errors, as e^{λt} does beside the saddle.
    """
    inertia, vector = [_fraction(v) for v in moments], [_fraction(v) for v in momentum]
    square = sum((x * x for x in vector), Fraction(0))
    norm = _root(square, 4 * ACCURATE_BITS + growth_bits)
    speeds = [norm / i for i in inertia]
    turn = max(speeds) * abs(_fraction(t))
    steps = max(1, ceil(turn / STEP))
    bits = ACCURATE_BITS + growth_bits + 2 * ceil(log2(steps + 1)) + 16
    angles = [round(speed * _fraction(t) / steps * 2**bits) for speed in speeds]
    direction = [round(x / norm * 2**bits) for x in vector]
    quaternion = [1 << bits, 0, 0, 0]
    for _ in range(steps):
        direction, quaternion = _step(direction, quaternion, angles, bits)
    with ctx.workprec(2 * bits):
        unit = arb(2) ** bits
        found = [arb(x) / unit for x in quaternion]
        return Reference(rotation_of(found), [arb(x) / unit for x in direction], found)


def _fraction(value: Exact) -> Fraction:
    number = exact(value)
    return Fraction(int(number.p), int(number.q))


def _root(square: Fraction, bits: int) -> Fraction:
    """Square root to ``bits`` significant bits or more, whatever the size."""
    shift = 2 * (bits + max(0, square.denominator.bit_length() - square.numerator.bit_length()))
    return Fraction(isqrt((square.numerator << shift) // square.denominator), 1 << (shift // 2))


def _step(direction: list[int], quaternion: list[int], angles: list[int], bits: int) -> tuple[list[int], list[int]]:
    """One step: coefficients carry h^k, ``angles`` are |L| h / I_i; all numbers are integers over 2^bits."""
    n1, n2, n3 = ([x] for x in direction)
    w, x, y, z = ([value] for value in quaternion)
    a1, a2, a3 = angles
    order = 0
    while order < 4 or any(abs(series[k]) > 1 for series in (n1, n2, n3, w, x, y, z) for k in (-1, -2, -3)):
        down = [series[::-1] for series in (n1, n2, n3)]

        def with_rate(series: Series, axis: int, down: list[Series] = down) -> int:
            return (_convolution(series, down[axis]) >> bits) * angles[axis]

        scale = 2 * (order + 1)
        w_next = -with_rate(x, 0) - with_rate(y, 1) - with_rate(z, 2)
        x_next = with_rate(w, 0) + with_rate(y, 2) - with_rate(z, 1)
        y_next = with_rate(w, 1) + with_rate(z, 0) - with_rate(x, 2)
        z_next = with_rate(w, 2) + with_rate(x, 1) - with_rate(y, 0)
        n1_next = 2 * (a3 - a2) * (_convolution(n2, down[2]) >> bits)
        n2_next = 2 * (a1 - a3) * (_convolution(n3, down[0]) >> bits)
        n3_next = 2 * (a2 - a1) * (_convolution(n1, down[1]) >> bits)
        new = (n1_next, n2_next, n3_next, w_next, x_next, y_next, z_next)
        for series, value in zip((n1, n2, n3, w, x, y, z), new, strict=True):
            series.append((value >> bits) // scale)
        order += 1
    return [sum(series) for series in (n1, n2, n3)], [sum(series) for series in (w, x, y, z)]


def _convolution(series: Series, down: Series) -> int:
    return sum(map(mul, series, down))

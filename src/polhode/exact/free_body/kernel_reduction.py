"""The steps of ``reduction`` for a block of bodies, compiled by Numba, and which of them the kernels take.

Bodies without a period (at rest, spherical, permanent rotation, on the separatrix), and those with numbers farther
apart than ``RANGE`` and ``SPREAD``, are left to NumPy: they need what only few need.
"""

from __future__ import annotations

from typing import Any

from polhode.exact.kernel_arithmetic import (
    BLOCK,
    Pair,
    add,
    bits_of,
    called,
    flags,
    inlined,
    multiply,
    multiply_float,
    of_bits,
    subtract,
    two_product,
    two_sum,
)

RANGE = 1e-120, 1e120  # of the largest moment and component of momentum
SPREAD = 2.0**-60  # of the moments, and of the components of momentum that are not zero: nothing underflows
NEAR = 1e-2  # of what cancels near the separatrix
# rows of BLOCK numbers in the store of a block of bodies: what these are, and what is formed before they are sorted
(I1, I2, I3, L1, L2, L3, FIRST, SECOND, THIRD, PARITY, SIZE, RATE, A, A_, B, B_, C, C_, P, P_, Q, Q_, GG, GG_, S,
 S_) = range(0, 26 * BLOCK, BLOCK)  # fmt: skip
KEPT = 26
# of what is found of them; LONG is −1 after the mirror, LEAD what the third-kind sum is multiplied by
(X1, X3, LONG, HALF, LEAD, LEAD_, V, V_, G, G_, FAST, FAST_, MEAN, MEAN_, SUM, SUM_, UP, ACROSS, E0, E1, E2,
 E3) = range(26 * BLOCK, 48 * BLOCK, BLOCK)  # fmt: skip
ROWS = 48


@inlined
def _power(exponent: int) -> float:
    return of_bits((exponent + 1023) << 52)


@inlined
def _exponent(x: float) -> int:
    """Return the exponent of ``frexp`` of a normal number, whatever its sign."""
    return ((bits_of(x) >> 52) & 2047) - 1022


@inlined
def _load(w: Any, i: int, moments: Any, momentum: Any) -> bool:
    """Sort and scale a body, ``reduction._sorted_and_scaled``; return whether its numbers are near enough together."""
    a, b, c = moments[0], moments[1], moments[2]
    x, y, z = momentum[0], momentum[1], momentum[2]
    p, q, r, parity = 0.0, 1.0, 2.0, 1.0
    if b < a:
        a, b, x, y, p, q, parity = b, a, y, x, q, p, -parity
    if c < b:
        b, c, y, z, q, r, parity = c, b, z, y, r, q, -parity
    if b < a:
        a, b, x, y, p, q, parity = b, a, y, x, q, p, -parity
    size = max(max(abs(x), abs(y)), abs(z))
    lowest = SPREAD * size
    near = (x == 0.0 or abs(x) >= lowest) and (y == 0.0 or abs(y) >= lowest) and (z == 0.0 or abs(z) >= lowest)
    within = RANGE[0] < c < RANGE[1] and RANGE[0] < size < RANGE[1]
    of_moments, of_momentum = _exponent(c), _exponent(size)
    down, lower = _power(-of_moments), parity * _power(-of_momentum)
    w[I1 + i], w[I2 + i], w[I3 + i] = a * down, b * down, c * down
    w[L1 + i], w[L2 + i], w[L3 + i] = x * lower, y * lower, z * lower
    w[FIRST + i], w[SECOND + i], w[THIRD + i], w[PARITY + i] = p, q, r, parity
    w[SIZE + i], w[RATE + i] = _power(of_momentum), _power(of_momentum - of_moments)
    return within and near and a >= SPREAD * c


@called
def _sums(w: Any, count: int) -> None:
    """Form the invariants of ``reduction._sums``, and S in double-double."""
    for i in range(count):
        i1, i2, i3 = w[I1 + i], w[I2 + i], w[I3 + i]
        a = multiply_float(two_sum(i2, -i1), i3)
        b = multiply_float(two_sum(i3, -i2), i1)
        c = multiply_float(two_sum(i3, -i1), i2)
        x, y, z = w[L1 + i], w[L2 + i], w[L3 + i]
        s1, s2, s3 = two_product(x, x), two_product(y, y), two_product(z, z)
        first = multiply(a, s1)
        w[A + i], w[A_ + i] = a
        w[B + i], w[B_ + i] = b
        w[C + i], w[C_ + i] = c
        w[P + i], w[P_ + i] = add(multiply(c, s1), multiply(b, s2))
        w[Q + i], w[Q_ + i] = add(multiply(a, s2), multiply(c, s3))
        w[GG + i], w[GG_ + i] = add(add(s1, s2), s3)
        w[S + i], w[S_ + i] = subtract(first, multiply(b, s3))
        w[UP + i] = NEAR * first[0]


@called
def _exact_difference(w: Any, i: int, terms: Any) -> Pair:
    """Return S of one body near the separatrix, ``reduction._signed_distance_from_separatrix``."""
    i1, i2, i3, x, z = w[I1 + i], w[I2 + i], w[I3 + i], w[L1 + i], w[L3 + i]
    for start, gap, factor, momentum in ((0, two_sum(i2, -i1), i3, x), (16, two_sum(i3, -i2), -i1, z)):
        terms[start], terms[start + 1] = gap
        count = 2
        for k in range(3):
            for j in range(count - 1, -1, -1):
                term = two_product(terms[start + j], factor if k == 0 else momentum)
                terms[start + 2 * j], terms[start + 2 * j + 1] = term
            count *= 2
    for _ in range(5):
        running = terms[0]
        for j in range(1, 32):
            running, error = two_sum(running, terms[j])
            terms[j - 1] = error
        terms[31] = running
    rest = terms[0]
    for j in range(1, 31):
        rest += terms[j]
    return two_sum(terms[31], rest)


@inlined
def _form(w: Any, i: int) -> int:
    """Return 1 for a body that takes the full form, 0 for the complementary one, −1 for one without a period."""
    long_axis = w[S + i] > 0.0
    b, p, q = (w[A + i], w[Q + i], w[P + i]) if long_axis else (w[B + i], w[P + i], w[Q + i])
    a = w[B + i] if long_axis else w[A + i]
    if not (b * q > 0.0 and p > 0.0 and w[S + i] != 0.0 and (w[L1 + i] != 0.0 or w[L3 + i] != 0.0)):
        return -1
    return 1 if a * p <= w[C + i] * abs(w[S + i]) else 0


@called
def begin(moments: Any, momentum: Any, begun: Any, w: Any, place: Any, terms: Any) -> tuple[int, int]:
    """Reduce a block and sort it; return how many bodies take the full form, and how many any. ``place`` has them."""
    count = len(moments)
    within = flags(count)
    for i in range(count):
        within[i] = _load(begun, i, moments[i], momentum[i])
    _sums(begun, count)
    for i in range(count):
        if abs(begun[S + i]) < begun[UP + i]:
            begun[S + i], begun[S_ + i] = _exact_difference(begun, i, terms)
    full, back = 0, count
    for i in range(count):
        form = _form(begun, i) if within[i] else -1
        if form == 1:
            place[full] = i
            full += 1
        elif form == 0:
            back -= 1
            place[back] = i
    for i in range(back, count):
        place[full + i - back] = place[i]
    good = full + count - back
    for k in range(KEPT):
        for i in range(good):
            w[k * BLOCK + i] = begun[k * BLOCK + place[i]]
    return full, good



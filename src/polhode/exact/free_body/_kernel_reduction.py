"""The steps of ``reduction`` for a block of bodies, compiled by Numba, and which of them the kernels take.

Bodies without a period (at rest, spherical, permanent rotation, on the separatrix), and those with numbers farther
apart than ``RANGE`` and ``SPREAD``, are left to NumPy: they need what only few need.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    Pair,
    bits_of,
    flags,
    of_bits,
    put,
    put_record,
    two_product,
    two_sum,
)
from polhode.exact.free_body import _kernel_store as at
from polhode.exact.free_body._formulas_setup import difference, invariants
from polhode.exact.free_body._kernel_store import KEPT

RANGE = 1e-120, 1e120  # of the largest moment and component of momentum
SPREAD = 2.0**-60  # of the moments, and of the components of momentum that are not zero: nothing underflows
NEAR = 1e-2  # of what cancels near the separatrix


def _power(exponent: int) -> float:
    return of_bits((exponent + 1023) << 52)


def _exponent(x: float) -> int:
    """Return the exponent of ``frexp`` of a normal number, whatever its sign."""
    return ((bits_of(x) >> 52) & 2047) - 1022


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
    w[at.I1 + i], w[at.I2 + i], w[at.I3 + i] = a * down, b * down, c * down
    w[at.L1 + i], w[at.L2 + i], w[at.L3 + i] = x * lower, y * lower, z * lower
    w[at.FIRST + i], w[at.SECOND + i], w[at.THIRD + i], w[at.PARITY + i] = p, q, r, parity
    w[at.SIZE + i], w[at.RATE + i] = _power(of_momentum), _power(of_momentum - of_moments)
    return within and near and a >= SPREAD * c


@called
def _sums(w: Any, count: int) -> None:
    """Form the invariants, and S in double-double."""
    for i in range(count):
        x, z = w[at.L1 + i], w[at.L3 + i]
        a, b, c, p, q, gg = invariants((w[at.I1 + i], w[at.I2 + i], w[at.I3 + i]), (x, w[at.L2 + i], z))
        put_record(w, at.A + i, (*a, *b, *c, *p, *q, *gg))
        s, first = difference(a, b, x, z)
        put(w, at.S + i, s)
        w[at.UP + i] = NEAR * first


@called
def _exact_difference(w: Any, i: int, terms: Any) -> Pair:
    """Return S of one body near the separatrix, ``reduction._signed_distance_from_separatrix``."""
    i1, i2, i3, x, z = w[at.I1 + i], w[at.I2 + i], w[at.I3 + i], w[at.L1 + i], w[at.L3 + i]
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


def _form(w: Any, i: int) -> int:
    """Return 1 for a body that takes the full form, 0 for the complementary one, −1 for one without a period."""
    long_axis = w[at.S + i] > 0.0
    b, p, q = (w[at.A + i], w[at.Q + i], w[at.P + i]) if long_axis else (w[at.B + i], w[at.P + i], w[at.Q + i])
    a = w[at.B + i] if long_axis else w[at.A + i]
    if not (b * q > 0.0 and p > 0.0 and w[at.S + i] != 0.0 and (w[at.L1 + i] != 0.0 or w[at.L3 + i] != 0.0)):
        return -1
    return 1 if a * p <= w[at.C + i] * abs(w[at.S + i]) else 0


@called
def begin(moments: Any, momentum: Any, begun: Any, w: Any, place: Any, terms: Any) -> tuple[int, int]:
    """Reduce a block and sort it; return how many bodies take the full form, and how many any. ``place`` has them."""
    count = len(moments)
    within = flags(count)
    for i in range(count):
        within[i] = _load(begun, i, moments[i], momentum[i])
    _sums(begun, count)
    for i in range(count):
        if abs(begun[at.S + i]) < begun[at.UP + i]:
            put(begun, at.S + i, _exact_difference(begun, i, terms))
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



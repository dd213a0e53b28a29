"""Canonical reduction of a free body: sorted axes, short-axis mode, positive third component, and its invariants.

Every body is brought to moments I1 ≤ I2 ≤ I3 with 2E I2 ≤ |L|² and L3 ≥ 0 by a proper rotation that sorts, a
mirror in which time runs backward (long-axis mode), and a half turn about the second axis. One set of formulas then
serves all. Source: van Zon & Schofield, J. Comput. Phys. 225 (2007) 145, with the cancellations removed.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from polhode._base.arrays import choose, compiled, namespace
from polhode.exact._array_arithmetic import for_arrays
from polhode.exact.free_body import _formulas_setup as formulas_setup
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Bool, Float64

FORMULAS = for_arrays(formulas_setup)
TINY_RATIO = 2.0**-900  # of components of L, below which numbers with it are scaled up by LIFT binary places
LIFT = 100
SHARP = 1e-280  # products of double-doubles above it have all their digits
Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]
Triple = tuple[Number, Number, Number]


class Reduction(NamedTuple):
    """A body in canonical form; all pairs are double-double.

    With V = I1 I2 I3: A = (I2−I1)I3, B = (I3−I2)I1, C = (I3−I1)I2, P = C L1² + B L2², Q = A L2² + C L3² and
    S = A L1² − B L3² ≤ 0 are V times the textbook quantities, which avoids all divisions; the mirror has been applied.
    """

    moments: Triple  # ascending, scaled by a power of two so that ½ ≤ I3 < 1
    momentum: Triple  # along the sorted axes, scaled so that ½ ≤ max |L_i| < 1, times 2^LIFT if a component is tiny
    canonical: Triple  # momentum after mirror and half turn, third component ≥ 0
    A: DoubleDouble
    B: DoubleDouble
    C: DoubleDouble
    P: DoubleDouble
    Q: DoubleDouble
    S: DoubleDouble
    root_S: DoubleDouble  # √−S, accurate where S itself underflows
    root_P: Number  # √P, likewise
    V: DoubleDouble
    G2: DoubleDouble  # |L|²
    long_axis: Flag  # whether the mirror was applied
    axes: tuple[Triple, ...]  # given components = axes · canonical components, signed permutation by rows
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number


def canonical_reduction(moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"]) -> Reduction:
    """Return the canonical form of bodies with moments and momentum (…, 3), any order, any scale.

    On JAX each stage is compiled by itself: as one kernel XLA would compute S again for everything that uses it.
    """
    sorted_ = compiled(_sorted_and_scaled, moments)(moments, momentum)
    I, L = sorted_[0], sorted_[1]  # noqa: E741
    sums = compiled(FORMULAS.invariants, moments)(I, L)
    # near the saddle L1² and L3² would lose their low words, so S is formed with both scaled up
    S = compiled(_signed_distance_from_separatrix, moments)(I, (L[0] * sorted_[5], L[1], L[2] * sorted_[5]), *sums[:2])
    return compiled(_assembled, moments)(sorted_, sums, S)


def _sorted_and_scaled(moments: Array, momentum: Array) -> tuple[Any, ...]:
    """Return moments, momentum, order and its parity, the scale of L1 and L3, its inverse, and the scales taken out."""
    xp = namespace(moments, momentum)
    order = xp.argsort(moments, axis=-1, stable=True)
    first, second, third = (order[..., k] for k in range(3))
    parity = xp.where((second - first) * (third - first) * (third - second) > 0, 1.0, -1.0)
    sort = lambda v: tuple(xp.take_along_axis(v, order, axis=-1)[..., k] for k in range(3))  # noqa: E731
    I, L = sort(moments), sort(momentum)  # noqa: E741
    _, moment_exponent = xp.frexp(I[2])
    size = xp.maximum(xp.maximum(xp.abs(L[0]), xp.abs(L[1])), xp.abs(L[2]))
    _, momentum_exponent = xp.frexp(size)
    # a component down to the smallest number keeps its digits in what is formed of it
    smallest = size
    for x in L:
        smallest = xp.minimum(smallest, xp.where(x == 0, size, xp.abs(x)))
    momentum_exponent = momentum_exponent - xp.where(smallest < TINY_RATIO * size, LIFT, 0)
    I = tuple(xp.ldexp(x, -moment_exponent) for x in I)  # noqa: E741
    L = tuple(parity * xp.ldexp(x, -momentum_exponent) for x in L)
    _, exponent = xp.frexp(xp.maximum(xp.abs(L[0]), xp.abs(L[2])))
    one = xp.ones_like(L[0])
    near, up = xp.ldexp(one, exponent), xp.ldexp(one, -exponent)
    scales = xp.ldexp(one, momentum_exponent), xp.ldexp(one, momentum_exponent - moment_exponent)
    return I, L, (first, second, third), parity, near, up, scales


def _assembled(sorted_: tuple[Any, ...], sums: tuple[DoubleDouble, ...], S: DoubleDouble) -> Reduction:
    """Apply mirror and half turn."""
    I, L, (first, second, third), parity, near, _, scales = sorted_  # noqa: E741
    A, B, C, P, Q, G2 = sums
    xp = namespace(near)
    long_axis = S[0] > 0
    swap = lambda x, y: (dd.where(long_axis, y, x), dd.where(long_axis, x, y))  # noqa: E731
    A, B = swap(A, B)
    P, Q = swap(P, Q)
    l1, l3 = xp.where(long_axis, L[2], L[0]), xp.where(long_axis, L[0], L[2])
    half_turn = xp.where(l3 < 0, -1.0, 1.0)
    flips = (half_turn, 1.0, half_turn)
    indices = (xp.where(long_axis, third, first), second, xp.where(long_axis, first, third))
    minus_S = dd.where(long_axis, S, dd.negate(S))
    return Reduction(
        moments=I,
        momentum=L,
        canonical=(l1 * half_turn, L[1], l3 * half_turn),
        A=A,
        B=B,
        C=C,
        P=P,
        Q=Q,
        S=dd.scale(dd.scale(minus_S, -near), near),
        root_S=dd.scale(dd.sqrt(minus_S), near),
        root_P=_root_of_sum(P[0], C[0], l1, B[0], L[1]),
        V=dd.multiply_float(dd.two_product(I[0], I[1]), I[2]),
        G2=G2,
        long_axis=long_axis,
        axes=tuple(tuple(xp.where(indices[j] == i, parity * flips[j], 0.0) for j in range(3)) for i in range(3)),
        momentum_scale=scales[0],
        rate_scale=scales[1],
    )


def _root_of_sum(value: Array, C: Array, x: Array, B: Array, y: Array) -> Array:
    """Return √(C x² + B y²), of which the sum is given but may have lost digits, or all, to underflow."""
    xp = namespace(value)
    _, exponent = xp.frexp(xp.maximum(xp.abs(x), xp.abs(y)))
    one = xp.ones_like(value)
    up, down = xp.ldexp(one, -exponent), xp.ldexp(one, exponent)
    x, y = x * up, y * up
    return xp.where(value > SHARP, xp.sqrt(value), xp.sqrt(C * x * x + B * y * y) * down)


def half_turn_sign(body: Reduction) -> Number:
    """Return −1 where the half turn about the second axis was applied, else 1."""
    xp = namespace(body.long_axis)
    third = xp.where(body.long_axis, body.momentum[0], body.momentum[2])
    return xp.where(third < 0, -1.0, 1.0)


def total(parts: Iterable[Any]) -> Any:
    """Return the sum of arrays, one at least; type checkers take a sum for a whole number where there may be none."""
    return sum(parts)


def as_sorted(body: Reduction, vector: Float64[Array, "*batch 3"]) -> Triple:
    """Return the components (…, 3) in the given axes along the sorted ones, as a proper rotation turns them."""
    return _between(body, [total(body.axes[i][j] * vector[..., i] for i in range(3)) for j in range(3)])


def from_sorted(body: Reduction, components: Triple) -> Triple:
    """Return components along the given axes; the inverse of ``as_sorted``."""
    canonical = _between(body, list(components))
    a, b, c = (row[0] * canonical[0] + row[1] * canonical[1] + row[2] * canonical[2] for row in body.axes)
    return a, b, c


def _between(body: Reduction, v: list[Array]) -> Triple:
    """Undo (or do) mirror and half turn, which commute and are their own inverses."""
    xp = namespace(body.long_axis, v[0])
    flip = half_turn_sign(body)
    return flip * xp.where(body.long_axis, v[2], v[0]), v[1], flip * xp.where(body.long_axis, v[0], v[2])


def _signed_distance_from_separatrix(I: Triple, L: Triple, A: DoubleDouble, B: DoubleDouble) -> DoubleDouble:  # noqa: E741
    """Return S = A L1² − B L3², correct to its last digit however close to the separatrix.

    Near it double-double alone would leave nothing of S; there the two products are expanded exactly.
    """
    xp = namespace(L[0])
    plain, first = FORMULAS.difference(A, B, L[0], L[2])

    def exact(*columns: Array) -> DoubleDouble:
        I1, I2, I3, L1, L3 = columns[:5]
        gain, loss = list(dd.two_sum(I2, -I1)), list(dd.two_sum(I3, -I2))
        for factor in (I3, L1, L1):
            gain = dd.expansion_product(gain, factor)
        for factor in (-I1, L3, L3):
            loss = dd.expansion_product(loss, factor)
        return dd.distil(gain + loss)

    near = xp.abs(plain[0]) < 1e-2 * first
    return choose(near, exact, lambda *columns: columns[5:], *I, L[0], L[2], *plain)  # type: ignore[return-value]

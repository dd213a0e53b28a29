"""The invariants of a Lagrange top, scaled, and accurate however close to each other the regimes come.

With a = L3, w = L1 + i L2, G = 2 mgl I1, τ = t/I1 and the Cayley–Klein parameters α = q0 + i q3, β = q1 + i q2, a top
of equal moments obeys 2α' = i a α − w̄ β, 2β' = w α − i a β, w' = G ᾱ β; I3 ≠ I1 only adds the constant spin
ν = L3 (I1 − I3)/(I1 I3) about the axis. Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. VI.

A centre of mass below the pivot (mgl < 0) is one above it on the reversed axis: a half turn about the first body axis.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode.arrays import namespace
from polhode.special import doubledouble as dd
from polhode.special.doubledouble import DoubleDouble
from polhode.types import Array, Bool, Float64

Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]


class Reduction(NamedTuple):
    """A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.

    u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ.
    """

    moments: tuple[Number, Number]  # I1, I3
    momentum: tuple[Number, Number, Number]
    quaternion: tuple[Number, Number, Number, Number]  # as given, not normalised
    size: DoubleDouble  # its |q|²
    G: DoubleDouble
    s0: DoubleDouble
    t0: DoubleDouble
    u0: DoubleDouble
    p: DoubleDouble  # u̇ at the epoch
    c: DoubleDouble  # p_φ − L3
    c_plus: DoubleDouble  # p_φ + L3
    twist: DoubleDouble  # p_φ − u L3 at the epoch
    F: DoubleDouble  # |w|² − G s − a c
    D: DoubleDouble  # 2G − a² − |w|² + G s
    w2: DoubleDouble  # |w|² at the epoch
    lean: DoubleDouble  # a (|w|² − G s) − G c: its sign against a's tells loops from waves
    reversed: Flag  # whether the axis was turned round
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number


def reduce_top(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Reduction:
    """Return the reduction of tops with moments (…, 3), mgl (…, 1), momentum (…, 3) and attitude (…, 4)."""
    xp = namespace(moments, mgl, momentum, attitude)
    turned = mgl[..., 0] < 0
    sign = xp.where(turned, -1.0, 1.0)
    I1, I3 = moments[..., 0], moments[..., 2]
    L1, L2, L3 = (momentum[..., k] for k in range(3))
    w, x, y, z = (attitude[..., k] for k in range(4))
    # a half turn about the first body axis: q → q i
    w, x, y, z = (xp.where(turned, new, old) for new, old in ((-x, w), (w, x), (z, y), (-y, z)))
    weight = xp.abs(mgl[..., 0])
    _, moment_exponent = xp.frexp(I1)
    momentum_exponent = _momentum_exponent(xp, I1, weight, (L1, L2, L3))
    one = xp.ones_like(L1)
    I1, I3 = xp.ldexp(I1, -moment_exponent), xp.ldexp(I3, -moment_exponent)
    L1, L2, L3 = (xp.ldexp(v, -momentum_exponent) for v in (L1, sign * L2, sign * L3))
    weight = xp.ldexp(xp.ldexp(weight, moment_exponent - momentum_exponent), -momentum_exponent)
    scales = xp.ldexp(one, momentum_exponent), xp.ldexp(one, momentum_exponent - moment_exponent)
    L, q = (L1, L2, L3), (w, x, y, z)
    parts = ((I1, I3), L, q, *_invariants(I1, weight, L, q), turned, *scales)
    return Reduction._make(parts)


def _momentum_exponent(xp: Any, I1: Array, weight: Array, momentum: tuple[Array, ...]) -> Array:
    """Return the exponent of the larger of |L| and √(mgl I1), without forming a product that may overflow."""
    largest = xp.maximum(xp.maximum(xp.abs(momentum[0]), xp.abs(momentum[1])), xp.abs(momentum[2]))
    _, exponent = xp.frexp(largest)
    _, of_moment = xp.frexp(I1)
    _, of_weight = xp.frexp(weight)
    half = (of_moment + of_weight + 1) // 2
    return xp.where(weight > 0, xp.where(largest > 0, xp.maximum(exponent, half), half), exponent)


def _invariants(
    I1: Array, weight: Array, momentum: tuple[Array, ...], quaternion: tuple[Array, ...]
) -> tuple[DoubleDouble, ...]:
    """Return |q|², G, s0, t0, u0, p, c, c', twist, F, D, |w|², lean: polynomials of the given floats over |q|².

    The polynomials are summed as expansions, since near the separatrix c, F and D vanish together and what is left of
    them decides how long the top lingers upright; double-double alone would leave nothing.
    """
    L1, L2, L3 = momentum
    w, x, y, z = quaternion
    product, short = dd.expansion_times_expansion, dd.compress
    G = [2.0 * v for v in dd.two_product(weight, I1)]
    S = short([*dd.two_product(x, x), *dd.two_product(y, y)])
    T = short([*dd.two_product(w, w), *dd.two_product(z, z)])
    size = short([*S, *T])
    real = short([*dd.two_product(x, w), *dd.two_product(y, z)])  # β̄α
    imaginary = short([*dd.two_product(x, z), *dd.two_product(-y, w)])
    in_phase = short([*product(real, [L1]), *product(imaginary, [-L2])])  # β̄αw
    twist = short([2.0 * v for v in (*product(real, [L2]), *product(imaginary, [L1]))])
    c = short([*twist, *product(S, [-2.0 * L3])])
    c_plus = short([*twist, *product(T, [2.0 * L3])])
    w2 = short([*dd.two_product(L1, L1), *dd.two_product(L2, L2)])
    energy = short([*product(size, w2), *product([-2.0 * g for g in G], S)], 5)
    F = short([*energy, *product(c, [-L3])], 5)
    rest = short([*(2.0 * g for g in G), *dd.two_product(L3, -L3)])
    D = short([*product(size, rest), *(-v for v in energy)], 5)
    n = dd.distil(size)
    over = lambda terms: dd.divide(dd.distil(terms), n)  # noqa: E731
    lean = short([*product(energy, [L3]), *product([-g for g in G], c)], 6)
    return (
        n, (G[0], G[1]), dd.scale(over(S), 2.0), dd.scale(over(T), 2.0), over([*T, *(-v for v in S)]),
        dd.scale(over(in_phase), -2.0), over(c), over(c_plus), over(twist), over(F), over(D), dd.distil(w2), over(lean),
    )  # fmt: skip

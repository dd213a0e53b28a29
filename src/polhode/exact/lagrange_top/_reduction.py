"""The invariants of a Lagrange top, scaled, and accurate however close to each other the regimes come.

With a = L3, w = L1 + i L2, G = 2 mgl I1, τ = t/I1 and the Cayley–Klein parameters α = q0 + i q3, β = q1 + i q2, a top
of equal moments obeys 2α' = i a α − w̄ β, 2β' = w α − i a β, w' = G ᾱ β; I3 ≠ I1 only adds the constant spin
ν = L3 (I1 − I3)/(I1 I3) about the axis. Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. VI.

A centre of mass below the pivot (mgl < 0) is one above it on the reversed axis: a half turn about the first body axis.

A top displaced from the vertical by a tiny ε has s or t, c or c', F and |w|² of the order of ε², and squares of these
underflow. There the motion is linear in the displacement, so the invariants are formed with the displacement scaled up
by a power of two. ``formulas_rates`` and ``formulas_setup`` undo this: the scaled top's state is scaled down if it
stays near the vertical, and the time it takes to leave grows by the logarithm of the scale if it does not.
"""

from __future__ import annotations

from typing import Any

from polhode._base.arrays import namespace
from polhode.exact.lagrange_top._formulas_roots import Reduction
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Float64

TINY, LIFTED = -200, -150  # binary exponents: of a displacement that is scaled up, and of what it becomes


def reduce_top(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Reduction:
    """Return the reduction of tops with moments (…, 3), mgl (…, 1), momentum (…, 3) and attitude (…, 4)."""
    xp = namespace(moments, mgl, momentum, attitude)
    reverse = mgl[..., 0] < 0
    sign = xp.where(reverse, -1.0, 1.0)
    I1, I3 = moments[..., 0], moments[..., 2]
    L1, L2, L3 = (momentum[..., k] for k in range(3))
    w, x, y, z = (attitude[..., k] for k in range(4))
    # a half turn about the first body axis: q → q i
    w, x, y, z = (xp.where(reverse, new, old) for new, old in ((-x, w), (w, x), (z, y), (-y, z)))
    weight = xp.abs(mgl[..., 0])
    _, moment_exponent = xp.frexp(I1)
    momentum_exponent = _momentum_exponent(xp, I1, weight, (L1, L2, L3))
    one = xp.ones_like(L1)
    I1, I3 = xp.ldexp(I1, -moment_exponent), xp.ldexp(I3, -moment_exponent)
    components = (L1, sign * L2, sign * L3)
    L1, L2, L3 = (xp.ldexp(v, -momentum_exponent) for v in components)
    weight = xp.ldexp(xp.ldexp(weight, moment_exponent - momentum_exponent), -momentum_exponent)
    scales = xp.ldexp(one, momentum_exponent), xp.ldexp(one, momentum_exponent - moment_exponent)
    G = dd.scale(dd.two_product(weight, I1), 2.0)
    size = _sum_of_squares(w, x, y, z)
    below, lift, kept = _lift(xp, G, (L1, L2, L3), (w, x, y, z))
    above, below = xp.where(below, 0, lift), xp.where(below, lift, 0)
    L = (*(kept * xp.ldexp(v, lift - momentum_exponent) for v in components[:2]), L3)
    q = (xp.ldexp(w, below), kept * xp.ldexp(x, above), kept * xp.ldexp(y, above), xp.ldexp(z, below))
    return Reduction((I1, I3), L, q, reverse, lift, *scales, *_invariants(G, size, L, q))


def _lift(
    xp: Any, G: DoubleDouble, momentum: tuple[Array, ...], quaternion: tuple[Array, ...]
) -> tuple[Array, Array, Array]:
    """Return whether the axis points down, the exponent that scales a tiny displacement up, and 0 to drop it, or 1.

    It is dropped exactly at the threshold of sleeping, 2G = a², where it grows like t and not like e^t: nothing is to
    show within 1e27 radians, the longest time for which a motion is given.
    """
    (L1, L2, L3), (w, x, y, z) = momentum, quaternion
    largest = lambda u, v: xp.maximum(xp.abs(u), xp.abs(v))  # noqa: E731
    cosine, sine = largest(w, z), largest(x, y)
    below = cosine < sine
    displacement = xp.maximum(xp.minimum(cosine, sine), largest(L1, L2))
    _, exponent = xp.frexp(displacement)
    double, square = dd.scale(G, 2.0), dd.two_product(L3, L3)
    threshold = (double[0] == square[0]) & (double[1] == square[1]) & ~below
    tiny = (displacement > 0) & (exponent < TINY) & (G[0] > 0)
    return below, xp.where(tiny & ~threshold, LIFTED - exponent, 0), xp.where(tiny & threshold, 0.0, 1.0)


def _momentum_exponent(xp: Any, I1: Array, weight: Array, momentum: tuple[Array, ...]) -> Array:
    """Return the exponent of the larger of |L| and √(mgl I1), without forming a product that may overflow."""
    largest = xp.maximum(xp.maximum(xp.abs(momentum[0]), xp.abs(momentum[1])), xp.abs(momentum[2]))
    _, exponent = xp.frexp(largest)
    _, of_moment = xp.frexp(I1)
    _, of_weight = xp.frexp(weight)
    half = (of_moment + of_weight + 1) // 2
    return xp.where(weight > 0, xp.where(largest > 0, xp.maximum(exponent, half), half), exponent)


def _sum_of_squares(w: Array, x: Array, y: Array, z: Array) -> list[Array]:
    S = dd.compress([*dd.two_product(x, x), *dd.two_product(y, y)])
    T = dd.compress([*dd.two_product(w, w), *dd.two_product(z, z)])
    return dd.compress([*S, *T])


def _invariants(
    G: DoubleDouble, size: list[Array], momentum: tuple[Array, ...], quaternion: tuple[Array, ...]
) -> tuple[DoubleDouble, ...]:
    """Return |q|², G, s0, t0, u0, p, c, c', twist, F, D, |w|², lean: polynomials of the given floats over |q|².

    The polynomials are summed as expansions, since near the separatrix c, F and D vanish together and what is left of
    them decides how long the top lingers upright; double-double alone would leave nothing.
    """
    L1, L2, L3 = momentum
    w, x, y, z = quaternion
    product, short = dd.expansion_times_expansion, dd.compress
    S = short([*dd.two_product(x, x), *dd.two_product(y, y)])
    T = short([*dd.two_product(w, w), *dd.two_product(z, z)])
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
        n, G, dd.scale(over(S), 2.0), dd.scale(over(T), 2.0), over([*T, *(-v for v in S)]),
        dd.scale(over(in_phase), -2.0), over(c), over(c_plus), over(twist), over(F), over(D), dd.distil(w2), over(lean),
    )  # fmt: skip

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

from typing import NamedTuple

from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    Sum,
    Truth,
    add,
    as_sum,
    binary_exponent,
    compress,
    distil,
    divide,
    floor,
    join,
    larger,
    multiply,
    multiply_float,
    multiply_terms,
    negated,
    negation,
    scale,
    smaller,
    subtract,
    times_power,
    two_product,
    where,
)
from polhode.exact.lagrange_top._formulas import Four

TINY, LIFTED = -200.0, -150.0  # binary exponents: of a displacement that is scaled up, and of what it becomes
NEAR = 2.0**-10  # of what cancels: what is left below it wants exact sums
ONE, ZERO = (1.0, 0.0), (0.0, 0.0)
Three = tuple[Number, Number, Number]


class Scaled(NamedTuple):
    """A top with mgl ≥ 0 and without powers of two."""

    moments: tuple[Number, Number]  # I1, I3
    momentum: Three
    quaternion: Four
    reversed: Truth  # whether the axis was reversed
    lift: Number  # binary exponent of the displacement's scale, 0 for most tops
    exponent: Number  # binary, taken out of the momentum
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number
    G: Pair


class Reduction(NamedTuple):
    """A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.

    u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ.
    """

    moments: tuple[Number, Number]  # I1, I3
    momentum: Three  # with the displacement scaled up by 2^lift
    quaternion: Four  # not normalised; likewise
    reversed: Truth  # whether the axis was reversed
    lift: Number  # binary exponent of the displacement's scale, 0 for most tops
    momentum_scale: Number  # powers of two taken out
    rate_scale: Number
    size: Pair  # |q|² as given
    G: Pair
    s0: Pair
    t0: Pair
    u0: Pair
    p: Pair  # u̇ at the epoch
    c: Pair  # p_φ − L3
    c_plus: Pair  # p_φ + L3
    twist: Pair  # p_φ − u L3 at the epoch
    F: Pair  # |w|² − G s − a c
    D: Pair  # 2G − a² − |w|² + G s
    w2: Pair  # |w|² at the epoch
    lean: Pair  # a (|w|² − G s) − G c: its sign against a's tells loops from waves


def is_upright(top: Reduction) -> bool:
    """Return whether the axis points up rather than down at the epoch."""
    return top.s0[0] < top.t0[0]


def leaves(top: Reduction) -> bool:
    """Return whether the displacement was scaled up and grows."""
    return (top.lift > 0.0) & is_upright(top) & (top.D[0] > 0.0)


# ---------------------------------------------------------------------- axis and size


def _largest(x: float, y: float) -> float:
    return larger(abs(x), abs(y))


def scaled(moments: Three, mgl: float, momentum: Three, attitude: Four) -> Scaled:
    """Turn a top whose centre of mass lies below, and take out powers of two."""
    turned = mgl < 0.0
    side, weight = where(turned, -1.0, 1.0), abs(mgl)
    w, x, y, z = attitude
    i1, _, i3 = moments
    l1, l2, l3 = momentum
    largest = larger(_largest(l1, l2), abs(l3))
    of_moment, of_momentum = binary_exponent(i1), binary_exponent(largest)
    # the larger of |L| and √(mgl I1), without forming a product that may overflow
    half = floor(0.5 * ((of_moment + binary_exponent(weight)) + 1.0))
    of_both = where(largest > 0.0, larger(of_momentum, half), half)
    exponent = where(weight > 0.0, of_both, of_momentum)
    i1 = times_power(i1, -of_moment)
    weight = times_power(times_power(weight, of_moment - exponent), -exponent)
    return Scaled(
        (i1, times_power(i3, -of_moment)),
        (times_power(l1, -exponent), times_power(side * l2, -exponent), times_power(side * l3, -exponent)),
        # a half turn about the first body axis: q → q i
        (where(turned, -x, w), where(turned, w, x), where(turned, z, y), where(turned, -y, z)),
        turned, 0.0 * weight, exponent, times_power(1.0, exponent), times_power(1.0, exponent - of_moment),
        scale(two_product(weight, i1), 2.0),
    )  # fmt: skip


def lifted(top: Scaled, momentum: Three) -> Scaled:
    """Scale a tiny displacement up; the momentum is the given one, which keeps digits that scaling down has lost.

    Exactly at the threshold of sleeping, 2G = a², where it grows like t and not like e^t, it is dropped: nothing is to
    show within 1e27 radians, the longest time for which a motion is given.
    """
    w, x, y, z = top.quaternion
    l1, l2, l3 = top.momentum
    cosine, sine = _largest(w, z), _largest(x, y)
    below = cosine < sine
    displacement = larger(smaller(cosine, sine), _largest(l1, l2))
    exponent = binary_exponent(displacement)
    double, square = scale(top.G, 2.0), two_product(l3, l3)
    threshold = (double[0] == square[0]) & (double[1] == square[1]) & negation(below)
    tiny = (displacement > 0.0) & (exponent < TINY) & (top.G[0] > 0.0)
    lift = where(tiny & negation(threshold), LIFTED - exponent, 0.0)
    kept = where(tiny & threshold, 0.0, 1.0)
    above, under = where(below, 0.0, lift), where(below, lift, 0.0)
    side, power = where(top.reversed, -1.0, 1.0), lift - top.exponent
    return Scaled(
        top.moments, (kept * times_power(momentum[0], power), kept * times_power(side * momentum[1], power), l3),
        (times_power(w, under), kept * times_power(x, above), kept * times_power(y, above), times_power(z, under)),
        top.reversed, lift, top.exponent, top.momentum_scale, top.rate_scale, top.G,
    )  # fmt: skip


def _over_size(
    top: Scaled, size: Pair, s: Pair, t: Pair, u: Pair, in_phase: Pair, c: Pair, c_plus: Pair, twist: Pair, f: Pair,
    d: Pair, w2: Pair, lean: Pair,
) -> Reduction:
    """Return the reduction of invariants times |q|²; s and t are half of them, and ``in_phase`` is −p/2."""
    return Reduction(
        top.moments, top.momentum, top.quaternion, top.reversed, top.lift, top.momentum_scale, top.rate_scale, size,
        top.G, scale(divide(s, size), 2.0), scale(divide(t, size), 2.0), divide(u, size),
        scale(divide(in_phase, size), -2.0), divide(c, size), divide(c_plus, size), divide(twist, size),
        divide(f, size), divide(d, size), w2, divide(lean, size),
    )  # fmt: skip


# ---------------------------------------------------------------------- invariants, as exact sums


def _products(a: float, b: float, c: float, d: float) -> Sum:
    """Return ab + cd."""
    return join(as_sum(two_product(a, b)), as_sum(two_product(c, d)))


def _times_pair(x: Sum, y: Pair) -> Sum:
    return join(multiply_terms(x, y[0]), multiply_terms(x, y[1]))


def size_of(top: Scaled) -> Sum:
    """Return |q|²: as a pair it would leave F of a planar top only 32 digits of what cancels."""
    w, x, y, z = top.quaternion
    return compress(join(_products(x, x, y, y), _products(w, w, z, z)), 4)


def exactly_reduced(top: Scaled, size: Sum) -> Reduction:
    """Return the reduction of a top; its invariants are polynomials of the given floats over |q|², which is ``size``.

    The polynomials are summed exactly, since near the separatrix c, F and D vanish together and what is left of them
    decides how long the top lingers upright; double-double alone would leave nothing.
    """
    l1, l2, l3 = top.momentum
    w, x, y, z = top.quaternion
    s, t = _products(x, x, y, y), _products(w, w, z, z)
    real, imaginary = _products(x, w, y, z), _products(x, z, -y, w)  # of β̄α
    in_phase = compress(join(multiply_terms(real, l1), multiply_terms(imaginary, -l2)), 4)  # of β̄αw
    twist = compress(join(multiply_terms(real, 2.0 * l2), multiply_terms(imaginary, 2.0 * l1)), 4)
    c = compress(join(twist, multiply_terms(s, -2.0 * l3)), 4)
    c_plus = compress(join(twist, multiply_terms(t, 2.0 * l3)), 4)
    kinetic = join(_times_pair(size, two_product(l1, l1)), _times_pair(size, two_product(l2, l2)))
    fall = as_sum(scale(top.G, -2.0))
    fall = join(_times_pair(fall, two_product(x, x)), _times_pair(fall, two_product(y, y)))
    energy = compress(join(kinetic, fall), 5)
    f = compress(join(energy, multiply_terms(c, -l3)), 5)
    rest = join(_times_pair(size, scale(top.G, 2.0)), _times_pair(size, two_product(l3, -l3)))
    d = compress(join(rest, negated(energy)), 5)
    lean = compress(join(multiply_terms(energy, l3), _times_pair(c, scale(top.G, -1.0))), 6)
    return _over_size(
        top, distil(size), distil(s), distil(t), distil(join(t, negated(s))), distil(in_phase), distil(c),
        distil(c_plus), distil(twist), distil(f), distil(d), distil(_products(l1, l1, l2, l2)), distil(lean),
    )  # fmt: skip


def reduction(moments: Three, mgl: float, momentum: Three, attitude: Four) -> Reduction:
    """Return the reduction of a top, at any scale and however near the vertical."""
    top = scaled(moments, mgl, momentum, attitude)
    return exactly_reduced(lifted(top, momentum), size_of(top))


# ---------------------------------------------------------------------- invariants in double-double


def _spare(x: Pair, size: float) -> float:
    """Return a number below zero if more has cancelled of terms of this size than ``NEAR`` allows."""
    return abs(x[0]) - NEAR * size


def plainly_reduced(top: Scaled) -> tuple[Reduction, float]:
    """Return the reduction but ``lean``, and a number below zero if too much cancels for double-double.

    The top's displacement is not tiny, nor is any of its numbers beside the others.
    """
    w, x, y, z = top.quaternion
    l1, l2, l3 = top.momentum
    s, t = add(two_product(x, x), two_product(y, y)), add(two_product(w, w), two_product(z, z))
    xw, yz, xz, yw = two_product(x, w), two_product(y, z), two_product(x, z), two_product(-y, w)
    real, imaginary = add(xw, yz), add(xz, yw)
    of_real, of_imaginary = abs(xw[0]) + abs(yz[0]), abs(xz[0]) + abs(yw[0])
    in_phase = subtract(multiply_float(real, l1), multiply_float(imaginary, l2))
    twist = scale(add(multiply_float(real, l2), multiply_float(imaginary, l1)), 2.0)
    below, above = multiply_float(s, 2.0 * l3), multiply_float(t, 2.0 * l3)
    c, c_plus = subtract(twist, below), add(twist, above)
    of_twist = 2.0 * (of_real * abs(l2) + of_imaginary * abs(l1))
    of_c = of_twist + abs(below[0])
    size, w2 = add(s, t), add(two_product(l1, l1), two_product(l2, l2))
    kinetic, fall = multiply(size, w2), scale(multiply(top.G, s), 2.0)
    energy = subtract(kinetic, fall)
    f = subtract(energy, multiply_float(c, l3))
    d = subtract(multiply(size, subtract(scale(top.G, 2.0), two_product(l3, l3))), energy)
    of_energy = kinetic[0] + fall[0]
    spare = smaller(_spare(in_phase, of_real * abs(l1) + of_imaginary * abs(l2)), _spare(twist, of_twist))
    spare = smaller(spare, smaller(_spare(c, of_c), _spare(c_plus, of_twist + abs(above[0]))))
    of_d = of_energy + size[0] * (2.0 * top.G[0] + l3 * l3)
    spare = smaller(spare, smaller(_spare(f, of_energy + of_c * abs(l3)), _spare(d, of_d)))
    return _over_size(top, size, s, t, subtract(t, s), in_phase, c, c_plus, twist, f, d, w2, ZERO), spare

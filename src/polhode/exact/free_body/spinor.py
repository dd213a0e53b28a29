"""The attitude quaternion of a free body as a quotient of theta functions, evaluated at given times.

Two complex theta functions A and B of the polhode angle make, up to their norm, the quaternion of the frame whose
third row is the angular momentum (Jacobi 1849; Klein & Sommerfeld, *Theorie des Kreisels*). Both are short series in
the smaller of the two nomes: the full form (m ≤ ½) is trigonometric in the polhode angle, the complementary form
(m > ½) exponential. The rest is a constant 4×4 matrix.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode.arrays import always, choose, namespace, nearest, split_halves
from polhode.exact.blocks import Columns
from polhode.exact.decay import exponential_decay
from polhode.special.circular import SplitRate, phase_fraction, reduced_phase, sine_cosine_turns
from polhode.special.doubledouble import fast_two_sum, two_sum
from polhode.types import Array, ArrayOrFloat, Bool, Float64

Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]
Part = Float64[ArrayOrFloat, "*shape"]
Spinor = tuple[Part, Part, Part, Part]
TINY = 1e-300  # on the separatrix, where q1 = 0, E may vanish; elsewhere it is at least √q1


class Motion(NamedTuple):
    """All that evaluation needs, one entry per body. ``full`` says which form the body takes."""

    full: Flag
    first: SplitRate  # full: rate of the phase of A; complementary: half the precession rate [turns per time]
    second: SplitRate  # full: rate of the phase of B; complementary: rate of u/2K
    start: tuple[Number, Number]  # full: (z0/4π, 0); complementary: u0/2K, double-double
    series: tuple[Number, ...]  # full: coefficients of A and B; complementary: cos and sin of (2n+1)(y/2 − π/4)
    nome: tuple[
        Number, Number, Number, Number, Number
    ]  # complementary: √q1, πK/K' in halves, y/2π, 0 on the separatrix
    parity: Number  # complementary: half turns of u at the start
    to_attitude: tuple[tuple[Number, ...], ...]  # quaternion = matrix · spinor / norm, (4, 4)
    to_momentum: tuple[tuple[Number, ...], ...]  # momentum = matrix · (n1, n2, n3), (3, 3)


def flatten(motion: Motion) -> Columns:
    """Return the entries as one flat tuple of arrays, ``full`` first."""
    matrices = (*(x for row in motion.to_attitude for x in row), *(x for row in motion.to_momentum for x in row))
    return (motion.full, *motion.first, *motion.second, *motion.start, *motion.series, *motion.nome, motion.parity,
            *matrices)  # fmt: skip


def unflatten(flat: Columns) -> Motion:
    """Return the inverse of ``flatten``."""
    to_attitude = tuple(flat[25 + 4 * i : 29 + 4 * i] for i in range(4))
    to_momentum = tuple(flat[41 + 3 * i : 44 + 3 * i] for i in range(3))
    return Motion(flat[0], flat[1:4], flat[4:7], flat[7:9], flat[9:19], flat[19:24], flat[24], to_attitude, to_momentum)


def evaluate(
    flat: Columns, time: Float64[ArrayOrFloat, "*times"], time_rest: Float64[ArrayOrFloat, "*times"] | None = None
) -> tuple[Float64[Array, "*shape"], ...]:
    """Return the four quaternion and three momentum components at the times, elementwise with broadcasting.

    Args:
        flat: a flattened ``Motion``.
        time: time since the epoch.
        time_rest: what the float ``time`` leaves of it, if anything.
    """
    motion = unflatten(flat)
    high, low = split_halves(time)
    low = low if time_rest is None else low + time_rest
    spinor = choose(motion.full, _full_of, _complementary_of, *flat[1:25], high, low)
    return _states(motion, spinor)


def start_spinor(motion: Motion) -> Spinor:
    """Return the spinor at the epoch."""
    xp = namespace(motion.parity)
    zero = xp.zeros_like(motion.parity)
    return choose(motion.full, _full_of, _complementary_of, *flatten(motion)[1:25], zero, zero)  # type: ignore[return-value]


def _full_of(*columns: Array) -> Spinor:
    first, second, start, series = columns[0:3], columns[3:6], columns[6], columns[8:18]
    fraction_a, rest_a = phase_fraction(first, columns[-2:])
    fraction_b, rest_b = phase_fraction(second, columns[-2:])
    return _full_spinor(series, fraction_a + (rest_a - start), fraction_b + (rest_b + start))


def _full_spinor(series: tuple[Array, ...], turns_a: Array, turns_b: Array) -> Spinor:
    """Sum A and B as polynomials in X = cos 2z and Y = sin 2z, where z is the difference of their phases."""
    a0, a1, a2, a3, a4, b0, b1, b2, b3, b4 = series
    sa, ca = sine_cosine_turns(turns_a - nearest(turns_a))
    sb, cb = sine_cosine_turns(turns_b - nearest(turns_b))
    cz, sz = ca * cb + sa * sb, sb * ca - cb * sa
    s2 = sz + sz
    X, Y = 1.0 - s2 * sz, s2 * cz
    pa, qa = a0 + X * (a1 + X * a2), Y * (a3 + X * a4)
    pb, qb = b0 + X * (b1 + X * b2), Y * (b3 + X * b4)
    return ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb


def _complementary_of(*columns: Array) -> Spinor:
    first, second, start, series = columns[0:3], columns[3:6], columns[6:8], columns[8:18]
    root_nome, half_upper, half_lower, y_turns, periodic = columns[18:23]
    fraction, rest = phase_fraction(first, columns[-2:])
    f, g, whole = reduced_phase(second, columns[-2:])
    if always(periodic, 1.0):
        u, error = two_sum(f, start[0])
    else:  # on the separatrix u runs to infinity: no period is taken out
        u, error = two_sum((1.0 - periodic) * whole, f)
        u, second_error = two_sum(u, start[0])
        error, whole = error + second_error, periodic * whole
    u, u_rest = fast_two_sum(u, g + (start[1] + error))
    more = periodic * nearest(u)
    u = u - more
    count = columns[23] + (whole + more)
    count = count - 4.0 * nearest(0.25 * count)
    turns = fraction - 0.25 * count
    turns = (turns - nearest(turns)) + (rest - u * y_turns)
    return _complementary_spinor(series, (root_nome, half_upper, half_lower), (u, u_rest), turns, count)


def _complementary_spinor(
    series: tuple[Number, ...], nome: tuple[Array, ...], u: tuple[Array, Array], turns: Array, count: Array
) -> Spinor:
    """Sum A and B in the growing powers of q1/E and the decaying ones of E = e^−|x|, x = πu/2K'."""
    xp = namespace(turns)
    root, upper, lower = nome
    side = xp.where(u[0] < 0, -1.0, 1.0)
    f, g = u[0] * side, u[1] * side
    e0 = exponential_decay(f, g, upper, lower)
    s, c = sine_cosine_turns(turns - nearest(turns))
    q = root * root
    q2, q3, q4 = q * q, q * q * q, q * q * q * q
    g1 = q / (e0 + TINY)
    g2 = g1 * g1
    g2 *= q
    g3 = g2 * g1
    g3 *= q2
    g4 = g3 * g1
    g4 *= q3
    e1 = q * e0
    e1 *= e0
    e2 = q2 * e1
    e2 *= e0
    e3 = q3 * e2
    e3 *= e0
    e4 = q4 * e3
    e4 *= e0
    plus = (1.0 + e0, g1 + e1, g2 + e2, g3 + e3, g4 + e4)
    minus = (1.0 - e0, g1 - e1, g2 - e2, g3 - e3, g4 - e4)
    cosine, sine = series[:5], series[5:]
    ar, ai = cosine[4] * plus[4], sine[4] * minus[4]
    br, bi = -sine[4] * plus[4], cosine[4] * minus[4]
    for n in (3, 2, 1, 0):  # in place, where arrays are written
        ar += cosine[n] * plus[n]
        ai += sine[n] * minus[n]
        if n % 2:
            br += sine[n] * plus[n]
            bi -= cosine[n] * minus[n]
        else:
            br -= sine[n] * plus[n]
            bi += cosine[n] * minus[n]
    ai *= side
    bi *= side
    odd = 1.0 - 2.0 * (count - 2.0 * xp.floor(0.5 * count))
    return c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br)


def _states(motion: Motion, spinor: Spinor) -> tuple[Array, ...]:
    xp = namespace(*spinor)
    a0, a1, b0, b1 = spinor
    aa, bb = a0 * a0, b0 * b0
    aa += a1 * a1
    bb += b1 * b1
    x = 1.0 / (aa + bb)
    root = xp.sqrt(x)
    n0, n1, n2 = a0 * b0, a0 * b1, aa - bb
    n0 += a1 * b1
    n1 -= a1 * b0
    n2 *= x
    x += x
    n0 *= x
    n1 *= x
    n, scaled = (n0, n1, n2), tuple(v * root for v in spinor)
    return (*(_product(row, scaled) for row in motion.to_attitude), *(_product(row, n) for row in motion.to_momentum))


def _product(row: tuple[Array, ...], values: tuple[Array, ...]) -> Array:
    """Return the sum of the products, without those that are known to vanish, as most of momentum's do."""
    pairs = [(a, v) for a, v in zip(row, values, strict=True) if not always(a, 0.0)]
    if not pairs:
        return 0.0 * values[0]
    total = pairs[0][0] * pairs[0][1]
    for a, v in pairs[1:]:
        total += a * v
    return total

"""The Cayley–Klein parameters of a Lagrange top as quotients of theta functions, evaluated at given times.

α ∝ θ1(z − iy_a)/θ4(z) and β ∝ θ2(z − iy_b)/θ4(z), each with a phase linear in time (Klein & Sommerfeld, *Theorie des
Kreisels*, ch. VI). The full form (m ≤ ½) is trigonometric in z, the complementary form (m > ½) exponential. As
|α|² + |β|² = 1 the common denominator is not needed, and w = 2(ᾱβ̇ − βᾱ̇) needs no derivative of it.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode.arrays import choose, namespace, nearest, split_halves
from polhode.exact.blocks import Columns
from polhode.exact.decay import exponential_decay
from polhode.special.circular import SplitRate, phase_fraction, reduced_phase, sine_cosine_turns
from polhode.special.doubledouble import fast_two_sum, two_sum
from polhode.types import Array, ArrayOrFloat, Bool, Float64

ENTRIES = 45  # of a flattened motion
Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]
Numerators = tuple[
    Float64[ArrayOrFloat, "*shape"], ...
]  # A, B and their derivatives by z or x', real and imaginary parts, phases in turns
TERMS = 4  # of each series: q^16 is below 1e-21


class Motion(NamedTuple):
    """All that evaluation needs, one entry per top. ``full`` says which form it takes."""

    full: Flag
    first: SplitRate  # of the phase of α [turns per time]
    second: SplitRate  # of the phase of β
    third: SplitRate  # full: of z/2π; complementary: of x/2K
    start: tuple[Number, Number]  # the same at the epoch, double-double
    series: tuple[Number, ...]  # full: sums and differences of e^{±ikz} in A and B; complementary: sin, cos of ky, 2ny
    constant: Number  # complementary: the constant term of B
    nome: tuple[Number, ...]  # complementary: q, πK/K' halves, y_a/π, y_b/π, whether periodic
    signs: tuple[Number, Number]  # of c' and c
    rates: tuple[Number, Number]  # of w: twice dz/dt or dx'/dt, twice the sum of the linear rates [momentum]
    phases: tuple[Number, Number, Number, Number]  # cos, sin of the constant phases of α and β
    axial: Number  # L3
    reversed: Number  # −1 where the axis was turned round


def flatten(motion: Motion) -> Columns:
    """Return the entries as one flat tuple of arrays, ``full`` first."""
    out: list[Array] = []
    for part in motion:
        out.extend(part if isinstance(part, tuple) else (part,))
    return tuple(out)


def unflatten(flat: Columns) -> Motion:
    """Return the inverse of ``flatten``."""
    return Motion(
        flat[0], flat[1:4], flat[4:7], flat[7:10], flat[10:12], flat[12:28], flat[28], flat[29:35], flat[35:37],
        flat[37:39], flat[39:43], flat[43], flat[44],
    )  # fmt: skip


def evaluate(
    flat: Columns, time: Float64[ArrayOrFloat, "*times"], time_rest: Float64[ArrayOrFloat, "*times"] | None = None
) -> tuple[Float64[Array, "*shape"], ...]:
    """Return the four quaternion and three momentum components at the times, elementwise with broadcasting.

    Args:
        flat: a flattened ``Motion``.
        time: time since the epoch.
        time_rest: what the float ``time`` leaves of it, if anything.
    """
    high, low = split_halves(time)
    low = low if time_rest is None else low + time_rest
    return _states(unflatten(flat), choose(flat[0], _full_of, _complementary_of, *flat[1:37], high, low))


def start_numerators(motion: Motion) -> Numerators:
    """Return A, B, their derivatives and phases at the epoch."""
    xp = namespace(motion.axial)
    zero = xp.zeros_like(motion.axial)
    return choose(motion.full, _full_of, _complementary_of, *flatten(motion)[1:37], zero, zero)


def _full_of(*columns: Array) -> Numerators:
    series, (sa, sb), times = columns[11:27], columns[34:36], columns[-2:]
    turns_a, turns_b = (_turns(columns[k : k + 3], times) for k in (0, 3))
    fraction, rest = phase_fraction(columns[6:9], times)
    z = fraction + (rest + columns[9])
    cosines, sines = _multiples(*sine_cosine_turns(z - nearest(z))[::-1], odd=True)
    a_sum, a_gap, b_sum, b_gap = (series[4 * k : 4 * k + 4] for k in range(4))
    odd = tuple(2.0 * n + 1.0 for n in range(TERMS))
    return (
        _dot(a_sum, sines), -sa * _dot(a_gap, cosines), _dot(b_sum, cosines), sb * _dot(b_gap, sines),
        _dot(a_sum, cosines, odd), sa * _dot(a_gap, sines, odd), -_dot(b_sum, sines, odd),
        sb * _dot(b_gap, cosines, odd), turns_a, turns_b,
    )  # fmt: skip


def _complementary_of(*columns: Array) -> Numerators:
    series, constant, times = columns[11:27], columns[27], columns[-2:]
    q, upper, lower, ya_turns, yb_turns, periodic = columns[28:34]
    sa, sb = columns[34:36]
    u, u_rest, count = _reduced_argument(columns[6:9], times, columns[9:11], periodic)
    xp = namespace(u)
    side = xp.where(u < 0, -1.0, 1.0)
    f, g = u * side, u_rest * side
    e0 = exponential_decay(f, g, upper, lower)
    distance = xp.maximum(0.5 - f, 0.0 * f)
    R = periodic * exponential_decay(distance, ((0.5 - distance) - f) * periodic - g, upper, lower)
    h, r = e0 * e0, R * R
    a_sine, a_cosine, b_cosine, b_sine = (series[4 * k : 4 * k + 4] for k in range(4))
    sums, gaps, b_up, b_down = [], [], [], []
    hk = h
    for n in range(TERMS):
        weight = (q**n * r) ** n if n else 1.0
        sums.append(weight * (1.0 + hk))
        gaps.append(weight * (1.0 - hk))
        hk = hk * h * h
        up, down = (q**n * r) ** (n + 1), (q ** (n + 1) * h) ** (n + 1)
        b_up.append(up + down)
        b_down.append(up - down)
    odd, even = tuple(2.0 * n + 1.0 for n in range(TERMS)), tuple(2.0 * n + 2.0 for n in range(TERMS))
    e = 2.0 * e0
    half = 0.5 * (count - 2.0 * xp.floor(0.5 * count))
    within = u + u_rest
    turns_a = _wrapped(_turns(columns[0:3], times) + sa * within * ya_turns) + half
    turns_b = _wrapped(_turns(columns[3:6], times) + sb * within * yb_turns) + half
    return (
        _dot(a_sine, sums), sa * side * _dot(a_cosine, gaps), e * (constant + _dot(b_cosine, b_up)),
        -sb * side * e * _dot(b_sine, b_down), side * _dot(a_sine, gaps, odd), sa * _dot(a_cosine, sums, odd),
        side * e * _dot(b_cosine, b_down, even), -sb * e * _dot(b_sine, b_up, even), turns_a, turns_b,
    )  # fmt: skip


def _reduced_argument(
    rate: tuple[Array, ...], times: tuple[Array, ...], start: tuple[Array, ...], periodic: Array
) -> tuple[Array, Array, Array]:
    """Return x/2K within half a period as a pair, and the periods taken out; on the separatrix none is."""
    fraction, rest, whole = reduced_phase((rate[0], rate[1], rate[2]), (times[0], times[1]))
    sum_, first_error = two_sum((1.0 - periodic) * whole, fraction)
    u, second_error = two_sum(sum_, start[0])
    u, u_rest = fast_two_sum(u, rest + (start[1] + (first_error + second_error)))
    more = periodic * nearest(u)
    count = periodic * whole + more
    return u - more, u_rest, count - 4.0 * nearest(0.25 * count)


def _turns(rate: tuple[Array, ...], times: tuple[Array, ...]) -> Array:
    fraction, rest = phase_fraction((rate[0], rate[1], rate[2]), (times[0], times[1]))
    return fraction + rest


def _wrapped(turns: Array) -> Array:
    return turns - nearest(turns)


def _multiples(cosine: Array, sine: Array, odd: bool) -> tuple[list[Array], list[Array]]:
    """Return cos kz and sin kz for k = 1, 3, 5, 7, or 2, 4, 6, 8."""
    double_c, double_s = 1.0 - 2.0 * sine * sine, 2.0 * sine * cosine
    c, s = (cosine, sine) if odd else (double_c, double_s)
    cosines: list[Array] = [c]
    sines: list[Array] = [s]
    for _ in range(TERMS - 1):
        c, s = c * double_c - s * double_s, s * double_c + c * double_s
        cosines.append(c)
        sines.append(s)
    return cosines, sines


def _dot(coefficients: tuple[Array, ...], values: list[Array], weights: tuple[float, ...] = (1.0,) * TERMS) -> Array:
    """Sum the products, smallest first."""
    total = weights[-1] * coefficients[-1] * values[-1]
    for a, v, k in zip(coefficients[-2::-1], values[-2::-1], weights[-2::-1], strict=True):
        total = total + (k * a) * v
    return total


def _states(motion: Motion, numerators: Numerators) -> tuple[Array, ...]:
    """Return quaternion and momentum: α = A e^{iφ_a}, β = B e^{iφ_b} over their norm, and w."""
    xp = namespace(*numerators)
    ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = numerators
    square = (ar * ar + ai * ai) + (br * br + bi * bi)
    x = 1.0 / square
    root = xp.sqrt(x)
    ca, sa, cb, sb = _phases(motion.phases, turns_a, turns_b)
    ar_t, ai_t = (ar * ca - ai * sa) * root, (ar * sa + ai * ca) * root
    br_t, bi_t = (br * cb - bi * sb) * root, (br * sb + bi * cb) * root
    by_argument, by_phase = motion.rates
    # ĀB' − BĀ' and i ĀB
    gain_r = (ar * dbr + ai * dbi) - (br * dar + bi * dai)
    gain_i = (ar * dbi - ai * dbr) - (bi * dar - br * dai)
    turn_r, turn_i = ai * br - ar * bi, ar * br + ai * bi
    wr = (by_argument * gain_r + by_phase * turn_r) * x
    wi = (by_argument * gain_i + by_phase * turn_i) * x
    cw, sw = cb * ca + sb * sa, sb * ca - cb * sa
    L1, L2 = wr * cw - wi * sw, wr * sw + wi * cw
    turned = motion.reversed < 0
    attitude = (
        xp.where(turned, br_t, ar_t), xp.where(turned, -ar_t, br_t), xp.where(turned, -ai_t, bi_t),
        xp.where(turned, bi_t, ai_t),
    )  # fmt: skip
    return (*attitude, L1, motion.reversed * L2, motion.axial + 0.0 * L1)


def _phases(constant: tuple[Array, ...], turns_a: Array, turns_b: Array) -> tuple[Array, ...]:
    """Return cos, sin of the whole phases of α and β."""
    out: list[Array] = []
    for turns, (c0, s0) in ((turns_a, constant[0:2]), (turns_b, constant[2:4])):
        s, c = sine_cosine_turns(_wrapped(turns))
        out += [c * c0 - s * s0, s * c0 + c * s0]
    return tuple(out)

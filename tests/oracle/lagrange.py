"""The Lagrange top to any number of digits, by Taylor series over one nutation and Legendre's integrals for the rest.

Nothing here is shared with the theta-function form of the library. Power series of 2α' = i a α − w̄ β,
2β' = w α − i a β, w' = G ᾱ β (spherical top, τ = t/I1) in fixed-point integers carry the top over less than one
nutation; whole nutations are a turn about the vertical and one about the axis, whose angles and period are complete
integrals of the first and third kind by Carlson's R_F and R_J, at turning points isolated exactly. Inputs are exact
rationals, so that double roots are known to be double.

Source: Whittaker, Analytical Dynamics, §71-73, in Cayley-Klein parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import ceil
from operator import mul
from typing import NamedTuple

from flint import acb, arb, ctx, fmpq, fmpq_poly, fmpz

from oracle.reference import Exact, exact

ACCURATE_BITS = 160
"""48 digits of every entry, and of L relative to its largest value."""
STEP = 0.5
"""Fastest rate times the length of one Taylor step."""
SMALL_TILT = 0.5
"""Largest 1 − cos θ up to which the slow quantities beside the vertical are used."""
MOST_GROWTH = 300.0
"""Exponent by which a motion magnifies errors: a passage of the upright from 1e-65 and back."""
DECAYED = 92
"""Exponent of what is left of tilt and momentum when a top on the separatrix counts as upright."""
Complex = tuple[int, int]


class TopState(NamedTuple):
    """Quaternion w, x, y, z, continuous from q/|q| at the start, and momentum in body axes."""

    quaternion: list[arb]
    momentum: list[arb]


class Spherical(NamedTuple):
    """A spherical top in units of momentum, α and β still over |q|, which need not be rational."""

    G: fmpq
    a: fmpq
    w: tuple[fmpq, fmpq]
    alpha: tuple[fmpq, fmpq]
    beta: tuple[fmpq, fmpq]

    @property
    def size(self) -> fmpq:
        return sum((x * x for x in (*self.alpha, *self.beta)), fmpq(0))

    @property
    def s(self) -> fmpq:
        return 2 * (self.beta[0] ** 2 + self.beta[1] ** 2) / self.size

    @property
    def c(self) -> fmpq:
        """p_φ − L3 = 2 Im β̄αw − a s."""
        (wr, wi), (ar, ai), (br, bi) = self.w, self.alpha, self.beta
        imaginary = (br * ar + bi * ai) * wi + (br * ai - bi * ar) * wr
        return 2 * imaginary / self.size - self.a * self.s

    @property
    def w2(self) -> fmpq:
        return self.w[0] ** 2 + self.w[1] ** 2


class Nutation(NamedTuple):
    """Period and turns of α and β in it, by τ."""

    period: arb
    alpha: arb
    beta: arb


def reference_top(
    moments: Sequence[Exact], mgl: Exact, momentum: Sequence[Exact], attitude: Sequence[Exact], t: Exact,
    bits: int = ACCURATE_BITS, direct: bool = False,
) -> TopState:  # fmt: skip
    """Return the state at ``t`` of a top with moments (I1, I1, I3), from the given state at 0; all numbers exact.

    By series alone, whole nutations too, if ``direct``: quicker so near the separatrix that none is complete.
    """
    I1, I3, L3, time = exact(moments[0]), exact(moments[2]), exact(momentum[2]), exact(t)
    weight = exact(mgl)
    top = spherical(I1, weight, momentum, attitude)
    if weight < 0:
        top = half_turned(top)
    with ctx.workprec(2 * bits + 400):
        alpha, beta, w = taylor(top, arb(time / I1), bits) if direct else _carried(top, time / I1, bits)
        if weight < 0:
            alpha, beta, w = beta, -alpha, w.conjugate()
        spin = acb.exp_pi_i(acb(arb(L3 * (I1 - I3) / (I1 * I3) * time) / (2 * arb.pi())))
        alpha, beta, w = alpha * spin, beta / spin, w / (spin * spin)
        return TopState([alpha.real, beta.real, beta.imag, alpha.imag], [w.real, w.imag, arb(L3)])


def spherical(I1: fmpq, weight: fmpq, momentum: Sequence[Exact], attitude: Sequence[Exact]) -> Spherical:
    L1, L2, L3 = map(exact, momentum)
    w, x, y, z = map(exact, attitude)
    return Spherical(2 * weight * I1, L3, (L1, L2), (w, z), (x, y))


def half_turned(top: Spherical) -> Spherical:
    """The same top seen with the axis reversed, by a half turn about the first body axis."""
    (wr, wi), (ar, ai) = top.w, top.alpha
    return Spherical(-top.G, -top.a, (wr, -wi), (-top.beta[0], -top.beta[1]), (ar, ai))


def _carried(top: Spherical, tau: fmpq, bits: int) -> tuple[acb, acb, acb]:
    norm = arb(top.size).sqrt()
    alpha, beta = (acb(arb(v[0]), arb(v[1])) / norm for v in (top.alpha, top.beta))
    w = acb(arb(top.w[0]), arb(top.w[1]))
    s, c = top.s, top.c
    t, c_plus = 2 - s, c + 2 * top.a
    if top.w2 == 0 and (s == 0 or t == 0 or top.G == 0):
        half = _turn(arb(top.a * tau) / 2)
        return alpha * half, beta / half, w / (half * half) if top.G == 0 else w
    cubic = cubic_of(top)
    slope = cubic.derivative()
    if cubic(s) == 0 and slope(s) == 0:
        rate_alpha, rate_beta = arb(c_plus * tau / (2 * t)), arb(c * tau / (2 * s))
        return alpha * _turn(rate_alpha), beta * _turn(rate_beta), w * _turn(rate_beta - rate_alpha)
    if c == 0 and _F(top) == 0:
        return _towards_upright(top, tau, bits)
    nutation = period_and_turns(top, cubic, bits)
    periods = (arb(tau) / nutation.period).floor().mid().unique_fmpz()
    assert periods is not None
    rest = arb(tau) - arb(periods) * nutation.period
    alpha, beta, w = taylor(top, rest, bits)
    turn_alpha, turn_beta = arb(periods) * nutation.alpha, arb(periods) * nutation.beta
    return alpha * _turn(turn_alpha), beta * _turn(turn_beta), w * _turn(turn_beta - turn_alpha)


def _F(top: Spherical) -> fmpq:
    """|w|² − G s − a c, half the coefficient of s in the cubic."""
    return top.w2 - top.G * top.s - top.a * top.c


def cubic_of(top: Spherical) -> fmpq_poly:
    """u̇² as a polynomial in s = 1 − u."""
    return fmpq_poly([-top.c**2, 2 * _F(top), 2 * top.G - top.a**2 - top.w2 + top.G * top.s, -top.G])


def _turn(angle: arb) -> acb:
    return acb(0, angle).exp()


def _towards_upright(top: Spherical, tau: fmpq, bits: int) -> tuple[acb, acb, acb]:
    """On the separatrix tilt and momentum die like e^-λτ; what is left is spin about the vertical."""
    decay = (arb(top.G) / 2 - arb(top.a) ** 2 / 4).sqrt()
    start = arb(top.s) if top.s else arb(1)
    enough = (DECAYED + 2 * start.log().abs_upper() + 10) / decay
    if abs(arb(tau)) <= enough:
        return taylor(top, arb(tau), bits)
    # any rational time beyond is right; one far beyond would cost a step for every radian
    arrival = exact(1.01 * float(enough)) * (1 if tau > 0 else -1)
    alpha, _, _ = taylor(top, arb(arrival), 140, growth=1.2 * float(enough * decay))
    return alpha * _turn(arb(top.a * (tau - arrival)) / 2), acb(0), acb(0)


def period_and_turns(top: Spherical, cubic: fmpq_poly, bits: int) -> Nutation:
    """Return period and turns to ``bits`` + 60 digits of the period, raising the precision until they are."""
    precision = bits + 200
    while precision < 1 << 15:
        with ctx.workprec(precision):
            result = _legendre(top, cubic)
            if all(x.is_finite() and (x.rad() == 0 or x.rel_accuracy_bits() > bits + 60) for x in result):
                return result
        precision *= 2
    raise ArithmeticError(f"no precision is enough for {top}")


def _legendre(top: Spherical, cubic: fmpq_poly) -> Nutation:
    c, c_plus = arb(top.c), arb(top.c + 2 * top.a)
    integral = fmpq_poly([x * cubic.denom() for x in cubic.coeffs()]).numer()
    roots = sorted((root.real for root, count in integral.complex_roots() for _ in range(count)), key=_Ordered)
    s1, s2 = roots[0], roots[1]
    d = s1 - s2
    A, m1 = (arb(top.G) * (s1 - roots[2]), (s2 - roots[2]) / (s1 - roots[2])) if top.G else (-arb(cubic[2]), arb(1))
    half_rate = A.sqrt() / 2
    K = acb.elliptic_rf(0, m1, 1).real
    t1, t2 = 2 - s1, 2 - s2
    period = 2 * K / half_rate
    beta = arb.pi() if s2.contains(0) and top.c == 0 else arb(0)
    alpha = arb.pi()
    if top.c != 0:
        beta = c / (half_rate * s1) * (K + d / s1 / 3 * acb.elliptic_rj(0, m1, 1, s2 / s1).real)
    if top.c + 2 * top.a != 0:
        alpha = c_plus / (half_rate * t1) * (K - d / t1 / 3 * acb.elliptic_rj(0, m1, 1, t2 / t1).real)
    return Nutation(period, alpha, beta)


class _Ordered:
    """Sorts balls downwards by their midpoints, at full precision."""

    def __init__(self, value: arb) -> None:
        self.value = value.mid()

    def __lt__(self, other: _Ordered) -> bool:
        return bool(self.value > other.value)


def taylor(top: Spherical, tau: arb, bits: int, growth: float = MOST_GROWTH) -> tuple[acb, acb, acb]:
    """Return α, β, w after ``tau`` by power series, over q/|q|; errors grow by e^``growth`` at most."""
    size = arb(top.w2 + top.a**2 + 2 * abs(top.G)).sqrt()
    if top.G > 0 and _highest_tilt(top) < SMALL_TILT:
        return _taylor_beside_upright(top, tau, bits, size)
    norm = arb(top.size).sqrt()
    scaled = [arb(v) / norm for v in (*top.alpha, *top.beta)] + [arb(x) / size for x in top.w]
    rates = [size / 2, arb(top.a) / 2, arb(top.G) / size]
    ar, ai, br, bi, wr, wi = _stepped(_step, scaled, rates, tau, size, bits + _lost_bits(top, size), growth)
    return acb(ar, ai), acb(br, bi), acb(wr, wi) * size


def _lost_bits(top: Spherical, size: arb) -> int:
    """Bits by which the momentum is smaller than the unit of the fixed-point numbers."""
    largest = arb(max(abs(top.a), abs(top.w[0]), abs(top.w[1])))
    return ceil(float((size / largest).log()) / 0.69) if largest > 0 else 0


def _highest_tilt(top: Spherical) -> float:
    """Return the largest 1 − cos θ of the motion."""
    cubic = cubic_of(top)
    integral = fmpq_poly([x * cubic.denom() for x in cubic.coeffs()]).numer()
    with ctx.workprec(200):
        return float(min((root.real.mid() for root, _ in integral.complex_roots()), key=_Ordered))


def _taylor_beside_upright(top: Spherical, tau: arb, bits: int, size: arb) -> tuple[acb, acb, acb]:
    """The same where the tilt stays small, in quantities that are as slow as the nutation.

    β'' = (κ − G|β|²) β with κ = G/2 − a²/4 − (|w|² − G s)/4 follows from the first-order equations; A = α e^{−iaτ/2}
    turns only as fast as |β|² lets it: A' = −½ conj(2β' + iaβ) β A/|α|². Near the threshold of the sleeping top all of
    these are far slower than the spin.
    """
    norm = arb(top.size).sqrt()
    a, G = arb(top.a), arb(top.G)
    alpha, beta = (acb(arb(v[0]), arb(v[1])) / norm for v in (top.alpha, top.beta))
    w = acb(arb(top.w[0]), arb(top.w[1]))
    kappa = arb(top.G / 2 - top.a**2 / 4 - (top.w2 - top.G * top.s) / 4)
    tilt = arb(_highest_tilt(top))
    slope = (w * alpha - acb(0, 1) * a * beta) / 2  # β'
    largest = (tilt / 2).sqrt()
    rate = abs(kappa).sqrt() + (G * tilt).sqrt() + abs(a) * tilt + abs(slope) / largest
    values = [v for x in (beta / largest, slope / (largest * rate), alpha) for v in (x.real, x.imag)]
    ratios = [rate, kappa / rate, G * largest**2 / rate, largest**2 * rate, largest**2 * a / 2]
    br, bi, vr, vi, ar, ai = _stepped(_slow_step, values, [*ratios, largest**2], tau, rate, bits + 40)
    alpha = acb(ar, ai) * _turn(a * tau / 2)
    beta, slope = acb(br, bi) * largest, acb(vr, vi) * largest * rate
    return alpha, beta, (2 * slope + acb(0, 1) * a * beta) / alpha


def _stepped(
    step: Callable[[list[int], list[int], int], list[int]], values: list[arb], rates: list[arb], tau: arb, size: arb,
    bits: int, growth: float = MOST_GROWTH,
) -> list[arb]:  # fmt: skip
    """Take equal steps of about STEP/size; ``rates`` come to ``step`` times its length."""
    turn = float(size * abs(tau))
    steps = max(1, ceil(turn / STEP))
    # growth is e^turn at most, and past a few hundred of it by far not that: the separatrix is left before
    work = bits + 24 + ceil(1.45 * min(turn, growth)) + 2 * (steps + 1).bit_length()
    unit = fmpz(1) << work

    def fixed(value: arb) -> int:
        return int((value * unit + arb("0.5")).mid().floor().unique_fmpz())

    with ctx.workprec(work + 200):
        h = tau / steps
        now, scaled = [fixed(v) for v in values], [fixed(h * r) for r in rates[: 5 if len(rates) > 3 else 3]]
        scaled += [fixed(r) for r in rates[5:]]
        for _ in range(steps):
            now = step(now, scaled, work)
        return [arb(x) / arb(unit) for x in now]


def _unfinished(series: list[list[int]]) -> bool:
    return len(series[0]) < 5 or any(abs(s[k]) > 1 for s in series for k in (-1, -2, -3))


def _step(values: list[int], rates: list[int], bits: int) -> list[int]:
    """One step; coefficients carry h^k. ``rates`` = |L| h/2, a h/2, G h/|L|, over 2^bits."""
    series = [[x] for x in values]
    ar, ai, br, bi, wr, wi = series
    rate, spin, pull = rates
    dot = _dot(bits)
    while _unfinished(series):
        dbr, dbi, dar, dai = br[::-1], bi[::-1], ar[::-1], ai[::-1]
        new = (
            -rate * (dot(wr, dbr) + dot(wi, dbi)) - spin * ai[-1],
            -rate * (dot(wr, dbi) - dot(wi, dbr)) + spin * ar[-1],
            rate * (dot(wr, dar) - dot(wi, dai)) + spin * bi[-1],
            rate * (dot(wr, dai) + dot(wi, dar)) - spin * br[-1],
            pull * (dot(ar, dbr) + dot(ai, dbi)),
            pull * (dot(ar, dbi) - dot(ai, dbr)),
        )
        order = len(ar)
        for s, x in zip(series, new, strict=True):
            s.append((x >> bits) // order)
    return [sum(s) for s in series]


def _dot(bits: int) -> Callable[[list[int], list[int]], int]:
    return lambda x, y: sum(map(mul, x, y)) >> bits


def _slow_step(values: list[int], rates: list[int], bits: int) -> list[int]:
    """One step of β, β', A and 1/|α|² beside the vertical, all scaled to order one."""
    br, bi, vr, vi, ar, ai = series = [[x] for x in values]
    move, pull, quartic, turn, spin, tilt = rates
    dot = _dot(bits)
    square: list[int] = []  # |β|², scaled
    mr: list[int] = []  # conj(2β' + iaβ) β /2, times h
    mi: list[int] = []
    inverse: list[int] = []  # 1/|α|²
    nr: list[int] = []
    ni: list[int] = []
    while _unfinished(series):
        dbr, dbi = br[::-1], bi[::-1]
        square.append(dot(br, dbr) + dot(bi, dbi))
        real, imaginary = dot(vr, dbr) + dot(vi, dbi), dot(vr, dbi) - dot(vi, dbr)
        mr.append(turn * real >> bits)
        mi.append(turn * imaginary - spin * square[-1] >> bits)
        one = (1 << bits) if not inverse else 0
        # (1 − |β|²)/|α|² = 1, order by order
        rest = one + (tilt * dot(square[:0:-1], inverse) >> bits)
        inverse.append((rest << bits) // ((1 << bits) - (tilt * square[0] >> bits)))
        back = inverse[::-1]
        nr.append(dot(mr, back))
        ni.append(dot(mi, back))
        dnr, dni, down = nr[::-1], ni[::-1], square[::-1]
        new = (
            move * vr[-1], move * vi[-1],
            pull * br[-1] - quartic * dot(br, down), pull * bi[-1] - quartic * dot(bi, down),
            (-(dot(dnr, ar) - dot(dni, ai))) << bits, (-(dot(dnr, ai) + dot(dni, ar))) << bits,
        )  # fmt: skip
        order = len(br)
        for s, x in zip(series, new, strict=True):
            s.append((x >> bits) // order)
    return [sum(s) for s in series]


def largest_momentum(
    moments: Sequence[Exact], mgl: Exact, momentum: Sequence[Exact], attitude: Sequence[Exact]
) -> arb:
    """Return the largest |L| of the whole motion: that at the lowest centre of mass."""
    weight = exact(mgl)
    top = spherical(exact(moments[0]), weight, momentum, attitude)
    top = half_turned(top) if weight < 0 else top
    square = arb(top.w2 + top.a**2)
    if top.G != 0 and not (top.w2 == 0 and top.s in (0, 2)):
        cubic = cubic_of(top)
        integral = fmpq_poly([x * cubic.denom() for x in cubic.coeffs()]).numer()
        lowest = min((root.real for root, _ in integral.complex_roots()), key=_Ordered)
        square = square + arb(top.G) * (lowest - arb(top.s))
    return square.nonnegative_part().sqrt()

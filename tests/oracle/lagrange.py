"""The Lagrange top to any number of digits, by Taylor series over one nutation and Legendre's integrals for the rest.

Nothing here is shared with the theta-function form of the library. Power series of 2α' = i a α − w̄ β,
2β' = w α − i a β, w' = G ᾱ β (spherical top, τ = t/I1) in fixed-point integers carry the top over less than one
nutation; whole nutations are a turn about the vertical and one about the axis, whose angles and period are complete
integrals of the first and third kind by Carlson's R_F and R_J, at turning points isolated exactly. Inputs are exact
rationals, so that double roots are known to be double.

Source: Whittaker, Analytical Dynamics, §71-73, in Cayley-Klein parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil
from operator import mul
from typing import NamedTuple

from flint import acb, arb, ctx, fmpq, fmpq_poly, fmpz

from oracle.reference import Exact, exact

ACCURATE_BITS = 160
"""48 digits of every entry, and of L relative to its largest value."""
STEP = 0.5
"""Fastest rate times the length of one Taylor step."""
DECAYED = 150
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
    bits: int = ACCURATE_BITS,
) -> TopState:  # fmt: skip
    """Return the state at ``t`` of a top with moments (I1, I1, I3), from the given state at 0; all numbers exact."""
    I1, I3, L3, time = exact(moments[0]), exact(moments[2]), exact(momentum[2]), exact(t)
    weight = exact(mgl)
    top = spherical(I1, weight, momentum, attitude)
    if weight < 0:
        top = half_turned(top)
    with ctx.workprec(2 * bits + 400):
        alpha, beta, w = _carried(top, time / I1, bits)
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
    cubic = fmpq_poly([-c * c, 2 * _F(top), 2 * top.G - top.a**2 - top.w2 + top.G * s, -top.G])
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


def _turn(angle: arb) -> acb:
    return acb(0, angle).exp()


def _towards_upright(top: Spherical, tau: fmpq, bits: int) -> tuple[acb, acb, acb]:
    """On the separatrix tilt and momentum die like e^-λτ; what is left is spin about the vertical."""
    decay = (arb(top.G) - arb(top.a) ** 2 / 4).sqrt()
    start = arb(top.s) if top.s else arb(1)
    enough = (DECAYED + 2 * start.log().abs_upper() + 10) / decay
    if abs(arb(tau)) <= enough:
        return taylor(top, arb(tau), bits)
    arrival = fmpq(int(enough.abs_upper().ceil().unique_fmpz()) if enough > 1 else 1) * (1 if tau > 0 else -1)
    alpha, _, _ = taylor(top, arb(arrival), bits)
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
    roots = [r.real for r, count in integral.complex_roots() for _ in range(count)]
    # float only sorts what is well apart; close roots are put in order exactly
    roots = sorted(sorted(roots, key=lambda x: -float(x.mid())), key=_Ordered)
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


def taylor(top: Spherical, tau: arb, bits: int) -> tuple[acb, acb, acb]:
    """Return α, β, w after ``tau`` by power series, over q/|q|."""
    size = arb(top.w2 + top.a**2 + 2 * abs(top.G)).sqrt()
    largest = arb(max(abs(top.a), abs(top.w[0]), abs(top.w[1])))
    turn = float(size * abs(tau))
    steps = max(1, ceil(turn / STEP))
    small = float((size / largest).log()) / 0.69 if largest > 0 else 0.0
    work = bits + 24 + ceil(1.45 * min(turn, 4000.0)) + ceil(small) + 2 * (steps + 1).bit_length()
    # growth is e^turn at most, and by far not that for spins that only turn
    unit = fmpz(1) << work
    h = tau / steps
    norm = arb(top.size).sqrt()

    def fixed(value: arb) -> int:
        return int((value * unit + arb("0.5")).mid().floor().unique_fmpz())

    with ctx.workprec(work + 200):
        pair = lambda v: [fixed(arb(v[0]) / norm), fixed(arb(v[1]) / norm)]  # noqa: E731
        scaled_w = [fixed(arb(x) / size) for x in top.w]
        values = [*pair(top.alpha), *pair(top.beta), *scaled_w]
        rate, spin = fixed(h * size / 2), fixed(h * arb(top.a) / 2)
        pull = fixed(h * arb(top.G) / size)
        for _ in range(steps):
            values = _step(values, rate, spin, pull, work)
        ar, ai, br, bi, wr, wi = (arb(x) / arb(unit) for x in values)
        return acb(ar, ai), acb(br, bi), acb(wr, wi) * size


def _step(values: list[int], rate: int, spin: int, pull: int, bits: int) -> list[int]:
    """One step; coefficients carry h^k. ``rate`` = |L| h/2, ``spin`` = a h/2, ``pull`` = G h/|L|, over 2^bits."""
    series = [[x] for x in values]
    ar, ai, br, bi, wr, wi = series
    order = 0
    while order < 4 or any(abs(s[k]) > 1 for s in series for k in (-1, -2, -3)):
        dbr, dbi, dar, dai = br[::-1], bi[::-1], ar[::-1], ai[::-1]
        dot = lambda x, y: sum(map(mul, x, y)) >> bits  # noqa: E731
        new = (
            -rate * (dot(wr, dbr) + dot(wi, dbi)) - spin * ai[-1],
            -rate * (dot(wr, dbi) - dot(wi, dbr)) + spin * ar[-1],
            rate * (dot(wr, dar) - dot(wi, dai)) + spin * bi[-1],
            rate * (dot(wr, dai) + dot(wi, dar)) - spin * br[-1],
            pull * (dot(ar, dbr) + dot(ai, dbi)),
            pull * (dot(ar, dbi) - dot(ai, dbr)),
        )
        order += 1
        for s, x in zip(series, new, strict=True):
            s.append((x >> bits) // order)
    return [sum(s) for s in series]

"""The Lagrange top to any number of digits, by Legendre's form: the oracle for the closed form under test.

Nothing here is shared with the theta-function form of the library. The tilt is written with Jacobi's sn, cn, dn by
descending Landen steps; the angles of the Cayley-Klein parameters α, β are incomplete integrals of the third kind by
Carlson's R_J, at turning points isolated exactly. Inputs are exact rationals, so that double roots are known to be
double; the rest is ball arithmetic at a precision that is raised until the balls are small enough.

Equations: 2α' = i a α − w̄ β, 2β' = w α − i a β, w' = G ᾱ β (spherical top, τ = t/I1).
Source: Whittaker, Analytical Dynamics, §71-73, in Cayley-Klein parameters; Carlson, Numer. Algorithms 10 (1995) 13.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import acb, arb, ctx, fmpq, fmpq_poly

from oracle.reference import HIGHEST_PRECISION, Exact, agm, carlson_rj, exact, jacobi

ACCURATE_BITS = 160
"""48 digits of every entry, and of L relative to its largest value."""


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
    """Tilt 1 − cos θ between ``lower`` and ``upper``, the third root of the cubic below them.

    It is upper − swing sn²(u) with u = first + half_rate τ at ``parameter1`` = 1 − m; sn, cn, dn are those of first.
    """

    upper: arb
    lower: arb
    swing: arb
    half_rate: arb
    parameter1: arb
    start: tuple[arb, arb, arb]


def reference_top(
    moments: Sequence[Exact], mgl: Exact, momentum: Sequence[Exact], attitude: Sequence[Exact], t: Exact,
    bits: int = ACCURATE_BITS,
) -> TopState:  # fmt: skip
    """Return the state at ``t`` of a top with moments (I1, I1, I3), from the given state at 0; all numbers exact."""
    precision = bits + 96
    while precision <= HIGHEST_PRECISION:
        with ctx.workprec(precision):
            state = _state(moments, mgl, momentum, attitude, t)
            limit = arb(2) ** -bits
            moved = limit * largest_momentum(moments, mgl, momentum, attitude)
            if _radii_below(state.quaternion, limit) and _radii_below(state.momentum, moved):
                return state
        precision *= 2
    raise ArithmeticError(f"{bits} bits need more than {HIGHEST_PRECISION} of work: {moments}, {mgl}, {momentum}, {t}")


def _radii_below(values: list[arb], limit: arb) -> bool:
    return all(x.is_finite() and (x.rad() == 0 or x.rad() < limit) for x in values)


def _state(
    moments: Sequence[Exact], mgl: Exact, momentum: Sequence[Exact], attitude: Sequence[Exact], t: Exact
) -> TopState:
    I1, I3, L3, time = exact(moments[0]), exact(moments[2]), exact(momentum[2]), exact(t)
    weight = exact(mgl)
    top = spherical(I1, weight, momentum, attitude)
    alpha, beta, w = _carried(half_turned(top) if weight < 0 else top, time / I1)
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


def _carried(top: Spherical, tau: fmpq) -> tuple[acb, acb, acb]:
    """Return α, β, w after ``tau``, over q/|q|."""
    norm = arb(top.size).sqrt()
    alpha, beta = (acb(arb(v[0]), arb(v[1])) / norm for v in (top.alpha, top.beta))
    w = acb(arb(top.w[0]), arb(top.w[1]))
    s, c = top.s, top.c
    t, c_plus = 2 - s, c + 2 * top.a
    if tau == 0:
        return alpha, beta, w
    if top.w2 == 0 and (s == 0 or t == 0 or top.G == 0):
        half = _turn(arb(top.a * tau) / 2)
        return alpha * half, beta / half, w / (half * half) if top.G == 0 else w
    cubic = cubic_of(top)
    if cubic(s) == 0 and cubic.derivative()(s) == 0:
        rate_alpha, rate_beta = arb(c_plus * tau / (2 * t)), arb(c * tau / (2 * s))
        return alpha * _turn(rate_alpha), beta * _turn(rate_beta), w * _turn(rate_beta - rate_alpha)
    return _nutated(top, nutation_of(top, cubic), tau, (alpha, beta, w))


def _nutated(top: Spherical, motion: Nutation, tau: fmpq, start: tuple[acb, acb, acb]) -> tuple[acb, acb, acb]:
    alpha, beta, w = start
    s1, s2, d = motion.upper, motion.lower, motion.swing
    c, c_plus = top.c, top.c + 2 * top.a
    t1 = 2 - s1 if c_plus else arb(0)  # 2 is a root then, and none is above it
    ratios = [(d / t1, (2 - s2) / t1) if c_plus else None, (-d / s1, s2 / s1) if c else None]
    (sn, cn, dn), (swept_alpha, swept_beta) = _along(motion, motion.half_rate * arb(tau), ratios)
    s, t = s2 + d * cn**2, t1 + d * sn**2
    sn0, cn0, _ = motion.start
    if c_plus:
        angle = arb(c_plus) / (2 * motion.half_rate * t1) * swept_alpha
        later_alpha = alpha * (t / arb(2 - top.s)).sqrt() * _turn(angle)
    elif sn0 == 0:  # from straight down, where α' = −w̄β/2
        later_alpha = (d / 2).sqrt() * sn * _direction(-w.conjugate() * beta)
    else:
        later_alpha = alpha * sn / sn0
    if c or s2 != 0:  # without c: a motion through the bottom that never reaches the top
        angle = arb(c) / (2 * motion.half_rate * s1) * swept_beta
        later_beta = beta * (s / arb(top.s)).sqrt() * _turn(angle)
    elif cn0 == 0:  # from upright, where β' = wα/2
        later_beta = -(d / 2).sqrt() * cn * _direction(w * alpha)
    else:
        later_beta = beta * cn / cn0
    speed = -2 * motion.half_rate * d * sn * cn * dn  # s' = 2 Re β̄αw
    later_w = acb(speed, arb(c) + arb(top.a) * s) / (2 * later_beta.conjugate() * later_alpha)
    return later_alpha, later_beta, later_w


def _direction(value: acb) -> acb:
    return value / abs(value)


def _turn(angle: arb) -> acb:
    return acb(0, angle).exp()


def cubic_of(top: Spherical) -> fmpq_poly:
    """u̇² as a polynomial in s = 1 − u."""
    excess = top.w2 - top.G * top.s  # the same all the time
    return fmpq_poly([-top.c**2, 2 * (excess - top.a * top.c), 2 * top.G - top.a**2 - excess, -top.G])


def nutation_of(top: Spherical, cubic: fmpq_poly) -> Nutation:
    s = top.s
    integral = fmpq_poly([x * cubic.denom() for x in cubic.coeffs()]).numer()
    roots = sorted((root.real for root, count in integral.complex_roots() for _ in range(count)), key=_Ordered)
    if top.c == 0:
        roots = [arb(0) if root.contains(0) else root for root in roots]
    s1, s2 = roots[0], roots[1]
    d = s1 - s2
    if top.G:
        width = s1 - roots[2]
        A, m1, dn = arb(top.G) * width, (s2 - roots[2]) / width, ((arb(s) - roots[2]) / width).sqrt()
    else:
        A, m1, dn = -arb(cubic[2]), arb(1), arb(1)
    (wr, wi), (ar, ai), (br, bi) = top.w, top.alpha, top.beta
    falling = (br * ar + bi * ai) * wr - (br * ai - bi * ar) * wi  # Re β̄αw
    if cubic(s) != 0:
        sn, cn = ((s1 - arb(s)) / d).sqrt(), ((arb(s) - s2) / d).sqrt()
        start = (-sn if falling > 0 else sn, cn, dn)
    elif (s1 - arb(s)).contains(0):
        start = (arb(0), arb(1), arb(1))
    else:
        start = (arb(1), arb(0), m1.sqrt())
    return Nutation(s1, s2, d, A.sqrt() / 2, m1, start)


def _along(
    motion: Nutation, phase: arb, ratios: Sequence[tuple[arb, arb] | None]
) -> tuple[tuple[arb, arb, arb], list[arb]]:
    """Return sn, cn, dn after ``phase`` and ∫ du/(1 + ratio sn² u) for each (ratio, 1 + ratio); cn ≥ 0 at the start."""
    sn0, cn0, dn0 = motion.start
    if motion.parameter1 == 0:
        return _on_separatrix((sn0 / cn0).asinh(), phase, ratios)
    complementary_modulus = motion.parameter1.sqrt()
    quarter = arb.pi() / (2 * agm(arb(1), complementary_modulus))
    first = sn0 * acb.elliptic_rf(cn0**2, dn0**2, 1).real
    u = first + phase
    half_turns = ((u / (2 * quarter)).mid() + arb("0.5")).floor().mid()
    rest = u - 2 * quarter * half_turns
    sn, cn, dn = jacobi(rest, complementary_modulus)

    def swept(ratio: arb, above: arb) -> arb:
        def third_kind(u: arb, sn: arb, cn: arb, dn: arb) -> arb:
            return u - ratio / 3 * sn**3 * carlson_rj(cn**2, dn**2, cn**2 + above * sn**2)

        complete = third_kind(quarter, arb(1), arb(0), complementary_modulus)
        return third_kind(rest, sn, cn, dn) + 2 * complete * half_turns - third_kind(first, sn0, cn0, dn0)

    whole = half_turns.unique_fmpz()
    if whole is None:  # the caller raises the precision
        unknown = arb("nan")
        return (unknown, unknown, unknown), [unknown for _ in ratios]
    found = [swept(*ratio) if ratio else arb(0) for ratio in ratios]
    return ((-sn, -cn, dn) if int(whole) % 2 else (sn, cn, dn)), found


def _on_separatrix(
    first: arb, phase: arb, ratios: Sequence[tuple[arb, arb] | None]
) -> tuple[tuple[arb, arb, arb], list[arb]]:
    """The same at modulus 1, in hyperbolic functions."""
    last = first + phase

    def swept(ratio: arb, above: arb) -> arb:
        root = ratio.sqrt()
        return (phase + root * ((root * last.tanh()).atan() - (root * first.tanh()).atan())) / above

    found = [swept(*ratio) if ratio else arb(0) for ratio in ratios]
    return (last.tanh(), last.sech(), last.sech()), found


class _Ordered:
    """Sorts balls downwards by their midpoints, at full precision."""

    def __init__(self, value: arb) -> None:
        self.value = value.mid()

    def __lt__(self, other: _Ordered) -> bool:
        return bool(self.value > other.value)


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

"""The Lagrange top in exact rational numbers, and balls computed from them.

The tilt follows a cubic with rational coefficients, f(u) = (1 − u²)(e − k u) − (p − a u)² for u = cos θ, whose roots
are enclosed in balls. Its double roots are rational, and the greatest common divisor with its derivative finds them: a
constant tilt, or the separatrix. The Cayley–Klein parameters α = w + iz and β = x + iy turn at rates rational in u,
whose integrals are of the third kind; a top that passes a vertical has no such integral there, but a factor that
changes sign.

Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV; Whittaker, *Analytical Dynamics*, §71–73.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import acb, arb, ctx, fmpq, fmpq_poly

from polhode.analysis._exact_arithmetic import Ball, Rational, Wanted
from polhode.proving.enclosures import _ball_turns as ball_turns
from polhode.proving.enclosures._elliptic_balls import Oscillation, Periodic, Place, Separatrix
from polhode.proving.enclosures._free_body_balls import INFINITE, STABLE, UNSTABLE, whole_turns
from polhode.proving.enclosures._motion_starts import ExactBody, MotionStart, Values, refine_named
from polhode.proving.enclosures.motion_enclosures import TopEnclosure


def enclose_top_motion(start: MotionStart, digits: int) -> TopEnclosure:
    """Return the enclosures of a Lagrange top's motion."""
    top = LagrangeTop(start)
    kept, moving = (refine_named(compute, digits) for compute in (top.constants, top.moving_constants))
    names = ("nutation_period", "precession_per_period", "spin_per_period", "precession_rate", "spin_rate", "action")
    return TopEnclosure(
        digits=digits, taken=start.taken, regime=top.regime, nutation_limits=(moving["lowest"], moving["highest"]),
        verdicts=top.verdicts, verdict=top.verdict, _body=top, energy=kept["energy"],
        vertical_momentum=kept["vertical_momentum"], axial_momentum=kept["axial_momentum"],
        **{name: moving.get(name) for name in names},
    )


class LagrangeTop(ExactBody):
    """A Lagrange top in exact numbers, in body axes with its centre of mass on the positive third one.

    Attributes:
        start: as given.
        reversed: whether these axes are the given ones rotated by π about the first, for a weight below zero.
        I1, I3, k: moments, and 2 I1 mgl ≥ 0.
        alpha, beta: Cayley–Klein parameters times |q|, each a pair of rationals; ``size`` is |q|².
        across: L1 and L2.
        a, p: momenta about the axis and about the vertical.
        u: cos θ at the start.
        falling: I1 u' at the start.
        cubic: f.
        steady: whether the tilt is constant.
    """

    def __init__(self, start: MotionStart) -> None:
        self.start = start
        self.I1, self.I3 = start.moments[0], start.moments[2]
        weight = start.numbers["mgl"]
        w, x, y, z = start.attitude
        L1, L2, L3 = start.momentum
        self.reversed = bool(weight < 0)
        if self.reversed:
            w, x, y, z, L2, L3 = -x, w, z, -y, -L2, -L3
        self.alpha, self.beta, self.across, self.a = (w, z), (x, y), (L1, L2), L3
        self.size = ball_turns.square_of((w, x, y, z))
        up = [2 * (x * z - w * y) / self.size, 2 * (y * z + w * x) / self.size]
        self.u = (w * w + z * z - x * x - y * y) / self.size
        self.k = 2 * self.I1 * abs(weight)
        self.mgl = abs(weight)
        self.p = L1 * up[0] + L2 * up[1] + self.a * self.u
        self.falling = up[0] * L2 - up[1] * L1
        self.e = L1 * L1 + L2 * L2 + self.k * self.u
        self.energy = self.e / (2 * self.I1) + self.a * self.a / (2 * self.I3)
        k, a, p, e = self.k, self.a, self.p, self.e
        self.cubic = fmpq_poly([e - p * p, 2 * p * a - k, -e - a * a, k])
        self.spin = a * (1 / self.I3 - 1 / self.I1)
        self._set_regime()
        self._made: dict[int, Any] = {}

    def _set_regime(self) -> None:
        still = self.across[0] == 0 and self.across[1] == 0
        upright = abs(self.u) == 1
        self.double = self._double_root()
        self.steady = self.double is not None and self.double == self.u
        separatrix = self.double is not None and not self.steady
        permanent = still and (upright or (self.k == 0 and self.a == 0))
        turning = self.p / self.a if self.a != 0 else fmpq(2)  # the tilt at which the azimuth has a turning point
        lean = self.cubic(turning)
        if permanent and self.a == 0:
            self.regime = "rest"
        elif self.k == 0:
            self.regime = "free"
        elif permanent:
            self.regime = "sleeping" if self.u == 1 else "hanging"
        elif separatrix:
            self.regime = "separatrix"
        elif self.steady:
            self.regime = "steady"
        elif self.a == 0 and self.p == 0:
            self.regime = "planar"
        else:
            within = abs(turning) < 1
            self.regime = "loop" if within and lean > 0 else "cusp" if within and lean == 0 else "undulating"
        self.permanent, self.separatrix = permanent, separatrix

    def _double_root(self) -> Rational | None:
        """Return the double root of the cubic, which is rational; None where all roots are simple."""
        if self.cubic.degree() < 0:  # no momentum and no weight
            return self.u
        common = self.cubic.gcd(self.cubic.derivative())
        if common.degree() < 1:
            return None
        # a triple root is one of the second derivative too
        coefficients = common.coeffs()
        return -coefficients[common.degree() - 1] / (common.degree() * coefficients[-1])

    @property
    def verdicts(self) -> dict[str, str]:
        """Verdicts on the upright and the hanging axis at this L3.

        Stable if no other motion nearby has equal integrals: upright iff L3² ≥ 4 I1 mgl, hanging always.
        """
        if self.k == 0:
            return {}
        return {"upright": STABLE if self.a * self.a >= 2 * self.k else UNSTABLE, "hanging": STABLE}

    @property
    def verdict(self) -> str | None:
        """The verdict on this motion, if the axis stays vertical."""
        if not self.permanent or self.k == 0:
            return None
        return self.verdicts["upright" if self.u == 1 else "hanging"]

    # ------------------------------------------------------------------ numbers

    def constants(self) -> dict[str, Wanted]:
        """Return energy and momenta."""
        axial = -self.a if self.reversed else self.a
        return {"energy": Wanted(arb(self.energy)), "vertical_momentum": Wanted(arb(self.p)),
                "axial_momentum": Wanted(arb(axial))}  # fmt: skip

    def moving_constants(self) -> dict[str, Wanted]:
        """Return limits of the tilt, period, precession, own turn and action, as far as they are defined."""
        if self.separatrix:
            rest = self.separatrix_root()
            return {**self._limits(arb(rest), arb(1)), "nutation_period": Wanted(INFINITE)}
        if self.steady:
            return {**self._limits(arb(self.u), arb(self.u)), **self._steady_constants()}
        swing = self._swing
        assert isinstance(swing, Nutation)
        return {**self._limits(swing.u1, swing.u2), **swing.constants()}

    def _limits(self, lowest: Ball, highest: Ball) -> dict[str, Wanted]:
        if self.reversed:
            lowest, highest = -highest, -lowest
        return {"lowest": Wanted(lowest, arb(1)), "highest": Wanted(highest, arb(1))}

    def separatrix_root(self) -> Rational:
        """Return the simple root of a cubic with a double root at 1."""
        return self.cubic.coeffs()[0] / self.k * -1 if self.k else self.u

    def _steady_constants(self) -> dict[str, Wanted]:
        """Return the numbers of a top of constant tilt, those of its smallest nutations."""
        if self.permanent:
            return {}
        # I1² ω² = −f''/2 for small nutations about a double root
        curvature = -self.cubic.derivative().derivative()(self.u) / 2
        period = 2 * arb.pi() * arb(self.I1) / arb(curvature).sqrt()
        alpha, beta = self.steady_rates()
        return _per_period(self, period, arb(alpha) * period, arb(beta) * period)

    def steady_rates(self) -> tuple[Rational, Rational]:
        """Return the rates at which α and β turn at a constant tilt."""
        up = (self.p + self.a) / (self.I1 * (1 + self.u)) if self.u != -1 else fmpq(0)
        down = (self.p - self.a) / (self.I1 * (1 - self.u)) if self.u != 1 else fmpq(0)
        return (self.spin + up) / 2, (down - self.spin) / 2

    # ------------------------------------------------------------------ the state

    @property
    def _swing(self) -> Nutation:
        if ctx.prec not in self._made:
            self._made = {ctx.prec: Nutation(self)}
        return self._made[ctx.prec]

    def lost_bits(self, elapsed: Rational) -> float:
        momentum = abs(self.across[0]) + abs(self.across[1]) + abs(self.a)
        # √x ≤ 1 + x in any unit of time serves as a bound here, where a few excess bits are harmless
        rate = momentum * (1 / self.I1 + 1 / self.I3) + 1 + self.mgl / self.I1
        return whole_turns(abs(elapsed) * rate)

    def values_at(self, elapsed: Rational) -> Values:
        norm = arb(self.size).sqrt()
        alpha, beta = (acb(arb(x), arb(y)) / norm for x, y in (self.alpha, self.beta))
        across = acb(*map(arb, self.across))
        if self.steady:
            rates = self.steady_rates()
            factors = [_turn(arb(rate) * arb(elapsed)) for rate in rates]
            alpha, beta = alpha * factors[0], beta * factors[1]
            across = across * self._steady_turn_of_momentum(elapsed)
        else:
            alpha, beta, across = self._swing.state(elapsed, alpha, beta, across)
        size = abs(across) + arb(self.first_square()).sqrt()
        axial = arb(self.a)
        if self.reversed:
            alpha, beta, across, axial = beta, -alpha, across.conjugate(), -axial
        return Values([alpha.real, beta.real, beta.imag, alpha.imag], [across.real, across.imag, axial], size)

    def _steady_turn_of_momentum(self, elapsed: Rational) -> Ball:
        """Return the factor of L1 + iL2 at a constant tilt; they vanish where the axis is vertical."""
        alpha, beta = self.steady_rates()
        if abs(self.u) == 1:  # with weight the momentum is along the axis; without, it precesses as in a free body
            return _turn(arb(-self.spin) * arb(elapsed))
        return _turn(arb(beta - alpha) * arb(elapsed))

    def first_square(self) -> Rational:
        """Return |L|² at the start."""
        return self.across[0] ** 2 + self.across[1] ** 2 + self.a**2


def _per_period(top: LagrangeTop, period: Ball, alpha: Ball, beta: Ball) -> dict[str, Wanted]:
    """Return period, turns and rates from the angles by which α and β turn in a period."""
    precession, spin = alpha + beta, alpha - beta
    if top.reversed:
        spin = -spin
    turn, rate = 2 * arb.pi(), 2 * arb.pi() / period
    return {"nutation_period": Wanted(period), "precession_per_period": Wanted(precession, turn),
            "spin_per_period": Wanted(spin, turn), "precession_rate": Wanted(precession / period, rate),
            "spin_rate": Wanted(spin / period, rate)}  # fmt: skip


def _turn(angle: Ball) -> Ball:
    return acb(0, angle).exp()


class _Roots(NamedTuple):
    """The roots of the cubic: the tilt's limits, their difference, the parameters m and 1 − m, and κ of sn(κ t)."""

    u1: Ball
    u2: Ball
    width: Ball
    m: Ball
    m1: Ball
    rate: Ball
    at: int | None  # which of both the motion starts from, 0 or 1


class Nutation:
    """The nutation u = u1 + (u2 − u1) sn² of a top, in balls of one precision; the separatrix is m = 1."""

    def __init__(self, top: LagrangeTop) -> None:
        self.top = top
        self.u1, self.u2, self.width, m, m1, self.rate, at = _find_roots(top)
        sn = ((arb(top.u) - self.u1) / self.width).sqrt() if at is None else arb(at)
        cn = ((self.u2 - arb(top.u)) / self.width).sqrt() if at is None else arb(1 - at)
        if top.falling < 0:
            sn = -sn
        self.oscillation: Oscillation = Separatrix(sn, cn) if top.separatrix else Periodic(m, m1, sn, cn)
        # of 1 + u and 1 − u, over their values at sn = 0
        self.up, self.down = 1 + self.u1, 1 - self.u1
        self.through_bottom = top.p == -top.a and bool(self.u1 == -1)
        self.through_top = top.p == top.a and bool(self.u2 == 1) and not top.separatrix
        self.turns_alpha, self.turns_beta = top.p != -top.a, top.p != top.a

    def constants(self) -> dict[str, Wanted]:
        """Return period, precession, own turn and action."""
        top, oscillation = self.top, self.oscillation
        assert isinstance(oscillation, Periodic)
        period = 2 * oscillation.quarter / self.rate
        alpha = arb(top.spin) * period / 2
        beta = -alpha
        if self.turns_alpha:
            alpha += self._share_alpha() * 2 * oscillation.complete(-self.width / self.up, (1 + self.u2) / self.up)
        if self.turns_beta:
            beta += self._share_beta() * 2 * oscillation.complete(self.width / self.down, (1 - self.u2) / self.down)
        mean = self.u1 + self.width * oscillation.mean_square()
        twice_kinetic = 2 * (arb(top.energy) - arb(top.mgl) * mean) * period
        action = (twice_kinetic - arb(top.p) * (alpha + beta) - arb(top.a) * (alpha - beta)) / (2 * arb.pi())
        if self.through_bottom:
            alpha += arb.pi()
        if self.through_top:
            beta += arb.pi()
        return {**_per_period(top, period, alpha, beta), "action": Wanted(action)}

    def _share_alpha(self) -> Ball:
        return arb((self.top.p + self.top.a) / (2 * self.top.I1)) / (self.up * self.rate)

    def _share_beta(self) -> Ball:
        return arb((self.top.p - self.top.a) / (2 * self.top.I1)) / (self.down * self.rate)

    def state(self, elapsed: Rational, alpha: Ball, beta: Ball, across: Ball) -> tuple[Ball, Ball, Ball]:
        """Return α, β and L1 + iL2 a time after the epoch, from those at the epoch."""
        top, t = self.top, arb(elapsed)
        place = self.oscillation.after(self.rate * t)
        spin = _turn(arb(top.spin) * t / 2)
        later_alpha, alpha_rate = self._alpha(place, alpha, beta, across)
        later_beta, beta_rate = self._beta(place, alpha, beta, across)
        half = acb(0, arb(top.spin) / 2)
        later_alpha, alpha_rate = later_alpha * spin, alpha_rate * spin
        later_beta, beta_rate = later_beta / spin, beta_rate / spin
        alpha_rate, beta_rate = alpha_rate + half * later_alpha, beta_rate - half * later_beta
        # 2α' = iΩ3 α − w̄β/I1 and 2β' = wα/I1 − iΩ3 β, solved for w
        later = 2 * arb(top.I1) * (later_alpha.conjugate() * beta_rate - later_beta * alpha_rate.conjugate())
        return later_alpha, later_beta, later

    def _find_speed(self, place: Place) -> Ball:
        """Return half of u'."""
        return self.width * self.rate * place.sn * place.cn * place.dn

    def _alpha(self, place: Place, alpha: Ball, beta: Ball, across: Ball) -> tuple[Ball, Ball]:
        """Return α and its rate without the spin that I3 ≠ I1 adds."""
        top, start = self.top, self.oscillation.start
        if self.through_bottom:
            if start.sn == 0:  # from straight down, where 2 I1 α' = −w̄β
                scale = -across.conjugate() * beta / (2 * arb(top.I1) * self.rate)
            else:
                scale = alpha / start.sn
            return scale * place.sn, scale * self.rate * place.cn * place.dn
        above = self.up + self.width * place.sn * place.sn
        value = alpha * (above / arb(1 + top.u)).sqrt()
        turning = arb(0)
        if self.turns_alpha:
            n, n1 = -self.width / self.up, (1 + self.u2) / self.up
            value = value * _turn(self._share_alpha() * self.oscillation.swept(place, n, n1))
            turning = arb((top.p + top.a) / (2 * top.I1)) / above
        return value, value * acb(self._find_speed(place) / above, turning)

    def _beta(self, place: Place, alpha: Ball, beta: Ball, across: Ball) -> tuple[Ball, Ball]:
        """Return β and its rate without the spin that I3 ≠ I1 adds."""
        top, start = self.top, self.oscillation.start
        if self.through_top:
            if start.cn == 0:  # from upright, where 2 I1 β' = wα
                root = self.oscillation.start.dn
                scale = -across * alpha / (2 * arb(top.I1) * self.rate * start.sn * root)
            else:
                scale = beta / start.cn
            return scale * place.cn, -scale * self.rate * place.sn * place.dn
        below = (1 - self.u2) + self.width * place.cn * place.cn
        value = beta * (below / arb(1 - top.u)).sqrt()
        turning = arb(0)
        if self.turns_beta:
            n, n1 = self.width / self.down, (1 - self.u2) / self.down
            value = value * _turn(self._share_beta() * self.oscillation.swept(place, n, n1))
            turning = arb((top.p - top.a) / (2 * top.I1)) / below
        return value, value * acb(-self._find_speed(place) / below, turning)


def _find_roots(top: LagrangeTop) -> _Roots:
    """Return the roots, exact where they are at a vertical or at the start."""
    twice, cubic = 2 * arb(top.I1), top.cubic
    slope = cubic.derivative()(top.u)
    at = None if cubic(top.u) != 0 else 0 if slope > 0 else 1
    if top.separatrix:
        low = top.separatrix_root()
        return _Roots(arb(low), arb(1), 1 - arb(low), arb(1), arb(0), (arb(top.k) * (1 - arb(low))).sqrt() / twice, at)
    if top.k == 0:
        square = top.first_square()
        middle, half = top.p * top.a / square, arb((square - top.a**2) * (square - top.p**2)).sqrt() / arb(square)
        u1, u2, width, m, m1 = arb(middle) - half, arb(middle) + half, 2 * half, arb(0), arb(1)
        rate = arb(square).sqrt() / twice
    else:
        u1, u2, width, rest = _three_roots(cubic)
        m, m1 = width / (width + rest), rest / (width + rest)
        rate = (arb(top.k) * (width + rest)).sqrt() / twice
    if top.p == -top.a:
        u1 = arb(-1)
    if top.p == top.a and (top.k == 0 or top.e > top.k):
        u2 = arb(1)
    if at is not None:
        u1, u2 = (arb(top.u), u2) if at == 0 else (u1, arb(top.u))
    return _Roots(u1, u2, width, m, m1, rate, at)


def _three_roots(cubic: fmpq_poly) -> tuple[Ball, Ball, Ball, Ball]:
    """Return the least root of a cubic with three, the middle one, and the differences of neighbours.

    By the cosine of a third of an angle, whose tangent is exact to its last digit even where roots are close (Viète).
    """
    c0, c1, c2, c3 = cubic.coeffs()
    shift, slope, value = c2 / (3 * c3), c1 / c3, c0 / c3
    p = slope - 3 * shift**2
    half = shift**3 - shift * slope / 2 + value / 2
    size = (arb(-p) / 3).sqrt()
    beyond = arb(-(half**2) - (p / 3) ** 3).sqrt()
    third, other = arb.atan2(beyond, arb(-half)) / 3, arb.atan2(beyond, arb(half)) / 3
    turn, root = arb.pi() / 3, 2 * arb(3).sqrt() * size
    least = -2 * size * (third - turn).cos() - arb(shift)
    middle = 2 * size * (third - 2 * turn).cos() - arb(shift)
    return least, middle, root * third.sin(), root * other.sin()

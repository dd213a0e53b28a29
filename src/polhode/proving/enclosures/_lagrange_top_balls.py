"""Enclosures of a Lagrange top's motion from exact numbers: its regime, its constants, and its state at any time.

The tilt follows a cubic with rational coefficients, f(u) = (1 − u²)(e − k u) − (p − a u)² for u = cos θ, whose roots
are enclosed in balls. Its double roots are rational, and the greatest common divisor with its derivative finds them: a
constant tilt, or the separatrix. All else is by the formulas of ``polhode.exact.lagrange_top``, but for their series:
A(z) is √t₂ θ3 θ1(z ∓ iy)/θ2(iy), and B(z) is √s₁ θ4 θ2(z ∓ iy)/θ2(iy).

Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV; Whittaker, *Analytical Dynamics*, §71–73.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from flint import acb, arb, ctx, fmpq, fmpq_poly

from polhode.analysis._exact_arithmetic import Ball, Rational, Wanted
from polhode.exact.lagrange_top import _formulas as formulas
from polhode.exact.lagrange_top import _formulas_integrals as formulas_integrals
from polhode.exact.lagrange_top import _formulas_numbers as formulas_numbers
from polhode.exact.lagrange_top import _formulas_rates as formulas_rates
from polhode.exact.lagrange_top import _formulas_reduction as formulas_reduction
from polhode.exact.lagrange_top import _formulas_roots as formulas_roots
from polhode.exact.lagrange_top import _formulas_setup as formulas_setup
from polhode.exact.lagrange_top._formulas import Motion
from polhode.exact.lagrange_top._formulas_integrals import Integrals
from polhode.exact.lagrange_top._formulas_rates import Frequencies
from polhode.exact.lagrange_top._formulas_reduction import Reduction
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.exact.lagrange_top._formulas_setup import Arguments, Given
from polhode.exact.lagrange_top._geometry import REGIMES
from polhode.proving.enclosures import _ball_turns as ball_turns
from polhode.proving.enclosures._ball_formulas import ZERO, carlson, for_balls, thetas
from polhode.proving.enclosures._free_body_balls import STABLE, UNSTABLE, Balls, whole_turns
from polhode.proving.enclosures._motion_starts import ExactBody, MotionStart, Values, refine_named
from polhode.proving.enclosures.motion_enclosures import TopEnclosure

NONE: Any = (ZERO, ZERO, ZERO, ZERO)


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
        across: L1 and L2; ``across2`` is the sum of their squares.
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
        self.mgl = abs(weight)
        self.k = 2 * self.I1 * self.mgl
        self.p = L1 * up[0] + L2 * up[1] + self.a * self.u
        self.falling = up[0] * L2 - up[1] * L1
        self.across2 = L1 * L1 + L2 * L2
        self.e = self.across2 + self.k * self.u
        self.energy = self.e / (2 * self.I1) + self.a * self.a / (2 * self.I3)
        k, a, p, e = self.k, self.a, self.p, self.e
        self.cubic = fmpq_poly([e - p * p, 2 * p * a - k, -e - a * a, k])
        double = self._double_root()
        self.steady = double is not None and double == self.u
        self.separatrix = double is not None and not self.steady
        self.permanent = self.across2 == 0 and (abs(self.u) == 1 or (k == 0 and a == 0))
        kind = SimpleNamespace(permanent=self.permanent, separatrix=self.separatrix, steady=self.steady)
        self.regime = REGIMES[int(float(FORMULAS._regime(self._reduced(), kind)))]
        self._motions: dict[int, Motion] = {}

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

    # ------------------------------------------------------------------ balls, at the present precision

    def _reduced(self) -> Reduction:
        a, p, u, k, w2 = self.a, self.p, self.u, self.k, self.across2
        pairs = (self.size, k, 1 - u, 1 + u, u, self.falling, p - a, p + a, p - u * a, w2 - k * (1 - u) - a * (p - a),
                 2 * k - a * a - w2 + k * (1 - u), w2, a * (w2 - k * (1 - u)) - k * (p - a))  # fmt: skip
        return Reduction(
            (arb(self.I1), arb(self.I3)), (arb(self.across[0]), arb(self.across[1]), arb(a)), NONE, self.reversed, ZERO,
            arb(1), arb(1), *((arb(x), ZERO) for x in pairs),
        )  # fmt: skip

    def _rates(self) -> tuple[Reduction, TurningPoints, Frequencies]:
        top = self._reduced()
        points = _turning_points(self, top)
        rates = FORMULAS.frequencies(top, points)
        if (rates.separatrix, rates.steady) != (self.separatrix, self.steady and not self.permanent):
            with ctx.workprec(2 * ctx.prec):  # in which roots that differ are apart
                return self._rates()
        return top, points, rates

    def constants(self) -> dict[str, Wanted]:
        """Return energy and momenta."""
        axial = -self.a if self.reversed else self.a
        return {"energy": Wanted(arb(self.energy)), "vertical_momentum": Wanted(arb(self.p)),
                "axial_momentum": Wanted(arb(axial))}  # fmt: skip

    def moving_constants(self) -> dict[str, Wanted]:
        """Return limits of the tilt, period, precession, own turn and action, as far as they are defined."""
        top, points, rates = self._rates()
        numbers = FORMULAS.numbers(top, points, rates)
        period, precession, spin = numbers.period, numbers.precession_per_period, numbers.spin_per_period
        turn = 2 * arb.pi()
        found = {"lowest": Wanted(numbers.lowest, arb(1)), "highest": Wanted(numbers.highest, arb(1))}
        if not self.permanent:
            found["nutation_period"] = Wanted(period)
        if not (self.permanent or self.separatrix):
            found |= {"precession_per_period": Wanted(precession, turn), "spin_per_period": Wanted(spin, turn),
                      "precession_rate": Wanted(precession / period, turn / period),
                      "spin_rate": Wanted(spin / period, turn / period)}  # fmt: skip
        if not (self.steady or self.separatrix):
            own = -spin if self.reversed else spin
            twice_kinetic = 2 * (arb(self.energy) - arb(self.mgl) * self._mean_tilt(points)) * period
            found["action"] = Wanted((twice_kinetic - arb(self.p) * precession - arb(self.a) * own) / turn)
        return found

    def _mean_tilt(self, points: TurningPoints) -> Ball:
        """Return the mean of cos θ over a nutation, u1 + (u2 − u1)(K − E)/mK."""
        d, m1 = points.d[0], points.B[0] / points.A[0]
        share = acb.elliptic_rd(0, acb(m1), 1).real / 3 * 2 * arb(1).agm(m1.sqrt()) / arb.pi()
        return points.t1[0] - 1 + d * share

    def lost_bits(self, elapsed: Rational) -> float:
        momentum = abs(self.across[0]) + abs(self.across[1]) + abs(self.a)
        # √x ≤ 1 + x in any unit of time serves as a bound here, where a few excess bits are harmless
        rate = momentum * (1 / self.I1 + 1 / self.I3) + 1 + self.mgl / self.I1
        return whole_turns(abs(elapsed) * rate)

    def values_at(self, elapsed: Rational) -> Values:
        if ctx.prec not in self._motions:
            self._motions = {ctx.prec: self._motion()}
        motion = self._motions[ctx.prec]
        state = FORMULAS.state_of(motion, _sums(motion, (arb(elapsed), ZERO, ZERO)))
        size = abs(acb(state[4], state[5])) + arb(self.across2 + self.a * self.a).sqrt()
        return Values(list(state[:4]), list(state[4:]), size)

    def _motion(self) -> Motion:
        top, points, rates = self._rates()
        at = FORMULAS.arguments(top, points, rates, FORMULAS.integrals_of(top, points, rates))
        motion, _ = FORMULAS.motion_without_phases(Given(top, points, rates, at, arb(self.start.momentum[2])))
        return motion._replace(phases=self._phases(_sums(motion, (ZERO, ZERO, ZERO))))

    def _phases(self, sums: Balls) -> Any:
        """Return cos and sin of the phases of the start; where α or β is zero there, their rates have them."""
        ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = sums
        alpha, beta, w = (acb(arb(x), arb(y)) for x, y in (self.alpha, self.beta, self.across))
        a, b = acb(ar, ai), acb(br, bi)
        if self.u == -1:  # 2α' = −w̄ β
            alpha, a = -w.conjugate() * beta, acb(dar, dai)
        elif self.u == 1:  # 2β' = wα
            beta, b = w * alpha, acb(dbr, dbi)
        return *_direction(alpha, a, turns_a), *_direction(beta, b, turns_b)


def _direction(value: Ball, of: Ball, turns: Ball) -> tuple[Ball, Ball]:
    """Return cos and sin of the angle from a complex number and some turns to a value, 1 and 0 if that is zero."""
    if value == 0:
        return arb(1), ZERO
    turned = value / (of * acb(2 * turns).exp_pi_i())
    turned = turned / abs(turned)
    return turned.real, turned.imag


# ---------------------------------------------------------------------- the functions that the series stand for


def _integral(idle: bool, terms: tuple[Ball, Ball, Ball]) -> Ball:
    """Return √c R_F(x, y, 1), or some number where there is none."""
    x, y, c = terms
    return arb(1) if idle else c.nonnegative_part().sqrt() * carlson(x, y, arb(1))


def _sharp_integral(idle: bool, terms: Any) -> tuple[Ball, Ball]:
    (x, _), (y, _), (c, _) = terms
    return _integral(idle, (x, y, c)), ZERO


def _arguments(top: Reduction, points: TurningPoints, rates: Frequencies, integrals: Integrals) -> Arguments:
    """Return the places of start and poles; the nome is zero where no theta function is taken."""
    by = arb(1) if rates.separatrix or rates.permanent else rates.nutation[0] / rates.half_root[0]  # π/2K
    x0 = integrals.x0[0] if top.p[0] >= 0 else -integrals.x0[0]
    return Arguments(
        not rates.separatrix, ZERO, arb(1), integrals.v_alpha * by, integrals.v_beta * by, ZERO, ZERO, (x0, ZERO)
    )


def _full(given: Given) -> Any:
    """Return the series, or for 0 < m < 1 the sizes of A and B, the imaginary parts of their poles, and K'/K."""
    top, points, at, rates = given.top, given.points, given.at, given.rates
    part = top.G[0] * points.d[0]
    if part == 0:
        return PLAIN.full_series(top, points, at, PLAIN.tails(at))
    ratio = 2 * rates.nutation[0] / (2 * rates.half_root[0]).agm(part.sqrt())
    _, _, theta3, theta4 = thetas(ZERO, ZERO, ratio)
    size_a = (points.t2[0] / 2).sqrt() * theta3.real / thetas(ZERO, at.y_alpha, ratio)[1].real
    size_b = (points.s1[0] / 2).sqrt() * theta4.real / thetas(ZERO, at.y_beta, ratio)[1].real
    return (size_a, at.y_alpha, ZERO, ZERO), NONE, (size_b, at.y_beta, ZERO, ZERO), NONE, ratio


def _full_sums(m: Motion, time: Any) -> Balls:
    if m.constant == 0:
        return PLAIN.full_sums(m, time)
    (size_a, y_a, *_), (size_b, y_b, *_), (sign_a, sign_b) = m.a_sum, m.b_sum, m.signs
    turns = PLAIN.phase(m.third, time)[0] + m.start[0]
    numbers = []
    for order in (0, 1):
        a = size_a * thetas(turns, -sign_a * y_a, m.constant, order=order)[0]
        b = size_b * thetas(turns, -sign_b * y_b, m.constant, order=order)[1]
        numbers += [a.real, a.imag, b.real, b.imag]
    return *numbers, PLAIN.phase(m.first, time)[0], PLAIN.phase(m.second, time)[0]


def _sums(m: Motion, time: Any) -> Balls:
    if m.full == 1:
        return FORMULAS.full_sums(m, time)
    side, turns_a, turns_b, e, factor, other, other_factor = FORMULAS.complementary_phase(m, time)
    return FORMULAS.complementary_sums(m, side, turns_a, turns_b, e.exp() * factor, other.exp() * other_factor)


MODULES = (
    formulas, formulas_reduction, formulas_roots, formulas_rates, formulas_integrals, formulas_setup, formulas_numbers,
)  # fmt: skip
PLAIN = for_balls(*MODULES)
FORMULAS = for_balls(
    *MODULES, arguments=_arguments, _integral=_integral, _sharp_integral=_sharp_integral, _full=_full,
    full_sums=_full_sums,
)


# ---------------------------------------------------------------------- turning points


def _turning_points(top: LagrangeTop, reduced: Reduction) -> TurningPoints:
    """Return the distances of the roots, which are rational where two of them coincide."""
    u, k, cubic = top.u, top.k, top.cubic
    total = top.across2 + top.a**2
    if top.steady or top.separatrix:
        # the roots, and G times the distance of the upper two, which stays where G is zero
        u1, u2, above = (u, u, total + k * (u - 2 * u)) if top.steady else (-cubic.coeffs()[0] / k, fmpq(1), fmpq(0))
        A = above + k * (u2 - u1)
        gaps = (u - u1, u2 - u, u2 - u1, 1 - u1, 1 - u2, 1 + u1, 1 + u2, A, above, A - k * (u - u1),
                above - k * (1 - u2), A + k * (1 + u1))  # fmt: skip
        return TurningPoints(*((arb(x), ZERO) for x in gaps))
    is_upper, lone = True, arb(total)
    if k != 0:
        least, middle, d, rest = _three_roots(cubic)
        is_upper = rest > d
        lone = arb(k) * (middle + rest - arb(u)) if is_upper else 1 - least
    return FORMULAS.turning_points_of(reduced, is_upper, (lone, ZERO), FORMULAS.apart(reduced).f1)


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

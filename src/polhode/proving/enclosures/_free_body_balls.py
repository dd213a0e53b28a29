"""Enclosures of a free body's motion from exact numbers: its regime, its constants, and its state at any time.

All by the formulas of ``polhode.exact.free_body``, but for their series: A(z) is θ4(z + i (½ ln q − ln g)) of nome q²,
and B(z) is g θ4(z − i (½ ln q + ln g)), where ln g = −πv/2K with sc(v | 1 − m)² = Q/P.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from flint import acb, arb, ctx, fmpq

from polhode.analysis._exact_arithmetic import Ball, Rational, Wanted, total
from polhode.exact.free_body import _formulas as formulas
from polhode.exact.free_body import _formulas_numbers as formulas_numbers
from polhode.exact.free_body import _formulas_rates as formulas_rates
from polhode.exact.free_body import _formulas_reduction as formulas_reduction
from polhode.exact.free_body import _formulas_setup as formulas_setup
from polhode.exact.free_body._formulas import Motion
from polhode.exact.free_body._formulas_reduction import Reduction
from polhode.exact.free_body._formulas_setup import Arguments, Given
from polhode.exact.free_body._geometry import REGIMES
from polhode.proving.enclosures import _ball_turns as ball_turns
from polhode.proving.enclosures._ball_formulas import ZERO, as_whole, carlson, exact_bits, for_balls, thetas
from polhode.proving.enclosures._motion_starts import ExactBody, MotionStart, Values, refine_named
from polhode.proving.enclosures.motion_enclosures import FreeEnclosure

Balls = tuple[Ball, ...]
STABLE, UNSTABLE = "stable", "unstable"


def enclose_free_motion(start: MotionStart, digits: int) -> FreeEnclosure:
    """Return the enclosures of a free body's motion."""
    body = FreeBody(start)
    kept, moving = (refine_named(compute, digits) for compute in (body.constants, body.moving_constants))
    names = ("period", "precession_per_period", "precession_rate", "solid_angle", "geometric_phase", "action")
    return FreeEnclosure(
        digits=digits, taken=start.taken, regime=body.regime, encircled_axis=body.encircled_axis,
        verdicts=body.verdicts, verdict=body.verdict, _body=body, energy=kept["energy"],
        momentum_norm=kept["momentum_norm"], momentum_square=kept["momentum_square"],
        **{name: moving.get(name) for name in names},
    )


class FreeBody(ExactBody):
    """A free body in exact rational numbers, and balls computed from them at the present precision.

    Formulas take moments and momentum times whole numbers that make them whole.
    """

    def __init__(self, start: MotionStart) -> None:
        self.start = start
        self.moments, self.momentum = start.moments, start.momentum
        self.square = total(x * x for x in self.momentum)
        self.velocity = [x / i for x, i in zip(self.momentum, self.moments, strict=True)]
        self.twice_energy = total(x * w for x, w in zip(self.momentum, self.velocity, strict=True))
        self._whole_moments, self._of_moments = as_whole(self.moments)
        self._whole_momentum, self._of_momentum = as_whole(self.momentum)
        self._reductions: dict[int, Reduction] = {}
        self._motions: dict[int, Motion] = {}
        body = self._reduced()
        kind, *_ = FORMULAS.start_of(body)
        self.regime, self.steady = REGIMES[int(float(FORMULAS._regime(body, kind)))], kind.constant
        self.encircled_axis = None if kind.constant or kind.separatrix else int(float(body.order[2]))

    def _reduced(self) -> Reduction:
        bits = max(ctx.prec, exact_bits(self._whole_moments + self._whole_momentum))
        if bits not in self._reductions:
            with ctx.workprec(bits):
                body = FORMULAS.reduction(_balls(self._whole_moments), _balls(self._whole_momentum))
            self._reductions = {bits: body}
        return self._reductions[bits]

    @property
    def _motion(self) -> Motion:
        if ctx.prec not in self._motions:
            body, norm = self._reduced(), arb(ball_turns.square_of(self.start.attitude)).sqrt()
            rates, attitude = FORMULAS.frequencies(body), _balls(arb(x) / norm for x in self.start.attitude)
            given = Given(_balls(self._whole_moments), _balls(self._whole_momentum), attitude, body, rates)
            motion = FORMULAS.motion_of(given)
            if not self.steady:
                precession, swing = FORMULAS.phase_rates(False, body, rates)
                motion = motion._replace(first=precession, second=swing)
            self._motions = {ctx.prec: motion}
        return self._motions[ctx.prec]

    @property
    def verdicts(self) -> dict[str, str]:
        """Verdicts on spins about the principal axes: stable if the moment is strictly extremal, or all are equal."""
        return {f"axis {k + 1}": self._verdict_about(k) for k in range(3)}

    def _verdict_about(self, k: int) -> str:
        own, *others = (self.moments[(k + j) % 3] for j in range(3))
        extremal = all(x > own for x in others) or all(x < own for x in others)
        same = all(x == own for x in others)
        return STABLE if extremal or same or self.square == 0 else UNSTABLE

    @property
    def verdict(self) -> str | None:
        """The verdict on this motion, if L is at rest in the body."""
        if not self.steady:
            return None
        along = [k for k in range(3) if self.momentum[k] != 0]
        return self._verdict_about(along[0]) if along else STABLE

    # ------------------------------------------------------------------ balls, at the present precision

    def constants(self) -> dict[str, Wanted]:
        """Return energy, |L| and |L|²."""
        return {"energy": Wanted(arb(self.twice_energy / 2)), "momentum_norm": Wanted(arb(self.square).sqrt()),
                "momentum_square": Wanted(arb(self.square))}  # fmt: skip

    def moving_constants(self) -> dict[str, Wanted]:
        """Return period, precession, cap and action, as far as they are defined."""
        if self.steady:
            return {}
        body, faster = self._reduced(), arb(fmpq(self._of_moments, self._of_momentum))
        numbers = FORMULAS.numbers(body, FORMULAS.frequencies(body))
        found = {"period": numbers.period / faster, "precession_per_period": numbers.precession_per_period,
                 "precession_rate": numbers.precession_rate * faster}  # fmt: skip
        if self.encircled_axis is not None:
            angle = numbers.solid_angle
            sense = 1 if self.moments[self.encircled_axis] == min(self.moments) else -1
            found |= {"solid_angle": angle, "geometric_phase": sense * angle,
                      "action": arb(self.square).sqrt() * angle / (2 * arb.pi())}  # fmt: skip
        return {name: Wanted(ball) for name, ball in found.items()}

    def lost_bits(self, elapsed: Rational) -> float:
        fastest = max(abs(w) for w in self.velocity) + sum_of_inverses(self.moments) * _bound_norm(self.square)
        return whole_turns(abs(elapsed) * fastest)

    def values_at(self, elapsed: Rational) -> Values:
        motion = self._motion
        time = arb(elapsed * self._of_moments / self._of_momentum), ZERO, ZERO
        spinor, alone = (_full_spinors if motion.full == 1 else _complementary_spinors)(motion, time)
        attitude, momentum = FORMULAS.state_of(motion, spinor)[:4], [arb(x) for x in self.momentum]
        if not self.steady:
            momentum = [x / self._of_momentum for x in FORMULAS.state_of(motion, alone)[4:]]
        return Values(list(attitude), momentum, arb(self.square).sqrt())


def _balls(numbers: Iterable[Any]) -> Any:
    return tuple(map(arb, numbers))


def _full_arguments(given: Given) -> Arguments:
    """Return the start, and for the series K'/K, zero for m = 0, g, and the imaginary parts at which θ4 is taken."""
    b, c, p, q, g2 = (pair[0] for pair in (given.body.B, given.body.C, given.body.P, given.body.Q, given.body.G2))
    x, y, z = given.body.canonical
    by = given.rates.mean[0] / given.rates.modulus_rate[0]  # π/2K
    start = by * y * b.sqrt() * carlson(c * x * x, c * z * z * p / q, p)
    far = by * q.sqrt() * carlson(c * g2, c * p / b, p)
    ratio = ZERO
    if given.body.A[0] != 0:
        ratio = given.rates.mean[0] / given.rates.modulus_rate[0].agm((given.body.A[0] * p).sqrt())
    half, start = arb.pi() * ratio / 2, arb.pi() - start if x < 0 else start
    series = ratio, (-far).exp(), far - half, far + half, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO
    return Arguments((start / (4 * arb.pi()), ZERO), series, (ZERO, ZERO, ZERO, ZERO, ZERO), ZERO)


def _full_spinors(m: Motion, time: Any) -> tuple[Balls, Balls]:
    """Return A and B by theta functions of z, and both without the phase of A, which only widens the momentum."""
    ratio, g, beyond_a, beyond_b, *_ = m.series
    (turns, _, _), (swing, _, count) = FORMULAS.phase(m.first, time), FORMULAS.phase(m.second, time)
    half = swing / 4 + m.start[0]  # z/4π, but for half turns of z, which the thetas repeat and the phases do not
    a, b = (acb(1) if ratio == 0 else thetas(2 * half, beyond, 2 * ratio)[3] for beyond in (beyond_a, beyond_b))
    half += (count - 4 * FORMULAS.whole(count / 4)) / 4
    return _parts(a * _turn(turns - half), g * b * _turn(turns + half)), _parts(a, g * b * _turn(2 * half))


def _complementary_spinors(m: Motion, time: Any) -> tuple[Balls, Balls]:
    turns, side, count, e, factor, other, other_factor = FORMULAS.complementary_phase(m, time)
    rest = side, count, e.exp() * factor, other.exp() * other_factor
    return FORMULAS.complementary_sums(m, turns, *rest), FORMULAS.complementary_sums(m, ZERO, *rest)


def _turn(turns: Ball) -> Ball:
    return acb(2 * turns).exp_pi_i()


def _parts(a: Ball, b: Ball) -> Balls:
    return a.real, a.imag, b.real, b.imag


# the thresholds are those beyond which doubles need other formulas
FORMULAS = for_balls(
    formulas, formulas_reduction, formulas_rates, formulas_setup, formulas_numbers, is_full=lambda body: True,
    _full_arguments=_full_arguments, full_sums=lambda m, time: _full_spinors(m, time)[0],
    NEAR=ZERO, SMALL_CAP=ZERO, HUGE_INVERSE=ZERO, TINY_RATIO=ZERO,
)


def whole_turns(angle: Rational) -> float:
    """Return about how many bits the whole turns of an angle have."""
    return max(float(int(angle.p).bit_length() - int(angle.q).bit_length()), 0.0)


def sum_of_inverses(moments: list[Rational]) -> Rational:
    """Return Σ 1/I."""
    return total(1 / i for i in moments)


def _bound_norm(square: Rational) -> Rational:
    """Return a rational that is no less than a root, and at most twice it."""
    bits = (int(square.p).bit_length() - int(square.q).bit_length()) // 2 + 1
    return fmpq(2) ** bits if bits >= 0 else fmpq(1, 2**-bits)


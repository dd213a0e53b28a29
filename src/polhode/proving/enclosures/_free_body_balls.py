"""Enclosures of a free body's motion from exact numbers: its regime, its constants, and its state at any time."""

from __future__ import annotations

from functools import cmp_to_key
from typing import Any, NamedTuple

from flint import acb, arb, ctx, fmpq

from polhode.analysis._exact_arithmetic import Ball, Rational, Wanted, total
from polhode.proving.enclosures import _ball_turns as ball_turns
from polhode.proving.enclosures._elliptic_balls import Oscillation, Periodic, Place, Separatrix
from polhode.proving.enclosures._motion_starts import ExactBody, MotionStart, Values, refine_named
from polhode.proving.enclosures.motion_enclosures import FreeEnclosure

STABLE, UNSTABLE = "stable", "unstable"
INFINITE = arb("inf")


class Polhode(NamedTuple):
    """A polhode in exact numbers: L_around = ±a dn u, L_middle = ±b sn u, L_other = o cn u, u = ν t + u0.

    Attributes:
        around: the encircled axis; on the separatrix, that of largest moment.
        middle, other: the axes of sn and cn.
        a2, b2, o2: squares of the amplitudes.
        nu2: ν².
        parameter: m.
        n: of the integral of the third kind, by which the encircled axis turns about L; not positive.
        excess: 2E − L²/I_around, over the least square of L across the encircled axis.
    """

    around: int
    middle: int
    other: int
    a2: Rational
    b2: Rational
    o2: Rational
    nu2: Rational
    parameter: Rational
    n: Rational
    excess: Rational


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
    """A free body in exact rational numbers, and balls computed from them at the present precision."""

    def __init__(self, start: MotionStart) -> None:
        self.start = start
        self.moments, self.momentum = start.moments, start.momentum
        self.velocity = [x / i for x, i in zip(self.momentum, self.moments, strict=True)]
        self.square = total(x * x for x in self.momentum)
        self.twice_energy = total(x * w for x, w in zip(self.momentum, self.velocity, strict=True))
        self._set_regime()
        self._made: dict[int, Any] = {}

    def _set_regime(self) -> None:
        """Decide the regime by comparisons of rationals."""
        inertia, L = self.moments, self.momentum
        low, middle, high = sorted(range(3), key=cmp_to_key(lambda j, k: -1 if inertia[j] < inertia[k] else 1))
        self.order = low, middle, high
        self.encircled_axis, around = None, None
        crossed = any(L[k - 2] * self.velocity[k - 1] != L[k - 1] * self.velocity[k - 2] for k in range(3))
        side = self.square - self.twice_energy * inertia[middle]
        if self.square == 0:
            self.regime = "rest"
        elif inertia[low] == inertia[high]:
            self.regime = "spherical"
        elif not crossed:
            self.regime = "permanent"
        elif inertia[low] == inertia[middle] or inertia[middle] == inertia[high]:
            self.regime, around = "symmetric", high if inertia[low] == inertia[middle] else low
        elif side == 0:
            self.regime, around = "separatrix", high
        else:
            self.regime, around = ("short-axis", high) if side > 0 else ("long-axis", low)
        if around is not None and self.regime != "separatrix":
            self.encircled_axis = around
        self.steady = around is None
        if around is not None:
            self.polhode = self._polhode(around)

    def _polhode(self, around: int) -> Polhode:
        inertia, C, E = self.moments, self.square, self.twice_energy
        low, middle, high = self.order
        if self.regime == "symmetric":
            middle, other = (k for k in range(3) if k != around)
        else:
            other = low if around == high else high
        Ik, Ii, Ij = (inertia[k] for k in (around, middle, other))
        cap, side = E * Ik - C, C - E * Ij
        a2, b2, o2 = Ik * side / (Ik - Ij), Ii * cap / (Ik - Ii), Ij * cap / (Ik - Ij)
        nu2 = (Ik - Ii) * side / (Ik * Ii * Ij)
        parameter = (Ii - Ij) * cap / ((Ik - Ii) * side)
        return Polhode(around, middle, other, a2, b2, o2, nu2, parameter, -a2 * parameter / o2, (E - C / Ik) / o2)

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

    @property
    def _swing(self) -> Swing:
        if ctx.prec not in self._made:
            self._made = {ctx.prec: Swing(self)}
        return self._made[ctx.prec]

    def moving_constants(self) -> dict[str, Wanted]:
        """Return period, precession, cap and action, as far as they are defined."""
        if self.steady:
            return {}
        if self.regime == "separatrix":
            rate = arb(self.square).sqrt() / arb(self.moments[self.order[1]])
            return {"period": Wanted(INFINITE), "precession_per_period": Wanted(INFINITE),
                    "precession_rate": Wanted(rate)}  # fmt: skip
        return {name: Wanted(ball) for name, ball in self._swing.constants().items()}

    def lost_bits(self, elapsed: Rational) -> float:
        fastest = max(abs(w) for w in self.velocity) + sum_of_inverses(self.moments) * _bound_norm(self.square)
        return whole_turns(abs(elapsed) * fastest)

    def values_at(self, elapsed: Rational) -> Values:
        turn, momentum = self._steady_state(elapsed) if self.steady else self._swing.state(elapsed)
        given = self.start.attitude
        norm = arb(ball_turns.square_of(given)).sqrt()
        attitude = ball_turns.multiply([arb(x) / norm for x in given], turn)
        return Values(attitude, momentum, arb(self.square).sqrt())

    def _steady_state(self, elapsed: Rational) -> tuple[list[Ball], list[Ball]]:
        return self._steady_turn(elapsed), [arb(x) for x in self.momentum]

    def _steady_turn(self, elapsed: Rational) -> list[Ball]:
        speed = arb(total(w * w for w in self.velocity)).sqrt()
        if self.square == 0:
            return [arb(1), arb(0), arb(0), arb(0)]
        sine, cosine = (speed * arb(elapsed) / 2).sin_cos()
        return [cosine, *(sine * arb(w) / speed for w in self.velocity)]


class Swing:
    """The swing of L along its polhode, in balls of one precision."""

    def __init__(self, body: FreeBody) -> None:
        self.body, self.polhode = body, body.polhode
        one = self.polhode
        inertia, L = body.moments, body.momentum
        self.norm = arb(body.square).sqrt()
        self.a, self.b, self.o = (arb(x).sqrt() for x in (one.a2, one.b2, one.o2))
        self.nu, self.n, self.n1 = arb(one.nu2).sqrt(), arb(one.n), arb(1 - one.n)
        self.facing = 1 if L[one.around] > 0 else -1
        j = one.other
        sense = 1 / inertia[(j + 2) % 3] - 1 / inertia[(j + 1) % 3]
        self.sense = self.facing * (-1 if sense > 0 else 1)
        sn, cn = self.sense * arb(L[one.middle]) / self.b, arb(L[j]) / self.o
        self.oscillation: Oscillation = (
            Separatrix(sn, cn) if one.parameter == 1 else Periodic(arb(one.parameter), arb(1 - one.parameter), sn, cn)
        )
        self.first = self._half_angles(self.oscillation.start)
        self.rate = self.norm / arb(inertia[one.around])
        self.share = self.norm * arb(one.excess) / self.nu

    def constants(self) -> dict[str, Ball]:
        """Return period, precession, cap and action."""
        body, oscillation = self.body, self.oscillation
        assert isinstance(oscillation, Periodic)
        period = 4 * oscillation.quarter / self.nu
        turn = self.rate * period + 4 * self.share * oscillation.complete(self.n, self.n1)
        dynamic = arb(body.twice_energy) * period / self.norm
        least = body.order[0] == self.polhode.around
        angle = 2 * arb.pi() + (turn - dynamic if least else dynamic - turn)
        return {"period": period, "precession_per_period": turn, "precession_rate": turn / period,
                "solid_angle": angle, "geometric_phase": angle if least else -angle,
                "action": self.norm * angle / (2 * arb.pi())}  # fmt: skip

    def state(self, elapsed: Rational) -> tuple[list[Ball], list[Ball]]:
        """Return the turn since the epoch as a quaternion, and the momentum."""
        one, t = self.polhode, arb(elapsed)
        place = self.oscillation.after(self.nu * t)
        azimuth = self.rate * t + self.share * self.oscillation.swept(place, self.n, self.n1)
        momentum = [arb(0)] * 3
        momentum[one.around] = self.facing * self.a * place.dn
        momentum[one.middle] = self.sense * self.b * place.sn
        momentum[one.other] = self.o * place.cn
        sine, cosine = (azimuth / 2).sin_cos()
        later = ball_turns.multiply([cosine, arb(0), arb(0), sine], self._half_angles(place))
        w, *cyclic = ball_turns.multiply(ball_turns.conjugate(self.first), later)
        turn = [w, arb(0), arb(0), arb(0)]
        for k, value in enumerate(cyclic):
            turn[1 + (one.around + 1 + k) % 3] = value
        return turn, momentum

    def _half_angles(self, place: Place) -> list[Ball]:
        """Return the turn, as a quaternion, by which L comes to lie along the third axis, the encircled axis third.

        The turn is by ψ about that axis, which L goes round, and by the angle θ between both.
        """
        one, sign = self.polhode, place.sign
        sn, cn = sign * place.sn, sign * place.cn
        angle = self.sense * (arb.atan2(self.b * sn, self.o * cn) + arb.pi() * place.half_periods)
        if one.other == (one.around + 1) % 3:
            angle = arb.pi() / 2 - angle
        along = self.a * place.dn / self.norm
        across = (self.o**2 * (1 - self.n * sn * sn)).sqrt() / self.norm
        large = ((1 + along) / 2).sqrt()
        small = across / (2 * large)
        cosine, sine = (large, small) if self.facing > 0 else (small, large)
        up, down = acb(0, angle / 2).exp(), acb(0, -angle / 2).exp()
        return [cosine * up.real, sine * down.real, sine * down.imag, cosine * up.imag]


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


"""Proved enclosures of motions in closed form: what they offer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from polhode.analysis._exact_arithmetic import Ball, ExactNumber, Rational, Wanted, exact_rational, refine, total
from polhode.proving.enclosures import _ball_turns as ball_turns
from polhode.proving.enclosures._motion_starts import ExactBody
from polhode.proving.enclosures.enclosed_numbers import EnclosedNumber, EnclosedState


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class MotionEnclosure:
    """Proved enclosures of the constants of a motion in closed form, and of its state at any time.

    Attributes:
        regime: decided in exact rational arithmetic.
        digits: of each enclosure.
        taken: name of an argument of the motion → "the nearest doubles" or "the exact numbers given".
        verdicts: "stable" or "unstable" by comparison of exact numbers, by the name of the axis.
        verdict: that of this motion, if the momentum is at rest in the body; None for others.
    """

    regime: str
    digits: int
    taken: Mapping[str, str]
    verdicts: Mapping[str, str]
    verdict: str | None
    _body: ExactBody = field()

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.regime}, {self.digits} digits>"

    def state(self, t: ExactNumber) -> EnclosedState:
        """Return enclosures of attitude, momentum and angular velocity at a time.

        They are along the axes of the motion, as its own ``state`` has them. A motion made from a body is rotated
        from its principal axes by the unit quaternion nearest to their matrix.

        Args:
            t: [s] a double, or exact decimals in quotes: "0.1" is a tenth, which no double is.

        Raises:
            InvalidInput: for a time that is not a finite number.
        """
        body, start = self._body, self._body.start
        elapsed = exact_rational("t", t) - start.epoch

        def compute() -> list[Wanted]:
            values = body.values_at(elapsed)
            velocity = [x / i for x, i in zip(values.momentum, start.moments, strict=True)]
            fastest = total(x * x for x in velocity).nonnegative_part().sqrt()
            attitude, vectors = values.attitude, [values.momentum, velocity]
            if start.axes is not None:
                attitude = _turned_back(attitude, start.axes)
                vectors = [ball_turns.turn_vector(start.axes, vector) for vector in vectors]
            entries = [x for row in ball_turns.as_matrix(attitude) for x in row]
            unit = 1 + 0 * values.size
            return [Wanted(ball, size) for balls, size in ((attitude, unit), (vectors[0], values.size),
                    (vectors[1], fastest), (entries, unit)) for ball in balls]

        extra = body.lost_bits(elapsed)
        numbers = tuple(EnclosedNumber(ball, self.digits) for ball in refine(compute, self.digits, extra))
        rows = tuple(numbers[k : k + 3] for k in (10, 13, 16))
        return EnclosedState(numbers[:4], numbers[4:7], numbers[7:10], rows)


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class FreeEnclosure(MotionEnclosure):
    """Proved enclosures of the constants of a free body's motion, and of its state at any time.

    Numbers are None where they are undefined, and infinite on the separatrix, as those of ``FreeMotion`` are.

    Attributes:
        regime: as ``FreeMotion.regime`` has it, decided in exact rational arithmetic.
        encircled_axis: index of the principal axis that the polhode encircles; None where there is none.
        period: polhode period T [s].
        precession_per_period: azimuth about L that the encircled axis gains in a period [rad].
        precession_rate: the mean rate of that [rad/s].
        solid_angle: Ω of the cap that the polhode cuts off [sr].
        geometric_phase: −Ω (short-axis mode) or Ω (long-axis mode) [rad].
        action: |L| Ω/2π [J s].
        energy: kinetic energy [J].
        momentum_norm: |L| [kg m²/s].
        momentum_square: |L|² [kg² m⁴/s²].
        verdicts: "stable" or "unstable" of a spin about each principal axis at this |L|, "axis 1" to "axis 3" in the
            order of the moments.
    """

    encircled_axis: int | None
    period: EnclosedNumber | None
    precession_per_period: EnclosedNumber | None
    precession_rate: EnclosedNumber | None
    solid_angle: EnclosedNumber | None
    geometric_phase: EnclosedNumber | None
    action: EnclosedNumber | None
    energy: EnclosedNumber
    momentum_norm: EnclosedNumber
    momentum_square: EnclosedNumber


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class TopEnclosure(MotionEnclosure):
    """Proved enclosures of the constants of a Lagrange top's motion, and of its state at any time.

    Numbers are None where they are undefined, and infinite on the separatrix, as those of ``LagrangeMotion`` are.

    Attributes:
        regime: as ``LagrangeMotion.regime`` has it. A tilt that stays, the sleeping top and the separatrix are double
            roots of the cubic, decided by its greatest common divisor with its derivative.
        nutation_limits: (min, max) of cos θ.
        nutation_period: T [s]; of a steady top, that of its smallest nutations.
        precession_per_period: azimuth that the axis gains in a period [rad].
        spin_per_period: turn of the body about its axis in a period [rad].
        precession_rate, spin_rate: the mean rates of both [rad/s].
        action: of the nutation, (1/2π) ∮ I1 θ' dθ [J s].
        energy: ½ L·I⁻¹L + mgl cos θ [J].
        vertical_momentum, axial_momentum: (R L)_z and L3 [kg m²/s].
        verdicts: "stable" or "unstable" of the axis "upright", with the centre of mass above the pivot, and "hanging",
            at this L3; none of a top without weight.
    """

    nutation_limits: tuple[EnclosedNumber, EnclosedNumber]
    nutation_period: EnclosedNumber | None
    precession_per_period: EnclosedNumber | None
    spin_per_period: EnclosedNumber | None
    precession_rate: EnclosedNumber | None
    spin_rate: EnclosedNumber | None
    action: EnclosedNumber | None
    energy: EnclosedNumber
    vertical_momentum: EnclosedNumber
    axial_momentum: EnclosedNumber


def _turned_back(attitude: Sequence[Ball], axes: Sequence[Rational]) -> list[Ball]:
    from flint import arb

    norm = arb(ball_turns.square_of(axes)).sqrt()
    return ball_turns.multiply(attitude, [arb(x) / norm for x in ball_turns.conjugate(axes)])

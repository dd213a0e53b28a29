"""Numbers proved to lie within bounds, and states of such numbers."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from polhode.analysis._exact_arithmetic import Ball, ExactNumber, exact_rational
from polhode.analysis._printing import print_answer
from polhode.types import Float64

_ARB = re.compile(r"\[?(?P<middle>[^\[\]+ ]*) ?\+/- (?P<radius>[^\]]*)\]")


@dataclass(frozen=True)
class EnclosedNumber:
    """A real number that is certain to lie in a ball: between ``lower`` and ``upper``.

    ``float`` gives the nearest double of the midpoint, ``in`` tests whether an exact number lies within, and ``str``
    writes the certain digits and the radius.

    Attributes:
        ball: the ball of python-flint, an ``arb``.
        digits: how many decimals ``str`` writes at most.

    >>> import polhode as ph
    >>> period = ph.certify(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))).period
    >>> print(period), float(period)
    10.68012008138356194852456 ± 9e-25
    (None, 10.680120081383562)
    """

    ball: Ball = field(repr=False)
    digits: int = 25

    @property
    def value(self) -> float:
        """The nearest double of the midpoint; inf for an infinite answer, such as the period on the separatrix."""
        return float(self.ball)

    @property
    def radius(self) -> float:
        """How far the number may be from the midpoint at most, rounded up."""
        radius = self.ball.rad()
        rounded = float(radius.upper())
        return rounded if rounded or radius == 0 else math.ulp(0.0)

    @property
    def lower(self) -> Fraction:
        """The lower end of the ball, exact.

        Raises:
            OverflowError: for an infinite answer.
        """
        middle, radius = self._exact
        return middle - radius

    @property
    def upper(self) -> Fraction:
        """The upper end of the ball, exact; raises as ``lower`` does."""
        middle, radius = self._exact
        return middle + radius

    @property
    def _exact(self) -> tuple[Fraction, Fraction]:
        """Midpoint and radius; python-flint's own ends are rounded to its present precision."""
        if not self.ball.is_finite():
            raise OverflowError("an infinite answer has no ends")
        return _fraction(self.ball.mid()), _fraction(self.ball.rad())

    def __contains__(self, number: ExactNumber) -> bool:
        exact = exact_rational("number", number)
        return self.ball.is_finite() and self.lower <= Fraction(int(exact.p), int(exact.q)) <= self.upper

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        middle, radius = self.parts
        return f"{middle} ± {radius}" if radius else middle

    def __repr__(self) -> str:
        return f"<{self}>"

    @property
    def parts(self) -> tuple[str, str]:
        """Midpoint and radius in decimals, between whose sum and difference the number lies; no radius if exact."""
        if not self.ball.is_finite():
            return str(self.value), ""
        text = self.ball.str(self.digits)
        if (match := _ARB.fullmatch(text)) is None:
            return text, ""
        radius = _rounded_up(match["radius"])
        return match["middle"] or "0", radius


def _fraction(ball: Ball) -> Fraction:
    exact = ball.fmpq()
    return Fraction(int(exact.p), int(exact.q))


def _rounded_up(radius: str) -> str:
    """Return a radius like "3.21e-27" with one digit, "4e-27"."""
    mantissa, _, exponent = f"{Decimal(radius):e}".lower().partition("e")
    digit, power = math.ceil(Decimal(mantissa)), int(exponent or 0)
    return f"1e{power + 1}" if digit == 10 else f"{digit}e{power}"


class EnclosedState(NamedTuple):
    """Enclosures of a body's state at one time.

    Attributes:
        attitude: (4,) unit quaternion wxyz, body → space, continuous from the epoch on, its sign included.
        momentum: (3,) [kg m²/s, body axes].
        angular_velocity: (3,) [rad/s, body axes].
        rotation_matrix: (3, 3) by rows, body → space.
    """

    attitude: tuple[EnclosedNumber, ...]
    momentum: tuple[EnclosedNumber, ...]
    angular_velocity: tuple[EnclosedNumber, ...]
    rotation_matrix: tuple[tuple[EnclosedNumber, ...], ...]

    @property
    def values(self) -> Float64[np.ndarray, "7"]:
        """(7,) the nearest doubles of attitude and momentum."""
        return np.array([float(x) for x in (*self.attitude, *self.momentum)])

    @property
    def radii(self) -> Float64[np.ndarray, "7"]:
        """(7,) the radii of attitude and momentum."""
        return np.array([x.radius for x in (*self.attitude, *self.momentum)])

    def __str__(self) -> str:
        vectors = {"attitude": self.attitude, "momentum": self.momentum, "angular_velocity": self.angular_velocity}
        return print_answer(
            "proved enclosures of a state, each number with its radius",
            **{name: ", ".join(map(str, numbers)) for name, numbers in vectors.items()},
        )

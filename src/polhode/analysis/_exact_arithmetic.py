"""Exact numbers that come in, and balls of python-flint that are refined until they are small enough."""

from __future__ import annotations

import copyreg
import math
from collections.abc import Callable, Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.extras import needing
from polhode._base.rational.numbers import as_fmpq, read_number
from polhode.errors import InvalidInput, NotConverged, shown

Ball = Any
"""A real or complex ball of python-flint."""
Rational = Any
"""A rational of python-flint."""
if TYPE_CHECKING:
    ExactNumber = int | float | str | Fraction | Decimal
    """A number without error: a double is the rational that it is, a text its decimals or its quotient, like "1/3"."""
else:
    ExactNumber = Any  # as functions check a user's numbers themselves


class PrecisionLimits(NamedTuple):
    """Bounds of the precision that may be asked for."""

    max_digits: int = 10_000  # decimal, of an answer
    max_bits: int = 1 << 16  # of the arithmetic


LIMITS = PrecisionLimits()


def import_flint() -> Any:
    """Return the module of python-flint.

    Raises:
        InvalidInput: if it is not installed.
    """
    with needing("Proofs need"):
        import flint
    copyreg.pickle(flint.arb, _reduce_ball)  # so that proofs can be pickled and copied
    copyreg.pickle(flint.acb, lambda ball: (flint.acb, (ball.real, ball.imag)))
    copyreg.pickle(flint.fmpq_poly, lambda polynomial: (flint.fmpq_poly, (polynomial.coeffs(),)))
    return flint


def _reduce_ball(ball: Ball) -> tuple[Any, tuple[Any, ...]]:
    """Return how to make a ball again, exactly."""
    import flint

    if not ball.is_finite():
        return flint.arb, (str(ball),)
    middle, radius = (tuple(map(int, x.man_exp())) for x in (ball.mid(), ball.rad()))
    return flint.arb, (middle, radius)


def exact_rational(name: str, number: ExactNumber) -> Rational:
    """Return a number as the rational that it is exactly.

    Raises:
        InvalidInput: for anything that is not a finite number within 1e±5000.
    """
    return as_fmpq(read_number(number, name=name))


def exact_rationals(name: str, values: Any, count: int) -> list[Rational]:
    """Return some numbers as rationals; of one number, the list has one entry.

    Raises:
        InvalidInput: for another count, or as ``exact_rational`` does.
    """
    given = [values] if np.ndim(np.asarray(values, dtype=object)) == 0 else list(values)
    if len(given) != count:
        raise InvalidInput(f"`{name}` must be {count} numbers; got {shown(values)}.")
    return [exact_rational(name, value) for value in given]


def check_digits(digits: int) -> int:
    """Return how many digits are asked for.

    Raises:
        InvalidInput: unless it is a whole number from 1 to 10000.
    """
    return check.whole("digits", digits, 1, LIMITS.max_digits)


class Wanted(NamedTuple):
    """A ball that is asked for.

    Attributes:
        ball: as computed with some precision.
        size: relative to which its radius counts, a ball; None for its own size.
    """

    ball: Ball
    size: Ball | None = None


def refine(compute: Callable[[], Sequence[Wanted]], digits: int, extra_bits: float = 0.0) -> list[Ball]:
    """Return balls computed with so many bits that each has the digits asked for.

    Args:
        compute: gives the balls with the precision that python-flint has at the time.
        digits: decimals.
        extra_bits: that are known to be lost on the way, as to whole turns at late times.

    Raises:
        NotConverged: if 65536 bits do not suffice.
    """
    spare_bits = 64
    from flint import arb, ctx

    bits = math.ceil(digits * math.log2(10.0) + max(extra_bits, 0.0)) + spare_bits
    while bits <= LIMITS.max_bits:
        with ctx.workprec(bits):
            results = compute()
            share = arb(10) ** -digits
            if all(_is_sharp(one, share) for one in results):
                return [one.ball for one in results]
        bits *= 2
    raise NotConverged(
        f"{LIMITS.max_bits} bits do not give {digits} digits: the numbers are too close to a case of their own. Give "
        "numbers that are exact, as decimals in `exact`, or fewer digits."
    )


def _is_sharp(one: Wanted, share: Ball) -> bool:
    radius = one.ball.rad()
    if radius == 0:
        return not one.ball.is_nan()
    if not one.ball.is_finite():
        return False
    size = abs(one.ball).lower() if one.size is None else one.size.upper()
    return bool(radius <= share * size)


def total(values: Iterable[Any]) -> Any:
    """Return the sum of rationals or balls."""
    first, *others = values
    for value in others:
        first = first + value
    return first

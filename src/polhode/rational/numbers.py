"""Exact rational numbers for doubles: which one a user meant by 0.1, 0.3333333333333333 or the double next to them.

A double stands for the simplest fraction within 4 units of its last place where that has a denominator up to a million:
0.3333333333333333 is 1/3, and 0.30000000000000004 is 3/10. Else it is its shortest decimal, where this has at most 15
digits. Numbers that are neither, such as π, are compared with those before them: equal moments stay equal, and a moment
that is half of another stays half of it, on which the integrals of tops depend.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from numbers import Rational
from typing import Any

from polhode.errors import InvalidInput, shown

LAST_PLACES = 4.0 * 2.0**-52  # relative: what a few operations in doubles leave
LARGEST_DENOMINATOR = 1_000_000
LARGEST_WHOLE = 2**53  # of doubles that hold every whole number below it
TYPED_DIGITS = 12  # of a decimal that somebody typed
MOST_DIGITS = 15  # of a decimal: every one of so many comes back from its double


def exact_number(value: Any) -> Fraction:
    """Return the fraction that one number stands for; fractions, integers and strings such as "1/3" as they are.

    Args:
        value: int, Fraction, rational of SymPy, float, or string.

    Raises:
        InvalidInput: for what is not one finite real number.

    >>> exact_number(1 / 3), exact_number(0.1 + 0.2), exact_number(0.54167)
    (Fraction(1, 3), Fraction(3, 10), Fraction(54167, 100000))
    """
    return exact_numbers([value])[0]


def exact_numbers(values: Sequence[Any]) -> list[Fraction]:
    """Return the fractions that several numbers stand for, with their ratios kept where these are simple.

    Raises:
        InvalidInput: for what is not a finite real number.

    >>> a, b = exact_numbers([math.pi, 2 * math.pi])
    >>> b / a
    Fraction(2, 1)
    """
    found: list[Fraction] = []
    unusual: list[tuple[float, Fraction]] = []
    for value in values:
        if isinstance(value, str):
            found.append(_parse(value))
            continue
        if isinstance(value, Rational):  # SymPy registers its rational numbers as such
            found.append(Fraction(int(value.numerator), int(value.denominator)))
            continue
        number = _as_float(value)
        plain = _plain(number)
        if plain is None:
            ratios = ((_near_fraction(number / other), exact) for other, exact in unusual)
            plain = next((ratio * exact for ratio, exact in ratios if ratio is not None), None)
            if plain is None:
                plain = _simplest(number)
                unusual.append((number, plain))
        found.append(plain)
    return found


def _parse(text: str) -> Fraction:
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        raise InvalidInput(
            f"a number must be whole, a fraction or a decimal, such as '2', '1/3' or '0.25'; got {shown(text)}."
        ) from None


def _as_float(value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise InvalidInput(f"exact arithmetic takes finite real numbers; got {shown(value)}.")
    return number


def _plain(number: float) -> Fraction | None:
    """Return the fraction of a number that is a simple fraction or a short decimal."""
    near = _near_fraction(number)
    if near is not None:
        return near
    digits = repr(number).lower().split("e")[0].lstrip("-").replace(".", "").strip("0")
    return Fraction(repr(number)) if len(digits) <= MOST_DIGITS else None


def _near_fraction(number: float) -> Fraction | None:
    """Return a fraction with a small denominator within some units of the last place; of a small number 1/n too."""
    if number == 0.0 or not math.isfinite(number):
        return Fraction(0) if number == 0.0 else None
    exact = Fraction(number)
    # below one the reciprocal, so that 1/3e9 is as simple as 3e9
    small = abs(exact) < 1
    near = (1 / exact if small else exact).limit_denominator(LARGEST_DENOMINATOR)
    near = 1 / near if small else near
    simple = min(near.denominator, abs(near.numerator)) <= LARGEST_DENOMINATOR
    whole = max(near.denominator, abs(near.numerator)) <= LARGEST_WHOLE
    return near if simple and whole and abs(near - exact) <= abs(exact) * Fraction(LAST_PLACES) else None


def _simplest(number: float) -> Fraction:
    """Return a fraction of small denominator within some units of the last place."""
    exact = Fraction(number)
    room = abs(exact) * Fraction(LAST_PLACES)
    low, high = exact - room, exact + room
    limit = 1
    while not low <= (near := exact.limit_denominator(limit)) <= high:
        limit *= 2
    return near


def read_short(value: float) -> Fraction:
    """Return a double as the number that was meant: a decimal of up to twelve digits, else the simplest fraction.

    Of all fractions that are rounded to this double the simplest has the least denominator.

    >>> read_short(0.1), read_short(1 / 3), read_short(2 / 7)
    (Fraction(1, 10), Fraction(1, 3), Fraction(2, 7))
    """
    value = float(value)
    decimal = Fraction(repr(value))
    if len(Decimal(repr(value)).normalize().as_tuple().digits) <= TYPED_DIGITS:
        return decimal
    exact, above = Fraction(value), Fraction(math.nextafter(value, math.inf))
    below = Fraction(math.nextafter(value, -math.inf))
    return _simplest_between((exact + below) / 2, (exact + above) / 2)


def _simplest_between(low: Fraction, high: Fraction) -> Fraction:
    """Return the fraction of least denominator in an open interval, by continued fractions."""
    if low < 0:
        return -_simplest_between(-high, -low) if high <= 0 else Fraction(0)
    whole = math.floor(low)
    if whole + 1 < high:
        return Fraction(whole + 1)
    rest = low - whole
    if not rest:  # the next best lies just above a whole number
        return whole + Fraction(1, math.floor(1 / (high - whole)) + 1)
    return whole + 1 / _simplest_between(1 / (high - whole), 1 / rest)


def read_double(value: float) -> Fraction:
    """Return a double as the binary fraction that it is."""
    return Fraction(float(value))

"""The one reader of numbers from outside: which rational number a double, a text, a Decimal or a Fraction is.

A double is the binary fraction that it is, unless the user says that the decimals were meant: then it is the shortest
decimal that rounds to it, which Python prints. Both readings are one-to-one and keep order: numbers are equal, or one
is larger, where their doubles are. So 0.1 + 0.2 is not 0.3 in either; for 3/10 give "0.3", or "3/10".
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from fractions import Fraction
from numbers import Rational, Real
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown

READINGS = {
    "exact": "each double is the binary fraction that it is",
    "decimal": "each double is the shortest decimal that rounds to it",
}
EXACT = "exact"  # the default everywhere
_TEXT = re.compile(r"[+-]?(?:[0-9]+/[0-9]+|(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE](?P<exponent>[+-]?[0-9]+))?)")


class NumberLimits(NamedTuple):
    """Numbers beyond which a number is not read as a rational."""

    max_digits: int = 4_300  # characters of a number in a text: Python itself reads no more digits
    # of ten: with a hundred million Python computes for minutes, before anything can be checked
    max_exponent: int = 5_000
    max_binary_exponent: int = 1_000  # of numbers of SymPy and mpmath: what doubles hold, with room for more bits below


LIMITS = NumberLimits()


def read_number(value: Any, read_as: str = EXACT, name: str = "number") -> Fraction:
    """Return the rational number that a value from outside is.

    Args:
        value: a double, whole number, Fraction, Decimal, number of SymPy or mpmath; or a text, decimals like "0.3" or a
            quotient like "1/3". All but doubles are read exactly.
        read_as: "exact" or "decimal", how a double is read; see ``READINGS``.
        name: of the value, for messages.

    Raises:
        InvalidInput: for anything but one finite real number within 1e±5000, and for single precision.

    >>> read_number(0.1), read_number(0.1, "decimal"), read_number("0.1"), read_number(0.375)
    (Fraction(3602879701896397, 36028797018963968), Fraction(1, 10), Fraction(1, 10), Fraction(3, 8))
    """
    check_reading(read_as)
    if isinstance(value, str):
        return _read_text(name, value)
    if isinstance(value, Decimal):
        return _read_decimal(name, value)
    if np.ndim(value) == 0 and hasattr(value, "dtype"):
        if np.issubdtype(value.dtype, np.floating) and value.dtype != np.float64:
            raise InvalidInput(f"`{name}` must be in double precision; got {shown(value)} of {value.dtype}. "
                               "Convert it.")
        value = np.asarray(value).item()
    if isinstance(value, bool) or not isinstance(value, Real):
        raise InvalidInput(f"`{name}` must be given as doubles, whole numbers, Fractions or decimals in quotes; "
                           f"got {shown(value)}.")
    if isinstance(value, Rational):  # SymPy registers its rational numbers as such
        return Fraction(int(value.numerator), int(value.denominator))
    if hasattr(value, "_mpf_"):
        exact = _read_binary(name, value)
        if float(exact) != exact:  # of more bits than a double, so that it has no shortest decimal and is what it is
            return exact
    number = float(value)
    if not math.isfinite(number):
        raise InvalidInput(f"`{name}` must be finite; got {shown(value)}.")
    return Fraction(number if read_as == EXACT else repr(number))


def _read_binary(name: str, value: Any) -> Fraction:
    """Return a Float of SymPy or of mpmath, which has any count of bits."""
    sign, mantissa, exponent, size = map(int, value._mpf_)
    if abs(exponent + size) > LIMITS.max_binary_exponent or (exponent and not mantissa):  # infinities and NaN have none
        raise InvalidInput(f"`{name}` must be finite and within 1e±300; got a {type(value).__name__} beyond.")
    return (-1) ** sign * mantissa * Fraction(2) ** exponent


def as_fmpq(number: Any) -> Any:
    """Return a Fraction, a double or a whole number as python-flint's rational."""
    from flint import fmpq

    return fmpq(*number.as_integer_ratio())


def as_fraction(number: Any) -> Fraction:
    """Return python-flint's rational as a Fraction."""
    return Fraction(int(number.p), int(number.q))


def nearest_double(number: Any) -> float:
    """Return the double next to a number, an infinity beyond the largest."""
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


def check_reading(read_as: Any) -> None:
    """Refuse a word that names no reading of doubles."""
    if not isinstance(read_as, str) or read_as not in READINGS:
        raise InvalidInput(f'`read_as` must be "exact" or "decimal"; got {shown(read_as)}.')


def _read_text(name: str, text: str) -> Fraction:
    parts = _TEXT.fullmatch(text.strip()) if len(text) <= LIMITS.max_digits else None
    if parts is not None and abs(int(parts["exponent"] or 0)) <= LIMITS.max_exponent:
        try:
            return Fraction(parts[0])
        except ZeroDivisionError:
            pass
    raise InvalidInput(f'`{name}` must be decimals like "0.3" or a quotient like "1/3", finite and within '
                       f"1e±{LIMITS.max_exponent}; got {shown(text)}.")


def _read_decimal(name: str, value: Decimal) -> Fraction:
    digits, exponent = value.as_tuple()[1:]
    if isinstance(exponent, str) or abs(exponent) > LIMITS.max_exponent or len(digits) > LIMITS.max_digits:
        raise InvalidInput(f"`{name}` must be finite and within 1e±{LIMITS.max_exponent}; got {shown(value)}.")
    return Fraction(value)

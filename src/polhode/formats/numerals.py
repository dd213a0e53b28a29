"""Numbers in text files, read by one rule: only what other programs would read too.

Python's ``float`` takes more than files mean: ``2_5`` is 25 to it, digits of other scripts count, ``1e400`` is infinite
and ``1e-400`` zero.
"""

from __future__ import annotations

import math
import re
from typing import NamedTuple

MAY_VANISH = re.compile(r"[eE]-\d{3}", re.ASCII)  # a number with such an exponent may be too small for a double
_FORM = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,6})?", re.ASCII)
_NOT_ZERO = re.compile(r"[+-]?[0.]*[1-9]")


class NumeralLimits(NamedTuple):
    """Numbers beyond which a text is not read as a number or a line of a table."""

    max_number: int = 400  # characters of a number; a double written out needs no more than 327 digits before the point
    max_line: int = 1_000_000  # characters of a line; a system of ten thousand parts needs a third


LIMITS = NumeralLimits()


def read_number(text: str) -> float:
    """Return the finite number that a word of a file is.

    Raises:
        ValueError: for anything but decimal digits, a point, an exponent and signs; for numbers too large for a double,
            or so small that nothing would be left of them.

    >>> read_number("-1.5e3")
    -1500.0
    """
    if len(text) > LIMITS.max_number or not _FORM.fullmatch(text):
        raise ValueError("must be a number in decimal digits")
    value = float(text)
    if not math.isfinite(value):
        raise ValueError("is too large for a number")
    if value == 0.0 and _NOT_ZERO.match(text):
        raise ValueError("is so small that nothing is left of it")
    return value


def read_fortran(text: str) -> float:
    """Return the number that a word of a Fortran program's file is, whose exponents may begin with D.

    Raises:
        ValueError: as ``read_number``.

    >>> read_fortran("-1.5D+03")
    -1500.0
    """
    return read_number(re.sub(r"(?<=[\d.])[dD](?=[+-]?\d)", "E", text))


def is_misread(word: str) -> bool:
    """Whether Python takes a word for a number, and ``read_number`` does not.

    >>> [is_misread(word) for word in ("2_5", "nan", "1e400", "C_1", "2.5")]
    [True, True, True, False, False]
    """
    try:
        float(word)
    except ValueError:
        return False
    try:
        read_number(word)
    except ValueError:
        return True
    return False

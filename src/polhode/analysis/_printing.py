"""The answers of this room as ``print`` shows them: a sentence, and a few numbers below it.

Each class of answers hands its sentence and numbers to ``print_answer`` in its ``__str__``. Its ``repr`` stays that of
the data, with all arrays.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np


class PrintingLimits(NamedTuple):
    """How much of an answer is printed."""

    max_numbers: int = 6  # in a line; of more the first are printed, and how many there are
    digits: int = 6  # significant ones


LIMITS = PrintingLimits()


def print_answer(sentence: str, **numbers: str | None) -> str:
    """Return the sentence, and a line for each of the numbers, without those that are None.

    >>> print(print_answer("It turns back", period="2 s", largest_multiplier=None))
    It turns back.
    period: 2 s
    """
    head = sentence[:1].upper() + sentence[1:].rstrip(".") + "."
    lines = [f"{name.replace('_', ' ')}: {words}" for name, words in numbers.items() if words is not None]
    return "\n".join([head, *lines])


def write_numbers(values: Any, unit: str = "", errors: Any = None) -> str | None:
    """Return up to six of the numbers with their unit, and how many there are if more; None of none.

    >>> write_numbers([0.5, -1e-3], "1/s"), write_numbers([1 + 2j, -1j]), write_numbers(range(9))
    ('0.5, -0.001 1/s', '1 + 2i, -1i', '0, 1, 2, 3, 4, 5, … (9)')
    >>> write_numbers(0.51234, "s", errors=0.02), write_numbers(None, "s"), write_numbers([])
    ('0.51234 ± 0.02 s', None, None)
    """
    if values is None:
        return None
    flat = np.ravel(values)
    if not flat.size:
        return None
    words = [_write_number(value) for value in flat[:LIMITS.max_numbers]]
    if errors is not None:
        words = [f"{word} ± {error:.2g}" for word, error in zip(words, np.ravel(errors), strict=False)]
    rest = f", … ({flat.size})" if flat.size > LIMITS.max_numbers else ""
    return f"{', '.join(words)}{rest} {unit}".rstrip()


def _write_number(value: Any) -> str:
    if not isinstance(value, complex | np.complexfloating):
        return f"{value:.{LIMITS.digits}g}"
    if value.imag == 0:
        return f"{value.real:.{LIMITS.digits}g}"
    across = f"{abs(value.imag):.{LIMITS.digits}g}i"
    if value.real == 0:
        return f"{'-' if value.imag < 0 else ''}{across}"
    return f"{value.real:.{LIMITS.digits}g} {'-' if value.imag < 0 else '+'} {across}"


def write_span(values: Any, unit: str = "") -> str:
    """Return the first and the last of the numbers: "from 0 to 300 s".

    >>> write_span([0.0, 1.0, 300.0], "s")
    'from 0 to 300 s'
    """
    return f"from {values[0]:.{LIMITS.digits}g} to {values[-1]:.{LIMITS.digits}g} {unit}".rstrip()


def count_things(number: int, thing: str, things: str | None = None) -> str:
    """Return a number with its noun.

    >>> count_things(1, "branch", "branches"), count_things(2, "crossing"), count_things(0, "crossing")
    ('1 branch', '2 crossings', 'no crossings')
    """
    return f"{number or 'no'} {thing if number == 1 else things or f'{thing}s'}"

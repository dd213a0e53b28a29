"""The response of the course to a typed answer, judged by as many digits as it has.

The page has an equal function in ``learn/_static/exercises.js``, line by line.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import NamedTuple

_NUMBER = re.compile(r"[+-]?(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d+))?")


class ResponseThresholds(NamedTuple):
    """Numbers that decide whether an answer is right.

    Attributes:
        min_digits: of an answer that is right to its digits; with one, a tenth of all answers would be right.
    """

    min_digits: int = 2


LIMITS = ResponseThresholds()


def wanted_digits(tolerance: float) -> int:
    """Return how many digits an answer needs so that its rounding stays within a relative tolerance.

    >>> wanted_digits(0.005), wanted_digits(0.0008)
    (3, 4)
    """
    return 1 + math.ceil(math.log10(0.5 / tolerance) - 1e-9)


def respond(typed: str, answer: float, mistakes: Sequence[tuple[float, str]], tolerance: float) -> str:
    """Return "Right.", "Right to 2 digits.", a hint, or in which direction an answer is off.

    An answer is right within the tolerance, or if it is the right one rounded to the two or more digits that were
    typed. Where that could be a mistake as well, more digits are asked for.

    >>> [respond(text, 4.0098, [(4.0, "Divide by the cosine.")], 0.001) for text in ("4.01", "4.0", "4.000", "4.1")]
    ['Right.', 'To these digits other answers look alike: give 4.', 'Divide by the cosine.', 'Too large.']
    """
    text = typed.strip().replace(",", ".").replace("−", "-")
    parts = _NUMBER.fullmatch(text)
    try:
        value = float(text) if parts else math.nan
    except ValueError:
        value = math.nan
    if parts is None or not math.isfinite(value):
        return "Enter a number."
    digits, half = _precision(*parts.groups(default=""))
    close = lambda known: abs(value - known) <= tolerance * abs(known) + (1e-12 if known == 0.0 else 0.0)  # noqa: E731
    rounds = lambda known: digits >= LIMITS.min_digits and abs(value - known) <= half * (1.0 + 1e-9)  # noqa: E731
    if close(answer):
        return "Right."
    hints = [hint for known, hint in mistakes if close(known)] or [hint for known, hint in mistakes if rounds(known)]
    if rounds(answer):
        alike = f"To these digits other answers look alike: give {wanted_digits(tolerance)}."
        return alike if hints else f"Right to {digits} digits."
    if hints:
        return hints[0]
    if abs(value - answer) <= half:
        return f"Give {wanted_digits(tolerance)} digits."
    if value * answer < 0.0:
        return "The sign is wrong." if close(-answer) or rounds(-answer) else "Check the sign."
    return "Too large." if abs(value) > abs(answer) else "Too small."


def _precision(whole: str, part: str, power: str) -> tuple[int, float]:
    """Return how many digits a number has, and half a unit of its last one; 1200 and 200 have two."""
    figures = (whole + part).lstrip("0")
    zeros = 0 if part else len(figures) - len(figures.rstrip("0"))
    ending = max(0, min(zeros, len(figures) - LIMITS.min_digits))
    return len(figures) - ending, 0.5 * 10.0 ** (int(power or 0) - len(part) + ending)

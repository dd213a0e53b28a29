"""Quantities with a standard deviation, like "27.38 ± 0.07 h"."""

from __future__ import annotations

import math
import re

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.formats.numerals import read_number
from polhode.spec.reach import check_reach
from polhode.spec.units import parse_quantity

Uncertain = str | float | tuple[float, float]
"""A quantity in SI, one with its standard deviation, or a text like "27.38 ± 0.07 h"."""
_ERROR = re.compile(r"\s*(?:±|\+/-|\+-)\s*")
_TRAILING_UNIT = re.compile(r"(?![eE][+-]?\d)[a-zA-Zµμ][^±]*$")


def quantity(name: str, text: str, unit: str, positive: bool = True) -> float:
    """Return a quantity in SI.

    Raises:
        InvalidInput: with the name, as a reader knows it.
    """
    try:
        value = parse_quantity(text, unit)
    except ValueError as error:
        raise InvalidInput(f"{name} {error}.") from None
    check_reach(name, value)
    if positive and not value > 0:
        raise InvalidInput(f"{name} must be positive; got {shown(text)}.")
    return value


def uncertain(name: str, measured: Uncertain, unit: str, bare: bool = False) -> tuple[float, float]:
    """Return a positive quantity and its standard deviation, in SI.

    Args:
        name: for messages.
        measured: numbers, or a text.
        unit: to which a text must be convertible.
        bare: whether a text may go without a unit.

    Raises:
        InvalidInput: for text that cannot be read, and for numbers that are not positive and finite.
    """
    if isinstance(measured, str):
        value, error = _read_value(name, measured, unit, bare)
    else:
        try:
            value, error = np.asarray(measured if np.ndim(measured) else (measured, 0.0), float).tolist()
        except (TypeError, ValueError):
            raise InvalidInput(
                f'{name} must be a number, one with its standard deviation, or a text like "27.38 ± 0.07 h"; got '
                f"{shown(measured)}."
            ) from None
        if not 0.0 < value < math.inf:
            raise InvalidInput(f"{name} must be positive; got {shown(measured)}.")
    if not 0.0 <= error < math.inf:
        raise InvalidInput(f"{name} must not have a negative error; got {shown(measured)}.")
    return value, error


def _read_value(name: str, text: str, unit: str, bare: bool) -> tuple[float, float]:
    value, *rest = _ERROR.split(text.strip())
    if len(rest) > 1:
        raise InvalidInput(f'{name} must be like "27.38 ± 0.07 h"; got {shown(text)}.')
    match = _TRAILING_UNIT.search(rest[-1] if rest else value)
    if match is None and bare:
        try:
            parts = [read_number(part) for part in (value, *rest)]
        except ValueError:
            raise InvalidInput(f"{name} must be numbers; got {shown(text)}.") from None
        check_reach(name, *parts)
        if not parts[0] > 0:
            raise InvalidInput(f"{name} must be positive; got {shown(text)}.")
    else:
        own = _TRAILING_UNIT.search(value)
        first = value if own or match is None else f"{value} {match.group()}"
        parts = [quantity(name, first, unit), *(quantity(name, part, unit, positive=False) for part in rest)]
    return parts[0], parts[1] if rest else 0.0

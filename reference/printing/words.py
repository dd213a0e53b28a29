"""The words of the formulas: what they take as given, and every language has in its own way.

Those that Python has as functions of single numbers are in ``polhode.exact._kernel_arithmetic``, the others in ``math``
and among the built-in functions. A printer maps each to a function or an operator of its language.
"""

from __future__ import annotations

from printing.sources import Source
from printing.tree import FLAG, NUMBER, Type

Signature = tuple[tuple[Type, ...], Type]
ONE: Signature = ((NUMBER,), NUMBER)
TWO: Signature = ((NUMBER, NUMBER), NUMBER)
WORDS: dict[str, Signature] = {
    "square_root": ONE,  # NaN below zero
    "exponential": ONE,
    "floor": ONE,
    "nearest": ONE,  # whole number, the even one of two
    "where": ((FLAG, NUMBER, NUMBER), NUMBER),  # of two numbers that are both known
    "larger": TWO,  # the second where they are not in order
    "abs": ONE,
    "atan": ONE,
    "atan2": TWO,
    "asinh": ONE,
    "sinh": ONE,
    "log": ONE,
    "tan": ONE,
}
"""Name → types of parameters and of the result."""
ARITHMETIC = "polhode.exact._kernel_arithmetic"
BUILT_IN = {"abs"}
CONSTANTS = {"pi", "nan", "inf"}
"""Of ``math``: a ``Global`` of the module "math"."""


def is_word(origin: Source, name: str) -> bool:
    """Return whether a function that stands in a module is one of the words."""
    return origin.name == ARITHMETIC and name in WORDS

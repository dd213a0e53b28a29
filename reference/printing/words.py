"""The words of the formulas: what they take as given, and every language has in its own way.

Python has them as functions of single numbers in ``polhode.exact._kernel_arithmetic``. A printer maps each to a
function or an operator of its language.
"""

from __future__ import annotations

from printing.sources import Source
from printing.tree import NUMBER, SUM, WHOLE, Tuple, Type

Signature = tuple[tuple[Type, ...], Type]
ONE: Signature = ((NUMBER,), NUMBER)
TWO: Signature = ((NUMBER, NUMBER), NUMBER)
PAIR = Tuple((NUMBER, NUMBER))
EXACT_SUMS: dict[str, Signature] = {
    "as_sum": ((PAIR,), SUM),
    "join": ((SUM, SUM), SUM),
    "negated": ((SUM,), SUM),
    "multiply_terms": ((SUM, NUMBER), SUM),
    "compress": ((SUM, WHOLE), SUM),  # to so many terms at most
    "distil": ((SUM,), PAIR),
}
WORDS: dict[str, Signature] = EXACT_SUMS | {
    "square_root": ONE,  # NaN below zero
    "exponential": ONE,
    "floor": ONE,
    "nearest": ONE,  # whole number, the even one of two
    "larger": TWO,  # the second where they are not in order
    "smaller": TWO,
    "abs": ONE,
    "binary_exponent": ONE,  # e with ½ ≤ |x|/2^e < 1, and 0 for x = 0
    "times_power": TWO,  # 2ⁿ x of x and a whole number n
    "arctangent": ONE,
    "angle_of": TWO,  # of y and x, between −π and π
    "logarithm": ONE,
    "hyperbolic_sine": ONE,
    "area_of_sine": ONE,  # the number whose hyperbolic sine is x
}
"""Name → types of parameters and of the result."""
TAKEN_APART = {"where", "choice", "constant", "negation", "choose", "iterate", "iterate_until"}
"""Words that no printer meets: a ``Choice``, a ``Unary`` or a ``Repeat`` takes their place, or what they are given."""
ARITHMETIC = "polhode.exact._kernel_arithmetic"
BUILT_IN = {"abs"}
CONSTANTS = {"pi", "nan", "inf"}
"""Of ``math``: a ``Global`` of the module "math"."""


def is_word(origin: Source, name: str) -> bool:
    """Return whether a function that stands in a module is one of the words."""
    return origin.name == ARITHMETIC and (name in WORDS or name in TAKEN_APART)

"""The formulas of exact motion over words for balls, and in place of their short series the functions these stand for.

A pair is a ball and zero, as a ball needs no second part. Python takes a comparison of balls that overlap as false. So
what formulas compare must be exact, or a root of what is, for which ``exact_bits`` is there; or both ways must be right
and differ by rounding alone, as those do between which doubles choose by what cancels less.

Source: Johansson, IEEE Trans. Comput. 66 (2017) 1281, for the arithmetic; Carlson, Numer. Algorithms 10 (1995) 13, for
R_F; DLMF §20.2 for theta functions.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from types import ModuleType, SimpleNamespace
from typing import Any

from flint import acb, arb, ctx

from polhode._base.compiled.copying import copy_modules
from polhode.analysis._exact_arithmetic import Ball, Rational
from polhode.exact import _formulas as formulas
from polhode.exact import _kernel_arithmetic as kernel_arithmetic
from polhode.special._doubledouble import INVERSE_TWO_PI, PI

MOST_STEPS = 100  # of a mean; it takes some ten, and the binary logarithm of its terms' exponents
Pair = tuple[Ball, Ball]
ZERO = arb(0)


class _Constants:
    """What formulas take from ``math``."""

    inf, nan = arb("inf"), arb("nan")

    @property
    def pi(self) -> Ball:
        return arb.pi()


def for_balls(*modules: ModuleType, **replaced: Any) -> Any:
    """Return the names of modules of formulas, with functions of balls; some functions and constants replaced."""
    parts = kernel_arithmetic, formulas, *modules
    spaces = copy_modules(parts, lambda function, _: function, FOR_BALLS | replaced)
    for space in spaces.values():
        space |= {name: x for name, x in replaced.items() if name in space and not callable(x)} | {"math": _Constants()}
    return SimpleNamespace(**{name: x for module in modules for name, x in spaces[module.__name__].items()})


def as_whole(numbers: Sequence[Rational]) -> tuple[list[int], int]:
    """Return rationals times a whole number, which makes them whole, and that number."""
    factor = math.lcm(*(int(x.q) for x in numbers))
    return [int(x.p) * (factor // int(x.q)) for x in numbers], factor


def exact_bits(numbers: Sequence[int]) -> int:
    """Return a precision in which no sum of products is rounded that take each of these whole numbers twice at most."""
    return 2 * sum(x.bit_length() for x in numbers) + 32


def carlson(x: Ball, y: Ball, z: Ball) -> Ball:
    """Return R_F of numbers that are not negative."""
    return acb.elliptic_rf(*(acb(number.nonnegative_part()) for number in (x, y, z))).real


def thetas(turns: Ball, beyond: Ball, ratio: Ball, *, order: int = 0) -> list[Ball]:
    """Return θ1 to θ4 of z = 2π turns + i beyond and nome e^(−π ratio), or their derivatives by z."""
    values = acb.modular_theta(acb(2 * turns, beyond / arb.pi()), acb(0, ratio), order)
    return [x / arb.pi() ** order for x in values] if order else list(values)


# ---------------------------------------------------------------------- words


def _of_balls(operation: Callable[..., Ball]) -> Callable[..., Pair]:
    return lambda *pairs: (operation(*(pair[0] for pair in pairs)), ZERO)


def _root_or_zero(x: Ball) -> Ball:
    return ZERO if x == 0 else x.sqrt()


def _constant(value: tuple[float, float], like: Ball) -> Pair:
    exact = {PI: arb.pi, INVERSE_TWO_PI: lambda: 1 / (2 * arb.pi())}.get(value, lambda: arb(value[0]) + value[1])
    return exact(), ZERO


def _nearest(x: Ball) -> Ball:
    """Return a whole number near the middle of a ball, whose choice changes no result."""
    return arb((x.mid() + 0.5).floor().mid())


def _phase(rate: Any, time: Any) -> tuple[Ball, Ball, Ball]:
    turns = rate[0] * time[0]
    count = _nearest(turns)
    return turns - count, ZERO, count


def _sine_cosine(turns: Ball) -> Pair:
    return (2 * turns).sin_cos_pi()


def _third_kind_mean(a: Pair, g: Pair, pp: Pair) -> tuple[Pair, Pair]:
    """Return ``formulas.third_kind_mean``, with a bound on what the sum leaves out.

    With x = (a−g)/(a+g) and δ = max(|x|, |ε|) ≤ ½, a step makes ε, 1/(1−ε²) − 1/√(1−x²) over the sum of both, and x
    smaller than δ². So what follows Q is less than |Q| δ.
    """
    mean, total, q, sharp = a[0].agm(g[0]), arb(1), arb(1), arb((1, -ctx.prec))
    one, other, square = a[0], g[0], pp[0]
    for _ in range(MOST_STEPS):
        product = one * other
        e = (square - product) / (square + product)
        apart = abs((one - other) / (one + other)).max(abs(e)).upper()
        if apart < 0.5 and abs(q) * apart < sharp:
            return (mean, ZERO), (total + arb(0, (abs(q) * apart).upper()), ZERO)
        q = q * e / 2
        one, other, square, total = (one + other) / 2, product.sqrt(), (square + product) ** 2 / square / 4, total + q
    return (mean, ZERO), (arb("nan"), ZERO)


FOR_BALLS: dict[str, Any] = {
    "two_product": lambda x, y: (x * y, ZERO), "two_sum": lambda x, y: (x + y, ZERO),
    "fast_two_sum": lambda x, y: (x + y, ZERO), "two_square": lambda x: (x * x, ZERO), "halves": lambda x: (x, ZERO),
    "add": _of_balls(operator.add), "subtract": _of_balls(operator.sub), "multiply": _of_balls(operator.mul),
    "divide": _of_balls(operator.truediv), "square": _of_balls(lambda x: x * x), "root": _of_balls(arb.sqrt),
    "root_or_zero": _of_balls(_root_or_zero), "scale": lambda x, y: (x[0] * y, ZERO),
    "multiply_float": lambda x, y: (x[0] * y, ZERO), "constant": _constant,
    "choice": lambda condition, x, y: tuple(map(arb, x if condition else y)),
    "where": lambda condition, x, y: arb(x if condition else y),
    "larger": arb.max, "smaller": arb.min, "nearest": _nearest, "whole": _nearest, "floor": lambda x: arb(x).floor(),
    "binary_exponent": lambda x: ZERO, "times_power": lambda x, n: x * arb((1, int(float(n)))),
    "square_root": arb.sqrt, "exponential": arb.exp, "arctangent": arb.atan, "angle_of": arb.atan2,
    "logarithm": arb.log, "hyperbolic_sine": arb.sinh, "area_of_sine": arb.asinh,
    "phase": _phase, "sine_cosine": _sine_cosine, "third_kind_mean": _third_kind_mean,
}  # fmt: skip

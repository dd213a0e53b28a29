"""Elementary functions of expressions: a node of a moving argument, a number of a number."""

from __future__ import annotations

import math
from collections.abc import Callable

from polhode.taylor.expressions import Expression
from polhode.taylor.operations import Operation


def sine_and_cosine(x: Expression) -> tuple[Expression, Expression]:
    """Return sin x and cos x."""
    if not x.terms:
        return x.tape.function(math.sin, x.constant), x.tape.function(math.cos, x.constant)
    sine = x.tape.unary(Operation.SINE, x)
    place = next(iter(sine.terms))
    return sine, Expression(x.tape, {place + 1: 1.0})


def cube_root(x: Expression) -> Expression:
    """Return x^(1/3), by the double that is nearest to this exponent."""
    x.tape.rounded |= x.tape.kept is not None
    return x ** (1.0 / 3.0)


def apply(operation: Operation, function: Callable[[float], float], x: Expression) -> Expression:
    """Return a function of an expression by its operation, or of a number by itself."""
    return x.tape.unary(operation, x) if x.terms else x.tape.function(function, x.constant)


def exponential(x: Expression) -> Expression:
    """Return eˣ."""
    return apply(Operation.EXPONENTIAL, math.exp, x)


def exponential_minus_one(x: Expression) -> Expression:
    """Return eˣ − 1 with all its digits."""
    return apply(Operation.EXPONENTIAL_MINUS_ONE, math.expm1, x)


def logarithm(x: Expression) -> Expression:
    """Return log x."""
    return apply(Operation.LOGARITHM, math.log, x)


def logarithm_of_one_plus(x: Expression) -> Expression:
    """Return log(1 + x) with all its digits."""
    return apply(Operation.LOGARITHM_OF_ONE_PLUS, math.log1p, x)


def hyperbolic_tangent(x: Expression) -> Expression:
    """Return tanh x."""
    return apply(Operation.TANH, math.tanh, x)


def eccentric_anomaly(mean_anomaly: Expression, eccentricity: float) -> Expression:
    """Return E of M = E − e sin E, both growing without bound."""
    if eccentricity == 0.0:
        return mean_anomaly
    return mean_anomaly.tape.unary(Operation.ECCENTRIC, mean_anomaly, eccentricity)

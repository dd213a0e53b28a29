"""A system's rates of change in ball arithmetic: Taylor coefficients, bounds in the complex plane, derivatives.

Numbers in a system's fields are parameters, which stand on the tape beside the state and do not move: so that what is
computed of them, such as one over a moment, is a ball too. Numbers in formulas are taken as the doubles they are.
Source: Johansson, IEEE Trans. Comput. 66 (2017) 1281, for the arithmetic.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.flatten_util
import numpy as np

from polhode.systems.base import AbstractSystem
from polhode.systems.forms import rates_of_change
from polhode.taylor.expressions import Expression, Operation, Tape, Untraceable, gradient
from polhode.taylor.jaxprs import uses_first, written
from polhode.taylor.machine import TRACING, Form, tape_value
from polhode.taylor.program import needed
from polhode.taylor.tracing import evaluated
from polhode.types import Array

Ball = Any  # of python-flint, real or complex


class BallSystem:
    """What moves, in balls.

    Args:
        system: what moves.
        state: one, which tells shapes.

    Attributes:
        form: of a state.
        size: n, how many numbers move: those of the state, and the time where rates depend on it.
        parameters: (m,) numbers in the system's fields.
        exact: whether what is computed of them is balls; else it was rounded to doubles.
        timed: whether the last of the numbers that move is the time.

    Raises:
        Untraceable: if rates are not made of operations that have a recurrence.
    """

    def __init__(self, system: AbstractSystem, state: Array) -> None:
        self.form = Form(np.shape(state), np.iscomplexobj(state))
        arrays, rest = eqx.partition(system, eqx.is_inexact_array)
        flat, unravel = jax.flatten_util.ravel_pytree(arrays)
        self.exact = True
        try:
            made = self._traced(lambda p: eqx.combine(unravel(p), rest), np.asarray(flat, float))
        except (*TRACING, TypeError, Untraceable):
            self.exact = False  # some of them are looked at as numbers, or go into functions without a recurrence
            made = self._traced(lambda p: system, np.zeros(0))
        self._tape, self._rates, self.size, self.parameters, self.timed = made
        if any(node.operation is Operation.ECCENTRIC for node in self._tape.nodes):
            raise Untraceable("Kepler's equation, which no ball solves yet")
        slopes = [gradient(x) for x in self._rates]
        self._slopes = [x for row in slopes for x in row[: self.size]]
        self._still = self._that_do_not_move()
        self._of_rates, self._of_slopes = needed(self._tape, self._rates), needed(self._tape, self._slopes)

    def _traced(
        self, system_of: Callable[[Any], AbstractSystem], parameters: Array
    ) -> tuple[Tape, list[Expression], int, Array, bool]:
        form = self.form

        def everything(t: Any, numbers: Any, p: Any) -> Any:
            return form.numbers(rates_of_change(system_of(p), t, form.state(numbers)))

        closed = written(everything, (), (form.size,), np.shape(parameters))
        timed = uses_first(closed)
        size = form.size + timed
        tape = Tape(size + len(parameters), form.size if timed else None)
        known = np.empty(tape.size, object)
        known[:] = tape.state()
        t = np.asarray(known[form.size] if timed else 0.0, object if timed else float)
        found = np.ravel(evaluated(closed, t, known[: form.size], known[size:])[0])
        rates = [tape_value(tape, x) for x in found] + [tape.constant(1.0)] * timed
        return tape, rates, size, parameters, timed

    def _that_do_not_move(self) -> list[bool]:
        still = [False] * self.size + [True] * (self._tape.size - self.size)
        for node in self._tape.nodes:
            still.append(all(still[k] for k in node.arguments))
        return still

    def rates(self, y: list[Ball], parameters: list[Ball]) -> list[Ball]:
        """Return the rates of change at a point, or at all points of a box."""
        z = self._nodes(y, parameters, self._of_rates)
        return [_value(x, z) for x in self._rates]

    def slopes(self, y: list[Ball], parameters: list[Ball]) -> list[list[Ball]]:
        """Return the derivatives (n, n) of the rates by what moves."""
        z = self._nodes(y, parameters, self._of_slopes)
        flat = [_value(x, z) for x in self._slopes]
        return [flat[k * self.size : (k + 1) * self.size] for k in range(self.size)]

    def _nodes(self, y: list[Ball], parameters: list[Ball], places: list[int]) -> list[Ball]:
        z = [*y, *parameters, *[None] * len(self._tape.nodes)]
        for place in places:
            z[place] = _first(self._tape.nodes[place - self._tape.size], z)
        return z

    def coefficients(self, y: list[Ball], parameters: list[Ball], order: int) -> list[list[Ball]]:
        """Return the Taylor coefficients (n, order + 1) of the motion from a point."""
        z: list[list[Ball]] = [[x] for x in self._nodes(y, parameters, self._of_rates)]
        moving = [(place, self._tape.nodes[place - self._tape.size]) for place in self._of_rates
                  if not self._still[place]]  # fmt: skip
        for k in range(order):
            for i in range(self.size):
                x = self._rates[i]
                total = x.constant if k == 0 else 0
                for place, factor in x.terms.items():
                    if k == 0 or not self._still[place]:
                        total = z[place][k] * factor + total
                z[i].append(total / (k + 1) if total != 0 or k == 0 else z[i][0] * 0)
            for place, node in moving:
                z[place].append(_next(node, z, place, k + 1, self._still))
        return z[: self.size]


def _value(x: Expression, z: list[Ball]) -> Ball:
    total = z[0] * 0 + x.constant
    for place, factor in x.terms.items():
        total += z[place] * factor
    return total


def _first(node: Any, z: list[Ball]) -> Ball:
    """Return the value of a node."""
    x = z[node.arguments[0]]
    match node.operation:
        case Operation.AFFINE:
            total = x * 0 + node.number
            for k, factor in zip(node.arguments, node.coefficients, strict=True):
                total += z[k] * factor
            return total
        case Operation.PRODUCT:
            other = z[node.arguments[1]]
            return x * x if node.arguments[0] == node.arguments[1] else x * other
        case Operation.POWER:
            return _power(x, node.number)
        case Operation.EXPONENTIAL:
            return x.exp()
        case Operation.LOGARITHM:
            return _analytic(x, "log")
        case Operation.SINE:
            return x.sin()
        case _:
            return x.cos()


def _power(x: Ball, exponent: float) -> Ball:
    twice = 2.0 * exponent
    if exponent.is_integer():
        return x ** int(exponent)
    if twice.is_integer():
        return _analytic(x, "sqrt") ** int(twice)
    return (_analytic(x, "log") * exponent).exp()


def _analytic(x: Ball, function: str) -> Ball:
    """Return a square root or logarithm, not a number where a complex ball meets the branch cut."""
    is_complex = hasattr(x, "complex_rad")
    return getattr(x, function)(analytic=True) if is_complex else getattr(x, function)()


def _next(node: Any, z: list[list[Ball]], place: int, k: int, still: list[bool]) -> Ball:
    """Return the k-th coefficient of a node, k > 0, by those of lower orders; as ``kernel_series`` does."""
    a = node.arguments[0]
    x, own = z[a], z[place]
    match node.operation:
        case Operation.AFFINE:
            total = x[0] * 0
            for other, factor in zip(node.arguments, node.coefficients, strict=True):
                if not still[other]:
                    total += z[other][k] * factor
            return total
        case Operation.PRODUCT:
            b = node.arguments[1]
            if still[a] or still[b]:
                constant, moving = (a, b) if still[a] else (b, a)
                return z[constant][0] * z[moving][k]
            return sum(map(operator.mul, x[: k + 1], reversed(z[b][: k + 1])), x[0] * 0)
        case Operation.POWER:
            total = x[0] * 0
            for j in range(k):
                term = own[j] * x[k - j]
                total += term * (k - j) * node.number - term * j
            return total / (k * x[0])
        case Operation.EXPONENTIAL:
            return sum(((k - j) * (own[j] * x[k - j]) for j in range(k)), x[0] * 0) / k
        case Operation.LOGARITHM:
            total = sum((j * (own[j] * x[k - j]) for j in range(1, k)), x[0] * 0)
            return (x[k] - total / k) / x[0]
        case Operation.SINE:
            return sum(((k - j) * (x[k - j] * z[place + 1][j]) for j in range(k)), x[0] * 0) / k
        case _:  # the sine stands before it
            return -sum(((k - j) * (x[k - j] * z[place - 1][j]) for j in range(k)), x[0] * 0) / k

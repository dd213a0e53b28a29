"""A system's rates of change in ball arithmetic: Taylor coefficients, bounds in the complex plane, derivatives.

Numbers in a system's fields are parameters, which are on the tape beside the state and do not move, so that what is
computed of them, such as one over a moment, is a ball too; likewise numbers in formulas, taken as exact doubles.
Source: Johansson, IEEE Trans. Comput. 66 (2017) 1281, for the arithmetic.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.flatten_util
import numpy as np

from polhode._base.jaxprs import depends_on
from polhode.systems._forms import rates_of_change
from polhode.systems.base import AbstractSystem
from polhode.taylor.expressions import Expression, Tape, Untraceable, gradient
from polhode.taylor.jaxprs import numbers_in, write_jaxpr
from polhode.taylor.machine import TRACING, Form, tape_value
from polhode.taylor.operations import ALONG, COMPANIONS, Node, Operation
from polhode.taylor.program import find_needed
from polhode.taylor.recurrences import RECURRENCES, Recurrence, Words
from polhode.taylor.tracing import evaluate, keep_numbers
from polhode.types import Array, Float64

Ball = Any  # of python-flint, real or complex
Step = tuple[int, Node, Recurrence | None, int]  # place, recurrence of a function, and how many nodes its results are
OF_JAX = frozenset({math.log10(math.e), 1.0 / math.log(10.0)})  # 1/ln 10 as ``jnp.log10`` rounds it


class BallSystem:
    """A system's rates of change in balls.

    Args:
        system: whose rates of change are meant.
        state: one, for the shapes.

    Attributes:
        form: of its states.
        size: n, how many numbers move: those of the state, and the time where rates depend on it.
        parameters: (m,) numbers in the system's fields, then those in its formulas.
        exact: whether all that is computed of them is balls; else some of it was rounded to doubles.
        timed: whether the last of the numbers that move is the time.
        looked_at: which parameters are taken as numbers, as the eccentricity of an orbit is, and cannot be balls.

    Raises:
        Untraceable: if rates are not made of operations that have a recurrence.
    """

    def __init__(self, system: AbstractSystem, state: Array) -> None:
        self.form = Form(np.shape(state), np.iscomplexobj(state))
        arrays, rest = eqx.partition(system, eqx.is_inexact_array)
        _, unravel = jax.flatten_util.ravel_pytree(arrays)
        self.exact = True
        try:
            parts = self._trace(lambda p: eqx.combine(unravel(p), rest), collect_numbers(system))
        except (*TRACING, TypeError, Untraceable):
            self.exact = False  # some are used as plain numbers, or by functions without a recurrence
            parts = self._trace(lambda p: system, np.zeros(0))
        self._tape, self._rates, self.size, self.parameters, self.timed = parts
        self.looked_at = sorted(place - self.size for place in self._tape.looked_at)
        slopes = [gradient(x) for x in self._rates]
        self._slopes = [x for row in slopes for x in row[: self.size]]
        self._by_parameters = [row[self.size :] for row in slopes]
        self._still = self._that_do_not_move()
        self._of_rates, self._of_slopes = self._steps_to(self._rates), self._steps_to(self._slopes)
        self._of_parameters = self._steps_to([x for row in self._by_parameters for x in row])

    def _trace(
        self, system_of: Callable[[Any], AbstractSystem], parameters: Array
    ) -> tuple[Tape, list[Expression], int, Array, bool]:
        form = self.form

        def everything(t: Any, numbers: Any, p: Any) -> Any:
            return form.numbers(rates_of_change(system_of(p), t, form.state(numbers)))

        closed = write_jaxpr(everything, (), (form.size,), np.shape(parameters))
        timed, count, kept = depends_on(closed, 0), len(parameters), numbers_in(closed) if self.exact else []
        size, parameters = form.size + timed, np.append(parameters, kept)
        tape = Tape(size + len(parameters), form.size if timed else None)
        tape.values = {size + k: float(x) for k, x in enumerate(parameters)}
        tape.kept = {x: size + count + k for k, x in enumerate(kept)} if self.exact else None
        known = np.empty(tape.size, object)
        known[:] = tape.state()
        t = np.asarray(known[form.size] if timed else 0.0, object if timed else float)
        with keep_numbers(tape):
            outputs = np.ravel(evaluate(closed, t, known[: form.size], known[size : size + count])[0])
        self.exact &= not (tape.rounded or OF_JAX.intersection(kept))
        rates = [tape_value(tape, x) for x in outputs] + [tape.constant(1.0)] * timed
        return tape, rates, size, parameters, timed

    def _that_do_not_move(self) -> list[bool]:
        still = [False] * self.size + [True] * (self._tape.size - self.size)
        for node in self._tape.nodes:
            still.append(all(still[k] for k in node.arguments))
        return still

    def _steps_to(self, outputs: list[Expression]) -> list[Step]:
        """Return the nodes that outputs are made of, in order, those with their companions as one."""
        steps: list[Step] = []
        for place in find_needed(self._tape, outputs):
            node = self._tape.nodes[place - self._tape.size]
            if node.operation not in ALONG:
                count = 1 + len(COMPANIONS.get(node.operation, ()))
                steps.append((place, node, RECURRENCES.get(node.operation), count))
        return steps

    def rates(self, y: list[Ball], parameters: list[Ball]) -> list[Ball]:
        """Return the rates of change at a point, or at all points of a box."""
        z = self._nodes(y, parameters, self._of_rates)
        return [_value(x, z) for x in self._rates]

    def slopes(self, y: list[Ball], parameters: list[Ball]) -> list[list[Ball]]:
        """Return the derivatives (n, n) of the rates by what moves."""
        z = self._nodes(y, parameters, self._of_slopes)
        flat = [_value(x, z) for x in self._slopes]
        return [flat[k * self.size : (k + 1) * self.size] for k in range(self.size)]

    def changes(self, y: list[Ball], parameters: list[Ball], radii: list[Ball]) -> list[Ball]:
        """Return bounds on how much the rates change when each parameter moves away from its midpoint by its radius."""
        z = self._nodes(y, parameters, self._of_parameters)
        bounds = []
        for row in self._by_parameters:
            parts = (abs(_value(x, z)) * r for x, r in zip(row, radii, strict=True) if x.terms or x.constant)
            bounds.append(sum(parts, abs(z[0]) * 0))
        return bounds

    def _nodes(self, y: list[Ball], parameters: list[Ball], steps: list[Step]) -> list[Ball]:
        z = [*y, *parameters, *[None] * len(self._tape.nodes)]
        for place, node, recurrence, count in steps:
            if recurrence is None:
                z[place] = _combine(node, z)
            else:
                z[place : place + count] = _values(recurrence, node, z)[:count]
        return z

    def coefficients(self, y: list[Ball], parameters: list[Ball], order: int) -> list[list[Ball]]:
        """Return the Taylor coefficients (n, order + 1) of the motion from a point."""
        first = self._nodes(y, parameters, self._of_rates)
        z: list[list[Ball]] = [[x] for x in first]
        moving = [self._series(step, z, first) for step in self._of_rates if not self._still[step[0]]]
        for k in range(1, order + 1):
            for i in range(self.size):
                x = self._rates[i]
                # y_k = f_{k−1}/k
                total = x.constant if k == 1 else 0
                for place, factor in x.terms.items():
                    if k == 1 or not self._still[place]:
                        total = z[place][k - 1] * factor + total
                z[i].append(total / k if total != 0 or k == 1 else z[i][0] * 0)
            for node, recurrence, x, own, number in moving:
                if recurrence is None:
                    own[0].append(_combination(node, z, k, self._still))
                    continue
                for series, value in zip(own, recurrence.coefficients(BALLS, k, x, own, number), strict=False):
                    series.append(value)
        return z[: self.size]

    def _series(self, step: Step, z: list[list[Ball]], first: list[Ball]) -> _Series:
        """Return what the coefficients of a step's results are found from."""
        place, node, recurrence, count = step
        own = z[place : place + count]
        if recurrence is not None:
            own += [[x] for x in _values(recurrence, node, first)[count:]]
        x = z[node.arguments[0]]
        return _Series(node, recurrence, x, own, type(x[0])(node.number))


class _Series(NamedTuple):
    """The coefficients of a step's argument and of its results, and the step's number as a ball."""

    node: Node
    recurrence: Recurrence | None
    argument: list[Ball]
    results: list[list[Ball]]
    number: Ball


def collect_numbers(system: AbstractSystem) -> Float64[np.ndarray, "parameters"]:
    """Return the numbers in a system's fields."""
    return np.asarray(jax.flatten_util.ravel_pytree(eqx.filter(system, eqx.is_inexact_array))[0], float)


def _value(x: Expression, z: list[Ball]) -> Ball:
    total = z[0] * 0 + x.constant
    for place, factor in x.terms.items():
        total += z[place] * factor
    return total


def _values(recurrence: Recurrence, node: Node, z: list[Ball]) -> Sequence[Ball]:
    """Return the values of a function's results."""
    x = z[node.arguments[0]]
    return recurrence.values(BALLS, x, type(x)(node.number))


def _combine(node: Node, z: list[Ball]) -> Ball:
    """Return the value of a sum or a product."""
    x = z[node.arguments[0]]
    if node.operation is Operation.PRODUCT:
        return x * x if node.arguments[0] == node.arguments[1] else x * z[node.arguments[1]]
    total = x * 0 + node.number
    for k, factor in zip(node.arguments, node.coefficients, strict=True):
        total += z[k] * factor
    return total


def eccentric_anomaly(mean_anomaly: Ball, eccentricity: Ball) -> Ball:
    """Return a ball with E of M = E − e sin E for each M in a ball, by Newton's method; infinite if none is proved.

    Source: Moore, *Methods and Applications of Interval Analysis*, §5.2: a ball that Newton's step maps into itself
    has one zero of each of the functions.
    """
    M, e = mean_anomaly, eccentricity
    middle, previous = M.mid() + e * M.mid().sin(), None
    for _ in range(60):
        middle = (middle - (middle - e * middle.sin() - M.mid()) / (1 - e * middle.cos())).mid()
        if previous is not None and middle == previous:
            break
        previous = middle
    missed = middle - e * middle.sin() - M
    tiny = 1e-300  # of a ball around a zero that is met exactly
    radius = 2 * (missed / (1 - e * middle.cos())).abs_upper() + tiny
    for _ in range(12):
        if not radius.is_finite():
            break
        # the interval Newton step N(B) = m − f(m)/f′(B): N(B) within B proves one zero in B, which is in N(B)
        ball = _ball(middle, radius)
        enclosure = middle - missed / (1 - e * ball.cos())
        if enclosure.is_finite() and ball.contains_interior(enclosure):
            return enclosure
        radius = radius * 2
    return M * math.inf


def _ball(middle: Ball, radius: Ball) -> Ball:
    """Return a ball around a number, a square around a complex one."""
    around = type(radius)(0, radius)
    return middle + (type(middle)(around, around) if hasattr(middle, "complex_rad") else around)


class _Balls(Words):
    """The words of ``recurrences`` for balls; NaN where a complex one meets a branch cut."""

    exponential, exponential_minus_one = operator.methodcaller("exp"), operator.methodcaller("expm1")
    sine, cosine, hyperbolic_tangent = (operator.methodcaller(name) for name in ("sin", "cos", "tanh"))
    eccentric_anomaly = staticmethod(eccentric_anomaly)

    def total(self, first: Any, stop: Any, start: Any, terms: Callable[[Any], Any]) -> Any:
        if isinstance(start, tuple):
            return self.totals(first, stop, start, terms)
        return sum(map(terms, range(first, stop)), start)

    def totals(self, first: Any, stop: Any, starts: tuple[Any, ...], terms: Callable[[Any], Any]) -> Sequence[Ball]:
        return tuple(map(sum, zip(*map(terms, range(first, stop)), strict=True), starts)) or starts

    def squared_secant(self, x: Ball) -> Ball:
        return x.sech() ** 2

    def logarithm(self, x: Ball) -> Ball:
        return _analytic(x, "log")

    def logarithm_of_one_plus(self, x: Ball) -> Ball:
        return _analytic(x + 1, "log") if hasattr(x, "complex_rad") else x.log1p()

    def raise_power(self, x: Ball, exponent: Ball) -> Ball:
        p = float(exponent.mid().real)
        if p.is_integer():
            return x ** int(p)
        if (2.0 * p).is_integer():
            return _analytic(x, "sqrt") ** int(2.0 * p)
        return (_analytic(x, "log") * exponent).exp()


BALLS = _Balls()


def _analytic(x: Ball, function: str) -> Ball:
    """Return a square root or logarithm, not a number where a complex ball meets the branch cut."""
    is_complex = hasattr(x, "complex_rad")
    return getattr(x, function)(analytic=True) if is_complex else getattr(x, function)()


def _combination(node: Node, z: list[list[Ball]], k: int, still: list[bool]) -> Ball:
    """Return the k-th coefficient of a sum or a product, k > 0."""
    a = node.arguments[0]
    x = z[a]
    if node.operation is Operation.PRODUCT:
        b = node.arguments[1]
        if still[a] or still[b]:
            constant, moving = (a, b) if still[a] else (b, a)
            return z[constant][0] * z[moving][k]
        return sum(map(operator.mul, x[: k + 1], reversed(z[b][: k + 1])), x[0] * 0)
    total = x[0] * 0
    for other, factor in zip(node.arguments, node.coefficients, strict=True):
        if not still[other]:
            total += z[other][k] * factor
    return total

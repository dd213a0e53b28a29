"""Branches on moving values: a program holds on one side of each, and a step ends where the motion goes to the other.

A field with corners or jumps, such as the greater of two numbers, is smooth between them. Its program is written for
the sides on which the motion is; the differences that tell the sides are watched as events are, so that no crossing is
missed, and from there the motion goes on by the program of the other side.

Source: Filippov, *Differential Equations with Discontinuous Righthand Sides* (1988), §4; Hairer, Nørsett & Wanner,
*Solving Ordinary Differential Equations I* (1993), §II.6, "switching functions".
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from polhode.taylor.expressions import Expression, Tape, Untraceable
from polhode.taylor.operations import Node, Operation, squared_secant, value_of
from polhode.types import Array, Float64

Signs = tuple[bool, ...]


class SideLimits(NamedTuple):
    """Thresholds that determine on which side of a branch a motion goes on."""

    max_at_border: float = 1e-12  # of the terms of a difference: nearer to zero the direction of the motion decides
    max_beyond_border: float = 1e-9  # of the terms of a difference: by more, a crossing went undetected
    min_slope: float = 1e-9  # of the terms of its slope: a smaller slope gives no direction
    ratio_rounding: float = 4.0 * float(np.finfo(float).eps)  # of coefficients: one difference is a multiple of another
    max_rounds: int = 8  # in which the sides of all branches must agree


LIMITS = SideLimits()


class Sides:
    """The branches on moving values that a tape has met, in the order of a function's comparisons.

    Args:
        signs: whether each difference is taken to be positive; of further ones the values at the point decide.
        point: components of the state.
    """

    def __init__(self, signs: Signs, point: Float64[np.ndarray, "n"]) -> None:
        self.signs, self._point = list(signs), point
        self.differences: list[Expression | None] = []
        self._values: list[Any] = []

    def is_positive(self, difference: Expression) -> bool:
        """Return whether a difference counts as positive, or zero; one that was met before, times a number, is that."""
        for j, known in enumerate(self.differences):
            if known is not None and (factor := ratio(difference, known)):
                return self.signs[j] == (factor > 0.0)
        k = len(self.differences)
        self.differences.append(difference)
        if k == len(self.signs):
            self.signs.append(bool(self._value(difference) >= 0.0))
        return self.signs[k]

    def is_known(self, answer: bool) -> bool:
        """Return the answer to a branch on numbers alone, which has its place in the order as well."""
        k = len(self.differences)
        self.differences.append(None)
        self.signs[k : k + 1] = [answer]
        return answer

    def _value(self, difference: Expression) -> Any:
        tape = difference.tape
        extend_values(tape, list(self._point), self._values)
        return combine(difference, [*self._point, *self._values])[0]

    def list_moving(self) -> list[tuple[int, Expression]]:
        """Return the differences that move, with their places in the order."""
        return [(k, x) for k, x in enumerate(self.differences) if x is not None]


def ratio(one: Expression, other: Expression) -> float:
    """Return the ratio of two expressions, constant to rounding; zero if they have none."""
    if one.terms.keys() != other.terms.keys():
        return 0.0
    first = next(iter(other.terms))
    factor = one.terms[first] / other.terms[first]
    pairs = [(one.terms[k], factor * c) for k, c in other.terms.items()] + [(one.constant, factor * other.constant)]
    return factor if all(abs(a - b) <= LIMITS.ratio_rounding * abs(b) for a, b in pairs) else 0.0


def combine(x: Expression, values: list[Any], sizes: list[Any] | None = None) -> tuple[Any, Any]:
    """Return the value of an expression, and the size of its terms, whose own sizes may be larger than their values."""
    value, size = x.constant, abs(x.constant)
    for k, c in x.terms.items():
        term = c * values[k]
        value, size = value + term, size + (abs(term) if sizes is None else abs(c) * sizes[k])
    return value, size


def sizes_of(tape: Tape, values: list[Any]) -> list[Any]:
    """Return the sizes of the terms of which components and nodes are sums, and which may cancel."""
    sizes = [abs(value) for value in values]
    for k, node in enumerate(tape.nodes, tape.size):
        match node.operation:
            case Operation.AFFINE:
                parts = zip(node.coefficients, node.arguments, strict=True)
                sizes[k] = abs(node.number) + sum(abs(c) * sizes[i] for c, i in parts)
            case Operation.PRODUCT:
                sizes[k] = sizes[node.arguments[0]] * sizes[node.arguments[1]]
            case _:
                pass
    return sizes


def extend_values(tape: Tape, components: list[Any], values: list[Any]) -> None:
    """Append the values of nodes that a list does not have yet."""
    known = [*components, *values]
    for node in tape.nodes[len(values) :]:
        value = value_of(node, [known[k] for k in node.arguments])
        values.append(value)
        known.append(value)


def _slope(node: Node, value: Any, x: list[Any], dx: list[Any]) -> Any:
    match node.operation:
        case Operation.AFFINE:
            return sum(c * v for c, v in zip(node.coefficients, dx, strict=True))
        case Operation.PRODUCT:
            return dx[0] * x[1] + x[0] * dx[1]
        case Operation.POWER:
            return node.number * value / x[0] * dx[0]
        case Operation.EXPONENTIAL:
            return value * dx[0]
        case Operation.LOGARITHM:
            return dx[0] / x[0]
        case Operation.SINE:
            return np.cos(x[0]) * dx[0]
        case Operation.COSINE:
            return -np.sin(x[0]) * dx[0]
        case Operation.TANH:
            return squared_secant(x[0]) * dx[0]
        case Operation.SQUARED_SECANT:
            return -2.0 * value * x[1] * dx[0]
        case Operation.EXPONENTIAL_MINUS_ONE:
            return (value + 1.0) * dx[0]
        case Operation.LOGARITHM_OF_ONE_PLUS:
            return dx[0] / (1.0 + x[0])
        case Operation.ECCENTRIC:
            return dx[0] / (1.0 - node.number * np.cos(value))
        case Operation.ECCENTRIC_SINE:
            return np.cos(x[1]) * dx[1]
        case Operation.ECCENTRIC_COSINE:
            return -np.sin(x[1]) * dx[1]


class Branches:
    """The differences whose signs are the sides of a program, at states of many copies.

    Args:
        tape: of the program.
        rates: of all its components.
        sides: that it was written for.
    """

    def __init__(self, tape: Tape, rates: list[Expression], sides: Sides) -> None:
        self._tape, self._rates = tape, rates
        self.signs: Signs = tuple(sides.signs)
        self._moving = sides.list_moving()

    @property
    def watched(self) -> list[Expression]:
        """The differences, positive on the side where they are."""
        return [x if self.signs[k] else -x for k, x in self._moving]

    def place(self, watched: int) -> int:
        """Return which branch a watched difference belongs to."""
        return self._moving[watched][0]

    def _values(self, y: Float64[np.ndarray, "copies n"]) -> list[Any]:
        """Return the values of components and nodes: of one copy plain numbers, with which Python is faster."""
        components: list[Any] = y[0].tolist() if len(y) == 1 else list(y.T)
        values: list[Any] = []
        extend_values(self._tape, components, values)
        return [*components, *values]

    def slope_along(self, branch: int, y: Float64[np.ndarray, "1 n"], direction: Float64[np.ndarray, "n"]) -> float:
        """Return the derivative of a branch's difference at one copy, along a direction of its components."""
        known, slopes = self._values(y), direction.tolist()
        self._append_slopes(known, slopes)
        difference = next(x for k, x in self._moving if k == branch)
        return float(combine(Expression(self._tape, difference.terms), slopes)[0])

    def _append_slopes(self, known: list[Any], slopes: list[Any]) -> None:
        """Append the derivatives of nodes to those of the components."""
        for node in self._tape.nodes:
            x, dx = [known[k] for k in node.arguments], [slopes[k] for k in node.arguments]
            slopes.append(_slope(node, known[len(slopes)], x, dx))

    def rates_at(self, y: Float64[np.ndarray, "1 n"]) -> Float64[np.ndarray, "n"]:
        """Return the rates of one copy on these sides."""
        known = self._values(y)
        return np.array([combine(rate, known)[0] for rate in self._rates])

    def hold(self, y: Float64[np.ndarray, "copies n"]) -> bool:
        """Return whether copies are on these sides, or at their borders, within rounding."""
        known = self._values(y)
        sizes = sizes_of(self._tape, known)
        for x in self.watched:
            value, size = combine(x, known, sizes)
            if np.any(value < -LIMITS.max_beyond_border * size):
                return False
        return True

    def touches_border(self, y: Float64[np.ndarray, "copies n"]) -> bool:
        """Return whether a copy is at a border, within rounding."""
        known = self._values(y)
        sizes = sizes_of(self._tape, known)
        each = (combine(x, known, sizes) for x in self.watched)
        return any(np.any(abs(value) <= LIMITS.max_at_border * size) for value, size in each)

    def sides_of(
        self, y: Float64[np.ndarray, "copies n"], crossed: Array, forth: float, units: Float64[np.ndarray, "copies"],
    ) -> list[Signs]:
        """Return on which side of each difference copies go on, by the rates of the sides of this program.

        Args:
            y: their components.
            forth: 1, or −1 backward in time.
            crossed: (C,) places in the order of branches that they are at the border of, −1 for none.
            units: (C,) of time, such as the lengths of their steps: borders that are crossed within a rounding of
                one time are crossed together.

        Raises:
            Untraceable: where a motion goes along a border, or only touches it.
        """
        known = self._values(y)
        sizes = sizes_of(self._tape, known)
        slopes: list[Any] = [combine(rate, known)[0] for rate in self._rates]
        signs = np.tile(self.signs, (len(y), 1))
        self._append_slopes(known, slopes)
        with np.errstate(invalid="ignore"):
            for k, difference in self._moving:
                value, size = combine(difference, known, sizes)
                slope, steepness = combine(Expression(self._tape, difference.terms), slopes)
                near = (abs(value) <= LIMITS.max_at_border * np.maximum(size, abs(slope) * units)) | (crossed == k)
                if np.any(near & np.logical_not(abs(slope) > LIMITS.min_slope * steepness)):
                    raise Untraceable("a branch on something that moves, along whose border the motion goes")
                signs[:, k] = np.where(near, forth * slope > 0.0, value > 0.0)
        return [tuple(map(bool, row)) for row in signs]


@np.errstate(divide="ignore", invalid="ignore", over="ignore")  # a NaN has no side
def settle(
    branches_of: Callable[[Signs], Branches], y: Float64[np.ndarray, "copies n"], signs: list[Signs], crossed: Array,
    forth: float, units: Float64[np.ndarray, "copies"],
) -> list[Signs]:
    """Return the sides on which copies go on.

    Args:
        branches_of: returns the branches of the program for given sides.
        y: components of the copies.
        signs: the sides where they come from.
        crossed, forth, units: as of ``Branches.sides_of``.

    Raises:
        Untraceable: where no side can be determined, as where both sides lead back to a border.
    """
    signs = list(signs)
    waiting = np.ones(len(y), bool)
    for _ in range(LIMITS.max_rounds):
        for each in set(signs[k] for k in np.flatnonzero(waiting)):
            some = np.array([k for k in np.flatnonzero(waiting) if signs[k] == each])
            now = branches_of(each).sides_of(y[some], crossed[some], forth, units[some])
            for k, side in zip(some, now, strict=True):
                waiting[k] = side != each
                signs[k] = side
        if not waiting.any():
            return signs
    raise Untraceable("a branch on something that moves, whose sides lead back to each other")

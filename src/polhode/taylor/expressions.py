"""Affine expressions of nodes, and the tape of nodes that a vector field is made of.

A node is a component of the state, or the result of one operation on nodes: an affine combination, a product, a power,
a function such as a sine with its cosine, a place in Kepler's orbit. Taylor coefficients of each obey a
recurrence in those of its arguments, so that a field which is a tape needs nothing else to be integrated.

Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §2.1; Moore, *Methods and Applications of Interval Analysis*, §3.4.
"""

from __future__ import annotations

import heapq
import math
import operator
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from polhode._base.jaxprs import NoRule
from polhode.taylor.operations import ALONG, COMPANIONS, IN_ORBIT, Node, Operation, value_of
from polhode.types import Array, Bool


class TapeLimits(NamedTuple):
    """The size of a tape."""

    max_nodes: int = 40_000  # larger fields are better stepped by operations on whole arrays


LIMITS = TapeLimits()


class Untraceable(NoRule):
    """A field with an operation that a tape does not have, which the message names.

    ``copies`` (C,) says which of a batch come to it; it is None where all do.
    """

    def __init__(self, what: str, copies: Bool[Array, "copies"] | None = None) -> None:
        super().__init__(what)
        self.copies = copies


class Tape:
    """Nodes, each once: 0 … size − 1 are the state, the others come in the order in which they can be computed.

    Args:
        size: of the state.
        clock: which of its components is the time, or None.
        instants: times between two jumps of the rates, at which branches on the time must agree.
    """

    def __init__(self, size: int, clock: int | None = None, instants: Any = ()) -> None:
        self.size, self.clock, self.instants = size, clock, np.asarray(instants, float)
        self.nodes: list[Node] = []
        self.values: dict[int, float] = {}  # of components that do not move
        self.looked_at: set[int] = set()  # of these, where an operation takes the number itself
        self.sides: Any = None  # ``sides.Sides``, where branches on moving values are taken
        self.kept: dict[float, int] | None = None  # places of numbers that are on the tape and not computed with
        self.rounded = False  # whether numbers were computed with in spite of that, and rounded
        self._known: dict[Node, int] = {}

    def state(self) -> list[Expression]:
        """Return the components of the state."""
        return [Expression(self, {k: 1.0}) for k in range(self.size)]

    def constant(self, value: float) -> Expression:
        """Return a number as an expression."""
        return Expression(self, {}, float(value))

    def keep(self, numbers: Any) -> Any:
        """Return those of an array's numbers that are kept as expressions, so that nothing is computed of them."""
        kept = self.kept
        if not kept or numbers.dtype == object or not np.issubdtype(numbers.dtype, np.inexact):
            return numbers
        place_of = lambda x: Expression(self, {kept[x]: 1.0}) if x in kept else x  # noqa: E731
        values = [Complex(place_of(x.real), place_of(x.imag)) if isinstance(x, complex) else place_of(x)
                  for x in np.ravel(numbers).tolist()]
        if not any(isinstance(x, Expression | Complex) for x in values):
            return numbers
        result = np.empty(len(values), object)
        result[:] = values
        return result.reshape(numbers.shape)

    def _watch(self, operation: Callable[[Any, Any], Any]) -> Callable[[float, float], float]:
        """Return an operation on two numbers, which notes where numbers are kept whether its result is rounded."""
        if self.kept is None:
            return operation

        def compute(a: float, b: float) -> float:
            value = operation(a, b)
            if not self.rounded:
                finite = all(map(math.isfinite, (a, b, value)))
                self.rounded = not finite or operation(Fraction(a), Fraction(b)) != Fraction(value)
            return value

        return compute

    @property
    def add(self) -> Callable[[float, float], float]:
        """How numbers are added."""
        return self._watch(operator.add)

    @property
    def multiply(self) -> Callable[[float, float], float]:
        """How numbers are multiplied."""
        return self._watch(operator.mul)

    @property
    def divide(self) -> Callable[[float, float], float]:
        """How numbers are divided."""
        return self._watch(operator.truediv)

    def function(self, function: Callable[[Any], float], x: float | Fraction) -> Expression:
        """Return a function of a number, which is taken for rounded but where it is of 0, or 0 or 1 of 1."""
        value = function(x)
        if self.kept is not None and not (x == 0.0 or (x == 1.0 and value in (0.0, 1.0))):
            self.rounded = True
        return self.constant(value)

    def find_number(self, x: Any) -> float | None:
        """Return the value of an expression that is a given number, and note that it was used."""
        if not isinstance(x, Expression):
            return float(x)
        if not x.terms:
            return x.constant
        (place, factor), *more = x.terms.items()
        if more or factor != 1.0 or x.constant or place not in self.values:
            return None
        self.looked_at.add(place)
        return self.values[place]

    def node(self, node: Node) -> int:
        """Return the number of a node, a new one if there is none like it."""
        if node not in self._known:
            if len(self.nodes) >= LIMITS.max_nodes:
                raise Untraceable(f"more than {LIMITS.max_nodes} operations")
            self.nodes.append(node)
            self._known[node] = self.size + len(self.nodes) - 1
        return self._known[node]

    def as_node(self, x: Expression) -> tuple[int, float]:
        """Return a node and the factor by which an expression is that node; sums equal up to sign are one node."""
        if x.as_node is None:  # as an element of a matrix is a factor of as many products as a row is long
            x.as_node = self._find_node(x)
        return x.as_node

    def _find_node(self, x: Expression) -> tuple[int, float]:
        if len(x.terms) == 1 and x.constant == 0.0:
            return next(iter(x.terms.items()))
        items = sorted(x.terms.items())
        sign = 1.0 if items[0][1] > 0.0 else -1.0
        places, factors = zip(*items, strict=True)
        coefficients = tuple(sign * c for c in factors)
        return self.node(Node(Operation.AFFINE, places, coefficients, sign * x.constant)), sign

    def at_instants(self, x: Any) -> np.ndarray:
        """Return the values of an expression of the time alone at the instants by which branches are chosen.

        Raises:
            Untraceable: if it depends on something else, or if no jump is named between which a branch could be chosen.
        """
        if not isinstance(x, Expression):
            return np.full(len(self.instants), float(x))
        return np.full(len(self.instants), x.constant) + sum(c * self._node_at(k) for k, c in x.terms.items())

    def _node_at(self, place: int) -> Any:
        if place < self.size:
            if place != self.clock:
                raise Untraceable("a branch on something that moves")
            if not len(self.instants):
                raise Untraceable("a branch on the time, at which no jump is named")
            return self.instants
        node = self.nodes[place - self.size]
        values = [self._node_at(k) for k in (node.arguments[:1] if node.operation in ALONG else node.arguments)]
        if node.operation in IN_ORBIT:
            raise Untraceable("a branch on a place in an orbit")
        return value_of(node, values)

    def decide(self, answers: np.ndarray) -> bool:
        """Return the value of a branch on the time, which must be equal at all instants."""
        if answers.any() != answers.all():
            raise Untraceable("a branch on the time that changes where no jump is named")
        return bool(answers.all())

    def relation(self, x: Any, y: Any, holds: Callable[[Any, Any], Any]) -> bool:
        """Return whether a relation of sizes holds between two expressions or numbers, where a branch asks for it.

        What moves is equal to something else for no time, but as it may stay so, where it does is a border.

        Raises:
            Untraceable: for moving values, where no sides of branches are taken.
        """
        difference = (x if isinstance(x, Expression) else self.constant(float(x))) - y
        if not difference.terms:
            answer = bool(holds(difference.constant, 0.0))
            return answer if self.sides is None else self.sides.is_known(answer)
        if self.sides is None:
            return self.decide(holds(self.at_instants(x), self.at_instants(y)))
        if len(self.instants):
            try:
                return self.sides.is_known(self.decide(holds(self.at_instants(x), self.at_instants(y))))
            except Untraceable:
                pass  # it depends on more than the time, or changes where no jump is named
        return bool(holds(1.0 if self.sides.is_positive(difference) else -1.0, 0.0))

    def total(self, summands: Iterable[Any]) -> Expression:
        """Return a sum of expressions and numbers."""
        terms: dict[int, float] = {}
        constant, add = 0.0, self.add
        for x in summands:
            if isinstance(x, Expression):
                constant = add(constant, x.constant)
                for k, c in x.terms.items():
                    terms[k] = add(terms.get(k, 0.0), c)
            else:
                constant = add(constant, float(x))
        return Expression(self, {k: c for k, c in terms.items() if c != 0.0}, constant)

    def product(self, x: Expression, y: Expression) -> Expression:
        """Return x y."""
        (i, a), (j, b) = self.as_node(x), self.as_node(y)
        return Expression(self, {self.node(Node(Operation.PRODUCT, (min(i, j), max(i, j)))): self.multiply(a, b)})

    def unary(self, operation: Operation, x: Expression, number: float = 0.0) -> Expression:
        """Return a function of an expression."""
        place, factor = self.as_node(x)
        if factor != 1.0:  # these functions are not homogeneous
            place = self.node(Node(Operation.AFFINE, (place,), (factor,)))
        node = self.node(Node(operation, (place,), (), number))
        for companion in COMPANIONS.get(operation, ()):
            self.node(Node(companion, (place, node)))
        return Expression(self, {node: 1.0})


def gradient(x: Expression) -> list[Expression]:
    """Return the derivatives of an expression by the components of the state, as expressions of its tape."""
    tape = x.tape
    # what a node gets from those that depend on it is added up once, when all of them have been
    slopes: dict[int, list[Expression]] = {k: [tape.constant(c)] for k, c in x.terms.items()}
    waiting = [-k for k in slopes if k >= tape.size]
    heapq.heapify(waiting)
    while waiting:
        place = -heapq.heappop(waiting)
        by = _sum(tape, slopes.pop(place))
        for argument, slope in _slopes(tape, place, tape.nodes[place - tape.size]):
            if argument not in slopes:
                slopes[argument] = [tape.constant(0.0)]
                if argument >= tape.size:
                    heapq.heappush(waiting, -argument)
            slopes[argument].append(by * slope)
    return [_sum(tape, slopes.get(k, ())) for k in range(tape.size)]


def _sum(tape: Tape, summands: Sequence[Expression]) -> Expression:
    return summands[0] if len(summands) == 1 else tape.total(summands)


def _slopes(tape: Tape, place: int, node: Node) -> list[tuple[int, Any]]:
    """Return the derivatives of a node by its arguments."""
    z = [Expression(tape, {k: 1.0}) for k in node.arguments]
    own = Expression(tape, {place: 1.0})
    match node.operation:
        case Operation.AFFINE:
            return list(zip(node.arguments, node.coefficients, strict=True))
        case Operation.PRODUCT:
            return [(node.arguments[0], z[1]), (node.arguments[1], z[0])]
        case Operation.POWER:
            return [(node.arguments[0], node.number * z[0] ** (node.number - 1.0))]
        case Operation.EXPONENTIAL:
            return [(node.arguments[0], own)]
        case Operation.LOGARITHM:
            return [(node.arguments[0], z[0] ** -1.0)]
        case Operation.SINE:
            return [(node.arguments[0], Expression(tape, {place + 1: 1.0}))]
        case Operation.COSINE:  # whose second argument only says which sine goes with it
            return [(node.arguments[0], -z[1])]
        case Operation.TANH:
            return [(node.arguments[0], Expression(tape, {place + 1: 1.0}))]
        case Operation.SQUARED_SECANT:  # it follows its tanh
            return [(node.arguments[0], own * z[1] * -2.0)]
        case Operation.EXPONENTIAL_MINUS_ONE:
            return [(node.arguments[0], own + 1.0)]
        case Operation.LOGARITHM_OF_ONE_PLUS:
            return [(node.arguments[0], (z[0] + 1.0) ** -1.0)]
        case Operation.ECCENTRIC:
            cosine = Expression(tape, {place + 2: 1.0})
            # dE/dM = 1/(1 − e cos E)
            return [(node.arguments[0], (1.0 - node.number * cosine) ** -1.0)]
        case Operation.ECCENTRIC_SINE:
            return [(node.arguments[1], Expression(tape, {place + 1: 1.0}))]
        case _:
            return [(node.arguments[1], Expression(tape, {place - 1: -1.0}))]


class Expression:
    """c + Σ cᵢ zᵢ over nodes zᵢ of one tape."""

    __slots__ = ("as_node", "constant", "tape", "terms")
    __array_priority__ = 1000.0

    def __init__(self, tape: Tape, terms: dict[int, float], constant: float = 0.0) -> None:
        self.tape, self.terms, self.constant = tape, terms, constant
        self.as_node: tuple[int, float] | None = None  # what ``Tape.as_node`` gives, once it has been asked for

    def _like(self, other: Any) -> Expression:
        return other if isinstance(other, Expression) else Expression(self.tape, {}, float(other))

    def scale(self, factor: float) -> Expression:
        """Return a multiple."""
        if factor == 0.0:
            return Expression(self.tape, {})
        multiply = self.tape.multiply
        return Expression(self.tape, {k: multiply(c, factor) for k, c in self.terms.items()},
                          multiply(self.constant, factor))

    def __add__(self, other: Any) -> Any:
        if isinstance(other, Complex | complex):
            return Complex.of(other) + self
        return total(self.tape, (self, self._like(other)))

    __radd__ = __add__

    def __neg__(self) -> Expression:
        return self.scale(-1.0)

    def __sub__(self, other: Any) -> Any:
        return self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return (-self) + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Complex | complex):
            return Complex.of(other) * self
        if not isinstance(other, Expression):
            return self.scale(float(other))
        if not self.terms:
            return other.scale(self.constant)
        return self.tape.product(self, other) if other.terms else self.scale(other.constant)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, Complex | complex):
            return Complex.of(self) / other
        if isinstance(other, Expression) and other.terms:
            return self * other**-1.0
        divisor = other.constant if isinstance(other, Expression) else float(other)
        if divisor == 0.0:
            raise Untraceable("a division by zero")
        # divided, not multiplied by the reciprocal, which would round twice
        divide = self.tape.divide
        return Expression(self.tape, {k: divide(c, divisor) for k, c in self.terms.items()},
                          divide(self.constant, divisor))

    def __rtruediv__(self, other: Any) -> Expression:
        return self**-1.0 * other

    def __pow__(self, exponent: float) -> Expression:
        exponent = float(exponent)
        if not self.terms:
            return self.tape.function(lambda x: x**exponent, self.constant)
        whole = int(exponent) if exponent.is_integer() and 0.0 <= exponent <= 64.0 else None
        if whole is None:
            return self.tape.unary(Operation.POWER, self, exponent)
        if whole == 0:
            return Expression(self.tape, {}, 1.0)
        half = self ** (whole // 2) if whole > 1 else None
        square = self if half is None else half * half
        return square if half is None or whole % 2 == 0 else square * self


class Complex:
    """A complex number whose parts are expressions or numbers."""

    __slots__ = ("imag", "real")
    __array_priority__ = 2000.0

    def __init__(self, real: Any, imag: Any) -> None:
        self.real, self.imag = real, imag

    @staticmethod
    def of(x: Any) -> Complex:
        """Return anything as such a number."""
        if isinstance(x, Complex):
            return x
        return Complex(x, 0.0) if isinstance(x, Expression) else Complex(float(x.real), float(x.imag))

    def conjugate(self) -> Complex:
        return Complex(self.real, -self.imag)

    def __neg__(self) -> Complex:
        return Complex(-self.real, -self.imag)

    def __add__(self, other: Any) -> Complex:
        other = Complex.of(other)
        return Complex(self.real + other.real, self.imag + other.imag)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Complex:
        return self + (-Complex.of(other))

    def __rsub__(self, other: Any) -> Complex:
        return (-self) + other

    def __mul__(self, other: Any) -> Complex:
        other = Complex.of(other)
        return Complex(self.real * other.real - self.imag * other.imag,
                       self.real * other.imag + self.imag * other.real)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Complex:
        other = Complex.of(other)
        # w/z = w z̄/|z|²
        square = other.real * other.real + other.imag * other.imag
        product = self * other.conjugate()
        return Complex(product.real / square, product.imag / square)

    def __rtruediv__(self, other: Any) -> Complex:
        return Complex.of(other) / self

    def __pow__(self, exponent: float) -> Complex:
        if not (float(exponent).is_integer() and 1 <= exponent <= 64):
            raise Untraceable(f"a complex number to the power {exponent:g}")
        result = self
        for _ in range(int(exponent) - 1):
            result = result * self
        return result


def total(tape: Tape, summands: Iterable[Any]) -> Any:
    """Return a sum of expressions, numbers and complex ones; of expressions alone in one pass."""
    plain, complex_part = [], None
    for x in summands:
        if isinstance(x, Complex | complex):
            complex_part = Complex.of(x) if complex_part is None else complex_part + x
        else:
            plain.append(x)
    expression = tape.total(plain)
    return expression if complex_part is None else complex_part + expression

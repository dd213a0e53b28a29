"""The recurrences of Taylor coefficients: each operation's formula, written once over the words of an implementation.

A formula of coefficients yields those of all results of an operation, one after the other, of an order k > 0:

    w: see ``Words``.
    k: the order.
    x: coefficients of the argument, ``x[j]`` that of order j.
    own: those of the results, each known from where it is yielded.
    number: an exponent or an eccentricity.

A formula of values has functions of numbers by their names in ``vectors``.

``loops`` prints the formulas for Python and Numba, ``straight_line`` writes them as machine code, ``array_rules`` runs
them on arrays of JAX, and ``proving.enclosures`` on balls. Sums are taken from the lowest j up and products as their
parentheses say, so that Python, Numba and machine code agree to the last bit. Arrays multiply by weights last.

Products have no row: their coefficients are Cauchy's Σ_{j≤k} a_j b_{k−j}, whose newest factors kernels add last, see
``kernel_lanes``. ``kernel_extended`` has the power's formula once more, for pairs.

Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §2.1; Griewank & Walther, *Evaluating Derivatives*, ch. 13.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from polhode.taylor.operations import Operation


class Words:
    """What an implementation computes with; a formula of values calls functions of numbers too."""

    def total(self, first: Any, stop: Any, start: Any, terms: Callable[[Any], Any]) -> Any:
        """Return start + terms(first) + … + terms(stop − 1), or as many sums as there are starts."""
        if isinstance(start, tuple):
            return self.totals(first, stop, start, terms)
        return self.totals(first, stop, (start,), lambda j: (terms(j),))[0]

    def totals(self, first: Any, stop: Any, starts: tuple[Any, ...], terms: Callable[[Any], Any]) -> Sequence[Any]:
        """Return a sum for each start; ``terms(j)`` has as many terms."""
        raise NotImplementedError

    def share(self, x: Any) -> Any:
        """Return what is needed twice."""
        return x


class Word:
    """An operand of which an implementation says what its operations are."""

    def operate(self, symbol: str, left: Any, right: Any) -> Any:
        """Return the result of an operation on this word and a word or number, on either side of it."""
        raise NotImplementedError

    def __neg__(self) -> Any:
        return self.operate("*", -1.0, self)

    def __add__(self, other: Any) -> Any:
        return self.operate("+", self, other)

    def __radd__(self, other: Any) -> Any:
        return self.operate("+", other, self)

    def __sub__(self, other: Any) -> Any:
        return self.operate("-", self, other)

    def __rsub__(self, other: Any) -> Any:
        return self.operate("-", other, self)

    def __mul__(self, other: Any) -> Any:
        return self.operate("*", self, other)

    def __rmul__(self, other: Any) -> Any:
        return self.operate("*", other, self)

    def __truediv__(self, other: Any) -> Any:
        return self.operate("/", self, other)


class Coefficients:
    """The coefficients of a node, which an implementation finds by their order."""

    def __init__(self, find: Callable[[Any], Any]) -> None:
        self._find = find

    def __getitem__(self, order: Any) -> Any:
        return self._find(order)


class Recurrence(NamedTuple):
    """The formulas of an operation.

    Attributes:
        results: how many there are: the operation's own, its companions', and those that serve the formula alone.
        values: (w, value of the argument, number) → those of the results.
        coefficients: (w, k, x, own, number) → those of order k.
    """

    results: int
    values: Callable[[Any, Any, Any], tuple[Any, ...]]
    coefficients: Callable[[Any, Any, Any, Any, Any], Iterator[Any]]


def _power(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # u = x^p: x u̇ = p u ẋ, so that k x₀ u_k = Σ_{j<k} (p(k−j) − j) u_j x_{k−j}
    (u,) = own
    yield w.total(0, k, 0.0, lambda j: (number * (k - j) - j) * (u[j] * x[k - j])) / (k * x[0])


def _exponential(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # u = e^x: u̇ = u ẋ, so that k u_k = Σ_{j<k} (k−j) u_j x_{k−j}
    (u,) = own
    yield w.total(0, k, 0.0, lambda j: (k - j) * (u[j] * x[k - j])) / k


def _exponential_minus_one(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # u̇ = (u + 1) ẋ
    (u,) = own
    yield w.total(0, k, k * x[k], lambda j: (k - j) * (u[j] * x[k - j])) / k


def _logarithm(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # x u̇ = ẋ, so that k x₀ u_k = k x_k − Σ_{0<j<k} j u_j x_{k−j}
    (u,) = own
    yield (x[k] - w.total(1, k, 0.0, lambda j: j * (u[j] * x[k - j])) / k) / x[0]


def _logarithm_of_one_plus(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # (1 + x) u̇ = ẋ
    (u,) = own
    yield (x[k] - w.total(1, k, 0.0, lambda j: j * (u[j] * x[k - j])) / k) / (1.0 + x[0])


def _circular(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # ṡ = c ẋ, ċ = −s ẋ
    s, c = own

    def terms(j: Any) -> tuple[Any, Any]:
        weight = w.share((k - j) * x[k - j])
        return weight * c[j], -(weight * s[j])

    of_sine, of_cosine = w.total(0, k, (0.0, 0.0), terms)
    yield of_sine / k
    yield of_cosine / k


def _hyperbolic(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # u = tanh x and v = 1/cosh² x: u̇ = v ẋ, v̇ = −2 u u̇
    u, v = own
    yield w.total(0, k, 0.0, lambda j: (k - j) * (x[k - j] * v[j])) / k
    yield -2.0 * w.total(0, k, 0.0, lambda j: (k - j) * (u[k - j] * u[j])) / k


def _place_values(w: Any, x: Any, number: Any) -> tuple[Any, ...]:
    anomaly = w.eccentric_anomaly(x, number)
    half = w.share(w.sine(0.5 * anomaly))
    # 1 − e cos E, which may be small, with all its digits
    return anomaly, w.sine(anomaly), w.cosine(anomaly), (1.0 - number) + (2.0 * number) * half * half


def _place(w: Any, k: Any, x: Any, own: Any, number: Any) -> Iterator[Any]:
    # (1 − e cos E) Ė = Ṁ, so that k (1 − e c₀) E_k = k M_k + e Σ_{0<j<k} j E_j c_{k−j}
    anomaly, s, c, divisor = own
    yield w.total(1, k, k * x[k], lambda j: number * (j * (anomaly[j] * c[k - j]))) / (k * divisor[0])

    def terms(j: Any) -> tuple[Any, Any]:
        # ṡ = c Ė, ċ = −s Ė, where E_k is known by now
        weight = w.share(j * anomaly[j])
        return weight * c[k - j], -(weight * s[k - j])

    of_sine, of_cosine = w.total(1, k + 1, (0.0, 0.0), terms)
    yield of_sine / k
    yield of_cosine / k


RECURRENCES = {
    Operation.POWER: Recurrence(1, lambda w, x, p: (w.raise_power(x, p),), _power),
    Operation.EXPONENTIAL: Recurrence(1, lambda w, x, _: (w.exponential(x),), _exponential),
    Operation.LOGARITHM: Recurrence(1, lambda w, x, _: (w.logarithm(x),), _logarithm),
    Operation.SINE: Recurrence(2, lambda w, x, _: (w.sine(x), w.cosine(x)), _circular),
    Operation.TANH: Recurrence(2, lambda w, x, _: (w.hyperbolic_tangent(x), w.squared_secant(x)), _hyperbolic),
    Operation.ECCENTRIC: Recurrence(4, _place_values, _place),
    Operation.EXPONENTIAL_MINUS_ONE: Recurrence(
        1, lambda w, x, _: (w.exponential_minus_one(x),), _exponential_minus_one
    ),
    Operation.LOGARITHM_OF_ONE_PLUS: Recurrence(
        1, lambda w, x, _: (w.logarithm_of_one_plus(x),), _logarithm_of_one_plus
    ),
}
"""By operation; other ones are their companions, sums, and products."""

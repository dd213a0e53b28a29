"""Taylor coefficients of whole arrays: a recurrence for each of JAX's operations.

The operations of a function are done once for each order, on arrays as large as they are. So a field of large arrays,
as that of a fluid is, has its series without being taken apart into numbers. Orders are written out one after the
other, or a loop of JAX's goes through them: then one array holds all coefficients of an array, and zeros where none are
known yet.

Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §2.1; Griewank & Walther, *Evaluating Derivatives*, ch. 13.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays.by_numpy import MOVES
from polhode._base.jaxprs import Entry, Listing, Scan
from polhode.taylor.expressions import Untraceable
from polhode.taylor.kernel_series import MAX_ANGLE_CHANGE, MAX_EXPONENT_CHANGE
from polhode.taylor.operations import Operation, squared_secant
from polhode.taylor.recurrences import RECURRENCES, Coefficients, Word, Words
from polhode.types import Array, Shaped

AFFINE = frozenset(MOVES) | {
    "add", "add_any", "sub", "neg", "mul", "div", "dot_general", "convert_element_type", "real", "imag", "complex",
    "conj", "scatter-add", "scatter_add", "reduce_sum", "cumsum", "reduce_window_sum", "copy_p", "fft",
    "triangular_solve", "scan",
}  # fmt: skip
"""Operations that are affine in the arguments that move, if ``_is_affine`` finds these in the right places."""
FIRST_STILL = frozenset(("select_n", "triangular_solve"))  # whose first argument must not move
REST_STILL = frozenset(("gather", "dynamic_slice", "div"))  # only whose first one may
Series = list[Array] | Array  # of one array, by order; an array in a loop over orders


class Step(NamedTuple):
    """One operation.

    Attributes:
        entry: of the listing.
        results: places of arrays; a rule may have more results than the operation, which it needs itself.
        rule: returns the k-th coefficients of the results, given those of the arguments up to k, its own up to k − 1
            and k; None where nothing moves.
        moving: which of the arguments move.
    """

    entry: Entry
    results: tuple[int, ...]
    rule: Callable[..., list[Array]] | None
    moving: tuple[int, ...]


class Unrolled:
    """The operations of a jaxpr one after the other.

    Args:
        closed: the jaxpr.
        moves: which of its arguments move.

    Raises:
        Untraceable: for operations on moving values that have no rule.
    """

    def __init__(self, closed: Any, moves: list[bool]) -> None:
        listing = Listing(closed)
        self.arguments, self.results = listing.inputs, listing.outputs
        self.constants: dict[int, Any] = listing.literals | listing.constants
        self.steps: list[Step] = []
        self._moves = [False] * listing.size
        for place, does in zip(listing.inputs, moves, strict=True):
            self._moves[place] = does
        for entry in listing.entries:
            self.steps.append(self._make_step(entry))

    @property
    def size(self) -> int:
        """How many places there are."""
        return len(self._moves)

    def is_moving(self, place: int) -> bool:
        """Return whether an array moves."""
        return self._moves[place]

    def _make_step(self, entry: Entry) -> Step:
        moving = tuple(k for k, place in enumerate(entry.operands) if self._moves[place])
        if not moving:
            return Step(entry, entry.results, None, ())
        rule = _find_rule(entry, moving, [self.constants.get(place) for place in entry.operands])
        for place in entry.results:
            self._moves[place] = True
        first, more = self.size, getattr(rule, "more", 0)
        self._moves += [True] * more
        return Step(entry, (*entry.results, *range(first, first + more)), rule, moving)


def bound_of_argument(step: Step) -> float | None:
    """Return by how much the argument of a function may change in a step: any (None), or a part of itself (0)."""
    name = step.entry.name
    if step.rule is None or (name == "pow" and isinstance(step.rule, _WholePower)):
        return None
    bounds = {"exp": MAX_EXPONENT_CHANGE, "expm1": MAX_EXPONENT_CHANGE, "tanh": 0.5 * MAX_EXPONENT_CHANGE,
              "sin": MAX_ANGLE_CHANGE, "cos": MAX_ANGLE_CHANGE}  # fmt: skip
    return bounds.get(name, 0.0 if name in ("log", "sqrt", "rsqrt", "cbrt", "pow") else None)


def _find_rule(entry: Entry, moving: tuple[int, ...], constants: list[Any]) -> Callable[..., list[Array]]:
    if _is_affine(entry, moving):
        return Affine(entry, moving)
    if entry.name == "pow":
        return _power(_read_exponent(constants[1]))(entry, moving)
    return entry.rule(RULES, "something that moves", Untraceable)(entry, moving)


def _is_affine(entry: Entry, moving: tuple[int, ...]) -> bool:
    """Return whether an operation is affine in those of its arguments that move."""
    name, loop = entry.name, entry.within
    if name not in AFFINE:
        return False
    if name in ("mul", "dot_general"):
        return len(moving) == 1
    if name in FIRST_STILL:
        return 0 not in moving
    if name in REST_STILL:
        return moving == (0,)
    if name in ("scatter", "scatter-add", "scatter_add"):
        return 1 not in moving
    if name == "dynamic_update_slice":
        return all(k < 2 for k in moving)
    if isinstance(loop, Scan):
        # a carried value moves if any part of it does, or if its operands do
        carried = range(loop.constants, loop.constants + loop.carried)
        return _all_affine(loop.body, {*moving, *carried})
    return True


def _all_affine(listing: Listing, moving: set[int]) -> bool:
    """Return whether all operations of a function are affine in those of its arguments that move."""
    affine: list[bool] = []

    def mark(entry: Entry, moves: list[bool]) -> list[bool]:
        which = tuple(k for k, does in enumerate(moves) if does)
        affine.append(not which or _is_affine(entry, which))
        return [bool(which)] * len(entry.results)

    listing.run([k in moving for k in range(len(listing.inputs))], mark, lambda number: False)
    return all(affine)


class Affine:
    """An operation that is affine in the arguments that move: its linear part maps the coefficients of each order."""

    def __init__(self, entry: Entry, moving: tuple[int, ...]) -> None:
        self.entry, self.moving = entry, moving

    def __call__(self, arguments: list[Any], own: list[Series], k: Any) -> list[Array]:
        def of(*values: Array) -> list[Array]:
            whole = [x[0] if j in self.moving else x for j, x in enumerate(arguments)]
            for j, value in zip(self.moving, values, strict=True):
                whole[j] = value
            return self.entry.bind(whole)

        if is_first(k):
            results, self.linear = jax.linearize(of, *(arguments[j][0] for j in self.moving))
            return results
        return self.linear(*(arguments[j][k] for j in self.moving))


def is_first(k: Any) -> bool:
    """Return whether the order is zero, as none is in a loop."""
    return isinstance(k, int) and k == 0


class Present:
    """The coefficient of the present order, where no other one is needed."""

    def __init__(self, value: Array) -> None:
        self.value = value

    def __getitem__(self, k: Any) -> Array:
        return self.value


def add_order(series: Any, value: Shaped[Array, "..."], k: Any) -> Any:
    """Return the coefficients with those of one more order; of an array that has none, they alone."""
    if series is None:
        return [value] if is_first(k) else Present(value)
    return [*series, value] if isinstance(series, list) else series.at[k].set(value)


class _Terms(Word):
    """All terms of a sum, or factors of them: weights of their orders j, and arrays."""

    def __init__(self, weights: Any, arrays: Any = 1) -> None:
        self.weights, self.arrays = weights, arrays

    def operate(self, symbol: str, left: Any, right: Any) -> _Terms:
        one, other = (x if isinstance(x, _Terms) else _Terms(x) for x in (left, right))
        if symbol == "-":  # of weights alone
            return _Terms(one.weights - other.weights)
        if symbol != "*":
            return super().operate(symbol, left, right)
        return _Terms(one.weights * other.weights, one.arrays * other.arrays)

    def add_up(self) -> Shaped[Array, "..."]:
        """Return the sum, where weights come last, so that one factor for all of an order is multiplied once."""
        weights = jnp.reshape(self.weights * 1.0, (-1, *[1] * (self.arrays.ndim - 1)))
        return jnp.sum(weights * self.arrays, axis=0)


class _Sums(Words):
    """The words of ``recurrences`` for arrays; what is not known yet is zero in an array of all orders."""

    sine, cosine, hyperbolic_tangent = staticmethod(jnp.sin), staticmethod(jnp.cos), staticmethod(jnp.tanh)

    def __init__(self, k: Any, example: Series) -> None:
        self.k, self.example = k, example

    def squared_secant(self, x: Array) -> Shaped[Array, "..."]:
        return squared_secant(x, jnp)

    def find(self, series: Series, order: Any) -> Any:
        """Return a coefficient; for the order j of a sum, and for k − j, those of all terms."""
        if not isinstance(order, _Terms):
            return series[order]
        if isinstance(series, list):
            return _Terms(1, jnp.stack([series[j] for j in order.weights]))
        return _Terms(1, series if order is self.j else jnp.roll(jnp.asarray(series)[::-1], self.k + 1, axis=0))

    def orders(self, stop: Any) -> _Terms:
        """Return the orders j of a sum: all that an array has, in whose place zeros of unknown ones are added too."""
        self.j = _Terms(np.arange(stop) if isinstance(self.example, list) else jnp.arange(len(self.example)))
        return self.j

    def totals(
        self, first: Any, stop: Any, starts: tuple[Any, ...], terms: Callable[[Any], Any]
    ) -> list[Shaped[Array, "..."]]:
        # from j = 0, as terms before the first have weight zero
        sums = (part.add_up() for part in terms(self.orders(stop)))
        return [total if isinstance(x, float) else x + total for x, total in zip(starts, sums, strict=True)]


def _factors(left: Series, right: Series, k: Any, stop: Any) -> tuple[Array, Array]:
    """Return a_j and b_{k−j} for all j < stop."""
    sums = _Sums(k, left)
    j = sums.orders(stop)
    return sums.find(left, j).arrays, sums.find(right, k - j).arrays


def _cauchy(left: Series, right: Series, k: Any, stop: Any) -> Array:
    """Return Σ a_j b_{k−j} over j < stop."""
    a, b = _factors(left, right, k, stop)
    return jnp.sum(a * b, axis=0)


def _product(entry: Entry, moving: tuple[int, ...]) -> Callable[..., list[Array]]:
    """Products: the sum over all pairs of orders that add up to k, for matrices as one product of stacked blocks."""

    def rule(arguments: list[Series], own: list[Series], k: Any) -> list[Array]:
        if entry.name != "dot_general":
            return [_cauchy(arguments[0], arguments[-1], k, k + 1)]
        left, right = _factors(arguments[0], arguments[-1], k, k + 1)
        (of_left, of_right), (batch_left, batch_right) = entry.parameters["dimension_numbers"]
        later = lambda axes: tuple(axis + 1 for axis in axes)  # noqa: E731
        numbers = (((0, *later(of_left)), (0, *later(of_right))), (later(batch_left), later(batch_right)))
        return [jax.lax.dot_general(left, right, numbers, preferred_element_type=left.dtype)]

    return rule


def _quotient(entry: Entry, moving: tuple[int, ...]) -> Callable[..., list[Array]]:
    def rule(arguments: list[Any], own: list[Series], k: Any) -> list[Array]:
        above, below = arguments
        value = above[k] if 0 in moving else above
        if is_first(k):
            return [value / below[0]]
        # q b = a: b₀ q_k = a_k − Σ_{j<k} q_j b_{k−j}
        return [((value if 0 in moving else 0.0) - _cauchy(own[0], below, k, k)) / below[0]]

    return rule


class _WholePower:
    """Whole powers above zero by products, as x may be zero; x², x³, … are results of their own."""

    def __init__(self, p: int) -> None:
        self.p, self.more = p, max(p - 2, 0)

    def __call__(self, arguments: list[Any], own: list[Series], k: Any) -> list[Array]:
        x = arguments[0]
        if self.p == 1:
            return [x[k]]
        powers = []
        lower = x
        for series in [*own[1:], own[0]]:
            powers.append(_cauchy(lower, x, k, k + 1))
            lower = add_order(series, powers[-1], k)
        return [powers[-1], *powers[:-1]]


def _power(p: float) -> Callable[..., Any]:
    if float(p).is_integer() and 0 < p <= 8:  # by products
        return lambda *_: _WholePower(int(p))
    return _function(Operation.POWER, p)


def _read_exponent(value: Any) -> float:
    if value is None or np.size(value) != 1:
        raise Untraceable("a power whose exponent is not one known number")
    return float(np.reshape(value, ()))


class _Function:
    """A function of ``recurrences``: the operation's result is the first in an order of its results, others follow."""

    def __init__(self, entry: Entry, operation: Operation, number: float, order: Sequence[int]) -> None:
        self.entry, self.recurrence, self.number, self.order = entry, RECURRENCES[operation], number, order
        self.more = len(order) - 1

    def __call__(self, arguments: list[Any], own: list[Series], k: Any) -> list[Array]:
        x, sums = arguments[0], _Sums(k, own[0])
        if is_first(k):
            values = self.recurrence.values(sums, x[0], self.number) if self.more else ()
            return [*self.entry.bind([x[0], *arguments[1:]]), *(values[place] for place in self.order[1:])]
        series, results = [x, *(own[place] for place in self.order)], []
        argument, *of_results = (
            Coefficients(lambda order, i=i: sums.find(series[i], order)) for i in range(len(series))
        )
        for value in self.recurrence.coefficients(sums, k, argument, of_results, self.number):
            results.append(value)
            if self.more:
                series[len(results)] = add_order(series[len(results)], value, k)
        return [results[place] for place in self.order]


def _function(operation: Operation, number: float = 0.0, order: Sequence[int] = (0,)) -> Callable[..., _Function]:
    return lambda entry, moving: _Function(entry, operation, number, order)


RULES: dict[str, Callable[..., Any]] = {
    "mul": _product, "dot_general": _product, "square": _product, "div": _quotient,
    "exp": _function(Operation.EXPONENTIAL), "expm1": _function(Operation.EXPONENTIAL_MINUS_ONE),
    "log": _function(Operation.LOGARITHM), "tanh": _function(Operation.TANH, order=(0, 1)),
    "sin": _function(Operation.SINE, order=(0, 1)), "cos": _function(Operation.SINE, order=(1, 0)),
    "integer_pow": lambda entry, moving: _power(entry.parameters["y"])(entry, moving), "sqrt": _power(0.5),
    "rsqrt": _power(-0.5), "cbrt": _power(1.0 / 3.0),
}  # fmt: skip

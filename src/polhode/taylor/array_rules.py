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

from polhode._base.jax_inner import Literal
from polhode._base.jaxprs import split_scan
from polhode.taylor.expressions import Untraceable
from polhode.taylor.jaxprs import INNER
from polhode.taylor.kernel_series import MAX_ANGLE_CHANGE, MAX_EXPONENT_CHANGE
from polhode.taylor.operations import Operation, squared_secant
from polhode.taylor.recurrences import RECURRENCES, Word, Words
from polhode.types import Array, Shaped

AFFINE = frozenset((
    "add", "add_any", "sub", "neg", "mul", "div", "dot_general", "convert_element_type", "real", "imag", "complex",
    "conj", "reshape", "transpose", "broadcast_in_dim", "slice", "squeeze", "expand_dims", "concatenate", "gather",
    "scatter", "scatter-add", "scatter_add", "reduce_sum", "cumsum", "reduce_window_sum", "rev", "pad", "copy",
    "copy_p", "stack", "unstack", "tile", "select_n", "dynamic_slice", "dynamic_update_slice", "fft",
    "triangular_solve", "scan", "split",
))  # fmt: skip
"""Operations that are affine in the arguments that move, if ``_is_affine`` finds these in the right places."""
FIRST_STILL = frozenset(("select_n", "triangular_solve"))  # whose first argument must not move
REST_STILL = frozenset(("gather", "dynamic_slice", "div"))  # only whose first one may
Series = list[Array] | Array  # of one array, by order; an array in a loop over orders


class Step(NamedTuple):
    """One operation.

    Attributes:
        equation: of the jaxpr.
        arguments, results: places of arrays; a rule may have more results than the equation, which it needs itself.
        rule: returns the k-th coefficients of the results, given those of the arguments up to k, its own up to k − 1
            and k; None where nothing moves.
        moving: which of the arguments move.
    """

    equation: Any
    arguments: tuple[int, ...]
    results: tuple[int, ...]
    rule: Callable[..., list[Array]] | None
    moving: tuple[int, ...]


class Unrolled:
    """The operations of a jaxpr one after the other, with the contents of inner functions written out.

    Args:
        closed: the jaxpr.
        moves: which of its arguments move.

    Raises:
        Untraceable: for operations on moving values that have no rule.
    """

    def __init__(self, closed: Any, moves: list[bool]) -> None:
        self.constants: dict[int, Any] = {}
        self.steps: list[Step] = []
        self._moves: list[bool] = []
        self.arguments = [self._place(does) for does in moves]
        self.results = self._inline(closed.jaxpr, closed.consts, self.arguments)
        self.size = len(self._moves)

    def is_moving(self, place: int) -> bool:
        """Return whether an array moves."""
        return self._moves[place]

    def _place(self, moves: bool) -> int:
        self._moves.append(moves)
        return len(self._moves) - 1

    def _add_constant(self, value: Any) -> int:
        place = self._place(False)
        self.constants[place] = value
        return place

    def _inline(self, jaxpr: Any, constants: Any, arguments: list[int]) -> list[int]:
        at = dict(zip(jaxpr.invars, arguments, strict=True))
        at.update(zip(jaxpr.constvars, map(self._add_constant, constants), strict=True))

        def find_place(variable: Any) -> int:
            return self._add_constant(variable.val) if isinstance(variable, Literal) else at[variable]

        for equation in jaxpr.eqns:
            places = [find_place(v) for v in equation.invars]
            inner = next((equation.params[k] for k in INNER if k in equation.params), None)
            if inner is not None and equation.primitive.name not in ("scan", "while", "cond"):
                plain, consts = (inner.jaxpr, inner.consts) if hasattr(inner, "jaxpr") else (inner, [])
                at.update(zip(equation.outvars, self._inline(plain, consts, places), strict=True))
                continue
            moving = tuple(k for k, place in enumerate(places) if self._moves[place])
            rule = _find_rule(equation, moving, [self.constants.get(place) for place in places]) if moving else None
            count = len(equation.outvars)
            results = tuple(self._place(bool(moving)) for _ in range(count + getattr(rule, "more", 0)))
            self.steps.append(Step(equation, tuple(places), results, rule, moving))
            at.update(zip(equation.outvars, results[:count], strict=True))
        return [find_place(v) for v in jaxpr.outvars]


def bound_of_argument(step: Step) -> float | None:
    """Return by how much the argument of a function may change in a step: any (None), or a part of itself (0)."""
    name = step.equation.primitive.name
    if step.rule is None or (name == "pow" and isinstance(step.rule, _WholePower)):
        return None
    bounds = {"exp": MAX_EXPONENT_CHANGE, "expm1": MAX_EXPONENT_CHANGE, "tanh": 0.5 * MAX_EXPONENT_CHANGE,
              "sin": MAX_ANGLE_CHANGE, "cos": MAX_ANGLE_CHANGE}  # fmt: skip
    return bounds.get(name, 0.0 if name in ("log", "sqrt", "rsqrt", "cbrt", "pow") else None)


def _find_rule(equation: Any, moving: tuple[int, ...], constants: list[Any]) -> Callable[..., list[Array]]:
    name = equation.primitive.name
    if _is_affine(equation, moving):
        return Affine(equation, moving)
    if name == "pow":
        return _power(_read_exponent(constants[1]))(equation, moving)
    if name in RULES:
        return RULES[name](equation, moving)
    raise Untraceable(f"`{name}` of something that moves")


def _is_affine(equation: Any, moving: tuple[int, ...]) -> bool:
    """Return whether an operation is affine in those of its arguments that move."""
    name, parameters = equation.primitive.name, equation.params
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
    if name == "scan":
        body, (known, carried) = parameters["jaxpr"], split_scan(parameters)
        # a carried value moves if any part of it does, or if its operands do
        return _all_affine(body.jaxpr, {*moving, *range(known, known + carried)})
    return True


def _all_affine(jaxpr: Any, moving: set[int]) -> bool:
    moves = {v for k, v in enumerate(jaxpr.invars) if k in moving}
    for equation in jaxpr.eqns:
        which = tuple(k for k, v in enumerate(equation.invars) if not isinstance(v, Literal) and v in moves)
        if not which:
            continue
        moves.update(equation.outvars)
        inner = next((equation.params[k] for k in INNER if k in equation.params), None)
        if inner is not None and equation.primitive.name != "scan":
            if equation.primitive.name in ("while", "cond") or not _all_affine(
                    getattr(inner, "jaxpr", inner), set(which)):
                return False
        elif not _is_affine(equation, which):
            return False
    return True


def bind(equation: Any, arguments: list[Any]) -> list[Shaped[Array, "..."]]:
    """Return the result of an operation on values."""
    results = equation.primitive.bind(*arguments, **equation.params)
    return list(results) if equation.primitive.multiple_results else [results]


class Affine:
    """An operation that is affine in the arguments that move: its linear part maps the coefficients of each order."""

    def __init__(self, equation: Any, moving: tuple[int, ...]) -> None:
        self.equation, self.moving = equation, moving

    def __call__(self, arguments: list[Any], own: list[Series], k: Any) -> list[Array]:
        def of(*values: Array) -> list[Array]:
            whole = [x[0] if j in self.moving else x for j, x in enumerate(arguments)]
            for j, value in zip(self.moving, values, strict=True):
                whole[j] = value
            return bind(self.equation, whole)

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
        return _Terms(one.weights * other.weights, one.arrays * other.arrays)

    def add_up(self) -> Array:
        """Return the sum."""
        weights = jnp.reshape(self.weights * 1.0, (-1, *[1] * (self.arrays.ndim - 1)))
        return jnp.sum(weights * self.arrays, axis=0)


class _Coefficients:
    """The coefficients of an array; for the order j of a sum, and for k − j, those of all terms."""

    def __init__(self, sums: _Sums, series: Series) -> None:
        self.sums, self.series = sums, series

    def __getitem__(self, order: Any) -> Any:
        k, series = self.sums.k, self.series
        if not isinstance(order, _Terms):
            return series[order]
        if isinstance(series, list):
            return _Terms(1, jnp.stack([series[j] for j in order.weights]))
        return _Terms(1, series if order is self.sums.j else jnp.roll(jnp.asarray(series)[::-1], k + 1, axis=0))


class _Sums(Words):
    """The words of ``recurrences`` for arrays; what is not known yet is zero in an array of all orders."""

    sine, cosine, hyperbolic_tangent = staticmethod(jnp.sin), staticmethod(jnp.cos), staticmethod(jnp.tanh)

    def __init__(self, k: Any, example: Series) -> None:
        self.k, self.example = k, example

    def squared_secant(self, x: Array) -> Array:
        return squared_secant(x, jnp)

    def orders(self, stop: Any) -> _Terms:
        """Return the orders j of a sum, of an array all."""
        self.j = _Terms(np.arange(stop) if isinstance(self.example, list) else jnp.arange(len(self.example)))
        return self.j

    def totals(self, first: Any, stop: Any, starts: tuple[Any, ...], terms: Callable[[Any], Any]) -> list[Array]:
        # from j = 0, as terms before the first have weight zero
        sums = (part.add_up() for part in terms(self.orders(stop)))
        return [total if isinstance(x, float) else x + total for x, total in zip(starts, sums, strict=True)]


def _factors(left: Series, right: Series, k: Any, stop: Any) -> tuple[Array, Array]:
    """Return a_j and b_{k−j} for all j < stop."""
    sums = _Sums(k, left)
    j = sums.orders(stop)
    return _Coefficients(sums, left)[j].arrays, _Coefficients(sums, right)[k - j].arrays


def _cauchy(left: Series, right: Series, k: Any, stop: Any) -> Array:
    """Return Σ a_j b_{k−j} over j < stop."""
    a, b = _factors(left, right, k, stop)
    return jnp.sum(a * b, axis=0)


def _product(equation: Any, moving: tuple[int, ...]) -> Callable[..., list[Array]]:
    """Products: the sum over all pairs of orders that add up to k, for matrices as one product of stacked blocks."""

    def rule(arguments: list[Series], own: list[Series], k: Any) -> list[Array]:
        if equation.primitive.name != "dot_general":
            return [_cauchy(arguments[0], arguments[-1], k, k + 1)]
        left, right = _factors(arguments[0], arguments[-1], k, k + 1)
        (of_left, of_right), (batch_left, batch_right) = equation.params["dimension_numbers"]
        later = lambda axes: tuple(axis + 1 for axis in axes)  # noqa: E731
        numbers = (((0, *later(of_left)), (0, *later(of_right))), (later(batch_left), later(batch_right)))
        return [jax.lax.dot_general(left, right, numbers, preferred_element_type=left.dtype)]

    return rule


def _quotient(equation: Any, moving: tuple[int, ...]) -> Callable[..., list[Array]]:
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
    """A function of ``recurrences``: the equation's result is the first in an order of its results, others follow."""

    def __init__(self, equation: Any, operation: Operation, number: float, order: Sequence[int]) -> None:
        self.equation, self.recurrence, self.number, self.order = equation, RECURRENCES[operation], number, order
        self.more = len(order) - 1

    def __call__(self, arguments: list[Any], own: list[Series], k: Any) -> list[Array]:
        x, sums = arguments[0], _Sums(k, own[0])
        if is_first(k):
            values = self.recurrence.values(sums, x[0], self.number) if self.more else ()
            return [*bind(self.equation, [x[0], *arguments[1:]]), *(values[place] for place in self.order[1:])]
        argument, *series = (_Coefficients(sums, of) for of in (x, *(own[place] for place in self.order)))
        results = []
        for value in self.recurrence.coefficients(sums, k, argument, series, self.number):
            if self.more:
                result = series[len(results)]
                result.series = add_order(result.series, value, k)
            results.append(value)
        return [results[place] for place in self.order]


def _function(operation: Operation, number: float = 0.0, order: Sequence[int] = (0,)) -> Callable[..., _Function]:
    return lambda equation, moving: _Function(equation, operation, number, order)


RULES: dict[str, Callable[..., Any]] = {
    "mul": _product, "dot_general": _product, "square": _product, "div": _quotient,
    "exp": _function(Operation.EXPONENTIAL), "expm1": _function(Operation.EXPONENTIAL_MINUS_ONE),
    "log": _function(Operation.LOGARITHM), "tanh": _function(Operation.TANH, order=(0, 1)),
    "sin": _function(Operation.SINE, order=(0, 1)), "cos": _function(Operation.SINE, order=(1, 0)),
    "integer_pow": lambda equation, moving: _power(equation.params["y"])(equation, moving), "sqrt": _power(0.5),
    "rsqrt": _power(-0.5), "cbrt": _power(1.0 / 3.0),
}  # fmt: skip

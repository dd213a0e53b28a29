"""From a function written with JAX to a tape: its jaxpr, evaluated on arrays of expressions.

Numbers stay numbers, so that results of parameters alone are computed once. Moving data is done to arrays of
expressions as to any others; operations linear with constant coefficients are applied to unit vectors. The time or
``sides`` decide branches; others, and functions without a recurrence, raise ``Untraceable``.
"""

from __future__ import annotations

import contextlib
import operator
from collections.abc import Callable, Iterator, Sequence
from contextvars import ContextVar
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays.by_numpy import BY_NUMPY, MOVES, by_numbers, factors
from polhode._base.jaxprs import NAMED, Call, Entry, Listing
from polhode.taylor.elementary import (
    cube_root,
    eccentric_anomaly,
    exponential,
    exponential_minus_one,
    hyperbolic_tangent,
    logarithm,
    logarithm_of_one_plus,
    sine_and_cosine,
)
from polhode.taylor.expressions import Complex, Expression, Tape, Untraceable, total
from polhode.types import Array, Bool

Rule = Callable[[list[Array], Entry], list[Any]]
RULES: dict[str, Rule] = {}


class TracingLimits(NamedTuple):
    """The largest operations that are written out."""

    max_rounds: int = 1000  # of a loop
    max_linear_size: int = 4096  # numbers of which unit vectors are made


LIMITS = TracingLimits()

_keeping: ContextVar[Tape | None] = ContextVar("keeping", default=None)
EXACT = frozenset(MOVES) | {  # operations that round no number
    "abs", "clamp", "complex", "conj", "convert_element_type", "copy_p", "imag", "iota", "max", "min", "neg", "real",
    "reduce_max", "reduce_min", "sign",
}  # fmt: skip


@contextlib.contextmanager
def keep_numbers(tape: Tape) -> Iterator[None]:
    """Make evaluations within keep the numbers that are in ``tape.kept``, where that is not None."""
    token = _keeping.set(None if tape.kept is None else tape)
    try:
        yield
    finally:
        _keeping.reset(token)


def list_operations(closed: Any) -> Listing:
    """Return the operations of a jaxpr, for one that is evaluated again and again."""
    return Listing(closed, NAMED)


def evaluate(
    closed: Any, *arguments: Array, places: Sequence[int] | None = None, read: Callable[[Any], Any] = np.asarray
) -> list[Any]:
    """Return the values of a jaxpr: all, or those at some places, with those that these need.

    Args:
        closed: of a function of real arrays, or its operations as ``list_operations`` gives them.
        arguments: arrays of expressions (dtype object), or of numbers.
        places: of the values that are wanted.
        read: a constant in the function → an array of expressions or of numbers.

    Returns:
        Arrays of expressions or numbers.

    Raises:
        Untraceable: if they are not made of operations that have a recurrence.
    """
    whole = closed if isinstance(closed, Listing) else list_operations(closed)
    listing = whole.only(places).with_constants(read)
    return _run(listing, [np.asarray(a) for a in arguments])


def _run(listing: Listing, arguments: list[Array]) -> list[Array]:
    tape = _keeping.get()
    return listing.run(arguments, _apply, np.asarray if tape is None else lambda x: tape.keep(np.asarray(x)))


def _apply(entry: Entry, arguments: list[Array]) -> list[Array]:
    if any(a.dtype == object for a in arguments):
        results = entry.rule(RULES, "something that moves", Untraceable)(arguments, entry)
        return [a if isinstance(a, np.ndarray) else _array(a) for a in results]
    if isinstance(entry.within, Call):
        return _run(entry.within.body, arguments)
    tape = _keeping.get()
    return by_numbers(entry, arguments) if tape is None else _by_exact_numbers(entry, arguments, tape)


def _by_exact_numbers(entry: Entry, arguments: list[Array], tape: Tape) -> list[Array]:
    """Compute numbers from numbers, and note on the tape whether any of them was rounded."""
    name, has_complex = entry.name, any(np.iscomplexobj(a) for a in arguments)
    has_doubles = any(jnp.issubdtype(kind.dtype, jnp.inexact) for kind in entry.made)
    is_exact = name in EXACT and not (name == "abs" and has_complex)
    if is_exact or not has_doubles:  # whole numbers and truth values are not rounded either
        return by_numbers(entry, arguments)
    if name not in RULES or has_complex:
        tape.rounded = True
        return by_numbers(entry, arguments)
    expressions = [_each(tape.constant, a) if np.issubdtype(a.dtype, np.inexact) else a for a in arguments]
    results = [np.asarray(a) for a in RULES[name](expressions, entry)]
    return [_each(lambda x: x.constant if isinstance(x, Expression) else x, a).astype(kind.dtype)
            for a, kind in zip(results, entry.made, strict=True)]


def _array(x: Any) -> Array:
    result = np.empty((), object)
    result[()] = x
    return result


def _each(function: Callable[[Any], Any], x: Array) -> Array:
    result = np.empty(x.shape, object)
    for k in np.ndindex(x.shape):
        result[k] = function(x[k])
    return result


def _rule(*names: str) -> Callable[[Rule], Rule]:
    def register(rule: Rule) -> Rule:
        RULES.update(dict.fromkeys(names, rule))
        return rule

    return register


def _find_tape(*arrays: Array) -> Tape:
    for a in arrays:
        for x in np.asarray(a).flat:
            for part in (x.real, x.imag) if isinstance(x, Complex) else (x,):
                if isinstance(part, Expression):
                    return part.tape
    return Tape(0)  # of numbers alone


# ---------------------------------------------------------------------- arithmetic


def _of_elements(rule: Callable[[list[Array], dict[str, Any]], Any]) -> Rule:
    """Return a rule of NumPy's for arrays of expressions, for which NumPy asks the expressions."""

    def of_expressions(x: list[Array], entry: Entry) -> list[Any]:
        results = rule(x, entry.parameters)
        return results if isinstance(results, list) else [results]

    return of_expressions


RULES.update({name: _of_elements(BY_NUMPY[name]) for name in (*MOVES, "add", "add_any", "sub", "mul", "neg", "square")})
RULES["div"] = lambda x, e: [x[0] / x[1]]
RULES["integer_pow"] = lambda x, e: [_each(lambda a: a ** e.parameters["y"], x[0])]
RULES["sqrt"] = lambda x, e: [_each(lambda a: a**0.5, x[0])]
RULES["rsqrt"] = lambda x, e: [_each(lambda a: a**-0.5, x[0])]
RULES["cbrt"] = lambda x, e: [_each(cube_root, x[0])]


@_rule("pow")
def _power(x: list[Array], entry: Entry) -> list[Array]:
    base, exponent = np.broadcast_arrays(*x)
    tape, result = _find_tape(*x), np.empty(base.shape, object)
    for k in np.ndindex(base.shape):
        power = tape.find_number(exponent[k])
        if power is None:
            raise Untraceable("a power whose exponent moves")
        result[k] = (base[k] if isinstance(base[k], Expression | Complex) else tape.constant(float(base[k]))) ** power
    return [result]


def _elementary(function: Callable[[Expression], Expression]) -> Rule:
    def rule(x: list[Array], entry: Entry) -> list[Array]:
        tape = _find_tape(x[0])

        def of(a: Any) -> Expression:
            if isinstance(a, Complex):
                raise Untraceable(f"`{entry.name}` of a complex number")
            return function(a if isinstance(a, Expression) else tape.constant(float(a)))

        return [_each(of, x[0])]

    return rule


@_rule("solve_kepler")
def _place_in_orbit(x: list[Array], entry: Entry) -> list[Array]:
    anomalies, e = np.broadcast_arrays(*x)
    tape, numbers = _find_tape(anomalies), []
    for x in e.flat:
        number = tape.find_number(x)
        if number is None:
            raise Untraceable("an eccentricity that moves")
        numbers.append(number)
    eccentric = [eccentric_anomaly(x, y) for x, y in zip(anomalies.flat, numbers, strict=True)]
    return [np.array([None, *eccentric], object)[1:].reshape(anomalies.shape)]


RULES["sin"] = _elementary(lambda a: sine_and_cosine(a)[0])
RULES["cos"] = _elementary(lambda a: sine_and_cosine(a)[1])
RULES["tan"] = _elementary(lambda a: sine_and_cosine(a)[0] / sine_and_cosine(a)[1])
RULES["exp"] = _elementary(exponential)
# of a mean anomaly, and what is a function of the place in an orbit goes on smoothly beyond a turn
RULES["_whole_turns"] = lambda x, e: [np.zeros(x[0].shape)]
RULES["log"] = _elementary(logarithm)
RULES["log1p"] = _elementary(logarithm_of_one_plus)
RULES["expm1"] = _elementary(exponential_minus_one)
# of two with equal signs, so that a small one keeps its digits
RULES["sinh"] = _elementary(lambda a: (exponential_minus_one(a) - exponential_minus_one(-a)) * 0.5)
RULES["cosh"] = _elementary(lambda a: (exponential(a) + exponential(-a)) * 0.5)
RULES["tanh"] = _elementary(hyperbolic_tangent)
RULES["logistic"] = _elementary(lambda a: 1.0 / (exponential(-a) + 1.0))


# ---------------------------------------------------------------------- branches


def _comparison(compare: Callable[[Any, Any], Any]) -> Rule:
    def rule(x: list[Array], entry: Entry) -> list[Array]:
        tape = _find_tape(*x)
        one, other = np.broadcast_arrays(*x)
        result = np.empty(one.shape, bool)
        for k in np.ndindex(result.shape):
            result[k] = tape.relation(one[k], other[k], compare)
        return [result]

    return rule


for _name in ("lt", "le", "gt", "ge", "eq", "ne"):
    RULES[_name] = _comparison(getattr(operator, _name))


def _choose_rule(first: Callable[[Any, Any], Any]) -> Rule:
    def rule(x: list[Array], entry: Entry) -> list[Array]:
        tape = _find_tape(*x)
        return [_pairs(lambda a, b: a if tape.relation(a, b, first) else b, *np.broadcast_arrays(*x))]

    return rule


RULES["max"], RULES["min"] = _choose_rule(operator.ge), _choose_rule(operator.le)
RULES["abs"] = _elementary(lambda a: a if a.tape.relation(a, 0.0, operator.ge) else -a)
RULES["sign"] = _elementary(lambda a: a.tape.constant(1.0 if a.tape.relation(a, 0.0, operator.ge) else -1.0))


# ---------------------------------------------------------------------- sums


@_rule("reduce_sum")
def _sum(x: list[Array], entry: Entry) -> list[Array]:
    axes, tape = tuple(entry.parameters["axes"]), _find_tape(x[0])
    kept = [k for k in range(x[0].ndim) if k not in axes]
    moved = np.transpose(x[0], (*kept, *axes))
    shape = moved.shape[: len(kept)]
    result = np.empty(shape, object)
    for k in np.ndindex(shape):
        result[k] = total(tape, np.ravel(moved[k]) if axes else [moved[k]])
    return [result]


@_rule("reduce_prod")
def _multiply_all(x: list[Array], entry: Entry) -> list[Array]:
    return [np.multiply.reduce(x[0], axis=tuple(entry.parameters["axes"]))]


@_rule("dot_general")
def _dot(x: list[Array], entry: Entry) -> list[Array]:
    left, right, shape = factors(x, entry.parameters)
    tape, result = _find_tape(*x), np.empty((*left.shape[:2], right.shape[1]), object)
    some_left, some_right = _differ_from_zero(left), _differ_from_zero(right)
    for k, i, j in np.ndindex(result.shape):
        places = np.flatnonzero(some_left[k, i] & some_right[k, j]).tolist()
        row, column = left[k, i], right[k, j]
        result[k, i, j] = total(tape, [row[m] * column[m] for m in places])
    return [result.reshape(shape)]


def _differ_from_zero(x: Array) -> Bool[np.ndarray, "..."]:
    """Return which elements are not the number zero, once for all products that they are in."""
    return np.array([not _is_zero(element) for element in np.ravel(x)], bool).reshape(x.shape)


def _is_zero(x: Any) -> bool:
    if isinstance(x, Complex):
        return False
    return not x.terms and x.constant == 0.0 if isinstance(x, Expression) else bool(x == 0)


# ---------------------------------------------------------------------- complex numbers

RULES["complex"] = lambda x, e: [_pairs(Complex, *np.broadcast_arrays(*x))]
RULES["real"] = lambda x, e: [_each(lambda a: Complex.of(a).real, x[0])]
RULES["imag"] = lambda x, e: [_each(lambda a: Complex.of(a).imag, x[0])]
RULES["conj"] = lambda x, e: [_each(lambda a: Complex.of(a).conjugate(), x[0])]


def _pairs(make: Callable[[Any, Any], Any], a: Array, b: Array) -> Array:
    result = np.empty(a.shape, object)
    for k in np.ndindex(a.shape):
        result[k] = make(a[k], b[k])
    return result


# ---------------------------------------------------------------------- data that moves

for _name in ("copy_p", "device_put", "reduce_precision"):
    RULES[_name] = lambda x, e: [x[0]]
RULES["optimization_barrier"] = lambda x, e: x


@_rule("convert_element_type")
def _convert(x: list[Array], entry: Entry) -> list[Array]:
    if not jnp.issubdtype(entry.parameters["new_dtype"], jnp.inexact):
        raise Untraceable(f"conversion to {entry.parameters['new_dtype']}")
    return [x[0]]


@_rule("select_n")
def _select(x: list[Array], entry: Entry) -> list[Array]:
    if x[0].dtype == object:
        raise Untraceable("a branch on something that moves (`select_n`)")
    return [MOVES["select_n"](x, entry.parameters)]


@_rule("scatter-add", "scatter_add", "cumsum", "triangular_solve", "reduce_window_sum", "fft")
def _linear(x: list[Array], entry: Entry) -> list[Array]:
    """Apply an operation linear in moving values to unit vectors, in real and imaginary parts."""
    moving = [k for k, a in enumerate(x) if a.dtype == object]
    if entry.name == "triangular_solve" and 0 in moving:
        raise Untraceable("a linear system whose matrix moves")
    kinds = [kind.dtype for kind in entry.given]
    parts = [2 if jnp.issubdtype(kind, jnp.complexfloating) else 1 for kind in kinds]
    size = sum(x[k].size * parts[k] for k in moving)
    if size > LIMITS.max_linear_size:
        raise Untraceable(f"`{entry.name}` of {size} numbers")
    [result] = entry.made
    is_complex = jnp.issubdtype(result.dtype, jnp.complexfloating)

    def of(flat: Any) -> Any:
        arguments, start = [jnp.asarray(np.zeros(a.shape) if a.dtype == object else a, k)
                        for a, k in zip(x, kinds, strict=True)], 0  # fmt: skip
        for k in moving:
            numbers = flat[start : start + x[k].size * parts[k]].reshape(*x[k].shape, parts[k])
            arguments[k] = numbers[..., 0] if parts[k] == 1 else jax.lax.complex(numbers[..., 0], numbers[..., 1])
            start += x[k].size * parts[k]
        output = jnp.ravel(entry.bind(arguments)[0])
        return jnp.stack([jnp.real(output), jnp.imag(output)], -1).ravel() if is_complex else output

    zero, matrix = np.asarray(of(jnp.zeros(size))), np.asarray(jax.jacfwd(of)(jnp.zeros(size)))
    elements: list[Any] = []
    for k in moving:
        for a in np.asarray(x[k]).flat:
            elements.extend([Complex.of(a).real, Complex.of(a).imag] if parts[k] == 2 else [a])
    tape = _find_tape(*(x[k] for k in moving))
    tape.rounded |= tape.kept is not None and entry.name in ("fft", "triangular_solve")
    values = np.empty(len(matrix), object)
    for row, (start, coefficients) in enumerate(zip(zero, matrix, strict=True)):
        where = np.flatnonzero(coefficients)
        values[row] = total(tape, [float(start), *(elements[k] * float(coefficients[k]) for k in where)])
    if is_complex:
        values = _pairs(Complex, values[::2], values[1::2])
    return [values.reshape(result.shape)]


@_rule("scan")
def _scan(x: list[Array], entry: Entry) -> list[Array]:
    """Write out a loop whose number of rounds is known."""
    loop: Any = entry.within
    if len(loop.order) > LIMITS.max_rounds:
        raise Untraceable(f"a loop of {len(loop.order)} rounds")
    body = loop.body.only()
    return loop.run(x, lambda values: _run(body, values), lambda shape, kind: np.empty(shape, object))


@_rule("cond")
def _branch(x: list[Array], entry: Entry) -> list[Array]:
    if x[0].dtype == object:
        raise Untraceable("a branch on something that moves (`cond`)")
    branches: Any = entry.within
    return _run(branches.each[branches.place(x[0])].only(), x[1:])

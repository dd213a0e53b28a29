"""Arithmetic of the kernels for Numba: instructions and functions in place of some of ``kernel_arithmetic``."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from llvmlite.ir import Constant, DoubleType, IntType
from numba.core.cgutils import alloca_once, for_range, unpack_tuple
from numba.core.types import BaseTuple, Boolean, UniTuple, boolean, float64, int64, none
from numba.extending import intrinsic
from numba.np.arrayobj import make_array

from polhode._base.compiled.compiling import compile_part
from polhode.exact._kernel_arithmetic import BLOCK, ROUNDING, SWEEPS
from polhode.exact._kernel_records import leaves

TUPLES: Any = BaseTuple  # whose types do not know that it has parts


def _instruction(function: Callable[..., Any]) -> Any:
    return intrinsic(inspect.unwrap(function))


@_instruction
def _fused(context: Any, a: Any, b: Any, c: Any) -> Any:
    """Return a b + c, rounded once."""
    return float64(float64, float64, float64), lambda _, builder, __, values: builder.fma(*values)


@_instruction
def _bits_of(context: Any, x: Any) -> Any:
    cast = lambda target, builder, _, values: builder.bitcast(values[0], target.get_value_type(int64))  # noqa: E731
    return int64(float64), cast


@_instruction
def _of_bits(context: Any, n: Any) -> Any:
    cast = lambda target, builder, _, values: builder.bitcast(values[0], target.get_value_type(float64))  # noqa: E731
    return float64(int64), cast


def _two_product(a: Any, b: Any) -> Any:
    p = a * b
    return p, _fused(a, b, -p)


@intrinsic(prefer_literal=True)
def _record(context: Any, rows: Any, i: Any, count: Any) -> Any:
    numbers = rows.dtype, count.literal_value

    def read(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        places = _places(context, builder, rows, values, count.literal_value)
        return context.make_tuple(builder, signature.return_type, [builder.load(place) for place in places])

    return UniTuple(*numbers)(rows, i, count), read


@intrinsic
def _load(context: Any, rows: Any, i: Any, kind: Any) -> Any:
    result = _type_of(leaves(kind.instance_class), kind.instance_class)

    def read(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        waiting = iter(_places(context, builder, rows, values, _count(result)))
        return _loaded(context, builder, result, waiting)

    return result(rows, i, kind), read


def _type_of(part: Any, kind: type | None) -> Any:
    if isinstance(part, tuple):
        return BaseTuple.from_types(tuple(_type_of(*inner) for inner in part), kind)
    return boolean if part is bool else float64


def _count(kind: Any) -> int:
    return sum(map(_count, kind)) if isinstance(kind, TUPLES) else 1


def _loaded(context: Any, builder: Any, kind: Any, places: Iterator[Any]) -> Any:
    if isinstance(kind, TUPLES):
        return context.make_tuple(builder, kind, [_loaded(context, builder, part, places) for part in kind])
    number = builder.load(next(places))
    return builder.fcmp_unordered("!=", number, Constant(number.type, 0.0)) if isinstance(kind, Boolean) else number


@intrinsic
def _put_record(context: Any, rows: Any, i: Any, values: Any) -> Any:
    def write(context: Any, builder: Any, _: Any, operands: Any) -> Any:
        places = _places(context, builder, rows, operands, _count(values))
        for place, value in zip(places, _flat(builder, values, operands[2]), strict=True):
            builder.store(value, place)
        return context.get_dummy_value()

    return none(rows, i, values), write


def _flat(builder: Any, kind: Any, value: Any) -> Iterator[Any]:
    """Yield the numbers of a record, and 1 and 0 for what holds and what does not."""
    if isinstance(kind, TUPLES):
        for part, inner in zip(kind, unpack_tuple(builder, value), strict=True):
            yield from _flat(builder, part, inner)
    else:
        yield builder.uitofp(value, DoubleType()) if isinstance(kind, Boolean) else value


def _places(context: Any, builder: Any, rows: Any, values: Any, count: int) -> list[Any]:
    """Return pointers to numbers of an array that stand BLOCK apart."""
    data, first = make_array(rows)(context, builder, values[0]).data, values[1]
    steps = [builder.add(first, Constant(first.type, k * BLOCK)) for k in range(count)]
    return [builder.gep(data, [step], inbounds=True) for step in steps]


@_instruction
def _negated(context: Any, x: Any) -> Any:
    write = lambda context, builder, signature, values: context.make_tuple(  # noqa: E731
        builder, signature.return_type, [builder.fneg(term) for term in unpack_tuple(builder, values[0])]
    )
    return x(x), write


@_instruction
def _multiply_terms(context: Any, x: Any, factor: Any) -> Any:
    def write(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        terms = []
        for term in unpack_tuple(builder, values[0]):
            product = builder.fmul(term, values[1])
            terms += [product, builder.fma(term, values[1], builder.fneg(product))]
        return context.make_tuple(builder, signature.return_type, terms)

    return UniTuple(float64, 2 * len(x))(x, factor), write


@intrinsic(prefer_literal=True)
def _compress(context: Any, x: Any, count: Any) -> Any:
    most = min(count.literal_value, len(x))

    def write(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        terms = unpack_tuple(builder, values[0])
        if most < len(terms):
            terms = _swept(builder, terms, most + 1)[-most:]
        return context.make_tuple(builder, signature.return_type, terms)

    return UniTuple(float64, most)(x, count), write


@_instruction
def _distil(context: Any, x: Any) -> Any:
    def write(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        rest, *errors, last = _swept(builder, unpack_tuple(builder, values[0]), SWEEPS)
        for error in errors:
            rest = builder.fadd(rest, error)
        return context.make_tuple(builder, signature.return_type, _two_sum(builder, last, rest))

    return UniTuple(float64, 2)(x), write


def _swept(builder: Any, terms: list[Any], times: int) -> list[Any]:
    """Sweep a sum as ``kernel_arithmetic._swept``, in a loop: written out, it would be thousands of instructions."""
    number, count = terms[0].type, Constant(IntType(64), len(terms) - 1)
    room = alloca_once(builder, number, size=len(terms))
    for k, term in enumerate(terms):
        builder.store(term, builder.gep(room, [Constant(IntType(64), k)]))
    first = builder.gep(room, [Constant(IntType(64), 0)])
    running = alloca_once(builder, number)
    with for_range(builder, Constant(IntType(64), times)):
        builder.store(builder.load(first), running)
        with for_range(builder, count) as loop:
            place = builder.gep(room, [builder.add(loop.index, Constant(IntType(64), 1))])
            total, error = _two_sum(builder, builder.load(running), builder.load(place))
            builder.store(error, builder.gep(room, [loop.index]))
            builder.store(total, running)
        builder.store(builder.load(running), builder.gep(room, [count]))
    return [builder.load(builder.gep(room, [Constant(IntType(64), k)])) for k in range(len(terms))]


def _two_sum(builder: Any, a: Any, b: Any) -> tuple[Any, Any]:
    s = builder.fadd(a, b)
    t = builder.fsub(s, a)
    return s, builder.fadd(builder.fsub(a, builder.fsub(s, t)), builder.fsub(b, t))


def _binary_exponent(x: Any) -> Any:
    # the exponent's bits become the last of 2⁵² + e, without instructions that not all processors have for vectors
    return _of_bits(((_bits_of(x) >> 52) & 2047) | LAST_PLACES) - (2.0**52 + 1022.0)


def _times_power(x: Any, n: Any) -> Any:
    return x * _of_bits(_bits_of((n + 1023.0) + ROUNDING) << 52)


two_product = compile_part(inspect.unwrap(_two_product))
LAST_PLACES = 0x433 << 52  # bits of 2⁵², in which a unit is the last place
FOR_NUMBA: dict[str, Any] = {
    "two_product": two_product, "bits_of": _bits_of, "of_bits": _of_bits,
    "as_sum": compile_part(lambda x: x), "join": compile_part(lambda x, y: x + y), "negated": _negated,
    "multiply_terms": _multiply_terms, "compress": _compress, "distil": _distil,
    "record": _record, "put_record": _put_record, "load": _load,
    "binary_exponent": compile_part(inspect.unwrap(_binary_exponent)),
    "times_power": compile_part(inspect.unwrap(_times_power)),
    "square_root": compile_part(lambda x: np.sqrt(x)), "exponential": compile_part(lambda x: math.exp(x)),
    "floor": compile_part(lambda x: np.floor(x)), "nearest": compile_part(lambda x: np.rint(x)),
    "room": compile_part(lambda count: np.empty(count)), "cleared": compile_part(lambda count: np.zeros(count)),
    "flags": compile_part(lambda count: np.empty(count, np.bool_)),
    "places": compile_part(lambda count: np.empty(count, np.int64)),
}  # fmt: skip

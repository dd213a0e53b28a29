"""Arithmetic of the kernels for Numba: instructions and functions in place of some of ``kernel_arithmetic``."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite.ir import Constant
from numba.core.cgutils import unpack_tuple
from numba.core.types import UniTuple, float64, int64, none
from numba.extending import intrinsic
from numba.np.arrayobj import make_array

from polhode._base.compiled.compiling import compile_part
from polhode.exact._kernel_arithmetic import BLOCK


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
def _put_record(context: Any, rows: Any, i: Any, values: Any) -> Any:
    def write(context: Any, builder: Any, _: Any, operands: Any) -> Any:
        places = _places(context, builder, rows, operands, len(values))
        for place, value in zip(places, unpack_tuple(builder, operands[2]), strict=True):
            builder.store(value, place)
        return context.get_dummy_value()

    return none(rows, i, values), write


def _places(context: Any, builder: Any, rows: Any, values: Any, count: int) -> list[Any]:
    """Return pointers to numbers of an array that stand BLOCK apart."""
    data, first = make_array(rows)(context, builder, values[0]).data, values[1]
    steps = [builder.add(first, Constant(first.type, k * BLOCK)) for k in range(count)]
    return [builder.gep(data, [step], inbounds=True) for step in steps]


two_product = compile_part(inspect.unwrap(_two_product))
FOR_NUMBA: dict[str, Any] = {
    "two_product": two_product, "bits_of": _bits_of, "of_bits": _of_bits,
    "record": _record, "put_record": _put_record,
    "square_root": compile_part(lambda x: np.sqrt(x)), "exponential": compile_part(lambda x: math.exp(x)),
    "floor": compile_part(lambda x: np.floor(x)), "nearest": compile_part(lambda x: np.rint(x)),
    "room": compile_part(lambda count: np.zeros(count)), "flags": compile_part(lambda count: np.empty(count, np.bool_)),
    "places": compile_part(lambda count: np.empty(count, np.int64)),
}  # fmt: skip

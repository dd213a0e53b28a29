"""Eight doubles as one value of Numba: loads, stores and arithmetic of LLVM's <8 x double>.

LLVM does not find the vectors in these kernels by itself. A value that is one needs no search, and becomes whatever the
machine has: one register of AVX-512, two of AVX, four of SSE or NEON.
"""

from __future__ import annotations

import operator
from typing import Any

from polhode.taylor.vectors import WIDTH

_FLAGS = ()


def vector_operations() -> tuple[Any, Any, Any]:
    """Teach Numba sums and products of vectors, and return how they are loaded, stored and gathered.

    ``load(array, index)`` is array[index : index + 8] of a contiguous flat array, ``store(array, index, value)`` sets
    it, and ``gather(array, places, first, base)`` is array[base + places[first + l]] for l = 0 … 7. Nothing is checked.
    """
    from llvmlite import ir
    from numba.core import types
    from numba.extending import intrinsic, models, register_model

    vector = ir.VectorType(ir.DoubleType(), WIDTH)

    class Vector(types.Type):
        def __init__(self) -> None:
            super().__init__(name="Vector8")

    class Model(models.PrimitiveModel):
        def __init__(self, manager: Any, kind: Any) -> None:
            super().__init__(manager, kind, vector)

    register_model(Vector)(Model)
    kind = Vector()
    for symbol, named in ((operator.add, "fadd"), (operator.mul, "fmul")):
        _define(symbol, named, Vector, kind)

    def place(context: Any, builder: Any, of: Any, array: Any, index: Any) -> Any:
        data = context.make_array(of)(context, builder, array).data
        return builder.bitcast(builder.gep(data, [index]), vector.as_pointer())

    def load(typing: Any, array: Any, index: Any) -> Any:
        def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            value = builder.load(place(context, builder, sig.args[0], args[0], args[1]))
            value.align = 8
            return value

        return kind(array, types.int64), generate

    def store(typing: Any, array: Any, index: Any, value: Any) -> Any:
        def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            kept = builder.store(args[2], place(context, builder, sig.args[0], args[0], args[1]))
            kept.align = 8
            return context.get_dummy_value()

        return types.void(array, types.int64, kind), generate

    def gather(typing: Any, array: Any, places: Any, first: Any, base: Any) -> Any:
        def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
            numbers = context.make_array(sig.args[0])(context, builder, args[0])
            where = context.make_array(sig.args[1])(context, builder, args[1])
            value: Any = ir.Constant(vector, ir.Undefined)
            for lane in range(WIDTH):
                at = builder.add(args[2], ir.Constant(ir.IntType(64), lane))
                found = builder.add(args[3], builder.load(builder.gep(where.data, [at])))
                number = builder.load(builder.gep(numbers.data, [found]))
                value = builder.insert_element(value, number, ir.Constant(ir.IntType(32), lane))
            return value

        return kind(array, places, types.int64, types.int64), generate

    return intrinsic(load), intrinsic(store), intrinsic(gather)


def _define(symbol: Any, named: str, kind_of: Any, kind: Any) -> None:
    """Define an operation of two vectors by an instruction of LLVM."""
    from numba.core.typing.templates import AbstractTemplate, infer_global, signature
    from numba.extending import lower_builtin

    class Template(AbstractTemplate):
        key = symbol

        def generic(self, args: Any, kws: Any) -> Any:
            both = len(args) == 2 and args[0] == kind and args[1] == kind
            return signature(kind, kind, kind) if both else None

    register: Any = infer_global  # whose types say it may be None
    register(symbol)(Template)

    def lower(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return getattr(builder, named)(args[0], args[1], flags=_FLAGS)

    lower_builtin(symbol, kind_of, kind_of)(lower)

"""Arithmetic of a kernel for Numba: loads, stores and operations on LLVM's <8 x double>.

LLVM does not find the vectors in these kernels by itself. A value that is one needs no search, and becomes whatever the
machine has: one register of AVX-512, two of AVX, four of SSE or NEON.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from functools import cache
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, models, register_model
from numba.np.arrayobj import make_array

from polhode.taylor.llvm_writer import SIGNATURE
from polhode.taylor.vectors import WIDTH

DOUBLE = ir.DoubleType()
VECTOR = ir.VectorType(DOUBLE, WIDTH)
ARITHMETIC = {operator.add: "fadd", operator.sub: "fsub", operator.mul: "fmul", operator.truediv: "fdiv"}


class Vector(types.Type):
    """Eight doubles."""

    def __init__(self) -> None:
        super().__init__(name="Vector8")


@register_model(Vector)
class Model(models.PrimitiveModel):
    """It is one value to LLVM."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, VECTOR)


class Numbers(types.Type):
    """A pointer to numbers in memory: neither bounds nor signs of indices are checked, nor are references counted."""

    def __init__(self, of: Any) -> None:
        self.of = of
        super().__init__(name=f"Numbers({of})")


@register_model(Numbers)
class NumbersModel(models.PrimitiveModel):
    """It is an address to LLVM."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, manager[kind.of].get_value_type().as_pointer())


KIND = Vector()


@cache
def of_one_copy() -> dict[str, Any]:
    """Return the functions that load, store and gather vectors from flat arrays, without checks."""
    _define_arithmetic()
    declarations = {"load": _load, "store": _store, "gather": _gather, "repeat": _spread,
            "borrow": _declare_borrow, "run_code": _run_code, "vectors": _declare_view(types.float64)}  # fmt: skip
    return {name: intrinsic(declaration) for name, declaration in declarations.items()}


@cache
def of_lanes() -> dict[str, Any]:
    """Return the replacements of the functions in ``lanes``."""
    _define_arithmetic()
    declarations = {"borrow": _declare_borrow, "run_code": _run_code, "vectors": _declare_view(KIND), "spread": _spread,
            "where_less": _where_less}  # fmt: skip
    each = {"raise_power": math.pow, "exponential": math.exp, "logarithm": math.log, "sine": math.sin,
            "cosine": math.cos, "exponential_minus_one": math.expm1, "logarithm_of_one_plus": math.log1p,
            "hyperbolic_tangent": math.tanh}  # fmt: skip
    return {name: intrinsic(declaration) for name, declaration in declarations.items()} | {
        name: intrinsic(_of_each(of, 2 if name == "raise_power" else 1)) for name, of in each.items()
    }


def _load(typing: Any, array: Any, index: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        value = builder.load(_place(context, builder, sig.args[0], args[0], args[1]))
        value.align = 8
        return value

    return KIND(array, types.int64), generate


def _store(typing: Any, array: Any, index: Any, value: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        kept = builder.store(args[2], _place(context, builder, sig.args[0], args[0], args[1]))
        kept.align = 8
        return context.get_dummy_value()

    return types.void(array, types.int64, KIND), generate


def _place(context: Any, builder: Any, of: Any, array: Any, index: Any) -> Any:
    return builder.bitcast(builder.gep(_data(context, builder, of, array), [index]), VECTOR.as_pointer())


def _gather(typing: Any, array: Any, places: Any, first: Any, base: Any) -> Any:
    """Declare array[base + places[first + l]] for l = 0 … 7."""

    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        numbers, where = (_data(context, builder, sig.args[k], args[k]) for k in (0, 1))
        values = []
        for lane in range(WIDTH):
            at = builder.add(args[2], ir.Constant(ir.IntType(64), lane))
            values.append(builder.load(builder.gep(numbers, [
                builder.add(args[3], builder.load(builder.gep(where, [at])))])))
        return _join(builder, values)

    return KIND(array, places, types.int64, types.int64), generate


def _declare_borrow(typing: Any, kind: Any) -> Any:
    """Declare these types without owners: flat arrays of numbers as their addresses, in tuples too."""
    bare = _bare(kind)
    return bare(kind), lambda context, builder, sig, args: _make_bare(context, builder, kind, args[0])


def _bare(kind: Any) -> Any:
    if isinstance(kind, types.BaseTuple):
        members: Any = kind  # whose types do not know that it has some
        return types.BaseTuple.from_types([_bare(of) for of in members.types], members.instance_class)
    if isinstance(kind, types.Array) and kind.ndim == 1 and kind.dtype in (types.float64, types.int64):
        return Numbers(kind.dtype)
    return kind


def _make_bare(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    if isinstance(kind, types.BaseTuple):
        members: Any = kind
        parts = [builder.extract_value(value, k) for k in range(len(members.types))]
        bare = [_make_bare(context, builder, of, part) for of, part in zip(members.types, parts, strict=True)]
        return context.make_tuple(builder, _bare(kind), bare)
    if isinstance(_bare(kind), Numbers):
        return _data(context, builder, kind, value)
    if isinstance(kind, types.Array):
        array = make_array(kind)(context, builder, value)
        array.meminfo = cgutils.get_null_value(array.meminfo.type)
        array.parent = cgutils.get_null_value(array.parent.type)
        return array._getvalue()
    return value


def _data(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    """Return the address at which numbers begin."""
    return value if isinstance(kind, Numbers) else make_array(kind)(context, builder, value).data


def _run_code(typing: Any, address: Any, flat: Any, a: Any, b: Any, number: Any, order: Any, units: Any) -> Any:
    """Declare a call of ``straight_line`` code."""

    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        of = builder.inttoptr(args[0], SIGNATURE.as_pointer())
        data = [_data(context, builder, sig.args[k], args[k]) for k in (1, 2, 3, 4, 6)]
        builder.call(of, [*data[:4], args[5], data[4]])
        return context.get_dummy_value()

    return types.void(types.int64, flat, a, b, number, types.int64, units), generate


def _declare_view(of: Any) -> Callable[..., Any]:
    """Return the declaration of the memory as numbers of one kind."""
    kind = Numbers(of)

    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        data = _data(context, builder, sig.args[0], args[0])
        return builder.bitcast(data, context.get_value_type(kind))

    return lambda typing, array: (kind(array), generate)


def _spread(typing: Any, x: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return _splat(builder, context.cast(builder, args[0], sig.args[0], types.float64))

    return KIND(x), generate


def _where_less(typing: Any, x: Any, y: Any, yes: Any, no: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return builder.select(builder.fcmp_ordered("<", args[0], args[1]), args[2], args[3])

    return KIND(KIND, KIND, KIND, KIND), generate


def _of_each(function: Callable[..., float], count: int) -> Callable[..., Any]:
    """Return the declaration of a function of each number, and of another one that all share."""
    doubles = (types.float64,) * count

    def generate(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        of = context.typing_context.resolve_value_type(function)
        kind = of.get_call_type(context.typing_context, doubles, {})
        call = context.get_function(of, kind)
        others = list(args[1:])
        return _join(builder, [call(builder, [_lane(builder, args[0], lane), *others]) for lane in range(WIDTH)])

    if count == 1:
        return lambda typing, x: (KIND(KIND), generate)
    return lambda typing, x, other: (KIND(KIND, types.float64), generate)


def _lane(builder: Any, value: Any, lane: int) -> Any:
    return builder.extract_element(value, ir.Constant(ir.IntType(32), lane))


def _join(builder: Any, numbers: list[Any]) -> Any:
    value: Any = ir.Constant(VECTOR, ir.Undefined)
    for lane, number in enumerate(numbers):
        value = builder.insert_element(value, number, ir.Constant(ir.IntType(32), lane))
    return value


def _splat(builder: Any, number: Any) -> Any:
    return _join(builder, [number] * WIDTH)


def _call(builder: Any, name: str, value: Any) -> Any:
    kind = ir.FunctionType(VECTOR, [VECTOR])
    return builder.call(cgutils.get_or_insert_function(builder.module, kind, f"{name}.v{WIDTH}f64"), [value])


@cache
def _define_arithmetic() -> None:
    """Teach Numba sums, products and quotients of vectors, also with one number that all share."""
    register: Any = infer_global  # whose types say it may be None
    for symbol, named in ARITHMETIC.items():

        class Template(AbstractTemplate):
            key = symbol

            def generic(self, args: Any, kws: Any) -> Any:
                if KIND not in args or not all(kind == KIND or isinstance(kind, types.Number) for kind in args):
                    return None
                return signature(KIND, *(kind if kind == KIND else types.float64 for kind in args))

        register(symbol)(Template)
        for kinds in ((Vector, Vector), (Vector, types.Float), (types.Float, Vector)):
            lower_builtin(symbol, *kinds)(_make_lowering(named))

    class Read(AbstractTemplate):
        key = operator.getitem

        def generic(self, args: Any, kws: Any) -> Any:
            return signature(args[0].of, args[0], types.int64) if isinstance(args[0], Numbers) else None

    class Write(AbstractTemplate):
        key = operator.setitem

        def generic(self, args: Any, kws: Any) -> Any:
            kinds = args[0], types.int64, getattr(args[0], "of", None)
            return signature(types.none, *kinds) if isinstance(args[0], Numbers) else None

    register(operator.getitem)(Read)
    register(operator.setitem)(Write)
    lower_builtin(operator.getitem, Numbers, types.Integer)(_read)
    lower_builtin(operator.setitem, Numbers, types.Integer, types.Any)(_write)

    class Absolute(AbstractTemplate):
        key = abs

        def generic(self, args: Any, kws: Any) -> Any:
            return signature(KIND, KIND) if args == (KIND,) else None

    register(abs)(Absolute)
    lower_builtin(abs, Vector)(lambda context, builder, sig, args: _call(builder, "llvm.fabs", args[0]))


def _make_lowering(named: str) -> Callable[..., Any]:
    def lower(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        both = (x if kind == KIND else _splat(builder, x) for x, kind in zip(args, sig.args, strict=True))
        return getattr(builder, named)(*both)

    return lower


def _read(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    value = builder.load(builder.gep(args[0], [args[1]]))
    value.align = 8
    return value


def _write(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    kept = builder.store(args[2], builder.gep(args[0], [args[1]]))
    kept.align = 8
    return context.get_dummy_value()

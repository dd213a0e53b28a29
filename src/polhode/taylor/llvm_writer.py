"""A function of LLVM in the making: numbers of one copy or of eight in memory, sums of them, and loops."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from llvmlite import ir

from polhode._base.compiled.machine_code import compile_module
from polhode.taylor.vectors import WIDTH

DOUBLE, INTEGER = ir.DoubleType(), ir.IntType(64)
VECTOR = ir.VectorType(DOUBLE, WIDTH)
ADDRESS = DOUBLE.as_pointer()
SIGNATURE = ir.FunctionType(ir.VoidType(), [ADDRESS] * 4 + [INTEGER, ADDRESS])
NAME = "run"
INSTRUCTIONS = {"+": ("add", "fadd"), "-": ("sub", "fsub"), "*": ("mul", "fmul"), "/": ("sdiv", "fdiv")}


class Code(NamedTuple):
    """A compiled function, and what keeps it in memory.

    Attributes:
        address: of a function of the coefficients, both stores of factors, the program's numbers, order and units.
        begins: the first order that it computes.
        engine: of LLVM.
    """

    address: int
    begins: int
    engine: Any


class Writer:
    """A function of LLVM with ``SIGNATURE``, of so many copies side by side."""

    def __init__(self, lanes: int) -> None:
        self.lanes, self.kind = lanes, VECTOR if lanes == WIDTH else DOUBLE
        self.module = ir.Module()
        function = ir.Function(self.module, SIGNATURE, NAME)
        for argument in function.args:
            if argument.type == ADDRESS:
                argument.add_attribute("noalias")
        self.flat, self.a, self.b, self.number, self.order, self.units = function.args
        self.builder = ir.IRBuilder(function.append_basic_block())

    def compile(self, begins: int) -> Code:
        """Return the machine code."""
        self.builder.ret_void()
        address, engine = compile_module(self.module, NAME)
        return Code(address, begins, engine)

    def load(self, base: Any, place: int, kind: Any = None) -> Any:
        kind = kind or self.kind
        at = self.builder.gep(base, [INTEGER(place)])  # all addresses are multiples of eight bytes
        return self.builder.load(self.builder.bitcast(at, kind.as_pointer()), align=8)

    def store(self, value: Any, base: Any, place: int) -> None:
        at = self.builder.gep(base, [INTEGER(place)])
        self.builder.store(value, self.builder.bitcast(at, value.type.as_pointer()), align=8)

    def load_number(self, place: int) -> Any:
        """Return one of the program's numbers."""
        return self.builder.load(self.builder.gep(self.number, [INTEGER(place)]))

    def spread(self, x: Any) -> Any:
        """Return one number for all copies."""
        if self.kind is DOUBLE:
            return x
        one = self.builder.insert_element(ir.Constant(VECTOR, ir.Undefined), x, ir.IntType(32)(0))
        places = ir.Constant(ir.VectorType(ir.IntType(32), WIDTH), [0] * WIDTH)
        return self.builder.shuffle_vector(one, ir.Constant(VECTOR, ir.Undefined), places)

    def operate(self, symbol: str, left: Any, right: Any) -> Any:
        """Return a sum, difference, product or quotient of integers, of numbers, or of one of them for each copy."""
        kinds = [x.type for x in (left, right) if not isinstance(x, int | float)]
        kind = VECTOR if VECTOR in kinds else DOUBLE if DOUBLE in kinds else INTEGER
        of_integers, of_numbers = INSTRUCTIONS[symbol]
        both = (self._convert(x, kind) for x in (left, right))
        return getattr(self.builder, of_integers if kind is INTEGER else of_numbers)(*both)

    def _convert(self, x: Any, kind: Any) -> Any:
        """Return an integer or a number, of Python or of LLVM, as one of a kind."""
        if isinstance(x, int | float):
            x = INTEGER(x) if kind is INTEGER else DOUBLE(float(x))
        elif x.type == INTEGER != kind:
            x = self.builder.sitofp(x, DOUBLE)
        return self.spread(x) if kind is VECTOR and x.type == DOUBLE else x

    def loop(
        self, first: Any, stop: Any, step: int, carried: Sequence[Any], body: Callable[..., Sequence[Any]]
    ) -> list[Any]:
        """Write a loop over first, first + step, … < stop, and return what it carries on in the end."""
        before, builder = self.builder.block, self.builder
        head, inside, after = (builder.append_basic_block() for _ in range(3))
        builder.branch(head)
        builder.position_at_end(head)
        j = builder.phi(INTEGER)
        values = [builder.phi(value.type) for value in carried]
        j.add_incoming(first, before)
        for phi, value in zip(values, carried, strict=True):
            phi.add_incoming(value, before)
        builder.cbranch(builder.icmp_signed("<", j, stop), inside, after)
        builder.position_at_end(inside)
        results = body(j, *values)
        j.add_incoming(builder.add(j, INTEGER(step)), builder.block)
        for phi, value in zip(values, results, strict=True):
            phi.add_incoming(value, builder.block)
        builder.branch(head)
        builder.position_at_end(after)
        return values

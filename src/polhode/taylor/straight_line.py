"""Machine code for the coefficients of one form of program, without the tables that the kernel reads.

It makes the same sums in the same order, so that no bit depends on which of the two computes. Programs that differ by
factors alone share one code, unless these are 1 or −1 in one and not in the other. LLVM takes some hundredths of a
second for a program of dozens of operations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from llvmlite import binding, ir

from polhode.taylor.expressions import Operation
from polhode.taylor.program import (
    ARGUMENT,
    CODE,
    CONSTANT,
    FACTOR,
    FIRST,
    INDEX,
    LEFT,
    NUMBER,
    OPERATIONS,
    OUT,
    PRODUCTS,
    RIGHT,
    SIZE,
    SLOTS,
    START,
    Program,
)
from polhode.taylor.vectors import WIDTH

DOUBLE, INTEGER = ir.DoubleType(), ir.IntType(64)
VECTOR = ir.VectorType(DOUBLE, WIDTH)
ADDRESS = DOUBLE.as_pointer()
SIGNATURE = ir.FunctionType(ir.VoidType(), [ADDRESS] * 4 + [INTEGER, ADDRESS])
ALIGNED = 8  # bytes, to which all addresses are
BLOCKS = 4  # of products of one copy, whose sums are made together
Terms = Callable[[Any, Any], list[Any]]


class Code(NamedTuple):
    """A compiled function, and what keeps it in memory.

    Attributes:
        address: of a function of the coefficients, both stores of factors, the program's numbers, order and units.
        engine: of LLVM.
    """

    address: int
    engine: Any


def generate(program: Program, lanes: int) -> Code:
    """Return the code that computes coefficients of so many copies at a time; see ``kernel_series.coefficients``."""
    factors = program.number[program.whole[FACTOR] : program.whole[CONSTANT]]
    signs = np.where(np.abs(factors) == 1.0, factors, 0.0).astype(np.int8)
    counts = program.number[program.whole[NUMBER] : program.whole[FACTOR]].astype(np.int64)
    counts *= program.operations == Operation.PRODUCT  # other operations have a constant or an exponent there
    return _compile(program.whole.tobytes(), signs.tobytes(), counts.tobytes(), lanes)


@lru_cache(maxsize=128)
def _compile(whole: bytes, signs: bytes, counts: bytes, lanes: int) -> Code:
    tables = np.frombuffer(whole, np.int64), np.frombuffer(signs, np.int8), np.frombuffer(counts, np.int64)
    written = _Writer(*tables, lanes)
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    module = binding.parse_assembly(str(written.module))
    module.verify()
    target = binding.Target.from_default_triple()
    machine = target.create_target_machine(cpu=binding.get_host_cpu_name(), features=_features().flatten(), opt=2)
    engine = binding.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    return Code(engine.get_function_address("coefficients"), engine)


def most_together() -> int:
    """Return how many products' sums fit the registers of this machine."""
    return 12 if _features().get("avx512f") else 3


def _features() -> Any:
    try:
        return binding.get_host_cpu_features()
    except RuntimeError:  # LLVM does not know this machine
        return binding.FeatureMap()


def _parts(whole: list[Any], size: int) -> list[list[Any]]:
    return [whole[low : low + size] for low in range(0, len(whole), size)]


class _Writer:
    """A function of LLVM in the making."""

    def __init__(self, whole: Any, signs: Any, counts: Any, lanes: int) -> None:
        # as llvmlite writes constants from Python's integers, not from NumPy's
        self.whole, self.signs, self.counts = whole.tolist(), signs.tolist(), counts.tolist()
        self.lanes = lanes
        self.kind = VECTOR if lanes == WIDTH else DOUBLE
        self.row = self.whole[SLOTS] * lanes
        self.module = ir.Module()
        self.module.triple = binding.get_default_triple()
        function = ir.Function(self.module, SIGNATURE, "coefficients")
        for argument in function.args:
            if argument.type == ADDRESS:
                argument.add_attribute("noalias")
        self.flat, self.a, self.b, self.number, self.order, units = function.args
        self.builder = ir.IRBuilder(function.append_basic_block())
        self.unit = self._load(units, 0)
        self._outputs(self.flat, None)
        self._loop(INTEGER(1), self.order, 1, [], self._of_order)
        self.builder.ret_void()

    # ------------------------------------------------------------------ numbers

    def _load(self, base: Any, place: int, kind: Any = None) -> Any:
        kind = kind or self.kind
        at = self.builder.gep(base, [INTEGER(place)])
        return self.builder.load(self.builder.bitcast(at, kind.as_pointer()), align=ALIGNED)

    def _store(self, value: Any, base: Any, place: int) -> None:
        at = self.builder.gep(base, [INTEGER(place)])
        self.builder.store(value, self.builder.bitcast(at, value.type.as_pointer()), align=ALIGNED)

    def _spread(self, x: Any) -> Any:
        """Return one number for all copies."""
        if self.kind is DOUBLE:
            return x
        one = self.builder.insert_element(ir.Constant(VECTOR, ir.Undefined), x, ir.IntType(32)(0))
        places = ir.Constant(ir.VectorType(ir.IntType(32), WIDTH), [0] * WIDTH)
        return self.builder.shuffle_vector(one, ir.Constant(VECTOR, ir.Undefined), places)

    def _z(self, row: Any, slot: int) -> Any:
        """Return the coefficient of a node, of the order whose row begins there."""
        return self._load(row, slot * self.lanes)

    def _load_number(self, place: int) -> Any:
        """Return one of the program's numbers."""
        return self.builder.load(self.builder.gep(self.number, [INTEGER(place)]))

    def _locate_row(self, j: Any) -> Any:
        return self.builder.gep(self.flat, [self.builder.mul(j, INTEGER(self.row))])

    def _loop(
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

    # ------------------------------------------------------------------ one order

    def _of_order(self, k: Any) -> list[Any]:
        whole, now = self.whole, self._locate_row(k)
        products: list[int] = []
        for q in range(whole[OPERATIONS]):
            operation = Operation(whole[whole[CODE] + q])
            if operation is Operation.PRODUCT:
                if self._needs(q, products):
                    self._products(k, now, products)
                    products = []
                products.append(q)
                continue
            self._products(k, now, products)
            products = []
            out, x = whole[whole[OUT] + q], whole[whole[ARGUMENT] + q]
            if operation is Operation.AFFINE:
                self._store(self._combination(now, x), now, out * self.lanes)
            else:
                self._function(operation, k, now, out, x, whole[NUMBER] + q)
        self._products(k, now, products)
        self._outputs(now, k)
        return []

    def _combination(self, row: Any, number: int) -> Any:
        whole, builder = self.whole, self.builder
        value = self._spread(DOUBLE(0.0))
        first, last = whole[whole[START] + number : whole[START] + number + 2]
        for q in range(first, last):
            z, sign = self._z(row, whole[whole[INDEX] + q]), self.signs[q]
            if sign == 0:
                z = builder.fmul(self._spread(self._load_number(whole[FACTOR] + q)), z)
            if q == first:
                value = builder.fneg(z) if sign < 0 else z
            else:
                value = builder.fsub(value, z) if sign < 0 else builder.fadd(value, z)
        return value

    def _outputs(self, now: Any, k: Any) -> None:
        """Write the state's next coefficients; of the first order where k is None."""
        whole, builder = self.whole, self.builder
        divisor = None if k is None else self._spread(builder.sitofp(builder.add(k, INTEGER(1)), DOUBLE))
        for i in range(whole[SIZE]):
            value = self._combination(now, whole[FIRST] + i)
            if divisor is None:
                value = builder.fadd(value, self._spread(self._load_number(whole[CONSTANT] + i)))
            value = builder.fmul(value, self.unit)
            self._store(value if divisor is None else builder.fdiv(value, divisor), now, self.row + i * self.lanes)

    # ------------------------------------------------------------------ products

    def _products(self, k: Any, now: Any, blocks: list[int]) -> None:
        """Write all products of a level: of eight copies each by itself, of one copy eight at a time."""
        whole = self.whole
        if self.lanes == WIDTH:
            ones = [(whole[whole[LEFT] + m], whole[whole[RIGHT] + m], whole[whole[OUT] + q] + p)
                    for q in blocks for p, m in enumerate(self._members(q))]  # fmt: skip
            for part in _parts(ones, most_together()):
                self._sums(k, now, self._of_copies(part), [out * WIDTH for _, _, out in part])
            return
        for part in _parts(blocks, BLOCKS):
            firsts = [whole[whole[ARGUMENT] + q] for q in part]
            for first in firsts:
                self._keep(k, now, first)
            self._sums(k, now, self._of_blocks(firsts), [whole[whole[OUT] + q] for q in part])

    def _needs(self, q: int, others: list[int]) -> bool:
        """Return whether a block has factors that other blocks make."""
        whole = self.whole
        outputs = {whole[whole[OUT] + other] + lane for other in others for lane in range(WIDTH)}
        factors = (whole[whole[table] + m] for m in self._members(q) for table in (LEFT, RIGHT))
        return not outputs.isdisjoint(factors)

    def _members(self, q: int) -> range:
        """Return which products a block has, without those that fill it."""
        first = self.whole[self.whole[ARGUMENT] + q]
        return range(first, first + self.counts[q])

    def _of_copies(self, products: Sequence[tuple[int, int, int]]) -> Terms:
        """Return what gives the terms of products, whose common factors are loaded once; see ``kernel_lanes``."""

        def terms(left: Any, right: Any) -> list[Any]:
            lefts, rights = self._locate_row(left), self._locate_row(right)
            x = {i: self._z(lefts, i) for i, _, _ in products}
            y = {j: self._z(rights, j) for _, j, _ in products}
            return [self.builder.fmul(x[i], y[j]) for i, j, _ in products]

        return terms

    def _keep(self, k: Any, now: Any, first: int) -> None:
        """Write where a block's factors are kept; see ``kernel_products``."""
        for table, store in ((LEFT, self.a), (RIGHT, self.b)):
            value = ir.Constant(VECTOR, ir.Undefined)
            for lane in range(WIDTH):
                factor = self._z(now, self.whole[self.whole[table] + first + lane])
                value = self.builder.insert_element(value, factor, ir.IntType(32)(lane))
            self._store(value, self._locate_kept_row(store, k), first)

    def _locate_kept_row(self, store: Any, order: Any) -> Any:
        return self.builder.gep(store, [self.builder.mul(order, INTEGER(self.whole[PRODUCTS]))])

    def _of_blocks(self, firsts: Sequence[int]) -> Terms:
        def terms(left: Any, right: Any) -> list[Any]:
            lefts, rights = self._locate_kept_row(self.a, left), self._locate_kept_row(self.b, right)
            return [self.builder.fmul(self._load(lefts, m, VECTOR), self._load(rights, m, VECTOR)) for m in firsts]

        return terms

    def _sums(self, k: Any, now: Any, terms: Terms, places: Sequence[int]) -> None:
        """Write both sums of each product, and store what they make; ``terms`` are of two orders that make k."""
        builder, none, one = self.builder, INTEGER(0), INTEGER(1)
        count, start = len(places), terms(k, none) + terms(none, k)

        def inner(j: Any, *sums: Any) -> list[Any]:
            late = builder.sub(k, j)
            more = terms(j, late) + terms(builder.add(j, one), builder.sub(late, one))
            return [builder.fadd(s, t) for s, t in zip(sums, more, strict=True)]

        before_last = builder.sub(k, one)
        sums = self._loop(one, before_last, 2, start, inner)
        before = builder.block
        even, after = builder.append_basic_block(), builder.append_basic_block()
        builder.cbranch(builder.trunc(k, ir.IntType(1)), after, even)
        builder.position_at_end(even)
        with_last: list[Any] = [builder.fadd(s, t) for s, t in zip(sums[:count], terms(before_last, one), strict=True)]
        builder.branch(after)
        builder.position_at_end(after)
        phis = [builder.phi(value.type) for value in with_last]
        for phi, without, last in zip(phis, sums, with_last, strict=False):
            phi.add_incoming(without, before)
            phi.add_incoming(last, even)
        for phi, other, place in zip(phis, sums[count:], places, strict=True):
            self._store(builder.fadd(phi, other), now, place)

    # ------------------------------------------------------------------ functions

    def _function(self, operation: Operation, k: Any, now: Any, out: int, x: int, number: int) -> None:
        """Write the recurrence of a function of node x; see ``kernel_series.function``."""
        builder, zero, one = self.builder, self._spread(DOUBLE(0.0)), INTEGER(1)
        whole_k, first = builder.sitofp(k, DOUBLE), self._z(self.flat, x)

        def past(j: Any) -> tuple[Any, Any]:
            """Return k − j as a double, and the coefficient of x of that order."""
            late = builder.sub(k, j)
            return builder.sitofp(late, DOUBLE), self._z(self._locate_row(late), x)

        def weigh(weight: Any, j: Any, node: int, z: Any) -> Any:
            return builder.fmul(self._spread(weight), builder.fmul(self._z(self._locate_row(j), node), z))

        def of_power(j: Any, total: Any) -> list[Any]:
            late, z = past(j)
            weight = builder.fsub(builder.fmul(exponent, late), builder.sitofp(j, DOUBLE))
            return [builder.fadd(total, weigh(weight, j, out, z))]

        def of_exponential(j: Any, total: Any) -> list[Any]:
            late, z = past(j)
            return [builder.fadd(total, weigh(late, j, out, z))]

        def of_logarithm(j: Any, total: Any) -> list[Any]:
            return [builder.fadd(total, weigh(builder.sitofp(j, DOUBLE), j, out, past(j)[1]))]

        def of_sine(j: Any, sine: Any, cosine: Any) -> list[Any]:
            late, z = past(j)
            weight, row = builder.fmul(self._spread(late), z), self._locate_row(j)
            return [builder.fadd(sine, builder.fmul(weight, self._z(row, out + 1))),
                    builder.fsub(cosine, builder.fmul(weight, self._z(row, out)))]  # fmt: skip

        if operation is Operation.POWER:
            exponent = self._load_number(number)
            (total,) = self._loop(INTEGER(0), k, 1, [zero], of_power)
            results = [builder.fdiv(total, builder.fmul(self._spread(whole_k), first))]
        elif operation is Operation.EXPONENTIAL:
            (total,) = self._loop(INTEGER(0), k, 1, [zero], of_exponential)
            results = [builder.fdiv(total, self._spread(whole_k))]
        elif operation is Operation.LOGARITHM:
            (total,) = self._loop(one, k, 1, [zero], of_logarithm)
            rest = builder.fdiv(total, self._spread(whole_k))
            results = [builder.fdiv(builder.fsub(self._z(now, x), rest), first)]
        elif operation is Operation.ECCENTRIC:
            results = self._orbital(k, now, out, x, self._spread(self._load_number(number)))
        else:
            totals = self._loop(INTEGER(0), k, 1, [zero, zero], of_sine)
            results = [builder.fdiv(total, self._spread(whole_k)) for total in totals]
        for place, value in enumerate(results):
            self._store(value, now, (out + place) * self.lanes)

    def _orbital(self, k: Any, now: Any, out: int, x: int, eccentricity: Any) -> list[Any]:
        """Write the recurrence of a place in an orbit; see ``kernel_series.orbital``."""
        builder, zero, one = self.builder, self._spread(DOUBLE(0.0)), INTEGER(1)
        by_k = self._spread(builder.sitofp(k, DOUBLE))

        def of_anomaly(j: Any, total: Any) -> list[Any]:
            past = self._z(self._locate_row(builder.sub(k, j)), out + 2)
            term = builder.fmul(self._z(self._locate_row(j), out), past)
            weighted = builder.fmul(self._spread(builder.sitofp(j, DOUBLE)), term)
            return [builder.fadd(total, builder.fmul(eccentricity, weighted))]

        def of_sine(j: Any, sine: Any, cosine: Any) -> list[Any]:
            weight = builder.fmul(self._spread(builder.sitofp(j, DOUBLE)), self._z(self._locate_row(j), out))
            row = self._locate_row(builder.sub(k, j))
            return [builder.fadd(sine, builder.fmul(weight, self._z(row, out + 2))),
                    builder.fsub(cosine, builder.fmul(weight, self._z(row, out + 1)))]  # fmt: skip

        (total,) = self._loop(one, k, 1, [builder.fmul(by_k, self._z(now, x))], of_anomaly)
        anomaly = builder.fdiv(total, builder.fmul(by_k, self._z(self.flat, out + 3)))
        self._store(anomaly, now, out * self.lanes)
        totals = self._loop(one, builder.add(k, one), 1, [zero, zero], of_sine)
        return [anomaly, *(builder.fdiv(of, by_k) for of in totals)]

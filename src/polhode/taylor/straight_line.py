"""Machine code for the coefficients of one form of program, without the tables that the kernel reads.

It makes the same sums in the same order, so that no bit depends on which of the two computes. Programs that differ by
factors alone share one code, unless these are 1 or −1 in one and not in the other. LLVM takes some hundredths of a
second for a program of dozens of operations.

Products and sums are not contracted into fused ones: on a Zen 3, which multiplies and adds beside each other, that
saved 0 to 7 % of a step, and Python, JavaScript and processors without such instructions would compute them slowly or
have other bits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir

from polhode._base.compiled.machine_code import host_features
from polhode.taylor.llvm_writer import ADDRESS, DOUBLE, INTEGER, SIGNATURE, VECTOR, Code, Writer
from polhode.taylor.operations import Operation
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
from polhode.taylor.recurrences import RECURRENCES, Coefficients, Word, Words
from polhode.taylor.vectors import WIDTH

Terms = Callable[[Any, Any], list[Any]]


class CodeLimits(NamedTuple):
    """The form of the code, and how long a function is."""

    blocks_together: int = 4  # of products of one copy, whose sums are interleaved
    # that a loop over products needs beside those of their sums, for factors and a product: of 16 with AVX, 4 take
    # Kirchhoff's coefficients 1.6 times as long, and 7, which leave fewer sums to a loop, the heavy top's 1.2 times
    registers_beside: int = 6
    products_sought: int = 64  # among which those with common factors are found, so that long programs take no longer
    terms_of_part: int = 500  # of sums and products of values: LLVM takes longer than in proportion for more in one


LIMITS = CodeLimits()


def generate(program: Program, lanes: int) -> Code:
    """Return the code that computes coefficients of so many copies at a time; see ``kernel_series.coefficients``.

    It begins with order zero where the program is of sums and products alone.
    """
    return _compile(*program.form_of_code, lanes, 0)


def generate_values(program: Program, lanes: int) -> Code:
    """Return the code that computes a program's outputs, and puts them behind the nodes of order zero.

    The program has some, and is of sums and products alone.
    """
    return _compile(*program.form_of_code, lanes, program.outputs)


@lru_cache(maxsize=256)
def _compile(whole: bytes, signs: bytes, counts: bytes, lanes: int, outputs: int) -> Code:
    tables = np.frombuffer(whole, np.int64), np.frombuffer(signs, np.int8), np.frombuffer(counts, np.int64)
    written = _Writer(*tables, lanes)
    return written.compile(written.write_values(outputs) if outputs else written.write_coefficients())


class Registers(NamedTuple):
    """The vector registers of a machine: how many there are, and doubles in each."""

    number: int
    doubles: int


def find_registers() -> Registers:
    """Return those of this machine."""
    features = host_features()
    if features.get("avx512f"):
        return Registers(32, 8)
    return Registers(16, 4) if features.get("avx") else Registers(32 if features.get("neon") else 16, 2)


def divide(sizes: Sequence[int]) -> list[range]:
    """Return ranges of things in order, of one thing each or with sizes of at most ``terms_of_part`` together."""
    first, size, parts = 0, 0, []
    for k, own in enumerate(sizes):
        if k > first and size + own > LIMITS.terms_of_part:
            parts.append(range(first, k))
            first, size = k, 0
        size += own
    return [*parts, range(first, len(sizes))]


def _parts(whole: list[Any], size: int) -> list[list[Any]]:
    return [whole[low : low + size] for low in range(0, len(whole), size)]


Product = tuple[int, int, int]  # slots of its factors and of itself


def _group_products(products: Sequence[Product], size: int) -> list[list[Product]]:
    """Return groups of products that have many factors in common, so that these are loaded once."""
    waiting, groups = list(products), list[list[Product]]()
    while waiting:
        first = waiting.pop(0)
        group, lefts, rights = [first], {first[0]}, {first[1]}
        while waiting and len(group) < size:
            sought = range(min(len(waiting), LIMITS.products_sought))
            loads = [(waiting[q][0] not in lefts) + (waiting[q][1] not in rights) for q in sought]
            following = waiting.pop(loads.index(min(loads)))
            group.append(following)
            lefts.add(following[0])
            rights.add(following[1])
        groups.append(sorted(group))
    return groups


class _Writer(Writer, Words):
    """The writer of a program's code, and the words of its recurrences."""

    def __init__(self, whole: Any, signs: Any, counts: Any, lanes: int) -> None:
        super().__init__(lanes)
        # as llvmlite writes constants from Python's integers, not from NumPy's
        self.whole, self.signs, self.counts = whole.tolist(), signs.tolist(), counts.tolist()
        self.row, self.registers = self.whole[SLOTS] * lanes, find_registers()

    def write_coefficients(self) -> int:
        """Write the coefficients of the state, and return the first order that this computes."""
        unit = self.load(self.units, 0)
        operations = self.whole[self.whole[CODE] :][: self.whole[OPERATIONS]]
        begins = int(not {*operations} <= {Operation.AFFINE, Operation.PRODUCT})
        if not begins:
            self._of_order(None, self.flat)
        self._rates(self.flat, None, unit)

        def of_order(k: Any) -> list[Any]:
            now = self._locate_row(k)
            self._of_order(k, now)
            self._rates(now, k, unit)
            return []

        self.loop(INTEGER(1), self.order, 1, [], of_order)
        return begins

    def write_values(self, outputs: int) -> int:
        """Write nodes of order zero, and so many outputs, in functions of limited length."""
        whole = self.whole
        terms = [self._count_terms(whole[whole[ARGUMENT] + q]) if whole[whole[CODE] + q] == Operation.AFFINE else WIDTH
                 for q in range(whole[OPERATIONS])]  # fmt: skip
        for some in divide(terms):
            self._of_order(None, self.flat, some)
            self._begin_part()
        for some in divide([self._count_terms(whole[FIRST] + o) for o in range(outputs)]):
            for o in some:
                self.store(self._output(self.flat, o, True), self.flat, self.row + o * self.lanes)
            self._begin_part()
        return 0

    def _begin_part(self) -> None:
        """Go on in another function, which this one calls at its end; values before that are in memory alone."""
        function = ir.Function(self.module, SIGNATURE, f"part{len(self.module.functions)}")
        function.linkage = "internal"
        function.attributes.add("noinline")
        self.builder.call(function, [self.flat, self.a, self.b, self.number, self.order, self.units])
        self.builder.ret_void()
        for argument in function.args:
            if argument.type == ADDRESS:
                argument.add_attribute("noalias")
        self.flat, self.a, self.b, self.number, self.order, self.units = function.args
        self.builder = ir.IRBuilder(function.append_basic_block())

    def _count_terms(self, number: int) -> int:
        first, last = self.whole[self.whole[START] + number : self.whole[START] + number + 2]
        return last - first

    # ------------------------------------------------------------------ numbers

    def _z(self, row: Any, slot: int) -> Any:
        """Return the coefficient of a node, of the order whose row begins there."""
        return self.load(row, slot * self.lanes)

    def _locate_row(self, j: Any) -> Any:
        return self.builder.gep(self.flat, [self.builder.mul(j, INTEGER(self.row))])

    # ------------------------------------------------------------------ one order

    def _of_order(self, k: Any | None, now: Any, some: range | None = None) -> None:
        """Write the nodes of all or some operations in an order, of order zero where k is None."""
        whole = self.whole
        products: list[int] = []
        for q in range(whole[OPERATIONS]) if some is None else some:
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
                value = self._combination(now, x)
                if k is None:
                    value = self.builder.fadd(value, self.spread(self.load_number(whole[NUMBER] + q)))
                self.store(value, now, out * self.lanes)
            else:
                self._function(operation, k, now, out, x, whole[NUMBER] + q)
        self._products(k, now, products)

    def _combination(self, row: Any, number: int) -> Any:
        whole, builder = self.whole, self.builder
        value = self.spread(DOUBLE(0.0))
        first, last = whole[whole[START] + number : whole[START] + number + 2]
        for q in range(first, last):
            z, sign = self._z(row, whole[whole[INDEX] + q]), self.signs[q]
            if sign == 0:
                z = builder.fmul(self.spread(self.load_number(whole[FACTOR] + q)), z)
            if q == first:
                value = builder.fneg(z) if sign < 0 else z
            else:
                value = builder.fsub(value, z) if sign < 0 else builder.fadd(value, z)
        return value

    def _output(self, row: Any, o: int, with_constant: bool) -> Any:
        value = self._combination(row, self.whole[FIRST] + o)
        if with_constant:
            value = self.builder.fadd(value, self.spread(self.load_number(self.whole[CONSTANT] + o)))
        return value

    def _rates(self, now: Any, k: Any | None, unit: Any) -> None:
        """Write the state's next coefficients; of the first order where k is None."""
        builder = self.builder
        divisor = None if k is None else self.spread(builder.sitofp(builder.add(k, INTEGER(1)), DOUBLE))
        for i in range(self.whole[SIZE]):
            value = builder.fmul(self._output(now, i, k is None), unit)
            self.store(value if divisor is None else builder.fdiv(value, divisor), now, self.row + i * self.lanes)

    # ------------------------------------------------------------------ products

    def _products(self, k: Any | None, now: Any, blocks: list[int]) -> None:
        """Write all products of a level: of eight copies each by itself, of one copy eight at a time."""
        whole = self.whole
        if self.lanes == WIDTH:
            products = [(whole[whole[LEFT] + m], whole[whole[RIGHT] + m], whole[whole[OUT] + q] + p)
                        for q in blocks for p, m in enumerate(self._members(q))]
            if k is None:
                for left, right, out in products:
                    self.store(self.builder.fmul(self._z(now, left), self._z(now, right)), now, out * WIDTH)
                return
            for group in _group_products(products, self._sums_that_fit):
                self._sums_of_copies(k, now, group)
            return
        if k is None:
            for q in blocks:
                left, right = self._keep(INTEGER(0), now, whole[whole[ARGUMENT] + q])
                self.store(self.builder.fmul(left, right), now, whole[whole[OUT] + q])
            return
        for part in _parts(blocks, LIMITS.blocks_together):
            firsts = [whole[whole[ARGUMENT] + q] for q in part]
            for first in firsts:
                self._keep(k, now, first)
            self._sums(k, now, VECTOR, self._of_blocks(firsts), [whole[whole[OUT] + q] for q in part])

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

    @property
    def _sums_that_fit(self) -> int:
        """How many sums the registers hold, beside what is added to them."""
        return self.registers.number - LIMITS.registers_beside

    def _sums_of_copies(self, k: Any, now: Any, products: Sequence[Product]) -> None:
        """Write the sums of products: of all copies in one loop, or of one register's copies after the other's.

        See ``kernel_lanes``.
        """
        doubles = self.registers.doubles
        fit = len(products) * WIDTH <= self._sums_that_fit * doubles
        width = WIDTH if fit else doubles
        kind = ir.VectorType(DOUBLE, width)
        for copy in range(0, WIDTH, width):

            def terms(left: Any, right: Any, copy: int = copy) -> list[Any]:
                lefts, rights = self._locate_row(left), self._locate_row(right)
                load = cache(lambda row, slot: self.load(row, slot * WIDTH + copy, kind))
                return [self.builder.fmul(load(lefts, i), load(rights, j)) for i, j, _ in products]

            self._sums(k, now, kind, terms, [out * WIDTH + copy for _, _, out in products])

    def _keep(self, k: Any, now: Any, first: int) -> list[Any]:
        """Write where a block's factors are kept, and return them; see ``kernel_products``."""
        kept = []
        for table, store in ((LEFT, self.a), (RIGHT, self.b)):
            value = ir.Constant(VECTOR, ir.Undefined)
            for lane in range(WIDTH):
                factor = self._z(now, self.whole[self.whole[table] + first + lane])
                value = self.builder.insert_element(value, factor, ir.IntType(32)(lane))
            self.store(value, self._locate_kept_row(store, k), first)
            kept.append(value)
        return kept

    def _locate_kept_row(self, store: Any, order: Any) -> Any:
        return self.builder.gep(store, [self.builder.mul(order, INTEGER(self.whole[PRODUCTS]))])

    def _of_blocks(self, firsts: Sequence[int]) -> Terms:
        def terms(left: Any, right: Any) -> list[Any]:
            lefts, rights = self._locate_kept_row(self.a, left), self._locate_kept_row(self.b, right)
            return [self.builder.fmul(self.load(lefts, m, VECTOR), self.load(rights, m, VECTOR)) for m in firsts]

        return terms

    def _sums(self, k: Any, now: Any, kind: Any, terms: Terms, places: Sequence[int]) -> None:
        """Write the sums of products, and store them; ``terms`` are of two orders that make k."""

        def add(j: Any, *sums: Any) -> list[Any]:
            return [self.builder.fadd(s, t) for s, t in zip(sums, terms(j, self.builder.sub(k, j)), strict=True)]

        none = INTEGER(0)
        sums = self.loop(INTEGER(1), k, 1, [ir.Constant(kind, [0.0] * kind.count)] * len(places), add)
        # the newest last, so that the older ones need not wait for them
        for value, place in zip(add(none, *add(k, *sums)), places, strict=True):
            self.store(value, now, place)

    # ------------------------------------------------------------------ functions

    def _function(self, operation: Operation, k: Any, now: Any, out: int, x: int, number: int) -> None:
        """Write the recurrence of a function of node x."""
        results, _, coefficients = RECURRENCES[operation]
        order, scalar = _Value(self, k), _Value(self, self.load_number(number))
        rows = {0: self.flat, order: now}

        def of(slot: int) -> Coefficients:
            find_row = lambda j: rows[j] if j in rows else self._locate_row(j.value)  # noqa: E731
            return Coefficients(lambda j: _Value(self, self._z(find_row(j), slot)))

        own = [of(slot) for slot in range(out, out + results)]
        for place, result in enumerate(coefficients(self, order, of(x), own, scalar), out):
            self.store(result.value, now, place * self.lanes)

    def totals(self, first: Any, stop: Any, starts: tuple[Any, ...], terms: Callable[[Any], Any]) -> list[_Value]:
        carried = [x.value if isinstance(x, _Value) else self.spread(DOUBLE(x)) for x in starts]

        def add(j: Any, *totals: Any) -> list[Any]:
            parts = terms(_Value(self, j))
            return [self.builder.fadd(total, part.value) for total, part in zip(totals, parts, strict=True)]

        return [_Value(self, total) for total in self.loop(INTEGER(first), stop.value, 1, carried, add)]


class _Value(Word):
    """A value of LLVM."""

    def __init__(self, writer: _Writer, value: Any) -> None:
        self.writer, self.value = writer, value

    def operate(self, symbol: str, left: Any, right: Any) -> _Value:
        bare = (x.value if isinstance(x, _Value) else x for x in (left, right))
        return _Value(self.writer, self.writer.operate(symbol, *bare))

    def __neg__(self) -> _Value:
        return _Value(self.writer, self.writer.builder.fneg(self.value))

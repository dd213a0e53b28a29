"""A tape as arrays, in the order in which its coefficients are computed.

Coefficients of one order of all nodes lie in one row. Nodes of a level need only nodes of lower levels; within a level
come affine combinations, then products in blocks of eight, then functions.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from polhode.taylor.expressions import Expression, Tape
from polhode.taylor.operations import ALONG, COMPANIONS, Node, Operation
from polhode.taylor.vectors import WIDTH
from polhode.types import Array, Bool, Float64, Integer

BLOCK = WIDTH  # products at a time
# where a program says how many, and where; see ``Program``
SIZE, SLOTS, OPERATIONS, PRODUCTS, FIRST = range(5)
CODE, OUT, ARGUMENT, LEFT, RIGHT, START, INDEX, NUMBER, FACTOR, CONSTANT = range(5, 15)
# functions whose arguments change by little in a step: roots and logarithms, exponentials, tanh, log(1 + x), sines
OF_ROOT, OF_EXPONENTIAL, OF_TANH, OF_ONE_PLUS, OF_ANGLE = range(5)


@dataclass(frozen=True, eq=False)  # a program is equal to itself alone, so that results derived from it can be kept
class Program:
    """A program for a kernel, in two flat arrays, as compiled functions take two arguments faster than twenty.

    Attributes:
        whole: (W,) integers. It begins with sizes, and with the places of what follows them:
            of the state, of a row, how many operations and products there are; then, for each operation, its code
            (a block of eight where it is a product), the slot where its result begins, and its argument: the row of
            START for an affine combination, the first product of a block, else a slot; the slots of both factors of
            products; where combinations begin among the terms, and the slots of terms; and which combination is the
            first of the outputs.
        number: (F,) for each operation the constant, the exponent, or how many products of a block count; the factors
            of terms, and the constants of outputs.
    """

    whole: Integer[Array, "integers"]
    number: Float64[np.ndarray, "numbers"]

    @property
    def slots(self) -> int:
        """How many numbers are in a row."""
        return int(self.whole[SLOTS])

    @property
    def size(self) -> int:
        """How many numbers the state has."""
        return int(self.whole[SIZE])

    @cached_property
    def moving(self) -> Bool[Array, "n"]:
        """Which components have rates that are not constant."""
        rows = int(self.whole[START]) + int(self.whole[FIRST]) + np.arange(self.size + 1)
        return np.diff(self.whole[rows]) > 0

    def still(self, numbers: int) -> Integer[Array, "slots"]:
        """Return 1 for each slot that does not move, if the last numbers of the state do not.

        The program is of sums, products and powers.
        """
        whole, flags = self.whole, np.zeros(self.slots, np.int64)
        flags[self.size - numbers : self.size] = 1
        for q, operation in enumerate(self.operations):
            out, first = whole[whole[OUT] + q], whole[whole[ARGUMENT] + q]
            if operation == Operation.AFFINE:
                start, end = whole[whole[START] + first : whole[START] + first + 2]
                flags[out] = flags[whole[whole[INDEX] + start : whole[INDEX] + end]].all()
            elif operation == Operation.PRODUCT:
                left, right = (whole[whole[table] + first : whole[table] + first + BLOCK] for table in (LEFT, RIGHT))
                flags[out : out + BLOCK] = flags[left] & flags[right]
            else:
                flags[out] = flags[first]
        return flags

    @cached_property
    def bounded_arguments(self) -> Integer[Array, "numbers"]:
        """Return how many arguments with bounded changes there are, then each one's slot and kind of function.

        See ``kernel_series.bound_change``.
        """
        kinds, count = self.operations, len(self.operations)
        arguments, numbers = self.whole[self.whole[ARGUMENT] :][:count], self.number[self.whole[NUMBER] :][:count]
        bounds = np.full(count, -1)
        for operation, kind in (
            (Operation.LOGARITHM, OF_ROOT), (Operation.LOGARITHM_OF_ONE_PLUS, OF_ONE_PLUS), (Operation.TANH, OF_TANH),
            (Operation.EXPONENTIAL, OF_EXPONENTIAL), (Operation.EXPONENTIAL_MINUS_ONE, OF_EXPONENTIAL),
            (Operation.SINE, OF_ANGLE), (Operation.ECCENTRIC, OF_ANGLE),
        ):
            bounds[kinds == operation] = kind
        bounds[(kinds == Operation.POWER) & (numbers % 1.0 != 0.0)] = OF_ROOT
        some = bounds >= 0
        pairs = np.stack([arguments[some], bounds[some]], axis=1)
        return np.concatenate([[len(pairs)], pairs.ravel()]).astype(np.int64)

    @cached_property
    def form(self) -> int:
        """A number that programs share which differ by factors alone."""
        return hash(self.whole.tobytes())

    @cached_property
    def form_of_code(self) -> tuple[bytes, bytes, bytes]:
        """All that machine code for it depends on: its integers, factors that are 1 or −1, and sizes of blocks."""
        factors = self.number[self.whole[FACTOR] : self.whole[CONSTANT]]
        signs = np.where(np.abs(factors) == 1.0, factors, 0.0).astype(np.int8)
        counts = self.number[self.whole[NUMBER] : self.whole[FACTOR]].astype(np.int64)
        counts *= self.operations == Operation.PRODUCT  # other operations have a constant or an exponent there
        return self.whole.tobytes(), signs.tobytes(), counts.tobytes()

    @cached_property
    def operations(self) -> Integer[Array, "operations"]:
        """The operations in order."""
        return self.whole[self.whole[CODE] : self.whole[CODE] + self.whole[OPERATIONS]]

    @cached_property
    def length(self) -> int:
        """About how many operations there are, with the sums of terms that the state's rates are."""
        return self.size + len(self.operations) + self.products

    @cached_property
    def is_of_products(self) -> bool:
        """Whether it is of sums and products alone."""
        return bool(np.isin(self.operations, (Operation.AFFINE, Operation.PRODUCT)).all())

    @property
    def outputs(self) -> int:
        """How many outputs there are."""
        return len(self.number) - int(self.whole[CONSTANT])

    @property
    def products(self) -> int:
        """How many products there are, in blocks."""
        return int(self.whole[PRODUCTS])


def make_program(tape: Tape, outputs: list[Expression]) -> Program:
    """Return the program that computes outputs, without the nodes that they do not need."""
    wanted = find_needed(tape, outputs)
    level = [0] * tape.size
    for node in tape.nodes:
        level.append(1 + max((level[k] for k in node.arguments), default=0))
    at = {k: k for k in range(tape.size)}
    slots = tape.size
    code, out, argument, number = [], [], [], []
    left: list[int] = []
    right: list[int] = []
    start, index, factor = [0], [], []

    def combine(terms: list[tuple[int, float]]) -> int:
        index.extend(at[k] for k, _ in terms)
        factor.extend(c for _, c in terms)
        start.append(len(index))
        return len(start) - 2

    def add(operation: Operation, where: int, of: int, value: float = 0.0) -> None:
        code.append(int(operation))
        out.append(where)
        argument.append(of)
        number.append(value)

    for step in range(1, max(level) + 1):
        of_step = [k for k in wanted if level[k] == step]
        by = {k: tape.nodes[k - tape.size] for k in of_step}
        for k in (k for k in of_step if by[k].operation is Operation.AFFINE):
            row = combine(list(zip(by[k].arguments, by[k].coefficients, strict=True)))
            add(Operation.AFFINE, slots, row, by[k].number)
            at[k], slots = slots, slots + 1
        products = [k for k in of_step if by[k].operation is Operation.PRODUCT]
        for begin in range(0, len(products), BLOCK):
            block = products[begin : begin + BLOCK]
            add(Operation.PRODUCT, slots, len(left), len(block))
            pairs = [by[k].arguments for k in block]
            pairs += [pairs[0]] * (BLOCK - len(block))
            left.extend(at[i] for i, _ in pairs)
            right.extend(at[j] for _, j in pairs)
            at.update((k, slots + lane) for lane, k in enumerate(block))
            slots += BLOCK
        for k in of_step:
            node = by[k]
            if node.operation in (Operation.AFFINE, Operation.PRODUCT) or node.operation in ALONG:
                continue
            add(node.operation, slots, at[node.arguments[0]], node.number)
            at[k], slots = slots, slots + 1
            for companion in range(len(COMPANIONS.get(node.operation, ()))):
                at[k + 1 + companion], slots = slots, slots + 1
            slots += node.operation is Operation.ECCENTRIC  # for what its recurrence is divided by
    first = len(start) - 1
    for x in outputs:
        combine(sorted(x.terms.items()))
    integers = {CODE: code, OUT: out, ARGUMENT: argument, LEFT: left, RIGHT: right, START: start, INDEX: index}
    numbers = {NUMBER: number, FACTOR: factor, CONSTANT: [x.constant for x in outputs]}
    length = CONSTANT + 1
    header = np.zeros(length, np.int64)
    header[[SIZE, SLOTS, OPERATIONS, PRODUCTS, FIRST]] = tape.size, slots, len(code), len(left), first
    for parts, place in ((integers, length), (numbers, 0)):
        for name, values in parts.items():
            header[name], place = place, place + len(values)
    whole = np.concatenate([header, *(np.array(values, np.int64) for values in integers.values())])
    return Program(whole, np.concatenate([np.array(values, float) for values in numbers.values()]))


def find_needed(tape: Tape, outputs: list[Expression]) -> list[int]:
    """Return the nodes that outputs are made of, in order; a sine and its cosine together, and so on."""
    needed: set[int] = set()
    left = [k for x in outputs for k in x.terms]
    while left:
        k = left.pop()
        if k < tape.size or k in needed:
            continue
        needed.add(k)
        node: Node = tape.nodes[k - tape.size]
        left.extend(node.arguments)
        if node.operation in COMPANIONS:
            left.extend(range(k + 1, k + 1 + len(COMPANIONS[node.operation])))
    return sorted(needed)

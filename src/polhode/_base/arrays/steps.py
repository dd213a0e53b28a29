"""Functions written with JAX as steps of NumPy: a few calls take less time so than their compilation by XLA."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays.by_numpy import BY_NUMPY
from polhode._base.jaxprs import Branches, Entry, Listing, NoRule, Scan, While
from polhode.types import Array, Shaped


class StepLimits(NamedTuple):
    """Numbers that decide whether a loop is compiled, and whether numbers are copied."""

    max_operations: int = 20_000  # of a loop; with more, compiling it takes less time
    max_copied: int = 1_000  # numbers that are copied where a view would do; of more the copying counts


LIMITS = StepLimits()
Compute = Callable[[list[Array], Any], Any]


class Step(NamedTuple):
    """One operation.

    Attributes:
        compute: its result, or a list of several, of operands and parameters.
        parameters: of JAX.
        operands: their places.
        results: places of these.
        types: of these.
    """

    compute: Callable[[list[Array], Any], Any]
    parameters: Any
    operands: tuple[int, ...]
    results: tuple[int, ...]
    types: tuple[Any, ...]


class Steps:
    """A function as a list of steps, without those whose results are unused.

    Args:
        listing: its operations.

    Raises:
        NoRule: if NumPy does not have one of them, or a loop is too long for Python.
    """

    def __init__(self, listing: Listing) -> None:
        self._inputs, self._outputs = listing.inputs, listing.outputs
        self._constants: list[Any] = [None] * listing.size  # by place, None where a value is computed
        for place, value in (listing.literals | listing.constants).items():
            self._constants[place] = np.asarray(value)
        self._steps: list[Step] = []
        known = [value is not None for value in self._constants]
        for entry in listing.only().entries:
            step = _make_step(entry)
            if all(known[k] for k in step.operands):  # what depends on constants alone is computed once
                with np.errstate(all="ignore"):
                    self._take(step, self._constants)
                for place in step.results:
                    known[place] = True
            else:
                self._steps.append(step)

    @property
    def count(self) -> int:
        """How many steps there are."""
        return len(self._steps)

    def __call__(self, arguments: list[Any]) -> list[Shaped[Array, "..."]]:
        """Return the values at arguments."""
        values: list[Any] = list(self._constants)
        for place, argument in zip(self._inputs, arguments, strict=True):
            values[place] = np.asarray(argument)
        with np.errstate(all="ignore"):  # JAX says nothing of infinite numbers either
            for step in self._steps:
                self._take(step, values)
        return [np.asarray(values[k]) for k in self._outputs]

    @staticmethod
    def _take(step: Step, values: list[Any]) -> None:
        """Set the results of a step among the values."""
        compute, parameters, operands, results, types = step
        computed = compute([values[k] for k in operands], parameters)
        if type(computed) is not list:
            kind = types[0]
            values[results[0]] = computed if computed.dtype is kind else np.asarray(computed, kind)
            return
        for place, value, kind in zip(results, computed, types, strict=True):
            values[place] = np.asarray(value, kind)


def _make_step(entry: Entry) -> Step:
    """Return the step of an operation."""
    make = LOOPS.get(type(entry.within))
    compute = entry.rule(BY_NUMPY, "numbers") if make is None else make(entry.within)
    if make is None and entry.name in OF_KNOWN_SHAPES:
        compute = OF_KNOWN_SHAPES[entry.name](entry) or compute
    types = tuple(kind.dtype for kind in entry.made)
    return Step(compute, entry.parameters, entry.operands, entry.results, types)


def _scan(loop: Scan) -> Callable[[list[Array], Any], list[Any]]:
    body = Steps(loop.body)
    if len(loop.order) * body.count > LIMITS.max_operations:
        raise NoRule("a long loop")
    return lambda x, p: loop.run(x, body, np.zeros)


def _while(loop: While) -> Callable[[list[Array], Any], list[Any]]:
    holds, body = Steps(loop.condition), Steps(loop.body)

    def compute(x: list[Array], p: Any) -> list[Any]:
        of_condition, of_body, carry = loop.split(x)
        while holds([*of_condition, *carry])[0]:
            carry = body([*of_body, *carry])
        return carry

    return compute


def _branch(branches: Branches) -> Callable[[list[Array], Any], list[Any]]:
    each = [Steps(branch) for branch in branches.each]
    return lambda x, p: each[branches.place(x[0])](x[1:])


# ---------------------------------------------------------------------- operations whose shapes are known beforehand


def _spread(entry: Entry) -> Compute | None:
    """Return ``broadcast_in_dim`` into a new array, which of few numbers takes a third of the time of a view."""
    (given,), p = entry.given, entry.parameters
    target, before = tuple(p["shape"]), [1] * len(p["shape"])
    for size, axis in zip(given.shape, p["broadcast_dimensions"], strict=True):
        before[axis] = size
    if tuple(before) == target:
        return lambda x, p: x[0].reshape(target)
    if math.prod(target) > LIMITS.max_copied:
        return None

    def compute(x: list[Array], p: Any) -> Array:
        made = np.empty(target, x[0].dtype)
        made[...] = x[0].reshape(before)
        return made

    return compute


def _slice(entry: Entry) -> Compute:
    p = entry.parameters
    strides = p["strides"] or [1] * len(p["start_indices"])
    where = tuple(slice(*each) for each in zip(p["start_indices"], p["limit_indices"], strides, strict=True))
    return lambda x, p: x[0][where]


def _squeeze(entry: Entry) -> Compute:
    shape = entry.made[0].shape
    return lambda x, p: x[0].reshape(shape)


def _along_last(reduce: Callable[..., Any]) -> Callable[[Entry], Compute | None]:
    """Return reductions along the last axis, the rows of which need not be brought together."""

    def make(entry: Entry) -> Compute | None:
        (given,) = entry.given
        if tuple(entry.parameters["axes"]) != (given.ndim - 1,):
            return None
        return lambda x, p: reduce(np.ascontiguousarray(x[0]), -1)

    return make


OF_KNOWN_SHAPES: dict[str, Callable[[Entry], Compute | None]] = {
    "broadcast_in_dim": _spread, "slice": _slice, "squeeze": _squeeze, "expand_dims": _squeeze,
    "reduce_sum": _along_last(np.add.reduce), "reduce_max": _along_last(np.maximum.reduce),
}  # fmt: skip
"""Rules that find out beforehand what those of ``BY_NUMPY`` find out at every call; None leaves it to these."""

LOOPS: dict[Any, Callable[[Any], Callable[[list[Array], Any], list[Any]]]] = {
    Scan: _scan, While: _while, Branches: _branch,
}  # fmt: skip

"""Functions written with JAX as steps of NumPy: a few calls take less time so than their compilation by XLA."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays.by_numpy import BY_NUMPY
from polhode.types import Array, Shaped

INNER = ("jaxpr", "call_jaxpr", "fun_jaxpr")
LOOPS = ("scan", "while", "cond")


class StepLimits(NamedTuple):
    """A number that decides whether a loop is compiled."""

    max_operations: int = 20_000  # of a loop; with more, compiling it takes less time


LIMITS = StepLimits()


class NoSteps(Exception):
    """A function has an operation that ``BY_NUMPY`` does not have, or a loop that is too long for Python."""


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
    """A jaxpr as a list of steps, without those whose results are unused.

    Args:
        closed: a jaxpr with its constants.

    Raises:
        NoSteps: if NumPy does not have one of its operations.
    """

    def __init__(self, closed: Any) -> None:
        self._constants: list[Any] = []  # by place, None where a value is computed
        steps: list[Step] = []
        self._inputs = [self._new() for _ in closed.jaxpr.invars]
        self._outputs = self._add(steps, closed.jaxpr, closed.consts, self._inputs)
        needed, kept = set(self._outputs), []
        for step in reversed(steps):
            if needed.intersection(step.results):
                needed.update(step.operands)
                kept.append(step)
        self._steps: list[Step] = []
        known = [value is not None for value in self._constants]
        for step in kept[::-1]:
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

    def _new(self, constant: Any = None) -> int:
        self._constants.append(None if constant is None else np.asarray(constant))
        return len(self._constants) - 1

    def _add(self, steps: list[Step], jaxpr: Any, constants: Any, inputs: list[int]) -> list[int]:
        """Append the steps of a jaxpr, and return the places of its values."""
        places: dict[Any, int] = dict(zip(jaxpr.invars, inputs, strict=True))
        places.update((variable, self._new(value)) for variable, value in zip(jaxpr.constvars, constants, strict=True))

        def place(variable: Any) -> int:
            return self._new(variable.val) if hasattr(variable, "val") else places[variable]

        for equation in jaxpr.eqns:
            name, operands = equation.primitive.name, [place(v) for v in equation.invars]
            inner = None if name in LOOPS else next((equation.params[k] for k in INNER if k in equation.params), None)
            if inner is not None:
                plain, own = (inner.jaxpr, inner.consts) if hasattr(inner, "jaxpr") else (inner, [])
                places.update(zip(equation.outvars, self._add(steps, plain, own, operands), strict=True))
                continue
            results = tuple(self._new() for _ in equation.outvars)
            places.update(zip(equation.outvars, results, strict=True))
            compute, types = _computation(equation), tuple(v.aval.dtype for v in equation.outvars)
            steps.append(Step(compute, equation.params, tuple(operands), results, types))
        return [place(v) for v in jaxpr.outvars]


def _computation(equation: Any) -> Callable[[list[Array], Any], Any]:
    name, parameters = equation.primitive.name, equation.params
    if name in LOOPS:
        return {"scan": _scan, "while": _while, "cond": _cond}[name](parameters)
    if name == "split":
        ends = np.cumsum(parameters["sizes"])[:-1]
        return lambda x, p: np.split(x[0], ends, p["axis"])
    if name == "unstack":
        return lambda x, p: list(np.moveaxis(np.asarray(x[0]), p["axis"], 0))
    if name not in BY_NUMPY:
        raise NoSteps(name)
    return BY_NUMPY[name]


def split_scan(parameters: dict[str, Any]) -> tuple[int, int]:
    """Return how many arguments of a scan are constants, and how many are carried from round to round."""
    if "num_consts" in parameters:
        return parameters["num_consts"], parameters["num_carry"]
    constants, carried, _ = parameters["ft_in"].unpack()  # JAX 0.11 and later
    return len(constants), len(carried)


def _scan(parameters: dict[str, Any]) -> Callable[[list[Array], Any], list[Any]]:
    body, (fixed, carried) = Steps(parameters["jaxpr"]), split_scan(parameters)
    length, jaxpr = parameters["length"], parameters["jaxpr"]
    if length * body.count > LIMITS.max_operations:
        raise NoSteps("a long loop")
    order = range(length)[:: -1 if parameters["reverse"] else 1]

    def compute(x: list[Array], p: Any) -> list[Any]:
        constants, carry, rows = x[:fixed], x[fixed : fixed + carried], x[fixed + carried :]
        stacks = [np.zeros((length, *v.aval.shape), v.aval.dtype) for v in jaxpr.jaxpr.outvars[carried:]]
        for k in order:
            computed = body([*constants, *carry, *(row[k] for row in rows)])
            carry = computed[:carried]
            for stack, value in zip(stacks, computed[carried:], strict=True):
                stack[k] = value
        return [*carry, *stacks]

    return compute


def _while(parameters: dict[str, Any]) -> Callable[[list[Array], Any], list[Any]]:
    holds, body = Steps(parameters["cond_jaxpr"]), Steps(parameters["body_jaxpr"])
    first, second = parameters["cond_nconsts"], parameters["cond_nconsts"] + parameters["body_nconsts"]

    def compute(x: list[Array], p: Any) -> list[Any]:
        carry = x[second:]
        while holds([*x[:first], *carry])[0]:
            carry = body([*x[first:second], *carry])
        return carry

    return compute


def _cond(parameters: dict[str, Any]) -> Callable[[list[Array], Any], list[Any]]:
    branches = [Steps(branch) for branch in parameters["branches"]]
    last = len(branches) - 1
    return lambda x, p: branches[int(np.clip(x[0], 0, last))](x[1:])

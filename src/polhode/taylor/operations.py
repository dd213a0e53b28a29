"""The operations that nodes of a tape are made by."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np

from polhode.taylor.kernel_kepler import eccentric_anomaly_at


class Operation(IntEnum):
    """The operation of a node."""

    AFFINE = 0
    PRODUCT = 1
    POWER = 2
    EXPONENTIAL = 3
    LOGARITHM = 4
    SINE = 5
    COSINE = 6  # of the sine before it, with which it shares the recurrence
    ECCENTRIC = 7  # E of M = E − e sin E
    ECCENTRIC_SINE = 8  # sin E, which follows E
    ECCENTRIC_COSINE = 9  # cos E, which follows that
    TANH = 10
    SQUARED_SECANT = 11  # 1/cosh² of its argument, behind its tanh
    EXPONENTIAL_MINUS_ONE = 12
    LOGARITHM_OF_ONE_PLUS = 13


# nodes that come with another one
COMPANIONS = {Operation.SINE: (Operation.COSINE,), Operation.TANH: (Operation.SQUARED_SECANT,),
              Operation.ECCENTRIC: (Operation.ECCENTRIC_SINE, Operation.ECCENTRIC_COSINE)}  # fmt: skip
ALONG = frozenset(itertools.chain(*COMPANIONS.values()))
IN_ORBIT = frozenset({Operation.ECCENTRIC, *COMPANIONS[Operation.ECCENTRIC]})


class Node(NamedTuple):
    """One operation.

    Attributes:
        operation: which.
        arguments: numbers of nodes.
        coefficients: of the arguments of an affine combination, as many.
        number: the constant of an affine combination, the exponent of a power, or an eccentricity.
    """

    operation: Operation
    arguments: tuple[int, ...]
    coefficients: tuple[float, ...] = ()
    number: float = 0.0


def squared_secant(x: Any, numbers: Any = np) -> Any:
    """Return 1/cosh² x, which is 1 − tanh² x, with all its digits."""
    small = numbers.exp(-2.0 * numbers.abs(x))
    return 4.0 * small / (1.0 + small) ** 2


FUNCTIONS: dict[Operation, Callable[[Any], Any]] = {
    Operation.EXPONENTIAL: np.exp, Operation.LOGARITHM: np.log, Operation.SINE: np.sin, Operation.COSINE: np.cos,
    Operation.TANH: np.tanh, Operation.SQUARED_SECANT: squared_secant, Operation.EXPONENTIAL_MINUS_ONE: np.expm1,
    Operation.LOGARITHM_OF_ONE_PLUS: np.log1p,
}  # fmt: skip


def value_of(node: Node, x: list[Any]) -> Any:
    """Return the value of a node, of numbers or arrays of its arguments."""
    match node.operation:
        case Operation.AFFINE:
            return node.number + sum(c * v for c, v in zip(node.coefficients, x, strict=True))
        case Operation.PRODUCT:
            return x[0] * x[1]
        case Operation.POWER:
            return np.float64(x[0]) ** node.number if isinstance(x[0], float) else x[0] ** node.number
        case Operation.ECCENTRIC:
            return np.vectorize(eccentric_anomaly_at, otypes=[float])(x[0], node.number)
        case Operation.ECCENTRIC_SINE:
            return np.sin(x[1])
        case Operation.ECCENTRIC_COSINE:
            return np.cos(x[1])
        case _:
            return FUNCTIONS[node.operation](x[0])

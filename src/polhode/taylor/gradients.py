"""Derivatives of an expression by the state, as expressions on its tape."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from typing import Any

from polhode.taylor.expressions import Expression, Tape
from polhode.taylor.operations import Node, Operation


def gradient(x: Expression) -> list[Expression]:
    """Return the derivatives of an expression by the components of the state, as expressions of its tape."""
    tape = x.tape
    # what a node gets from those that depend on it is added up once, when all of them have been
    slopes: dict[int, list[Expression]] = {k: [tape.constant(c)] for k, c in x.terms.items()}
    waiting = [-k for k in slopes if k >= tape.size]
    heapq.heapify(waiting)
    while waiting:
        place = -heapq.heappop(waiting)
        by = _sum(tape, slopes.pop(place))
        for argument, slope in _slopes(tape, place, tape.nodes[place - tape.size]):
            if argument not in slopes:
                slopes[argument] = [tape.constant(0.0)]
                if argument >= tape.size:
                    heapq.heappush(waiting, -argument)
            slopes[argument].append(by * slope)
    return [_sum(tape, slopes.get(k, ())) for k in range(tape.size)]


def _sum(tape: Tape, summands: Sequence[Expression]) -> Expression:
    return summands[0] if len(summands) == 1 else tape.total(summands)


def _slopes(tape: Tape, place: int, node: Node) -> list[tuple[int, Any]]:
    """Return the derivatives of a node by its arguments."""
    z = [Expression(tape, {k: 1.0}) for k in node.arguments]
    own = Expression(tape, {place: 1.0})
    match node.operation:
        case Operation.AFFINE:
            return list(zip(node.arguments, node.coefficients, strict=True))
        case Operation.PRODUCT:
            return [(node.arguments[0], z[1]), (node.arguments[1], z[0])]
        case Operation.POWER:
            return [(node.arguments[0], node.number * z[0] ** (node.number - 1.0))]
        case Operation.EXPONENTIAL:
            return [(node.arguments[0], own)]
        case Operation.LOGARITHM:
            return [(node.arguments[0], z[0] ** -1.0)]
        case Operation.SINE:
            return [(node.arguments[0], Expression(tape, {place + 1: 1.0}))]
        case Operation.COSINE:  # whose second argument only says which sine goes with it
            return [(node.arguments[0], -z[1])]
        case Operation.TANH:
            return [(node.arguments[0], Expression(tape, {place + 1: 1.0}))]
        case Operation.SQUARED_SECANT:  # it follows its tanh
            return [(node.arguments[0], own * z[1] * -2.0)]
        case Operation.EXPONENTIAL_MINUS_ONE:
            return [(node.arguments[0], own + 1.0)]
        case Operation.LOGARITHM_OF_ONE_PLUS:
            return [(node.arguments[0], (z[0] + 1.0) ** -1.0)]
        case Operation.ECCENTRIC:
            cosine = Expression(tape, {place + 2: 1.0})
            # dE/dM = 1/(1 − e cos E)
            return [(node.arguments[0], (1.0 - node.number * cosine) ** -1.0)]
        case Operation.ECCENTRIC_SINE:
            return [(node.arguments[1], Expression(tape, {place + 1: 1.0}))]
        case _:
            return [(node.arguments[1], Expression(tape, {place - 1: -1.0}))]

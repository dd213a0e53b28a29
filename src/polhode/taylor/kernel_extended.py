"""Evaluates a series whose first coefficients have twice as many digits, as the state has.

Roundings of a step are then those of its higher terms, which are small. They matter all the same: numbers such as one
over a moment are rounded once and for all, so that what they leave out has one sign, and a phase grows with the square
of the time.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.special._doubledouble import add, divide, fast_two_sum, multiply, multiply_float
from polhode.taylor.kernel_space import Exact, Lanes, Series
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
    RIGHT,
    SIZE,
    SLOTS,
    START,
)
from polhode.taylor.vectors import raise_power

ORDERS_IN_PAIRS = 12  # roundings of the other coefficients, which have one sign, are 1e-26 of the state a step
Pair = tuple[Any, Any]


def two_product(a: Any, b: Any) -> Pair:
    """Return the product and its exact error [Dekker–Veltkamp], as ``doubledouble`` does for arrays."""
    splitting = 134217729.0  # 2²⁷ + 1
    p, t, u = a * b, splitting * a, splitting * b
    ah, bh = t - (t - a), u - (u - b)
    al, bl = a - ah, b - bh
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


def advance_lanes(series: Series, lanes: Lanes, order: Any) -> None:
    """Set state and its low part to those after a step, in place of the function of ``kernel_series``."""
    exact, width, h = lanes.exact, series.whole[SLOTS], lanes.steps[0]
    rows, size = exact.whole[SLOTS], series.whole[SIZE]
    for i in range(size):
        exact.high[i], exact.low[i] = lanes.states[i], lanes.low[i]
    first_coefficients(exact, size, lanes.units[0])
    for i in range(size):
        rest = 0.0
        # Horner's rule: the terms of high order in doubles, the first of them in two parts
        for k in range(order, ORDERS_IN_PAIRS - 1, -1):
            rest = rest * h + series.flat[k * width + i]
        value = rest, 0.0
        for k in range(ORDERS_IN_PAIRS - 1, -1, -1):
            value = add(multiply_float(value, h), (exact.high[k * rows + i], exact.low[k * rows + i]))
        lanes.states[i], lanes.low[i] = value


@called
def first_coefficients(exact: Exact, size: Any, unit: Any) -> None:
    """Set the first coefficients of what moves, of powers of the time over a unit that is a power of two."""
    whole, number = exact.whole, exact.number
    for k in range(ORDERS_IN_PAIRS - 1):
        nodes_in_pairs(exact, k)
        for i in range(size):
            value = combination_in_pairs(exact, k, whole[FIRST] + i)
            if k == 0:
                value = add(value, (number[whole[CONSTANT] + i], 0.0))
            # y_{k+1} = unit ẏ_k/(k + 1)
            value = divide((value[0] * unit, value[1] * unit), (k + 1.0, 0.0))
            exact.high[(k + 1) * whole[SLOTS] + i], exact.low[(k + 1) * whole[SLOTS] + i] = value


def nodes_in_pairs(exact: Exact, k: Any) -> None:
    """Set the k-th coefficients of all nodes; see ``kernel_series.nodes``."""
    whole, number, high, low = exact.whole, exact.number, exact.high, exact.low
    base = k * whole[SLOTS]
    for q in range(whole[OPERATIONS]):
        operation, out, argument = whole[whole[CODE] + q], whole[whole[OUT] + q], whole[whole[ARGUMENT] + q]
        scalar = number[whole[NUMBER] + q]
        if k > 0 and operation != 1 and exact.still[out] == 1:
            continue
        if operation == 0:
            value = combination_in_pairs(exact, k, argument)
            if k == 0:
                value = add(value, (scalar, 0.0))
            high[base + out], low[base + out] = value
        elif operation == 1:
            for p in range(int(scalar)):
                left, right = whole[whole[LEFT] + argument + p], whole[whole[RIGHT] + argument + p]
                high[base + out + p], low[base + out + p] = product_in_pairs(exact, k, left, right)
        else:
            high[base + out], low[base + out] = power_in_pairs(exact, k, out, argument, scalar)


def combination_in_pairs(exact: Exact, k: Any, row: Any) -> Pair:
    whole, number, base = exact.whole, exact.number, k * exact.whole[SLOTS]
    start, value = whole[START] + row, (0.0, 0.0)
    for q in range(whole[start], whole[start + 1]):
        at = base + whole[whole[INDEX] + q]
        value = add(value, multiply_float((exact.high[at], exact.low[at]), number[whole[FACTOR] + q]))
    return value


def product_in_pairs(exact: Exact, k: Any, left: Any, right: Any) -> Pair:
    value, x, y, width = (0.0, 0.0), left, k * exact.whole[SLOTS] + right, exact.whole[SLOTS]
    terms = k + 1
    if exact.still[right] == 1:
        x, y, terms = left + k * width, right, 1
    elif exact.still[left] == 1:
        terms = 1
    for _ in range(terms):
        value = add(value, multiply((exact.high[x], exact.low[x]), (exact.high[y], exact.low[y])))
        x, y = x + width, y - width
    return value


def power_in_pairs(exact: Exact, k: Any, out: Any, x: Any, exponent: Any) -> Pair:
    """Return the k-th coefficient of the power of a node, whose exponent is half a whole number."""
    high, low, width = exact.high, exact.low, exact.whole[SLOTS]
    base = high[x], low[x]
    if k == 0:
        return power_of_pair(base, exponent)
    # k x₀ u_k = Σ_{j<k} (p(k−j) − j) u_j x_{k−j}, as in ``kernel_series``
    value = 0.0, 0.0
    for j in range(k):
        u, y = j * width + out, (k - j) * width + x
        term = multiply((high[u], low[u]), (high[y], low[y]))
        value = add(value, multiply_float(term, exponent * (k - j) - j))
    return divide(value, multiply_float(base, k * 1.0))


@called
def power_of_pair(x: Pair, exponent: Any) -> Pair:
    """Return x to half a whole number: u of which the square is x to the whole one, by one step of Newton's."""
    first = raise_power(x[0], exponent)
    # u² = x^m, m = 2p: Newton from u takes u to u (1 + ½(1 − u² x^−m)), which squares the error
    square = multiply((first, 0.0), (first, 0.0))
    whole = 1.0, 0.0
    for _ in range(int(abs(2.0 * exponent))):
        whole = multiply(whole, x)
    if exponent < 0.0:
        missing = add((1.0, 0.0), multiply((-square[0], -square[1]), whole))  # 1 − u² x^m
    else:
        missing = add((1.0, 0.0), divide((-square[0], -square[1]), whole))
    if not abs(missing[0]) < 1e-8:
        return first, 0.0  # zero, infinite, or not a number
    return fast_two_sum(first, 0.5 * first * missing[0])

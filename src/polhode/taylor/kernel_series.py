"""The recurrences of Taylor coefficients: of any program, eight products at a time, one in each lane of a vector.

Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §3.2, for the length of a step.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

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
)
from polhode.taylor.vectors import gather, load, store
from polhode.types import Array

FLOOR = 1e-3  # of the scale: a motion that dies away is computed to this part of its first size
UNITS = 300  # of time that are tried
FAR = 256.0  # units: a longer step may be of coefficients that vanished


def combination(whole: Array, number: Array, z: Array, base: Any, row: Any) -> Any:
    start, index, factor = whole[START] + row, whole[INDEX], whole[FACTOR]
    value = 0.0
    for q in range(whole[start], whole[start + 1]):
        value += number[factor + q] * z[base + whole[index + q]]
    return value


def function(operation: Any, z: Array, base: Any, width: Any, k: Any, out: Any, x: Any, exponent: Any) -> None:
    """Set the k-th coefficient of a function of node x; see ``program``."""
    u, y, total = out, base + x, 0.0
    if operation == 2:
        if k == 0:
            z[base + out] = z[x] ** exponent
            return
        for j in range(k):
            total += (exponent * (k - j) - j) * (z[u] * z[y])
            u, y = u + width, y - width
        z[base + out] = total / (k * z[x])
    elif operation == 3:
        if k == 0:
            z[base + out] = math.exp(z[x])
            return
        for j in range(k):
            total += (k - j) * (z[u] * z[y])
            u, y = u + width, y - width
        z[base + out] = total / k
    elif operation == 4:
        if k == 0:
            z[base + out] = math.log(z[x])
            return
        for j in range(1, k):
            u, y = u + width, y - width
            total += j * (z[u] * z[y])
        z[base + out] = (z[base + x] - total / k) / z[x]
    else:
        if k == 0:
            z[base + out] = math.sin(z[x])
            z[base + out + 1] = math.cos(z[x])
            return
        sine, cosine = 0.0, 0.0
        for j in range(k):
            weight = (k - j) * z[y]
            sine += weight * z[u + 1]
            cosine -= weight * z[u]
            u, y = u + width, y - width
        z[base + out] = sine / k
        z[base + out + 1] = cosine / k


def nodes(whole: Array, number: Array, z: Array, a: Array, b: Array, k: Any) -> None:
    """Set the k-th coefficients of all nodes from those of the state; a and b keep the factors of products."""
    width, products = whole[SLOTS], whole[PRODUCTS]
    codes, outs, arguments, numbers = whole[CODE], whole[OUT], whole[ARGUMENT], whole[NUMBER]
    lefts, rights = whole[LEFT], whole[RIGHT]
    base = k * width
    for q in range(whole[OPERATIONS]):
        operation, out = whole[codes + q], base + whole[outs + q]
        if operation == 1:
            m = whole[arguments + q]
            row = k * products + m
            left, right = gather(z, whole, lefts + m, base), gather(z, whole, rights + m, base)
            store(a, row, left)
            store(b, row, right)
            if k == 0:
                store(z, out, left * right)
                continue
            # the newest from registers, the older from memory; two sums
            one, two = left * load(b, m), load(a, m) * right
            x, y = m + products, row - products
            for _ in range(1, k - 1, 2):
                one = one + load(a, x) * load(b, y)
                two = two + load(a, x + products) * load(b, y - products)
                x += 2 * products
                y -= 2 * products
            if k % 2 == 0:
                one = one + load(a, x) * load(b, y)
            store(z, out, one + two)
        elif operation == 0:
            value = combination(whole, number, z, base, whole[arguments + q])
            z[out] = value + number[numbers + q] if k == 0 else value
        else:
            function(operation, z, base, width, k, whole[outs + q], whole[arguments + q], number[numbers + q])


def coefficients(whole: Array, number: Array, z: Array, a: Array, b: Array, order: Any, unit: Any) -> None:
    """Set the coefficients of the state up to an order, of powers of the time over a unit that is a power of two."""
    width, first, constant = whole[SLOTS], whole[FIRST], whole[CONSTANT]
    for k in range(order):
        nodes(whole, number, z, a, b, k)
        base = k * width
        for i in range(whole[SIZE]):
            value = combination(whole, number, z, base, first + i)
            if k == 0:
                value += number[constant + i]
            # divided: multiplied by the reciprocal, errors of all steps would have one sign
            z[base + width + i] = value * unit / (k + 1)


def step_length(whole: Array, z: Array, scale: Array, order: Any, reach: Any) -> Any:
    """Return the length of a step by the last three coefficients; infinite where all are zero, NaN where none is."""
    width = whole[SLOTS]
    size, best = FLOOR, np.inf
    for i in range(whole[SIZE]):
        size = max(size, abs(z[i]) / scale[i])
    for k in range(order - 2, order + 1):
        largest = 0.0
        for i in range(whole[SIZE]):
            part = abs(z[k * width + i]) / scale[i]
            if not part <= 1e250:
                return np.nan
            largest = max(largest, part)
        if largest > 0.0:
            best = min(best, (size / largest) ** (1.0 / k))
    if best == np.inf:  # a polynomial, of which earlier ones may overflow
        for k in range(order - 2):
            for i in range(whole[SIZE]):
                if not abs(z[k * width + i]) <= 1e250 * scale[i]:
                    return np.nan
    return best * reach


def power_of_two(x: Any) -> Any:
    """Return the power of two at or below a positive number."""
    return math.ldexp(1.0, math.frexp(x)[1] - 1)


def fitted_series(
    whole: Array, number: Array, z: Array, a: Array, b: Array, scale: Array, order: Any, reach: Any, unit: Any,
    left: Any,
) -> Any:  # fmt: skip
    """Set the coefficients by a unit of time that fits them, and return it and the length of the step in it.

    The search begins with a unit such as the last step's length, and goes up to the time that is left.
    """
    length, lowered = np.nan, False
    for _ in range(UNITS):
        coefficients(whole, number, z, a, b, order, unit)
        length = step_length(whole, z, scale, order, reach)
        if not length >= 0.0:
            if unit < 1e-280:
                break
            unit, lowered = unit * 2.0**-8, True  # they overflow
        elif length > FAR and unit < left and not lowered:  # the last ones may have vanished
            unit = min(unit * 2.0**16, power_of_two(left) * 2.0)
        else:
            break
    return unit, length


def evaluate(whole: Array, z: Array, order: Any, h: Any, out: Array) -> None:
    """Set out to the state after h units of time."""
    width = whole[SLOTS]
    for i in range(whole[SIZE]):
        value = z[order * width + i]
        for k in range(order - 1, -1, -1):
            value = value * h + z[k * width + i]
        out[i] = value

"""The recurrences of Taylor coefficients of any program, and the evaluation of a series.

Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §3.2, for the length of a step.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from polhode._base.compiled.copying import called
from polhode.taylor import kernel_kepler
from polhode.taylor import vectors as arithmetic
from polhode.taylor.kernel_products import block
from polhode.taylor.kernel_space import NOBODY, Course, Lanes, Series
from polhode.taylor.loops import write_function
from polhode.taylor.program import (
    ARGUMENT,
    CODE,
    CONSTANT,
    FACTOR,
    FIRST,
    INDEX,
    NUMBER,
    OF_ANGLE,
    OF_EXPONENTIAL,
    OF_ROOT,
    OF_TANH,
    OPERATIONS,
    OUT,
    SIZE,
    SLOTS,
    START,
)
from polhode.taylor.vectors import (
    LANES,
    exponential,
    run_code,
    spread,
    vectors,
    where_less,
)
from polhode.types import Array

MIN_SIZE = 1e-3  # of the scale: a motion that dies away is computed to this part of its first size
MAX_COEFFICIENT = 1e250  # for the last coefficients together, as products of two are summed
ROOT_SHARE_LEFT = 0.1  # of what is under a root, in a step
MAX_EXPONENT_CHANGE = 8.0  # by which an exponent changes in a step
MAX_ANGLE_CHANGE = 4.0  # rad by which the argument of a sine changes in a step


def combination(series: Series, base: Any, row: Any) -> Any:
    whole, number, z = series.whole, series.number, series.z
    start, index, factor = whole[START] + row, whole[INDEX], whole[FACTOR]
    value = spread(0.0)
    for q in range(whole[start], whole[start + 1]):
        value = value + number[factor + q] * z[base + whole[index + q]]
    return value


def size_of_terms(series: Series, row: Any) -> Any:
    """Return what the terms of a combination add up to where none takes away from another, of order zero."""
    whole, number, z = series.whole, series.number, series.z
    start, index, factor = whole[START] + row, whole[INDEX], whole[FACTOR]
    value = spread(0.0)
    for q in range(whole[start], whole[start + 1]):
        value = value + abs(number[factor + q] * z[whole[index + q]])
    return value


def squared_secant(x: Any) -> Any:
    """Return 1/cosh² x, which is 1 − tanh² x, with all its digits."""
    small = exponential(-2.0 * abs(x))
    return 4.0 * small / ((1.0 + small) * (1.0 + small))


function = called(write_function({**vars(kernel_kepler), **vars(arithmetic), **globals()}))


def nodes(series: Series, k: Any) -> None:
    """Set the k-th coefficients of all nodes from those of the state."""
    whole, number, z = series.whole, series.number, series.z
    codes, outs, arguments, numbers = whole[CODE], whole[OUT], whole[ARGUMENT], whole[NUMBER]
    width = whole[SLOTS]
    base = k * width
    for q in range(whole[OPERATIONS]):
        operation, out, argument, scalar = whole[codes + q], whole[outs + q], whole[arguments + q], number[numbers + q]
        if operation == 1:
            block(series, k, argument, int(scalar), base + out)
        elif operation == 0:
            value = combination(series, base, argument)
            z[base + out] = value + scalar if k == 0 else value
        else:
            function(operation, series.flat, z, base, width, k, out, argument, scalar)


def coefficients(series: Series, order: Any, units: np.ndarray) -> None:
    """Set the coefficients of the state up to an order, of powers of the time over units that are powers of two."""
    whole, number, z, unit = series.whole, series.number, series.z, vectors(units)[0]
    if series.code != 0:
        if series.begins:
            nodes(series, 0)
        run_code(series.code, series.flat, series.a, series.b, number, order, units)
        return
    width, first, constant = whole[SLOTS], whole[FIRST], whole[CONSTANT]
    for k in range(order):
        nodes(series, k)
        base = k * width
        for i in range(whole[SIZE]):
            value = combination(series, base, first + i)
            if k == 0:
                value = value + number[constant + i]
            # divided: multiplied by the reciprocal, errors of all steps would have one sign
            z[base + width + i] = value * unit / (k + 1)


def step_lengths(series: Series, lanes: Lanes, course: Course) -> None:
    """Set the lengths of steps by the last three coefficients; infinite where all are zero, NaN where one is too large.

    In ``lanes.lengths`` they are followed by the size of the state, and by those of the coefficients; then come the
    same of what follows the motion. That has a radius of its own: at an equilibrium the state's series ends at once,
    and that of a tangent does not.
    """
    measure_coefficients(series, lanes, course)
    order, reach, width, least_ratio = course.order, course.reach, series.whole[SLOTS], 1e-300
    whole, flat, scales, lengths = series.whole, series.flat, lanes.scales, lanes.lengths
    for lane in range(LANES):
        if lanes.which[lane] == NOBODY:
            continue
        best = np.inf
        for e in range(3):
            last = lengths[(2 + e) * LANES + lane]
            if last > 0.0:
                # radius of convergence by the root test, (|x|/|x_k|)^(1/k) of the last orders: Jorba & Zou 2005, §3.2
                best = min(best, math.log(lengths[LANES + lane] / last) / (order - 2 + e))
            elif last != last:
                best = np.nan
                break
        for e in range(3):
            size, last = lengths[5 * LANES + lane], lengths[(6 + e) * LANES + lane]
            if last > MAX_COEFFICIENT * max(size, 1.0):
                best = np.nan
            elif size > 0.0 and last > 0.0:  # what begins at zero is as smooth as the motion that drives it
                best = min(best, math.log(max(size / last, least_ratio)) / (order - 2 + e))
        if best == np.inf:  # a polynomial, of which earlier ones may overflow
            for k in range(order - 2):
                for i in range(whole[SIZE]):
                    if not abs(flat[(k * width + i) * LANES + lane]) <= MAX_COEFFICIENT * scales[i * LANES + lane]:
                        best = np.nan
        lengths[lane] = math.exp(best) * reach


def measure_coefficients(series: Series, lanes: Lanes, course: Course) -> None:
    """Set the sizes of the state and of its last three coefficients, and those of what follows the motion."""
    order, whole, z = course.order, series.whole, series.z
    width, scale, sizes = whole[SLOTS], vectors(lanes.scales), vectors(lanes.lengths)
    size, total, row = spread(MIN_SIZE), spread(0.0), (order - 2) * width
    one, two, three = total, total, total
    for i in range(whole[SIZE]):
        inverse = 1.0 / scale[i]
        part, first = abs(z[i]) * inverse, abs(z[row + i]) * inverse
        second, third = abs(z[row + width + i]) * inverse, abs(z[row + 2 * width + i]) * inverse
        # comparisons with NaN are false, so that it is seen in the total alone
        size, one = where_less(size, part, part, size), where_less(one, first, first, one)
        two, three = where_less(two, second, second, two), where_less(three, third, third, three)
        total = total + (first + second + third)
    most, none = spread(MAX_COEFFICIENT), spread(np.nan)
    sizes[1], sizes[2] = size, where_less(total, most, one, none)
    sizes[3], sizes[4] = where_less(total, most, two, none), where_less(total, most, three, none)
    of_followers(series, lanes, course)


def of_followers(series: Series, lanes: Lanes, course: Course) -> None:
    """Set the size of what follows the motion, now or after a unit of time, and of its last three coefficients."""
    z, width, sizes = series.z, series.whole[SLOTS], vectors(lanes.lengths)
    for e in range(-1, 3):
        largest = spread(0.0)
        for f in range(course.followers):
            i = course.follows[f]
            if e < 0:
                largest = where_less(largest, abs(z[i]), abs(z[i]), largest)
            part = abs(z[width + i]) if e < 0 else abs(z[(course.order - 2 + e) * width + i])
            largest = where_less(largest, part, part, largest)
        sizes[6 + e] = largest


@called
def bound_change(series: Series, order: Any, lane: Any, slot: Any, kind: Any, ahead: Any) -> Any:
    """Return how far, in units and at most ``ahead``, the argument of a function changes by no more than it may.

    Series of sines end in roundings e^Δ times their own where the angle changes by Δ, and if these cancel in the rates,
    the coefficients of a smooth motion do not show it. Coefficients do not show an exponential that is too small as
    yet, such as the distance of a tanh from 1. And those of a root have no singularity where its argument has a double
    zero: behind it they are those of the root with the other sign.
    """
    first, length = series.flat[slot * LANES + lane], ahead
    underflow = -700.0  # an exponent, up to which it may come from any lower one
    if kind == OF_EXPONENTIAL:
        most = max(MAX_EXPONENT_CHANGE, underflow - first)
    elif kind == OF_ANGLE:
        most = MAX_ANGLE_CHANGE
    elif kind == OF_TANH:  # 1 ∓ tanh x = 2 e^(∓2x)/(1 + e^(∓2x))
        most = 0.5 * max(MAX_EXPONENT_CHANGE, underflow + 2.0 * abs(first))
    else:
        most = (1.0 - ROOT_SHARE_LEFT) * abs(first if kind == OF_ROOT else 1.0 + first)
    while length > 0.0 and not sum_of_sizes(series, order, lane, slot, length) <= most:
        length *= 0.5
    return length


@called
def sum_of_sizes(series: Series, order: Any, lane: Any, slot: Any, length: Any) -> Any:
    """Return the sum of the sizes of a node's terms in a step, but that of order zero."""
    flat, width, total, power = series.flat, series.whole[SLOTS], 0.0, 1.0
    for k in range(1, order):
        power *= length
        total += abs(flat[(k * width + slot) * LANES + lane]) * power
    return total


def power_of_two(x: Any) -> Any:
    """Return the power of two at or below a positive number."""
    return math.ldexp(1.0, math.frexp(x)[1] - 1)


def fit_series(series: Series, lanes: Lanes, course: Course) -> None:
    """Set the coefficients by units of time that fit them, the units, and the lengths of steps in them.

    The search begins with units such as the last steps' lengths, and goes up to the times that are left.
    """
    units, left, lowered = lanes.units, lanes.left, lanes.lowered
    far = 256.0  # units: a longer step may be of coefficients that vanished
    for lane in range(LANES):
        lowered[lane] = 0
    for _ in range(300):
        coefficients(series, course.order, units)
        step_lengths(series, lanes, course)
        settled = True
        for lane in range(LANES):
            unit, length = units[lane], lanes.lengths[lane]
            if lanes.which[lane] == NOBODY:
                continue
            if not length >= 0.0:
                if not unit < 1e-280 and has_values(series, lane):
                    units[lane], lowered[lane], settled = unit * 2.0**-8, 1, False  # they overflow
            elif length > far and unit < left[lane] and lowered[lane] == 0:  # the last ones may have vanished
                units[lane], settled = min(unit * 2.0**16, power_of_two(left[lane]) * 2.0), False
        if settled:
            break


@called
def has_values(series: Series, lane: Any) -> Any:
    """Return whether all nodes have values; where one is infinite, no unit of time makes a series."""
    for slot in range(series.whole[SLOTS]):
        if not abs(series.flat[slot * LANES + lane]) < np.inf:
            return False
    return True


def advance_lanes(series: Series, lanes: Lanes, order: Any) -> None:
    """Set the lanes' states to those after a step; ``kernel_extended`` has the same with twice as many digits."""
    width, z, y, steps = series.whole[SLOTS], series.z, vectors(lanes.states), vectors(lanes.steps)[0]
    size, together = series.whole[SIZE], 4  # components, as each multiplication waits for a sum
    several = size - size % together
    for i in range(0, several, together):
        row = order * width + i
        a, b, c, d = z[row], z[row + 1], z[row + 2], z[row + 3]
        # Horner's rule, from the smallest terms up
        for _ in range(order):
            row -= width
            a, b = a * steps + z[row], b * steps + z[row + 1]
            c, d = c * steps + z[row + 2], d * steps + z[row + 3]
        y[i], y[i + 1], y[i + 2], y[i + 3] = a, b, c, d
    for i in range(several, size):
        value = z[order * width + i]
        for k in range(order - 1, -1, -1):
            value = value * steps + z[k * width + i]
        y[i] = value


def sample_copy(
    series: Series, course: Course, lane: Any, t: Any, unit: Any, copy: Any, first: Any, last: Any, out: Array
) -> None:
    """Set samples (C, T, n) of a copy from a first one up to a last, by its series at t: always the same bits."""
    width, flat, order = series.whole[SLOTS], series.flat, course.order
    for s in range(first, last):
        h = (course.times[s] - t) / unit
        for i in range(series.whole[SIZE]):
            value = flat[(order * width + i) * LANES + lane]
            for k in range(order - 1, -1, -1):
                value = value * h + flat[(k * width + i) * LANES + lane]
            out[copy, s, i] = value
        if course.clock >= 0:
            out[copy, s, course.clock] = course.times[s]

"""The evaluation of ``series`` for many times at once, compiled by Numba: of one top, and of many.

The same arithmetic in blocks and in loops without branches, as of the free body's kernel.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.exact.kernel_arithmetic import (
    BLOCK,
    called,
    entry,
    exponential,
    floor,
    halves,
    inlined,
    nearest,
    phase,
    places,
    room,
    sine_cosine,
    square_root,
    two_sum,
    whole,
)

__all__ = ["COLUMNS", "WORK", "numerators", "states_of_many", "states_of_one"]

WORTH = 20_000  # states for which a thread is worth its start
COLUMNS, WORK = 45, 17  # of a flattened ``series.Motion``, and rows that evaluating it takes
Four = tuple[float, float, float, float]
State = tuple[float, float, float, float, float, float, float]
Numerators = tuple[float, float, float, float, float, float, float, float, float, float]


@inlined
def _dot(a: float, b: float, c: float, d: float, v: Four) -> float:
    """Sum the products, smallest first."""
    return ((d * v[3] + c * v[2]) + b * v[1]) + a * v[0]


@inlined
def _turns(upper: float, lower: float, low: float, high: float, rest: float) -> float:
    fraction, left, _ = phase(upper, lower, low, high, rest)
    return fraction + left


@inlined
def _exponent(x: float, rest: float, upper: float, lower: float) -> tuple[float, float]:
    """Return the leading part of the exponent of ``decay.exponential_decay``, exact, and the factor for the rest."""
    high, low = halves(x)
    small = (high * lower + low * (upper + lower)) + rest * upper
    return -(high * upper), 1.0 - small * (1.0 - 0.5 * small)


@inlined
def _full_of(m: Any, high: float, low: float) -> Numerators:
    """Return ``series._full_of``."""
    fraction, rest, _ = phase(m[7], m[8], m[9], high, low)
    z = fraction + (rest + m[10])
    s1, c1 = sine_cosine(z - whole(z))
    c, s = 1.0 - 2.0 * s1 * s1, 2.0 * s1 * c1
    c3, s3 = c1 * c - s1 * s, s1 * c + c1 * s
    c5, s5 = c3 * c - s3 * s, s3 * c + c3 * s
    c7, s7 = c5 * c - s5 * s, s5 * c + c5 * s
    cosines, sines = (c1, c3, c5, c7), (s1, s3, s5, s7)
    odd_cosines, odd_sines = (c1, 3.0 * c3, 5.0 * c5, 7.0 * c7), (s1, 3.0 * s3, 5.0 * s5, 7.0 * s7)
    sa, sb = m[35], m[36]
    return (
        _dot(m[12], m[13], m[14], m[15], sines), -sa * _dot(m[16], m[17], m[18], m[19], cosines),
        _dot(m[20], m[21], m[22], m[23], cosines), sb * _dot(m[24], m[25], m[26], m[27], sines),
        _dot(m[12], m[13], m[14], m[15], odd_cosines), sa * _dot(m[16], m[17], m[18], m[19], odd_sines),
        -_dot(m[20], m[21], m[22], m[23], odd_sines), sb * _dot(m[24], m[25], m[26], m[27], odd_cosines),
        _turns(m[1], m[2], m[3], high, low), _turns(m[4], m[5], m[6], high, low),
    )  # fmt: skip


@inlined
def _argument_of(m: Any, high: float, low: float) -> tuple[float, ...]:
    """Return side, both phases in turns, and exponent and factor of E and of R, ``series._complementary_of``."""
    upper, lower, periodic = m[30], m[31], m[34]
    fraction, rest, turned = phase(m[7], m[8], m[9], high, low)
    total, first_error = two_sum((1.0 - periodic) * turned, fraction)
    u, second_error = two_sum(total, m[10])
    v = rest + (m[11] + (first_error + second_error))
    u0 = u + v
    u_rest = v - (u0 - u)
    more = nearest(u0) if periodic != 0.0 else 0.0
    count = periodic * turned + more
    count = count - 4.0 * whole(0.25 * count)
    u0 = u0 - more
    side = -1.0 if u0 < 0.0 else 1.0
    f, g = u0 * side, u_rest * side
    exponent, factor = _exponent(f, g, upper, lower)
    distance = max(0.5 - f, 0.0)
    other, other_factor = _exponent(distance, ((0.5 - distance) - f) * periodic - g, upper, lower)
    half = 0.5 * (count - 2.0 * floor(0.5 * count))
    within = u0 + u_rest
    turns_a = _turns(m[1], m[2], m[3], high, low) + m[35] * within * m[32]
    turns_b = _turns(m[4], m[5], m[6], high, low) + m[36] * within * m[33]
    turns_a, turns_b = (turns_a - whole(turns_a)) + half, (turns_b - whole(turns_b)) + half
    return side, turns_a, turns_b, exponent, factor, other, other_factor


@inlined
def _complementary_of(m: Any, side: float, turns_a: float, turns_b: float, e0: float, R: float) -> Numerators:
    q, sa, sb = m[29], m[35], m[36]
    h, r = e0 * e0, R * R
    h2 = h * h
    h3 = h * h2
    h5 = h3 * h2
    h7 = h5 * h2
    q2 = q * q
    q3 = q2 * q
    w1, w2, w3 = q * r, q2 * r, q3 * r
    p1, p2, p3, p4 = q * h, q2 * h, q3 * h, q2 * q2 * h
    v2, v3 = w2 * w2, w3 * w3
    u1, u2, u3 = w1 * w1, v2 * w2, v3 * v3
    d2, d3, d4 = p2 * p2, p3 * p3 * p3, (p4 * p4) * (p4 * p4)
    v3 = v3 * w3
    sums = 1.0 + h, w1 * (1.0 + h3), v2 * (1.0 + h5), v3 * (1.0 + h7)
    gaps = 1.0 - h, w1 * (1.0 - h3), v2 * (1.0 - h5), v3 * (1.0 - h7)
    up, down = (r + p1, u1 + d2, u2 + d3, u3 + d4), (r - p1, u1 - d2, u2 - d3, u3 - d4)
    odd_sums, odd_gaps = (sums[0], 3.0 * sums[1], 5.0 * sums[2], 7.0 * sums[3]), (
        gaps[0], 3.0 * gaps[1], 5.0 * gaps[2], 7.0 * gaps[3])  # fmt: skip
    even_up, even_down = (2.0 * up[0], 4.0 * up[1], 6.0 * up[2], 8.0 * up[3]), (
        2.0 * down[0], 4.0 * down[1], 6.0 * down[2], 8.0 * down[3])  # fmt: skip
    e = 2.0 * e0
    return (
        _dot(m[12], m[13], m[14], m[15], sums), sa * side * _dot(m[16], m[17], m[18], m[19], gaps),
        e * (m[28] + _dot(m[20], m[21], m[22], m[23], up)), -sb * side * e * _dot(m[24], m[25], m[26], m[27], down),
        side * _dot(m[12], m[13], m[14], m[15], odd_gaps), sa * _dot(m[16], m[17], m[18], m[19], odd_sums),
        side * e * _dot(m[20], m[21], m[22], m[23], even_down), -sb * e * _dot(m[24], m[25], m[26], m[27], even_up),
        turns_a, turns_b,
    )  # fmt: skip


@inlined
def _state_of(m: Any, numerators: Numerators) -> State:
    """Return attitude and momentum, ``series._states``."""
    ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b = numerators
    x = 1.0 / ((ar * ar + ai * ai) + (br * br + bi * bi))
    root = square_root(x)
    s, c = sine_cosine(turns_a - whole(turns_a))
    ca, sa = c * m[39] - s * m[40], s * m[39] + c * m[40]
    s, c = sine_cosine(turns_b - whole(turns_b))
    cb, sb = c * m[41] - s * m[42], s * m[41] + c * m[42]
    ar_t, ai_t = (ar * ca - ai * sa) * root, (ar * sa + ai * ca) * root
    br_t, bi_t = (br * cb - bi * sb) * root, (br * sb + bi * cb) * root
    gain_r = (ar * dbr + ai * dbi) - (br * dar + bi * dai)
    gain_i = (ar * dbi - ai * dbr) - (bi * dar - br * dai)
    turn_r, turn_i = ai * br - ar * bi, ar * br + ai * bi
    wr = (m[37] * gain_r + m[38] * turn_r) * x
    wi = (m[37] * gain_i + m[38] * turn_i) * x
    cw, sw = cb * ca + sb * sa, sb * ca - cb * sa
    turned = m[44] < 0.0
    return (
        (br_t if turned else ar_t), (-ar_t if turned else br_t), (-ai_t if turned else bi_t),
        (bi_t if turned else ai_t), wr * cw - wi * sw, m[44] * (wr * sw + wi * cw), m[43],
    )  # fmt: skip


# ---------------------------------------------------------------------- one top


@called
def state_at(m: Any, time: float, rest: float) -> State:
    """Return attitude and momentum of one top at a time, given in two parts."""
    high, low = halves(time)
    if m[0] != 0.0:
        return _state_of(m, _full_of(m, high, low + rest))
    side, turns_a, turns_b, exponent, factor, other, other_factor = _argument_of(m, high, low + rest)
    e0, R = exponential(exponent) * factor, m[34] * (exponential(other) * other_factor)
    return _state_of(m, _complementary_of(m, side, turns_a, turns_b, e0, R))


@inlined
def _put(m: Any, i: int, numerators: Numerators, out: Any) -> None:
    (out[0, i], out[1, i], out[2, i], out[3, i], out[4, i], out[5, i], out[6, i]) = _state_of(m, numerators)


@called
def _full(m: Any, times: Any, rests: Any, out: Any) -> None:
    for i in range(times.size):
        high, low = halves(times[i])
        _put(m, i, _full_of(m, high, low + rests[i]), out)


@called
def _complementary(m: Any, times: Any, rests: Any, out: Any, work: Any) -> None:
    for i in range(times.size):
        high, low = halves(times[i])
        work[0, i], work[1, i], work[2, i], work[3, i], work[4, i], work[5, i], work[6, i] = _argument_of(
            m, high, low + rests[i]
        )
    for i in range(times.size):
        work[3, i], work[5, i] = exponential(work[3, i]), exponential(work[5, i])
    for i in range(times.size):
        e0, R = work[3, i] * work[4, i], m[34] * (work[5, i] * work[6, i])
        _put(m, i, _complementary_of(m, work[0, i], work[1, i], work[2, i], e0, R), out)


@entry
def states_of_one(m: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    out, work = np.empty((7, BLOCK)), np.empty((7, BLOCK))
    for low in range(0, times.size, BLOCK):
        high = min(low + BLOCK, times.size)
        if m[0] != 0.0:
            _full(m, times[low:high], rests[low:high], out)
        else:
            _complementary(m, times[low:high], rests[low:high], out, work)
        for i in range(high - low):
            for k in range(4):
                attitude[low + i, k] = out[k, i]
            for k in range(3):
                momentum[low + i, k] = out[4 + k, i]


# ---------------------------------------------------------------------- many tops


@inlined
def _column(m: Any, i: int) -> Any:
    """Return the numbers of one top from rows of BLOCK."""
    n = BLOCK
    return (
        0.0, m[n + i], m[2 * n + i], m[3 * n + i], m[4 * n + i], m[5 * n + i], m[6 * n + i], m[7 * n + i],
        m[8 * n + i], m[9 * n + i], m[10 * n + i], m[11 * n + i], m[12 * n + i], m[13 * n + i], m[14 * n + i],
        m[15 * n + i], m[16 * n + i], m[17 * n + i], m[18 * n + i], m[19 * n + i], m[20 * n + i], m[21 * n + i],
        m[22 * n + i], m[23 * n + i], m[24 * n + i], m[25 * n + i], m[26 * n + i], m[27 * n + i], m[28 * n + i],
        m[29 * n + i], m[30 * n + i], m[31 * n + i], m[32 * n + i], m[33 * n + i], m[34 * n + i], m[35 * n + i],
        m[36 * n + i], m[37 * n + i], m[38 * n + i], m[39 * n + i], m[40 * n + i], m[41 * n + i], m[42 * n + i],
        m[43 * n + i], m[44 * n + i],
    )  # fmt: skip


@inlined
def _keep(work: Any, i: int, x: Numerators) -> None:
    n = BLOCK
    work[i], work[n + i], work[2 * n + i], work[3 * n + i], work[4 * n + i] = x[0], x[1], x[2], x[3], x[4]
    work[5 * n + i], work[6 * n + i], work[7 * n + i], work[8 * n + i], work[9 * n + i] = x[5], x[6], x[7], x[8], x[9]


@called
def _full_of_many(m: Any, count: int, high: Any, low: Any, work: Any) -> None:
    for i in range(count):
        _keep(work, i, _full_of(_column(m, i), high[i], low[i]))


@called
def _complementary_of_many(m: Any, count: int, high: Any, low: Any, work: Any) -> None:
    n = BLOCK
    for i in range(count):
        (work[10 * n + i], work[11 * n + i], work[12 * n + i], work[13 * n + i], work[14 * n + i], work[15 * n + i],
         work[16 * n + i]) = _argument_of(_column(m, i), high[i], low[i])  # fmt: skip
    for i in range(count):
        work[13 * n + i] = exponential(work[13 * n + i])
        work[15 * n + i] = exponential(work[15 * n + i])
    for i in range(count):
        e0, R = work[13 * n + i] * work[14 * n + i], m[34 * n + i] * (work[15 * n + i] * work[16 * n + i])
        found = _complementary_of(_column(m, i), work[10 * n + i], work[11 * n + i], work[12 * n + i], e0, R)
        _keep(work, i, found)


@called
def numerators(m: Any, full: int, count: int, high: Any, low: Any, work: Any) -> None:
    """Put the numerators of a block into the first ten rows of ``work``, which has seventeen.

    Args:
        m: columns in rows of BLOCK; the first tops take the full form.
        full: how many these are.
        count: of all tops.
        high, low: times in halves.
        work: rows of BLOCK.
    """
    _full_of_many(m, full, high, low, work)
    # loops from zero, or LLVM would not trust their indices
    _complementary_of_many(m[full:], count - full, high[full:], low[full:], work[full:])


@called
def _states(m: Any, count: int, work: Any) -> None:
    """Put attitude and momentum into the first seven rows of ``work`` in place of the numerators."""
    n = BLOCK
    for i in range(count):
        found = (work[i], work[n + i], work[2 * n + i], work[3 * n + i], work[4 * n + i], work[5 * n + i],
                 work[6 * n + i], work[7 * n + i], work[8 * n + i], work[9 * n + i])  # fmt: skip
        (work[i], work[n + i], work[2 * n + i], work[3 * n + i], work[4 * n + i], work[5 * n + i],
         work[6 * n + i]) = _state_of(_column(m, i), found)  # fmt: skip


@entry
def states_of_many(columns: Any, tops: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    m, work = room(COLUMNS * BLOCK), room(WORK * BLOCK)
    high, low, place = room(BLOCK), room(BLOCK), places(BLOCK)
    for first in range(0, times.size, BLOCK):
        count = min(BLOCK, times.size - first)
        front, back = 0, count
        for i in range(first, first + count):
            if columns[0, tops[i]] != 0.0:
                place[front] = i
                front += 1
            else:
                back -= 1
                place[back] = i
        for i in range(count):
            high[i], rest = halves(times[place[i]])
            low[i] = rest + rests[place[i]]
        for k in range(1, COLUMNS):
            for i in range(count):
                m[k * BLOCK + i] = columns[k, tops[place[i]]]
        numerators(m, front, count, high, low, work)
        _states(m, count, work)
        for i in range(count):
            for k in range(4):
                attitude[place[i], k] = work[k * BLOCK + i]
            for k in range(3):
                momentum[place[i], k] = work[(4 + k) * BLOCK + i]

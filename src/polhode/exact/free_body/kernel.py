"""The evaluation of ``spinor`` for many times at once, compiled by Numba: of one body, and of many.

The same arithmetic, in blocks that stay in the first-level cache and in loops that LLVM turns into vector instructions:
no branches, no calls but to the exponential, which has a loop of its own. What Numba compiles is kept in its cache
beside this file, or in the user's where that cannot be written.

All cores share long runs, by threads of Python's: Numba's own end a process that forks, or calls them twice at once.
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

__all__ = ["BLOCK", "spinors", "states_of_many", "states_of_one"]

WORTH = 30_000  # states for which a thread is worth its start
COLUMNS = 50  # of a flattened ``spinor.Motion``
Spinor = tuple[float, float, float, float]
State = tuple[float, float, float, float, float, float, float]


@inlined
def _full(
    m1: float, m2: float, m3: float, m4: float, m5: float, m6: float, start: float,
    a0: float, a1: float, a2: float, a3: float, a4: float, b0: float, b1: float, b2: float, b3: float, b4: float,
    high: float, low: float,
) -> Spinor:  # fmt: skip
    """Return ``spinor._full_of``."""
    fa, ra, _ = phase(m1, m2, m3, high, low)
    fb, rb, _ = phase(m4, m5, m6, high, low)
    ta, tb = fa + (ra - start), fb + (rb + start)
    sa, ca = sine_cosine(ta - whole(ta))
    sb, cb = sine_cosine(tb - whole(tb))
    cz, sz = ca * cb + sa * sb, sb * ca - cb * sa
    s2 = sz + sz
    X, Y = 1.0 - s2 * sz, s2 * cz
    pa, qa = a0 + X * (a1 + X * a2), Y * (a3 + X * a4)
    pb, qb = b0 + X * (b1 + X * b2), Y * (b3 + X * b4)
    return ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb


@inlined
def _exponent(x: float, rest: float, upper: float, lower: float) -> tuple[float, float]:
    """Return the leading part of the exponent of ``decay.exponential_decay``, exact, and the factor for the rest."""
    high, low = halves(x)
    small = (high * lower + low * (upper + lower)) + rest * upper
    return -(high * upper), 1.0 - small * (1.0 - 0.5 * small)


@inlined
def _complementary_phase(
    m1: float, m2: float, m3: float, m4: float, m5: float, m6: float, start: float, start_rest: float,
    upper: float, lower: float, y_turns: float, periodic: float, parity: float, high: float, low: float,
) -> tuple[float, float, float, float, float, float, float]:  # fmt: skip
    """Return turns, side, count of half turns, and exponent and factor of E and of R, ``spinor._complementary_of``."""
    fraction, rest, _ = phase(m1, m2, m3, high, low)
    f, g, turned = phase(m4, m5, m6, high, low)
    total, first_error = two_sum((1.0 - periodic) * turned, f)
    u, second_error = two_sum(total, start)
    v = g + (start_rest + (first_error + second_error))
    u0 = u + v
    u_rest = v - (u0 - u)
    more = nearest(u0) if periodic != 0.0 else 0.0
    u0 = u0 - more
    count = parity + (periodic * turned + more)
    count = count - 4.0 * whole(0.25 * count)
    turns = fraction - 0.25 * count
    turns = (turns - whole(turns)) + (rest - u0 * y_turns)
    side = -1.0 if u0 < 0.0 else 1.0
    f, g = u0 * side, u_rest * side
    exponent, factor = _exponent(f, g, upper, lower)
    distance = max(0.5 - f, 0.0)
    other, other_factor = _exponent(distance, ((0.5 - distance) - f) * periodic - g, upper, lower)
    return turns, side, count, exponent, factor, other, other_factor


@inlined
def _complementary(
    c0: float, c1: float, c2: float, c3: float, c4: float, s0: float, s1: float, s2: float, s3: float, s4: float,
    root: float, turns: float, side: float, count: float, e0: float, R: float,
) -> Spinor:  # fmt: skip
    """Return ``spinor._complementary_spinor``."""
    s, c = sine_cosine(turns - whole(turns))
    q = root * root
    q2 = q * q
    g1 = root * R
    g2 = g1 * g1 * q
    g3 = g2 * g1 * q2
    g4 = g3 * g1 * q2 * q
    e1 = q * e0 * e0
    e2 = q2 * e1 * e0
    e3 = q2 * q * e2 * e0
    e4 = q2 * q2 * e3 * e0
    ar, ai = c4 * (g4 + e4), s4 * (g4 - e4)
    br, bi = -s4 * (g4 + e4), c4 * (g4 - e4)
    ar, ai = ar + c3 * (g3 + e3), ai + s3 * (g3 - e3)
    br, bi = br + s3 * (g3 + e3), bi - c3 * (g3 - e3)
    ar, ai = ar + c2 * (g2 + e2), ai + s2 * (g2 - e2)
    br, bi = br - s2 * (g2 + e2), bi + c2 * (g2 - e2)
    ar, ai = ar + c1 * (g1 + e1), ai + s1 * (g1 - e1)
    br, bi = br + s1 * (g1 + e1), bi - c1 * (g1 - e1)
    ar, ai = ar + c0 * (1.0 + e0), ai + s0 * (1.0 - e0)
    br, bi = br - s0 * (1.0 + e0), bi + c0 * (1.0 - e0)
    ai, bi = ai * side, bi * side
    odd = 1.0 - 2.0 * (count - 2.0 * floor(0.5 * count))
    return c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br)


@inlined
def _normal(a0: float, a1: float, b0: float, b1: float) -> tuple[float, float, float, float, float, float, float]:
    """Return the spinor of unit length and the direction of momentum, ``spinor._states``."""
    aa, bb = a0 * a0 + a1 * a1, b0 * b0 + b1 * b1
    x = 1.0 / (aa + bb)
    root = square_root(x)
    x2 = x + x
    n0, n1, n2 = (a0 * b0 + a1 * b1) * x2, (a0 * b1 - a1 * b0) * x2, (aa - bb) * x
    return a0 * root, a1 * root, b0 * root, b1 * root, n0, n1, n2


@inlined
def _row4(a: float, b: float, c: float, d: float, x: float, y: float, z: float, w: float) -> float:
    return ((a * x + b * y) + c * z) + d * w


@inlined
def _row3(a: float, b: float, c: float, x: float, y: float, z: float) -> float:
    return (a * x + b * y) + c * z


# ---------------------------------------------------------------------- one body


@inlined
def _state(m: Any, spinor: Spinor) -> State:
    """Return attitude and momentum of a spinor."""
    a, b, c, d, n0, n1, n2 = _normal(*spinor)
    return (
        _row4(m[25], m[26], m[27], m[28], a, b, c, d), _row4(m[29], m[30], m[31], m[32], a, b, c, d),
        _row4(m[33], m[34], m[35], m[36], a, b, c, d), _row4(m[37], m[38], m[39], m[40], a, b, c, d),
        _row3(m[41], m[42], m[43], n0, n1, n2), _row3(m[44], m[45], m[46], n0, n1, n2),
        _row3(m[47], m[48], m[49], n0, n1, n2),
    )  # fmt: skip


@inlined
def _full_spinor(m: Any, high: float, low: float) -> Spinor:
    return _full(m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[9], m[10], m[11], m[12], m[13], m[14], m[15], m[16],
                 m[17], m[18], high, low)  # fmt: skip


@inlined
def _phase_of(m: Any, high: float, low: float) -> tuple[float, float, float, float, float, float, float]:
    return _complementary_phase(
        m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[20], m[21], m[22], m[23], m[24], high, low
    )


@inlined
def _complementary_spinor(m: Any, turns: float, side: float, count: float, e0: float, R: float) -> Spinor:
    return _complementary(m[9], m[10], m[11], m[12], m[13], m[14], m[15], m[16], m[17], m[18], m[19], turns, side,
                          count, e0, R)  # fmt: skip


@called
def state_at(m: Any, time: float, rest: float) -> State:
    """Return attitude and momentum of one body at a time, given in two parts."""
    high, low = halves(time)
    if m[0] != 0.0:
        return _state(m, _full_spinor(m, high, low + rest))
    turns, side, count, exponent, factor, other, other_factor = _phase_of(m, high, low + rest)
    e0, R = exponential(exponent) * factor, m[23] * (exponential(other) * other_factor)
    return _state(m, _complementary_spinor(m, turns, side, count, e0, R))


@inlined
def _put(i: int, state: State, out: Any) -> None:
    out[0, i], out[1, i], out[2, i], out[3, i], out[4, i], out[5, i], out[6, i] = state


@called
def _full_of_one(m: Any, times: Any, rests: Any, out: Any) -> None:
    for i in range(times.size):
        high, low = halves(times[i])
        _put(i, _state(m, _full_spinor(m, high, low + rests[i])), out)


@called
def _complementary_of_one(m: Any, times: Any, rests: Any, out: Any, work: Any) -> None:
    for i in range(times.size):
        high, low = halves(times[i])
        work[0, i], work[1, i], work[2, i], work[3, i], work[4, i], work[5, i], work[6, i] = _phase_of(
            m, high, low + rests[i]
        )
    for i in range(times.size):
        work[3, i], work[5, i] = exponential(work[3, i]), exponential(work[5, i])
    for i in range(times.size):
        e0, R = work[3, i] * work[4, i], m[23] * (work[5, i] * work[6, i])
        _put(i, _state(m, _complementary_spinor(m, work[0, i], work[1, i], work[2, i], e0, R)), out)


@entry
def states_of_one(m: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    out, work = np.empty((7, BLOCK)), np.empty((7, BLOCK))
    for low in range(0, times.size, BLOCK):
        high = min(low + BLOCK, times.size)
        if m[0] != 0.0:
            _full_of_one(m, times[low:high], rests[low:high], out)
        else:
            _complementary_of_one(m, times[low:high], rests[low:high], out, work)
        for i in range(high - low):
            for k in range(4):
                attitude[low + i, k] = out[k, i]
            for k in range(3):
                momentum[low + i, k] = out[4 + k, i]


# ---------------------------------------------------------------------- many bodies, their columns one after the other


@called
def _full_of_many(m: Any, count: int, high: Any, low: Any, work: Any) -> None:
    B = BLOCK
    for i in range(count):
        work[i], work[B + i], work[2 * B + i], work[3 * B + i] = _full(
            m[B + i], m[2 * B + i], m[3 * B + i], m[4 * B + i], m[5 * B + i], m[6 * B + i], m[7 * B + i], m[9 * B + i],
            m[10 * B + i], m[11 * B + i], m[12 * B + i], m[13 * B + i], m[14 * B + i], m[15 * B + i], m[16 * B + i],
            m[17 * B + i], m[18 * B + i], high[i], low[i],
        )  # fmt: skip


@called
def _complementary_of_many(m: Any, count: int, high: Any, low: Any, work: Any) -> None:
    B = BLOCK
    for i in range(count):
        (work[4 * B + i], work[5 * B + i], work[6 * B + i], work[7 * B + i], work[8 * B + i], work[9 * B + i],
         work[10 * B + i]) = _complementary_phase(
            m[B + i], m[2 * B + i], m[3 * B + i], m[4 * B + i], m[5 * B + i], m[6 * B + i], m[7 * B + i], m[8 * B + i],
            m[20 * B + i], m[21 * B + i], m[22 * B + i], m[23 * B + i], m[24 * B + i], high[i], low[i],
        )  # fmt: skip
    for i in range(count):
        work[7 * B + i] = exponential(work[7 * B + i])
        work[9 * B + i] = exponential(work[9 * B + i])
    for i in range(count):
        e0, R = work[7 * B + i] * work[8 * B + i], m[23 * B + i] * (work[9 * B + i] * work[10 * B + i])
        work[i], work[B + i], work[2 * B + i], work[3 * B + i] = _complementary(
            m[9 * B + i], m[10 * B + i], m[11 * B + i], m[12 * B + i], m[13 * B + i], m[14 * B + i], m[15 * B + i],
            m[16 * B + i], m[17 * B + i], m[18 * B + i], m[19 * B + i], work[4 * B + i], work[5 * B + i],
            work[6 * B + i], e0, R,
        )  # fmt: skip


@called
def spinors(m: Any, full: int, count: int, high: Any, low: Any, work: Any) -> None:
    """Put the spinors of a block into the first four rows of ``work``, which has eleven.

    Args:
        m: columns in rows of BLOCK; the first bodies take the full form.
        full: how many these are.
        count: of all bodies.
        high, low: times in halves.
        work: rows of BLOCK.
    """
    _full_of_many(m, full, high, low, work)
    # loops from zero, or LLVM would not trust their indices
    _complementary_of_many(m[full:], count - full, high[full:], low[full:], work[full:])


@called
def _states(m: Any, count: int, work: Any) -> None:
    """Put attitude and momentum into the first seven rows of ``work`` in place of the spinors."""
    B = BLOCK
    for i in range(count):
        a, b, c, d, n0, n1, n2 = _normal(work[i], work[B + i], work[2 * B + i], work[3 * B + i])
        for k in range(4):
            j = (25 + 4 * k) * B + i
            work[k * B + i] = _row4(m[j], m[j + B], m[j + 2 * B], m[j + 3 * B], a, b, c, d)
        for k in range(3):
            j = (41 + 3 * k) * B + i
            work[(4 + k) * B + i] = _row3(m[j], m[j + B], m[j + 2 * B], n0, n1, n2)


@entry
def states_of_many(columns: Any, bodies: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    m, work = room(COLUMNS * BLOCK), room(11 * BLOCK)
    high, low, place = room(BLOCK), room(BLOCK), places(BLOCK)
    for first in range(0, times.size, BLOCK):
        count = min(BLOCK, times.size - first)
        front, back = 0, count
        for i in range(first, first + count):
            if columns[0, bodies[i]] != 0.0:
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
                m[k * BLOCK + i] = columns[k, bodies[place[i]]]
        spinors(m, front, count, high, low, work)
        _states(m, count, work)
        for i in range(count):
            for k in range(4):
                attitude[place[i], k] = work[k * BLOCK + i]
            for k in range(3):
                momentum[place[i], k] = work[(4 + k) * BLOCK + i]

"""The evaluation of ``spinor`` for many times at once, compiled by Numba (extra ``fast``).

The same arithmetic, in blocks that stay in the first-level cache and in loops that LLVM turns into vector instructions:
no branches, no calls but to the exponential, which has a loop of its own. What Numba compiles is kept in its cache
beside this file, or in the user's where that cannot be written.

All cores share long runs, by threads of Python's: Numba's own end a process that forks, or calls them twice at once.
"""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any

import numpy as np

from polhode.types import Float64

try:
    from numba import njit
except ImportError:  # plain functions then, which nothing calls
    njit = None

ROUNDING = 6755399441055744.0  # 1.5 · 2⁵²: added and taken away again, it leaves the nearest whole number
SPLITTING = 134217729.0  # 2²⁷ + 1
BLOCK = 256  # states
WORTH = 30_000  # states for which a thread is worth its start
_S = [(-1) ** n * (2.0 * np.pi) ** (2 * n + 1) / float(np.prod(np.arange(1.0, 2 * n + 2))) for n in range(9)]
_C = [(-1) ** n * (2.0 * np.pi) ** (2 * n) / float(np.prod(np.arange(1.0, 2 * n + 1))) for n in range(10)]
S0, S1, S2, S3, S4, S5, S6, S7, S8 = _S
C0, C1, C2, C3, C4, C5, C6, C7, C8, C9 = _C


def _compiled(**options: Any) -> Callable[[Callable[..., Any]], Any]:
    """Return Numba's decorator, applied to the function itself where the tests wrap it to check annotations."""
    return lambda function: function if njit is None else njit(**options)(inspect.unwrap(function))


@_compiled(inline="always")
def _whole(x: float) -> float:
    return (x + ROUNDING) - ROUNDING


@_compiled(inline="always")
def _sine_cosine(x: float) -> tuple[float, float]:
    """Return sin 2πx and cos 2πx, |x| ≤ ½."""
    quarter = _whole(4.0 * x)
    r = x - 0.25 * quarter
    z = r * r
    s = r * (S0 + z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * (S6 + z * (S7 + z * S8))))))))
    c = C0 + z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * (C6 + z * (C7 + z * (C8 + z * C9))))))))
    n = quarter - 4.0 * np.floor(0.25 * quarter)
    odd = n == 1.0 or n == 3.0
    a, b = (c, s) if odd else (s, c)
    return (-a if n >= 2.0 else a), (-b if n == 1.0 or n == 2.0 else b)


@_compiled(inline="always")
def _two_sum(a: float, b: float) -> tuple[float, float]:
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


@_compiled(inline="always")
def _phase(upper: float, lower: float, low: float, high: float, rest: float) -> tuple[float, float, float]:
    """Return ``circular.reduced_phase``."""
    a, b, c = upper * high, upper * rest, lower * high
    na, nb, nc = _whole(a), _whole(b), _whole(c)
    d = lower * rest + low * (high + rest)
    middle, middle_error = _two_sum(b - nb, c - nc)
    fraction, error = _two_sum(a - na, middle)
    more = _whole(fraction)
    return fraction - more, error + (middle_error + d), na + (nb + nc) + more


@_compiled(inline="always")
def _put(m: Any, i: int, a0: float, a1: float, b0: float, b1: float, out: Any) -> None:
    """Store attitude and momentum of a spinor, ``spinor._states``."""
    aa, bb = a0 * a0 + a1 * a1, b0 * b0 + b1 * b1
    x = 1.0 / (aa + bb)
    root = np.sqrt(x)
    x2 = x + x
    n0, n1, n2 = (a0 * b0 + a1 * b1) * x2, (a0 * b1 - a1 * b0) * x2, (aa - bb) * x
    a0, a1, b0, b1 = a0 * root, a1 * root, b0 * root, b1 * root
    out[0, i] = ((m[25] * a0 + m[26] * a1) + m[27] * b0) + m[28] * b1
    out[1, i] = ((m[29] * a0 + m[30] * a1) + m[31] * b0) + m[32] * b1
    out[2, i] = ((m[33] * a0 + m[34] * a1) + m[35] * b0) + m[36] * b1
    out[3, i] = ((m[37] * a0 + m[38] * a1) + m[39] * b0) + m[40] * b1
    out[4, i] = (m[41] * n0 + m[42] * n1) + m[43] * n2
    out[5, i] = (m[44] * n0 + m[45] * n1) + m[46] * n2
    out[6, i] = (m[47] * n0 + m[48] * n1) + m[49] * n2


@_compiled(error_model="numpy")
def _full(m: Any, times: Any, rests: Any, out: Any) -> None:
    """Fill a block by ``spinor._full_of``."""
    for i in range(times.size):
        t = SPLITTING * times[i]
        high = t - (t - times[i])
        low = (times[i] - high) + rests[i]
        fa, ra, _ = _phase(m[1], m[2], m[3], high, low)
        fb, rb, _ = _phase(m[4], m[5], m[6], high, low)
        ta, tb = fa + (ra - m[7]), fb + (rb + m[7])
        sa, ca = _sine_cosine(ta - _whole(ta))
        sb, cb = _sine_cosine(tb - _whole(tb))
        cz, sz = ca * cb + sa * sb, sb * ca - cb * sa
        s2 = sz + sz
        X, Y = 1.0 - s2 * sz, s2 * cz
        pa, qa = m[9] + X * (m[10] + X * m[11]), Y * (m[12] + X * m[13])
        pb, qb = m[14] + X * (m[15] + X * m[16]), Y * (m[17] + X * m[18])
        _put(m, i, ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb, out)


@_compiled(inline="always")
def _exponent(x: float, rest: float, upper: float, lower: float) -> tuple[float, float]:
    """Return the leading part of the exponent of ``decay.exponential_decay``, exact, and the factor for the rest."""
    t = SPLITTING * x
    high = t - (t - x)
    low = x - high
    small = (high * lower + low * (upper + lower)) + rest * upper
    return -(high * upper), 1.0 - small * (1.0 - 0.5 * small)


@_compiled(error_model="numpy")
def _complementary(m: Any, times: Any, rests: Any, out: Any, work: Any) -> None:
    """Fill a block by ``spinor._complementary_of``."""
    root, upper, lower, y_turns, periodic = m[19], m[20], m[21], m[22], m[23]
    for i in range(times.size):
        t = SPLITTING * times[i]
        high = t - (t - times[i])
        low = (times[i] - high) + rests[i]
        fraction, rest, _ = _phase(m[1], m[2], m[3], high, low)
        f, g, whole = _phase(m[4], m[5], m[6], high, low)
        total, first_error = _two_sum((1.0 - periodic) * whole, f)
        u, second_error = _two_sum(total, m[7])
        v = g + (m[8] + (first_error + second_error))
        u0 = u + v
        u_rest = v - (u0 - u)
        more = np.rint(u0) if periodic != 0.0 else 0.0
        u0 = u0 - more
        count = m[24] + (periodic * whole + more)
        count = count - 4.0 * _whole(0.25 * count)
        turns = fraction - 0.25 * count
        work[0, i] = (turns - _whole(turns)) + (rest - u0 * y_turns)
        side = -1.0 if u0 < 0.0 else 1.0
        f, g = u0 * side, u_rest * side
        work[1, i], work[2, i] = side, count
        work[3, i], work[4, i] = _exponent(f, g, upper, lower)
        distance = max(0.5 - f, 0.0)
        work[5, i], work[6, i] = _exponent(distance, ((0.5 - distance) - f) * periodic - g, upper, lower)
    for i in range(times.size):
        work[3, i], work[5, i] = np.exp(work[3, i]), np.exp(work[5, i])
    q = root * root
    q2 = q * q
    for i in range(times.size):
        side, count = work[1, i], work[2, i]
        e0, R = work[3, i] * work[4, i], periodic * (work[5, i] * work[6, i])
        s, c = _sine_cosine(work[0, i] - _whole(work[0, i]))
        g1 = root * R
        g2 = g1 * g1 * q
        g3 = g2 * g1 * q2
        g4 = g3 * g1 * q2 * q
        e1 = q * e0 * e0
        e2 = q2 * e1 * e0
        e3 = q2 * q * e2 * e0
        e4 = q2 * q2 * e3 * e0
        ar, ai = m[13] * (g4 + e4), m[18] * (g4 - e4)
        br, bi = -m[18] * (g4 + e4), m[13] * (g4 - e4)
        ar, ai = ar + m[12] * (g3 + e3), ai + m[17] * (g3 - e3)
        br, bi = br + m[17] * (g3 + e3), bi - m[12] * (g3 - e3)
        ar, ai = ar + m[11] * (g2 + e2), ai + m[16] * (g2 - e2)
        br, bi = br - m[16] * (g2 + e2), bi + m[11] * (g2 - e2)
        ar, ai = ar + m[10] * (g1 + e1), ai + m[15] * (g1 - e1)
        br, bi = br + m[15] * (g1 + e1), bi - m[10] * (g1 - e1)
        ar, ai = ar + m[9] * (1.0 + e0), ai + m[14] * (1.0 - e0)
        br, bi = br - m[14] * (1.0 + e0), bi + m[9] * (1.0 - e0)
        ai, bi = ai * side, bi * side
        odd = 1.0 - 2.0 * (count - 2.0 * np.floor(0.5 * count))
        _put(m, i, c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br), out)


@_compiled(cache=True, nogil=True, error_model="numpy")
def _of_one(full: bool, m: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    out, work = np.empty((7, BLOCK)), np.empty((7, BLOCK))
    for low in range(0, times.size, BLOCK):
        high = min(low + BLOCK, times.size)
        if full:
            _full(m, times[low:high], rests[low:high], out)
        else:
            _complementary(m, times[low:high], rests[low:high], out, work)
        for i in range(high - low):
            for k in range(4):
                attitude[low + i, k] = out[k, i]
            for k in range(3):
                momentum[low + i, k] = out[4 + k, i]


def states_of_one(
    columns: tuple[float, ...], times: Float64[np.ndarray, "time"], rests: Float64[np.ndarray, "time"]
) -> tuple[Float64[np.ndarray, "time 4"], Float64[np.ndarray, "time 3"]]:
    """Return attitude and momentum of one body at times, given in two parts.

    Args:
        columns: the 50 numbers of a flattened ``spinor.Motion``.
        times: (T,) since the epoch.
        rests: (T,) what the floats leave of them.
    """
    full, m = bool(columns[0]), tuple(map(float, columns))
    attitude, momentum = np.empty((times.size, 4)), np.empty((times.size, 3))
    count = min(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1,
                max(1, times.size // WORTH))  # fmt: skip
    ends = [times.size * k // count for k in range(count + 1)]
    parts = [slice(*pair) for pair in pairwise(ends)]

    def fill(part: slice) -> None:
        _of_one(full, m, times[part], rests[part], attitude[part], momentum[part])

    if count == 1:
        fill(parts[0])
    else:
        with ThreadPoolExecutor(count) as pool:
            list(pool.map(fill, parts))
    return attitude, momentum

"""``special.agm`` for a block of bodies or tops, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode.exact.kernel_arithmetic import (
    BLOCK,
    Pair,
    add,
    called,
    divide,
    inlined,
    multiply,
    pair,
    put,
    root,
    scale,
    square,
    subtract,
)
from polhode.special.agm import CONVERGED, MOST_STEPS

# state of the mean, what closes it, and whether it may end; all but the last are pairs of rows
AA, BB, PP, QQ, TT, CLOSED, TOTAL, DONE = range(0, 16 * BLOCK, 2 * BLOCK)
STATE, STEPS = 10, 15  # rows
AT_ONCE = 3  # steps of all bodies, before the first is looked at


@inlined
def start_mean(s: Any, i: int, a: Pair, g: Pair, pp: Pair) -> None:
    """Begin the mean of positive a and g, with the sum that starts from p² = pp."""
    put(s, AA + i, a)
    put(s, BB + i, g)
    put(s, PP + i, pp)
    put(s, QQ + i, (1.0, 0.0))
    put(s, TT + i, (1.0, 0.0))


@called
def _step(s: Any, count: int) -> None:
    for i in range(count):
        a, g, pp = pair(s, AA + i), pair(s, BB + i), pair(s, PP + i)
        ag = multiply(a, g)
        both = add(pp, ag)
        q = scale(multiply(pair(s, QQ + i), divide(subtract(pp, ag), both)), 0.5)
        put(s, PP + i, scale(divide(square(both), pp), 0.25))
        put(s, QQ + i, q)
        put(s, TT + i, add(pair(s, TT + i), q))
        put(s, AA + i, scale(add(a, g), 0.5))
        put(s, BB + i, root(ag))


@called
def _close(s: Any, count: int) -> None:
    """Close as ``agm.third_kind_agm`` does, and say where that is exact."""
    for i in range(count):
        a, g, pp = pair(s, AA + i), pair(s, BB + i), pair(s, PP + i)
        middle = scale(add(a, g), 0.5)
        half = 0.5 * ((a[0] - g[0]) + (a[1] - g[1]))
        d = subtract(pp, square(middle))
        e = d[0] + d[1] + half * half
        x, e = half / middle[0], e / (2.0 * middle[0] * middle[0] + e)
        last = 0.5 * s[QQ + i] * e
        rest = last + last * (0.25 * (e * e - 0.5 * x * x))
        put(s, CLOSED + i, add(middle, (-0.25 * middle[0] * x * x, 0.0)))
        put(s, TOTAL + i, add(pair(s, TT + i), (rest, 0.0)))
        s[DONE + i] = 1.0 if abs(x) < CONVERGED and abs(e) < CONVERGED else 0.0


@called
def third_kind(w: Any, mean: int, total: int, count: int, s: Any, who: Any) -> None:
    """Put mean and third-kind sum into the store; who has converged makes room for who has not.

    Args:
        w: store, of rows of BLOCK.
        mean, total: first rows of the pairs that take the results.
        count: of bodies.
        s: STEPS rows, begun by ``start_mean``.
        who: room for BLOCK whole numbers.
    """
    for i in range(count):
        who[i] = i
    for step in range(1, MOST_STEPS + 1):
        _step(s, count)
        if step < AT_ONCE:
            continue
        _close(s, count)
        left = 0
        for i in range(count):
            j = who[i]
            if s[DONE + i] == 1.0 or step == MOST_STEPS:
                put(w, mean + j, pair(s, CLOSED + i))
                put(w, total + j, pair(s, TOTAL + i))
            else:
                for k in range(STATE):
                    s[k * BLOCK + left] = s[k * BLOCK + i]
                who[left] = j
                left += 1
        count = left
        if count == 0:
            return

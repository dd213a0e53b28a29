"""The arithmetic–geometric mean with its third-kind sum, for a block of bodies or tops."""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._formulas import AT_ONCE, CONVERGED, MOST_STEPS, mean_closed, mean_distance, mean_step
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    Pair,
    pair,
    put,
    put_record,
)

# state of the mean, what closes it, and whether it may end; all but the last are pairs of rows
AA, BB, PP, QQ, TT, CLOSED, TOTAL, DONE = range(0, 16 * BLOCK, 2 * BLOCK)
STATE, STEPS = 10, 15  # rows


def start_mean(s: Any, i: int, a: Pair, g: Pair, pp: Pair) -> None:
    """Begin the mean of positive a and g, with the sum that starts from p² = pp."""
    put_record(s, AA + i, (*a, *g, *pp, 1.0, 0.0, 1.0, 0.0))


@called
def _step(s: Any, count: int) -> None:
    for i in range(count):
        a, g, pp, q, total = mean_step(
            pair(s, AA + i), pair(s, BB + i), pair(s, PP + i), pair(s, QQ + i), pair(s, TT + i)
        )
        put(s, AA + i, a)
        put(s, BB + i, g)
        put(s, PP + i, pp)
        put(s, QQ + i, q)
        put(s, TT + i, total)


@called
def _close(s: Any, count: int) -> None:
    """Close the mean, and say where that is exact."""
    for i in range(count):
        x, e, middle = mean_distance(pair(s, AA + i), pair(s, BB + i), pair(s, PP + i))
        mean, total = mean_closed(x, e, middle, s[QQ + i], pair(s, TT + i))
        put(s, CLOSED + i, mean)
        put(s, TOTAL + i, total)
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

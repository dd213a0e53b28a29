"""The integrals of the first kind for a block of tops, compiled by Numba: the steps of ``formulas_integrals``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    choice,
    multiply,
    pair,
    put,
    put_record,
    root_or_zero,
    square_root,
    where,
)
from polhode.exact._kernel_records import load
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas_integrals import (
    CLOSER,
    MOST_STEPS,
    closed,
    closed_sharply,
    duplicated,
    duplicated_sharply,
    is_close,
    is_closer,
    place_of_start,
    pole_of_alpha,
    pole_of_beta,
    rest_of_alpha,
    rest_of_beta,
    widest,
)
from polhode.exact.lagrange_top._formulas_reduction import ONE, Reduction
from polhode.exact.lagrange_top._formulas_roots import TurningPoints

# rows of the duplication, those of the sharp one in pairs
X, Y, Z = 0, 2 * BLOCK, 4 * BLOCK
STEPS = 6


def _three(s: Any, i: int) -> Any:
    return s[X + i], s[Y + i], s[Z + i]


def _three_pairs(s: Any, i: int) -> Any:
    return pair(s, X + i), pair(s, Y + i), pair(s, Z + i)


def _put_three(s: Any, i: int, now: Any) -> None:
    s[X + i], s[Y + i], s[Z + i] = now


@called
def _first_kind(s: Any, count: int) -> None:
    """Put R_F(x, y, 1) of two rows into the first; a step is taken by those that need it alone."""
    for i in range(count):
        s[Z + i] = 1.0
    for _ in range(MOST_STEPS):
        far = 0
        for i in range(count):
            far += 0 if is_close(_three(s, i)) else 1
        if far == 0:
            break
        for i in range(count):
            now = _three(s, i)
            near, (x, y, z) = is_close(now), duplicated(now)
            _put_three(s, i, (where(near, now[0], x), where(near, now[1], y), where(near, now[2], z)))
    for i in range(count):
        s[X + i] = closed(_three(s, i))


@called
def _first_kind_sharply(s: Any, count: int) -> None:
    """Put R_F(x, y, 1) of two pairs of rows into the first."""
    for i in range(count):
        put(s, Z + i, ONE)
    for _ in range(MOST_STEPS):
        far = 0
        for i in range(count):
            far += 0 if widest(s[X + i], s[Y + i], s[Z + i]) <= CLOSER else 1
        if far == 0:
            break
        for i in range(count):
            now = _three_pairs(s, i)
            near, (x, y, z) = is_closer(now), duplicated_sharply(now)
            put(s, X + i, choice(near, now[0], x))
            put(s, Y + i, choice(near, now[1], y))
            put(s, Z + i, choice(near, now[2], z))
    for i in range(count):
        put(s, X + i, closed_sharply(_three_pairs(s, i)))


def _integrate(terms: Callable[..., Any], w: Any, count: int, s: Any, to: int) -> None:
    for i in range(count):
        s[X + i], s[Y + i], w[to + i] = terms(load(w, at.TOP + i, Reduction), load(w, at.POINTS + i, TurningPoints))
    _first_kind(s, count)
    for i in range(count):
        w[to + i] = square_root(w[to + i]) * s[X + i]


@called
def integrals(w: Any, full: int, count: int, s: Any) -> None:
    """Put the places of the poles, and the start, into the store; NaN where one fails.

    Args:
        w: store of tops, those of the full form first; they alone need the distances of the poles from K'.
        full: how many these are.
        count: of all tops.
        s: STEPS rows.
    """
    _integrate(pole_of_alpha, w, count, s, at.V_ALPHA)
    _integrate(pole_of_beta, w, count, s, at.V_BETA)
    _integrate(rest_of_alpha, w, full, s, at.W_ALPHA)
    _integrate(rest_of_beta, w, full, s, at.W_BETA)
    for i in range(count):
        x, y, c = place_of_start(load(w, at.POINTS + i, TurningPoints))
        put_record(s, i, (x, y))
        put(w, at.X0 + i, c)
    _first_kind_sharply(s, count)
    for i in range(count):
        put(w, at.X0 + i, multiply(root_or_zero(pair(w, at.X0 + i)), pair(s, X + i)))

"""The set-up of many tops, from moments to the columns of ``formulas.Motion``, compiled by Numba.

The same steps as ``reduction``, ``roots``, ``frequencies`` and ``preparation``, in blocks of tops and in loops that
LLVM turns into vector instructions. Tops are sorted on the way: those that take the full form first, then those that
take the complementary one. Tops that have no weight, that do not nutate, and that end upright are left to NumPy.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called, entry
from polhode.exact._kernel_agm import STEPS
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    flags,
    places,
    room,
)
from polhode.exact._kernel_loops import WORK, sums_of_many
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas import AXIAL, COLUMNS
from polhode.exact.lagrange_top._kernel_integrals import integrals
from polhode.exact.lagrange_top._kernel_rates import rates
from polhode.exact.lagrange_top._kernel_reduction import TERMS, begin
from polhode.exact.lagrange_top._kernel_roots import turning_points
from polhode.exact.lagrange_top._kernel_series import phases, series
from polhode.exact.lagrange_top._kernel_store import KEPT, ROWS

WORTH = 1_000  # tops for which a thread is worth its start


@called
def _sorted(begun: Any, count: int, sources: Any, w: Any, place: Any, order: Any) -> tuple[int, int]:
    """Copy the tops that the kernels take, those of the full form first; return how many take it, and how many any.

    Args:
        begun, w: stores of tops before and after.
        count: of tops before.
        sources, place: where the tops come from, before and after.
        order: room for BLOCK whole numbers.
    """
    full, back = 0, count
    for i in range(count):
        d, b = begun[at.GAP + i], begun[at.B + i]
        if not (begun[at.UP + i] >= 0.0 and d > 0.0 and b > 0.0):
            continue
        if begun[at.G + i] * d <= b:
            order[full] = i
            full += 1
        else:
            back -= 1
            order[back] = i
    for i in range(back, count):
        order[full + i - back] = order[i]
    good = full + count - back
    for k in range(KEPT):
        for i in range(good):
            w[k * BLOCK + i] = begun[k * BLOCK + order[i]]
    for i in range(good):
        place[i] = sources[order[i]]
    return full, good


@called
def _finite(m: Any, count: int, good: Any) -> None:
    """Say which tops have numbers alone in their columns."""
    for i in range(count):
        total = 0.0
        for k in range(1, COLUMNS):
            x = m[k * BLOCK + i]
            total += x - x
        good[i] = total == 0.0


def set_up_one(moments: Any, mgl: Any, momentum: Any, attitude: Any) -> tuple[float, ...] | None:
    """Return the numbers of the motion of one top, a block by itself, or None for one that is left to NumPy."""
    columns, left = [[0.0] for _ in range(COLUMNS)], [True]
    set_up([moments], [mgl], [momentum], [attitude], columns, left, 0)
    return None if left[0] else tuple(x for (x,) in columns)


@entry
def set_up(
    moments: Any, mgl: Any, momentum: Any, attitude: Any, columns: Any, left: Any, first: int
) -> None:
    begun, w, m = room(ROWS * BLOCK), room(ROWS * BLOCK), room(COLUMNS * BLOCK)
    steps, work, zeros, terms = room(STEPS * BLOCK), room(WORK * BLOCK), room(BLOCK), room(TERMS)
    sources, place, who = places(BLOCK), places(BLOCK), places(BLOCK)
    good = flags(BLOCK)
    for low in range(0, len(moments), BLOCK):
        part = slice(low, low + BLOCK)
        count = begin(moments[part], mgl[part], momentum[part], attitude[part], begun, sources, terms)
        turning_points(begun, count)
        full, count = _sorted(begun, count, sources, w, place, who)
        rates(w, count, steps, who, m)
        integrals(w, full, count, steps)
        for i in range(count):
            m[AXIAL + i] = momentum[low + place[i]][2]
        series(w, full, count, m)
        sums_of_many(m, full, count, zeros, zeros, zeros, work)
        phases(w, count, m, work)
        _finite(m, count, good)
        for i in range(count):
            columns[0][first + low + place[i]] = 1.0 if i < full else 0.0
            left[low + place[i]] = not good[i]
        for k in range(1, COLUMNS):
            column = columns[k]
            for i in range(count):
                column[first + low + place[i]] = m[k * BLOCK + i]

"""The set-up of many tops, from moments to the columns of ``formulas.Motion``, compiled by Numba.

The steps of the formulas in blocks of tops and in loops that LLVM turns into
vector instructions. Tops are sorted on the way: those that take the full form first, then those that
take the complementary one. Tops that have no weight, that do not nutate, and that end upright are left to NumPy.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called, entry
from polhode.exact._formulas import mean_start
from polhode.exact._kernel_agm import AA, STEPS, third_kind
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    cleared,
    flags,
    pair,
    places,
    put_record,
    record,
    room,
    scale,
    times_power,
)
from polhode.exact._kernel_loops import SUMS, WORK, sums_of_many
from polhode.exact._kernel_records import load
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas import (
    A_SUM,
    AXIAL,
    COLUMNS,
    FIRST,
    NOME,
    PHASES,
    REVERSED,
    Four,
    Motion,
    sums_at,
)
from polhode.exact.lagrange_top._formulas_integrals import Integrals, integrals_of
from polhode.exact.lagrange_top._formulas_rates import Frequencies, Starts, frequencies, frequencies_of, starts_of
from polhode.exact.lagrange_top._formulas_reduction import (
    Reduction,
    Three,
    exactly_reduced,
    plainly_reduced,
    scaled,
    size_of,
)
from polhode.exact.lagrange_top._formulas_roots import (
    TurningPoints,
    apart,
    begun,
    is_found,
    nearer,
    turning_points_of,
)
from polhode.exact.lagrange_top._formulas_setup import (
    Arguments,
    Given,
    Timing,
    arguments,
    complementary,
    full_series,
    is_full,
    motion_of,
    phases_of,
    tails,
    timing_of,
)
from polhode.exact.lagrange_top._kernel_integrals import integrals
from polhode.exact.lagrange_top._kernel_reduction import begin, is_left, is_near, is_within
from polhode.exact.lagrange_top._kernel_roots import turning_points
from polhode.exact.lagrange_top._kernel_store import ALL, KEPT, ROWS

WORTH = 4_000  # tops for which a thread is worth its start and its memory


def _form(w: Any, i: int) -> int:
    """Return 1 for a top that takes the full form, 0 for the complementary one, −1 for one that the kernels leave."""
    points = load(w, at.POINTS + i, TurningPoints)
    if not (w[at.UP + i] >= 0.0 and points.d[0] > 0.0 and points.B[0] > 0.0):
        return -1
    return 1 if is_full(load(w, at.TOP + i, Reduction), points) else 0


@called
def _sorted(before: Any, count: int, sources: Any, w: Any, place: Any, order: Any) -> tuple[int, int]:
    """Copy the tops that the kernels take, those of the full form first; return how many take it, and how many any.

    Args:
        before, w: stores of tops before and after.
        count: of tops before.
        sources, place: where the tops come from, before and after.
        order: room for BLOCK whole numbers.
    """
    full, back = 0, count
    for i in range(count):
        form = _form(before, i)
        if form == 1:
            order[full] = i
            full += 1
        elif form == 0:
            back -= 1
            order[back] = i
    for i in range(back, count):
        order[full + i - back] = order[i]
    good = full + count - back
    for k in range(KEPT):
        for i in range(good):
            w[k * BLOCK + i] = before[k * BLOCK + order[i]]
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


# ---------------------------------------------------------------------- the formulas in loops


@called
def _start_alpha(w: Any, count: int, steps: Any) -> None:
    for i in range(count):
        start = starts_of(load(w, at.TOP + i, Reduction), load(w, at.POINTS + i, TurningPoints))
        state, w[at.EXPONENT + i] = mean_start(start.root_A, start.root_B, start.alpha)
        put_record(w, at.BEGUN + i, start)
        put_record(steps, AA + i, state)


@called
def _start_beta(w: Any, count: int, steps: Any) -> None:
    for i in range(count):
        start = load(w, at.BEGUN + i, Starts)
        state, _ = mean_start(start.root_A, start.root_B, start.beta)
        put_record(steps, AA + i, state)


@called
def _put_rates(w: Any, count: int) -> None:
    for i in range(count):
        top, points = load(w, at.TOP + i, Reduction), load(w, at.POINTS + i, TurningPoints)
        start = load(w, at.BEGUN + i, Starts)
        mean = scale(pair(w, at.MEAN + i), times_power(1.0, w[at.EXPONENT + i]))
        rates = frequencies_of(top, points, start, mean, pair(w, at.ALPHA + i), pair(w, at.BETA + i))
        put_record(w, at.RATES + i, rates)


@called
def _put_arguments(w: Any, count: int) -> None:
    for i in range(count):
        top, points = load(w, at.TOP + i, Reduction), load(w, at.POINTS + i, TurningPoints)
        rates, parts = load(w, at.RATES + i, Frequencies), load(w, at.INTEGRALS + i, Integrals)
        put_record(w, at.AT + i, arguments(top, points, rates, parts))


@called
def _full_series(w: Any, full: int, m: Any) -> None:
    for i in range(full):
        put_record(w, at.TAILS + i, tails(load(w, at.AT + i, Arguments)))
    for i in range(full):
        top, points = load(w, at.TOP + i, Reduction), load(w, at.POINTS + i, TurningPoints)
        place, tail = load(w, at.AT + i, Arguments), record(w, at.TAILS + i, 4)
        put_record(m, A_SUM + i, full_series(top, points, place, tail))


@called
def _complementary_series(w: Any, count: int, m: Any) -> None:
    for i in range(count):
        top, points = load(w, at.TOP + i, Reduction), load(w, at.POINTS + i, TurningPoints)
        put_record(m, A_SUM + i, complementary(top, points, load(w, at.AT + i, Arguments)))


@called
def _put_timing(w: Any, count: int, m: Any) -> None:
    for i in range(count):
        top, rates = load(w, at.TOP + i, Reduction), load(w, at.RATES + i, Frequencies)
        timing = timing_of(top, rates, load(w, at.AT + i, Arguments))
        put_record(w, at.TIMING + i, timing)
        put_record(m, FIRST + i, timing.rates)
        put_record(m, NOME + i, timing.places)
        m[REVERSED + i] = -1.0 if top.reversed else 1.0


@called
def _phases(w: Any, count: int, m: Any, work: Any) -> None:
    for i in range(count):
        top, timing = load(w, at.TOP + i, Reduction), load(w, at.TIMING + i, Timing)
        put_record(m, PHASES + i, phases_of(top, timing, sums_at(work, SUMS + i)))


def set_up_one(moments: Three, mgl: tuple[float], momentum: Three, attitude: Four) -> Motion | None:
    """Return the constants of motion of one top, or None for one that is left to NumPy."""
    if not is_within(moments, mgl[0], momentum):
        return None
    given = scaled(moments, mgl[0], momentum, attitude)
    if not is_near(given):
        return None
    top, spare = plainly_reduced(given)
    top = exactly_reduced(given, size_of(given)) if spare < 0.0 else top
    lone = apart(top)
    root = nearer(nearer(begun(lone)))
    points = turning_points_of(top, lone.upper, root[0], lone.f1)
    if is_left(top) or not (is_found(root) and points.d[0] > 0.0 and points.B[0] > 0.0):
        return None
    rates = frequencies(top, points)
    at_start = arguments(top, points, rates, integrals_of(top, points, rates))
    motion = motion_of(Given(top, points, rates, at_start, momentum[2]))
    return motion if _is_finite(motion) else None


def _is_finite(part: Any) -> bool:
    return all(map(_is_finite, part)) if isinstance(part, tuple) else part - part == 0.0


@entry
def set_up(
    moments: Any, mgl: Any, momentum: Any, attitude: Any, columns: Any, left: Any, first: int
) -> None:
    before, w, m = room(ALL), room(ROWS), cleared(COLUMNS * BLOCK)
    steps, work, zeros = room(STEPS * BLOCK), room(WORK * BLOCK), cleared(BLOCK)
    sources, place, who = places(BLOCK), places(BLOCK), places(BLOCK)
    good = flags(BLOCK)
    for low in range(0, len(moments), BLOCK):
        part = slice(low, low + BLOCK)
        count = begin(moments[part], mgl[part], momentum[part], attitude[part], before, sources)
        turning_points(before, count)
        full, count = _sorted(before, count, sources, w, place, who)
        _start_alpha(w, count, steps)
        third_kind(w, at.MEAN, at.ALPHA, count, steps, who)
        _start_beta(w, count, steps)
        third_kind(w, at.AGAIN, at.BETA, count, steps, who)
        _put_rates(w, count)
        integrals(w, full, count, steps)
        _put_arguments(w, count)
        for i in range(count):
            m[AXIAL + i] = momentum[low + place[i]][2]
        _full_series(w, full, m)
        _complementary_series(w[full:], count - full, m[full:])
        _put_timing(w, count, m)
        sums_of_many(m, full, count, zeros, zeros, zeros, work)
        _phases(w, count, m, work)
        _finite(m, count, good)
        for i in range(count):
            columns[0][first + low + place[i]] = 1.0 if i < full else 0.0
            left[low + place[i]] = not good[i]
        for k in range(1, COLUMNS):
            column = columns[k]
            for i in range(count):
                column[first + low + place[i]] = m[k * BLOCK + i]

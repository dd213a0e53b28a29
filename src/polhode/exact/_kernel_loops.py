"""The loops over states that both motions have: of one body or top, and of many.

They run in blocks that stay in the first-level cache, and as loops that LLVM turns into vector instructions: no
branches, no calls but to the exponential, which has a loop of its own. What Numba compiles is kept in its cache beside
these files, or in the user's where that cannot be written. All cores share long runs, by threads of Python's: Numba's
own end a process that forks, or calls them twice at once.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called, entry, given
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    Time,
    exponential,
    halves,
    places,
    put_record,
    record,
    room,
)

WORTH = 25_000  # states for which a thread is worth its start
PHASE = 7  # numbers of a phase
SUMS, WORK = PHASE * BLOCK, PHASE + 10  # where sums begin in a store, after the phases, and rows of such a store
Numbers = tuple[float, ...]

# ---------------------------------------------------------------------- declared here, defined by a motion's formulas
# ``copies`` puts the formulas of a motion in place of these, and fails where one is missing.


@given
def unflatten(m: Any) -> Any:
    """Return the motion whose numbers stand in one tuple."""


@given
def motion_at(m: Any, i: int) -> Any:
    """Return the motion whose numbers stand in rows."""


@given
def sums_at(work: Any, i: int) -> Any:
    """Return the sums of a form that stand in rows."""


@given
def full_sums(m: Any, time: Time) -> Any:
    """Return the sums of the full form at a time."""


@given
def complementary_phase(m: Any, time: Time) -> Any:
    """Return three numbers, exponent and factor of E, and of R, of the complementary form at a time."""


@given
def complementary_sums(m: Any, a: float, b: float, c: float, e0: float, R: float) -> Any:
    """Return the sums of the complementary form, of the three numbers, E and R."""


@given
def state_of(m: Any, sums: Numbers) -> Any:
    """Return attitude and momentum."""


# ---------------------------------------------------------------------- one body or top


@called
def state_at(m: Any, time: float, rest: float) -> Numbers:
    """Return attitude and momentum of a motion at a time, given in two parts."""
    high, low = halves(time)
    if m.full != 0.0:
        return state_of(m, full_sums(m, (high, low, rest)))
    a, b, c, exponent, factor, other, other_factor = complementary_phase(m, (high, low, rest))
    e0, R = exponential(exponent) * factor, exponential(other) * other_factor
    return state_of(m, complementary_sums(m, a, b, c, e0, R))


@called
def _full_of_one(column: Any, times: Any, rests: Any, work: Any) -> None:
    m = unflatten(column)
    for i in range(times.size):
        high, low = halves(times[i])
        put_record(work, i, state_of(m, full_sums(m, (high, low, rests[i]))))


@called
def _complementary_of_one(column: Any, times: Any, rests: Any, work: Any) -> None:
    m = unflatten(column)
    for i in range(times.size):
        high, low = halves(times[i])
        put_record(work, i, complementary_phase(m, (high, low, rests[i])))
    _exponentials(work, times.size)
    for i in range(times.size):
        a, b, c, exponent, factor, other, other_factor = record(work, i, PHASE)
        put_record(work, i, state_of(m, complementary_sums(m, a, b, c, exponent * factor, other * other_factor)))


def _exponentials(work: Any, count: int) -> None:
    for i in range(count):
        work[3 * BLOCK + i] = exponential(work[3 * BLOCK + i])
        work[5 * BLOCK + i] = exponential(work[5 * BLOCK + i])


@entry
def states_of_one(column: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    work = room(WORK * BLOCK)
    for low in range(0, times.size, BLOCK):
        high = min(low + BLOCK, times.size)
        if column[0] != 0.0:
            _full_of_one(column, times[low:high], rests[low:high], work)
        else:
            _complementary_of_one(column, times[low:high], rests[low:high], work)
        for i in range(high - low):
            for k in range(4):
                attitude[low + i, k] = work[k * BLOCK + i]
            for k in range(3):
                momentum[low + i, k] = work[(4 + k) * BLOCK + i]


# ---------------------------------------------------------------------- many, their numbers in rows of BLOCK


@called
def _full_of_many(m: Any, count: int, high: Any, low: Any, rest: Any, work: Any) -> None:
    for i in range(count):
        put_record(work, SUMS + i, full_sums(motion_at(m, i), (high[i], low[i], rest[i])))


@called
def _complementary_of_many(m: Any, count: int, high: Any, low: Any, rest: Any, work: Any) -> None:
    for i in range(count):
        put_record(work, i, complementary_phase(motion_at(m, i), (high[i], low[i], rest[i])))
    _exponentials(work, count)
    for i in range(count):
        a, b, c, exponent, factor, other, other_factor = record(work, i, PHASE)
        sums = complementary_sums(motion_at(m, i), a, b, c, exponent * factor, other * other_factor)
        put_record(work, SUMS + i, sums)


@called
def sums_of_many(m: Any, full: int, count: int, high: Any, low: Any, rest: Any, work: Any) -> None:
    """Put the sums of a block into the rows of ``work`` from SUMS on.

    Args:
        m: numbers of the motions in rows of BLOCK; the first motions take the full form.
        full: how many these are.
        count: of all.
        high, low, rest: times in halves, and what these leave of them.
        work: rows of BLOCK.
    """
    _full_of_many(m, full, high, low, rest, work)
    # loops from zero, or LLVM would not trust their indices
    _complementary_of_many(m[full:], count - full, high[full:], low[full:], rest[full:], work[full:])


@called
def _states_of_many(m: Any, count: int, work: Any) -> None:
    for i in range(count):
        put_record(work, i, state_of(motion_at(m, i), sums_at(work, SUMS + i)))


@entry
def states_of_many(columns: Any, bodies: Any, times: Any, rests: Any, attitude: Any, momentum: Any) -> None:
    m, work = room(len(columns) * BLOCK), room(WORK * BLOCK)
    high, low, rest, place = room(BLOCK), room(BLOCK), room(BLOCK), places(BLOCK)
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
            high[i], low[i] = halves(times[place[i]])
            rest[i] = rests[place[i]]
        for k in range(1, len(columns)):
            for i in range(count):
                m[k * BLOCK + i] = columns[k, bodies[place[i]]]
        sums_of_many(m, front, count, high, low, rest, work)
        _states_of_many(m, count, work)
        for i in range(count):
            for k in range(4):
                attitude[place[i], k] = work[k * BLOCK + i]
            for k in range(3):
                momentum[place[i], k] = work[(4 + k) * BLOCK + i]

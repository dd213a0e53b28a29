"""The set-up of many bodies, from moments to the columns of ``formulas.Motion``, compiled by Numba.

The steps of ``formulas_setup`` in blocks of bodies and in loops that LLVM turns into vector instructions: none has a
branch or calls a function of the C library, but those that do nothing else. Bodies are sorted on the way: those that
take the full form first, then those that take the complementary one. Those without a period (at rest, spherical,
permanent rotation, on the separatrix), and those with numbers farther apart than ``RANGE`` and ``SPREAD``, are left to
NumPy: they need what only few need.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called, entry
from polhode.exact._formulas import mean_start
from polhode.exact._kernel_agm import AA, STEPS, third_kind
from polhode.exact._kernel_arithmetic import (
    BLOCK,
    Pair,
    cleared,
    flags,
    pair,
    places,
    put,
    put_record,
    record,
    room,
    scale,
    times_power,
)
from polhode.exact._kernel_loops import SUMS, WORK, sums_of_many
from polhode.exact._kernel_records import load, rows_of
from polhode.exact.free_body._formulas import COLUMNS, FIRST, START, TO_ATTITUDE, Motion, sums_at
from polhode.exact.free_body._formulas_rates import (
    Frequencies,
    Start,
    frequencies,
    frequencies_of,
    phase_rates,
    start_of,
)
from polhode.exact.free_body._formulas_reduction import (
    Reduction,
    Scaled,
    Sums,
    Three,
    exact_distance,
    plain_distance,
    reduced,
    reduction,
    scaled,
    sums_of,
    terms_of_distance,
)
from polhode.exact.free_body._formulas_setup import (
    Amplitude,
    Angles,
    Four,
    Given,
    amplitude,
    angles,
    complementary_arguments,
    full_amplitude,
    full_arguments,
    full_start,
    is_full,
    matrices,
    motion_of,
)

WORTH = 8_000  # bodies for which a thread is worth its start and its memory
RANGE = 1e-120, 1e120  # of the largest moment and component of momentum
SPREAD = 2.0**-60  # of the moments, and of the components of momentum that are not zero: nothing underflows
# rows of what stores keep of a block of bodies, in the order given, and then sorted by the form that they take
BODY, SCALED, SUMMED, DISTANCE, NEAR, ALL = rows_of(Reduction, Scaled, Sums, Pair, tuple[float])
KEPT = SCALED // BLOCK
_, BEGUN, MEAN, TOTAL, EXPONENT, RATES, AT, ANGLES, ATTITUDE, ROWS = rows_of(
    Reduction, Start, Pair, Pair, tuple[float], Frequencies, Amplitude, Angles, Four
)


# ---------------------------------------------------------------------- which bodies the kernels take, and one of them


def is_within(moments: Three, momentum: Three) -> bool:
    """Return whether no number of a body is too large, too small, or too far from the others."""
    a, b, c = moments
    x, y, z = abs(momentum[0]), abs(momentum[1]), abs(momentum[2])
    largest, size = max(max(a, b), c), max(max(x, y), z)
    lowest = SPREAD * size
    near = (x == 0.0 or x >= lowest) and (y == 0.0 or y >= lowest) and (z == 0.0 or z >= lowest)
    within = RANGE[0] < largest < RANGE[1] and RANGE[0] < size < RANGE[1]
    return within and near and min(min(a, b), c) >= SPREAD * largest


def has_period(body: Reduction) -> bool:
    x, _, z = body.canonical
    return body.B[0] * body.Q[0] > 0.0 and body.P[0] > 0.0 and body.S[0] != 0.0 and (x != 0.0 or z != 0.0)


def set_up_one(moments: Three, momentum: Three, attitude: Four) -> Motion | None:
    """Return the constants of motion of one body, or None for one that is left to NumPy."""
    if not is_within(moments, momentum):
        return None
    body = reduction(moments, momentum)
    if not has_period(body):
        return None
    return motion_of(Given(moments, momentum, attitude, body, frequencies(body)))


# ---------------------------------------------------------------------- blocks of bodies


@called
def _load(moments: Any, momentum: Any, w: Any, within: Any) -> None:
    for i in range(len(moments)):
        of_moments = moments[i, 0], moments[i, 1], moments[i, 2]
        of_momentum = momentum[i, 0], momentum[i, 1], momentum[i, 2]
        within[i] = is_within(of_moments, of_momentum)
        put_record(w, SCALED + i, scaled(of_moments, of_momentum))


@called
def _sum(w: Any, count: int) -> None:
    """Form the invariants, S in double-double."""
    for i in range(count):
        body = load(w, SCALED + i, Scaled)
        sums = sums_of(body)
        _, x, z = terms_of_distance(body)
        distance, near = plain_distance(sums.A, sums.B, x, z)
        put_record(w, SUMMED + i, sums)
        put(w, DISTANCE + i, distance)
        w[NEAR + i] = 1.0 if near else 0.0


@called
def _sum_exactly(w: Any, i: int) -> None:
    moments, x, z = terms_of_distance(load(w, SCALED + i, Scaled))
    put(w, DISTANCE + i, exact_distance(moments, x, z))


@called
def _reduce(w: Any, count: int) -> None:
    for i in range(count):
        body, sums = load(w, SCALED + i, Scaled), load(w, SUMMED + i, Sums)
        put_record(w, BODY + i, reduced(body, sums, pair(w, DISTANCE + i)))


@called
def _begin(moments: Any, momentum: Any, begun: Any, w: Any, place: Any) -> tuple[int, int]:
    """Reduce a block and sort it; return how many bodies take the full form, and how many any. ``place`` has them."""
    count = len(moments)
    within = flags(count)
    _load(moments, momentum, begun, within)
    _sum(begun, count)
    for i in range(count):
        if begun[NEAR + i] != 0.0:
            _sum_exactly(begun, i)
    _reduce(begun, count)
    full, back = 0, count
    for i in range(count):
        body = load(begun, BODY + i, Reduction)
        if not (within[i] and has_period(body)):
            continue
        if is_full(body):
            place[full] = i
            full += 1
        else:
            back -= 1
            place[back] = i
    for i in range(back, count):
        place[full + i - back] = place[i]
    good = full + count - back
    for k in range(KEPT):
        for i in range(good):
            w[k * BLOCK + i] = begun[k * BLOCK + place[i]]
    return full, good


@called
def _start_mean(w: Any, count: int, steps: Any) -> None:
    for i in range(count):
        start, fast, slow, pp = start_of(load(w, BODY + i, Reduction))
        state, w[EXPONENT + i] = mean_start(fast, slow, pp)
        put_record(w, BEGUN + i, start)
        put_record(steps, AA + i, state)


@called
def _put_rates(w: Any, full: int, count: int, m: Any) -> None:
    for i in range(count):
        body, start = load(w, BODY + i, Reduction), load(w, BEGUN + i, Start)
        mean = scale(pair(w, MEAN + i), times_power(1.0, w[EXPONENT + i]))
        rates = frequencies_of(body, start, mean, pair(w, TOTAL + i))
        put_record(w, RATES + i, rates)
        put_record(m, FIRST + i, phase_rates(i < full, body, rates))


@called
def _full_arguments(w: Any, full: int, m: Any) -> None:
    for i in range(full):
        at = full_amplitude(load(w, BODY + i, Reduction))
        put_record(w, AT + i, (at.rise, at.run))
        put_record(m, START + i, full_arguments(0.0, at.series))
    for i in range(full):
        m[START + i] = full_start(w[AT + i], w[AT + BLOCK + i])


@called
def _complementary_arguments(w: Any, count: int, m: Any) -> None:
    for i in range(count):
        put_record(w, AT + i, amplitude(load(w, BODY + i, Reduction), load(w, RATES + i, Frequencies)))
    for i in range(count):
        put_record(w, ANGLES + i, angles(load(w, AT + i, Amplitude)))
    for i in range(count):
        body, rates = load(w, BODY + i, Reduction), load(w, RATES + i, Frequencies)
        at, angle = load(w, AT + i, Amplitude), load(w, ANGLES + i, Angles)
        put_record(m, START + i, complementary_arguments(body, rates, at, angle))


@called
def _matrices(w: Any, count: int, m: Any, spinor: Any) -> None:
    for i in range(count):
        body, rates = load(w, BODY + i, Reduction), load(w, RATES + i, Frequencies)
        attitude = record(w, ATTITUDE + i, 4)
        put_record(m, TO_ATTITUDE + i, matrices(body, rates.G[0], attitude, sums_at(spinor, SUMS + i)))


@entry
def set_up(moments: Any, momentum: Any, attitude: Any, columns: Any, left: Any, first: int) -> None:
    begun, w, m = room(ALL), room(ROWS), cleared(COLUMNS * BLOCK)
    steps, work, zeros = room(STEPS * BLOCK), room(WORK * BLOCK), cleared(BLOCK)
    place, who = places(BLOCK), places(BLOCK)
    for low in range(0, len(moments), BLOCK):
        part = slice(low, low + BLOCK)
        full, count = _begin(moments[part], momentum[part], begun, w, place)
        for i in range(count):
            start = attitude[low + place[i]]
            put_record(w, ATTITUDE + i, (start[0], start[1], start[2], start[3]))
        _start_mean(w, count, steps)
        third_kind(w, MEAN, TOTAL, count, steps, who)
        _put_rates(w, full, count, m)
        _full_arguments(w, full, m)
        _complementary_arguments(w[full:], count - full, m[full:])
        sums_of_many(m, full, count, zeros, zeros, zeros, work)
        _matrices(w, count, m, work)
        for i in range(count):
            columns[0][first + low + place[i]] = 1.0 if i < full else 0.0
            left[low + place[i]] = False
        for k in range(1, COLUMNS):
            column = columns[k]
            for i in range(count):
                column[first + low + place[i]] = m[k * BLOCK + i]

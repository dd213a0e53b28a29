"""The kernel: copies side by side, their steps, samples and events, and the projection onto conserved quantities.

It runs any program, so that it is compiled once for an installation; ``kernels`` says by whom. A copy takes the same
steps to the same bits, whatever lane it is in and whatever moves beside it.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import entry
from polhode.taylor.kernel_companions import advance_companions, keep_companions, seat_companions
from polhode.taylor.kernel_invariants import back_onto, compute_outputs, output
from polhode.taylor.kernel_series import (
    advance_lanes,
    bound_change,
    combination,
    fit_series,
    nodes,
    power_of_two,
    sample_copy,
    size_of_terms,
)
from polhode.taylor.kernel_space import (
    EVENT,
    HITS,
    LATEST,
    NEXT,
    NOBODY,
    STEPS,
    TIME,
    UNIT,
    Copies,
    Course,
    Lanes,
    Series,
)
from polhode.taylor.kernel_zeros import ROUNDING, find_reach, first_zero
from polhode.taylor.program import CONSTANT, FIRST, SIZE, SLOTS
from polhode.taylor.vectors import LANES, borrow, vectors
from polhode.types import Array

RUNNING, DONE, STOPPED, FULL, FAILED = range(5)  # status of a copy
MIN_RELATIVE_STEP = 4e-16  # of the present time: shorter steps do not advance


@entry
def advance(rates: Series, integrals: Series, copies: Copies, lanes: Lanes, course: Course, limit: Any) -> None:
    """Go on with the copies that run, for at most so many steps side by side.

    Args:
        rates: of the state, then what is watched.
        integrals: what is conserved, then its gradients.
        copies, lanes, course: see there.
        limit: of the steps.
    """
    rates, integrals, copies, lanes = in_lanes(rates), in_lanes(integrals), borrow(copies), borrow(lanes)
    course = borrow(course)
    z, states, status, which = rates.z, vectors(lanes.states), copies.status, lanes.which
    order, watched, following = course.order, lanes.p.shape[0], 0
    for lane in range(LANES):
        which[lane] = NOBODY
    for _ in range(limit):
        following, taken = seat_copies(copies, lanes, course, following)
        if taken == 0:
            return
        for i in range(rates.whole[SIZE]):
            z[i] = states[i]
        fit_series(rates, lanes, course)
        if watched:
            nodes(rates, order)
            expand_watched(rates, lanes, order, course.forth)
        for lane in range(LANES):
            lanes.steps[lane] = 0.0
            if which[lane] != NOBODY:
                status[which[lane]] = plan_step(rates, copies, lanes, course, lane)
        evaluate_steps(rates, copies, lanes, course)
        if course.clock >= 0:
            for lane in range(LANES):
                lanes.states[course.clock * LANES + lane] = lanes.later[lane]
        if copies.wanted.shape[1]:
            back_onto(integrals, lanes, copies.wanted.shape[1])
        if course.companions:
            advance_companions(rates, integrals, copies, lanes, course)
        for lane in range(LANES):
            k = which[lane]
            if k != NOBODY and status[k] == RUNNING:
                status[k] = finish_step(copies, lanes, course, lane)
            if k != NOBODY and status[k] != RUNNING:
                keep_companions(copies, lanes, k, lane)
                which[lane] = NOBODY
    for lane in range(LANES):
        if which[lane] != NOBODY:
            keep_companions(copies, lanes, which[lane], lane)


def in_lanes(series: Series) -> Series:
    """Return a series as a kernel computes with it."""
    own = borrow(series)
    return Series(own.whole, own.number, own.flat, vectors(own.flat), own.a, own.b, own.code, own.begins, own.bounded)


def seat_copies(copies: Copies, lanes: Lanes, course: Course, following: Any) -> tuple[Any, Any]:
    """Give free lanes to copies that wait, and return which copy is the next one, and how many lanes are taken."""
    taken, count = 0, copies.y.shape[0]
    for lane in range(LANES):
        if lanes.which[lane] == NOBODY:
            while following < count and copies.status[following] != RUNNING:
                following += 1
            if following == count:
                continue
            k = following
            lanes.which[lane], following = k, k + 1
            for i in range(copies.y.shape[1]):
                lanes.states[i * LANES + lane], lanes.scales[i * LANES + lane] = copies.y[k, i], copies.scale[k, i]
            for i in range(copies.low.shape[1]):
                lanes.low[i * LANES + lane] = copies.low[k, i]
            for c in range(copies.wanted.shape[1]):
                lanes.wanted[c * LANES + lane], lanes.slack[c * LANES + lane] = copies.wanted[k, c], copies.slack[k, c]
            seat_companions(copies, lanes, k, lane)
            lanes.units[lane], lanes.left[lane] = copies.now[k, UNIT], abs(course.end - copies.now[k, TIME])
        taken += 1
    return following, taken


def expand_watched(rates: Series, lanes: Lanes, order: Any, forth: Any) -> None:
    """Set the Taylor coefficients of watched functions, in units of time."""
    whole, watched, terms = rates.whole, vectors(lanes.watched), vectors(lanes.terms)
    n, width = whole[SIZE], whole[SLOTS]
    for w in range(lanes.p.shape[0]):
        row, start, to_t = whole[FIRST] + n + w, w * (order + 1), 1.0
        for k in range(order + 1):
            watched[start + k] = combination(rates, k * width, row) * to_t
            to_t *= forth
        watched[start] = watched[start] + rates.number[whole[CONSTANT] + n + w]
        terms[w] = ROUNDING * (size_of_terms(rates, row) + abs(rates.number[whole[CONSTANT] + n + w]))


def plan_step(rates: Series, copies: Copies, lanes: Lanes, course: Course, lane: Any) -> Any:
    """Set the length of a copy's step, and return its status."""
    k, unit, p, order = lanes.which[lane], lanes.units[lane], lanes.p, course.order
    for w in range(p.shape[0]):
        for j in range(order + 1):
            p[w, j] = lanes.watched[(w * (order + 1) + j) * LANES + lane]
    t, left = copies.now[k, TIME], lanes.left[lane]
    h = min(lanes.lengths[lane] * unit, course.longest)
    for b in range(1, 2 * rates.bounded[0], 2):
        ahead = min(h, left)
        reached = unit * bound_change(rates, order, lane, rates.bounded[b], rates.bounded[b + 1], ahead / unit)
        if reached < ahead:
            h = reached
    for w in range(p.shape[0]):  # which may shorten the step
        ahead = min(h, left)
        reached = unit * find_reach(p[w], order, ahead / unit, course.reach)
        if reached < ahead:
            h = reached
    if not h > MIN_RELATIVE_STEP * abs(t) or not h > 0.0:
        return FAILED
    copies.now[k, UNIT] = power_of_two(min(h, left))
    last = h >= left * (1.0 - 1e-12)
    later = course.end if last else t + course.forth * h
    event, h = event_in(copies, lanes, course, lane, later - t)
    if event >= 0:
        if copies.counts[k, HITS] == copies.hits.shape[1]:
            return FULL
        later, last = t + h, False
        h = later - t  # the state is that of the time which is kept
    lanes.later[lane], lanes.event[lane], lanes.last[lane], lanes.steps[lane] = later, event, last, h / unit
    return RUNNING


def evaluate_steps(rates: Series, copies: Copies, lanes: Lanes, course: Course) -> None:
    """Set the samples within the steps that are planned, and the lanes' states to those after them."""
    for lane in range(LANES):
        k = lanes.which[lane]
        if k != NOBODY and copies.status[k] == RUNNING:
            first, following = take_samples(copies, lanes, course, lane)
            sample_copy(rates, course, lane, copies.now[k, TIME], lanes.units[lane], k, first, following, copies.out)
    advance_lanes(rates, lanes, course.order)


def take_samples(copies: Copies, lanes: Lanes, course: Course, lane: Any) -> tuple[Any, Any]:
    """Return the first sample within a copy's step and the next one behind it, which is recorded."""
    k, later, event = lanes.which[lane], lanes.later[lane], lanes.event[lane]
    first = following = copies.counts[k, NEXT]
    # a sample at the end of a step has its state, put back onto what is conserved
    while following < course.samples and (
        course.forth * course.times[following] < course.forth * later
        or (event >= 0 and course.times[following] == later)
    ):
        following += 1
    copies.counts[k, NEXT] = following
    return first, following


def event_in(copies: Copies, lanes: Lanes, course: Course, lane: Any, h: Any) -> tuple[Any, Any]:
    """Return the watched function that is the first to change its sign within h, or −1, and the time of that."""
    k, unit, order, p = lanes.which[lane], lanes.units[lane], course.order, lanes.p
    t, event, first, length = copies.now[k, TIME], -1, h, abs(h)
    # an event so near to the step's beginning, of its length, is the last one: at most eight times as far as the value
    # there tells, and a millionth of the step
    close, times_missed, farthest = 1e-14, 8.0, 1e-6
    for w in range(p.shape[0]):
        others, power = 0.0, length / unit
        for j in range(1, order + 1):
            others += abs(p[w, j]) * power
            power *= length / unit
        if abs(p[w, 0]) > others or others <= lanes.terms[w * LANES + lane]:  # one that stays at zero changes no sign
            continue
        low, least = 0.0, MIN_RELATIVE_STEP * abs(t)
        if copies.counts[k, EVENT] == w and abs(copies.now[k, LATEST] - t) <= close * length + least:
            low = close * length + 4.0 * MIN_RELATIVE_STEP * abs(t)
            if p[w, 1] != 0.0:  # the value left there shows by how much the zero was missed
                low = max(low, min(times_missed * unit * abs(p[w, 0] / p[w, 1]), farthest * length))
            low = min(low, length)
        zero = course.forth * unit * first_zero(
            p[w], order, low / unit, length / unit, course.falling[w], lanes.work, lanes.waiting
        )
        if abs(zero) <= abs(first):
            event, first = w, zero
    return event, first


def finish_step(copies: Copies, lanes: Lanes, course: Course, lane: Any) -> Any:
    """Advance a copy's records to the end of a step, and return its status."""
    k, later, event = lanes.which[lane], lanes.later[lane], lanes.event[lane]
    n, following = copies.y.shape[1], copies.counts[k, NEXT]
    for i in range(n):
        copies.y[k, i] = lanes.states[i * LANES + lane]
    for i in range(copies.low.shape[1]):
        copies.low[k, i] = lanes.low[i * LANES + lane]
    while following < course.samples and course.times[following] == later:
        for i in range(n):
            copies.out[k, following, i] = copies.y[k, i]
        following += 1
    copies.counts[k, NEXT] = following
    copies.counts[k, STEPS] += 1
    copies.now[k, TIME] = later
    lanes.units[lane], lanes.left[lane] = copies.now[k, UNIT], abs(course.end - later)
    if event >= 0:
        hit = copies.counts[k, HITS]
        copies.hits[k, hit, 0], copies.hits[k, hit, 1] = later, event
        for i in range(n):
            copies.hits[k, hit, 2 + i] = copies.y[k, i]
        copies.counts[k, HITS] = hit + 1
        copies.counts[k, EVENT], copies.now[k, LATEST] = event, later
        if course.stops[event]:
            return STOPPED
    return DONE if lanes.last[lane] else RUNNING


@entry
def conserved_values(integrals: Series, y: Array, states: Array, values: Array) -> None:
    """Set values (C, K) of what is conserved at states (C, n), with room for those of all lanes."""
    series = in_lanes(integrals)
    n, state = series.whole[SIZE], vectors(states)
    for first in range(0, y.shape[0], LANES):
        there = min(LANES, y.shape[0] - first)
        for lane in range(there):
            for i in range(n):
                states[i * LANES + lane] = y[first + lane, i]
        compute_outputs(series, state)
        for c in range(values.shape[1]):
            state[0] = output(series, c)
            for lane in range(there):
                values[first + lane, c] = states[lane]

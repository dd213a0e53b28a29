"""Moves companions of copies: runs from other starts or of other orders, through the same steps.

They show how far a motion is from the true one. As they take its steps, they are compared with it where these end, and
need neither samples nor a choice of steps: next to the motion itself, a companion costs its coefficients.

Runs by equal steps whose states differ by less than a rounding would be rounded alike, and hide what roundings do: of
motions past a saddle whose energy is a small difference of large numbers, 4 in 10 had a companion that coincided with
them. So a companion is moved by a last place, up or down, in each step.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode._base.compiled.copying import called
from polhode.taylor.kernel_invariants import back_onto
from polhode.taylor.kernel_series import MAX_COEFFICIENT, advance_lanes, coefficients
from polhode.taylor.kernel_space import MANY_KICKS, NOBODY, STEPS, Copies, Course, Lanes, Series
from polhode.taylor.program import SIZE
from polhode.taylor.vectors import LANES, spread, vectors, where_less


def advance_companions(rates: Series, integrals: Series, copies: Copies, lanes: Lanes, course: Course) -> None:
    """Move companions of all lanes by the steps that these have just taken, and note how far apart they are then."""
    conserved, kicks = copies.wanted.shape[1], vectors(lanes.kicks)
    n, z, y, wanted = rates.whole[SIZE], rates.z, vectors(lanes.states), vectors(lanes.wanted)
    own, sizes, gaps = vectors(lanes.own), vectors(lanes.sizes), vectors(lanes.gaps)
    others, theirs = vectors(lanes.others), vectors(lanes.others_wanted)
    for i in range(n):
        own[i] = y[i]
        sizes[i] = where_less(sizes[i], abs(y[i]), abs(y[i]), sizes[i])
    for c in range(conserved):
        own[n + c] = wanted[c]
    for j in range(course.companions):
        for i in range(n):
            z[i] = others[j * n + i]
        coefficients(rates, course.orders[j], lanes.units)
        advance_lanes(rates, lanes, course.orders[j])
        choose_kicks(copies, lanes, course, n, j)
        for i in range(n):
            size = where_less(abs(y[i]), abs(z[i]), abs(z[i]), abs(y[i]))  # of what is rounded on the way
            y[i] = y[i] + kicks[i] * size
        if course.clock >= 0:
            for lane in range(LANES):
                lanes.states[course.clock * LANES + lane] = lanes.later[lane]
        for c in range(conserved):
            wanted[c] = theirs[j * conserved + c]
        if conserved:
            back_onto(integrals, lanes, conserved)
        for i in range(n):
            gap, at = abs(y[i] - own[i]), j * n + i
            others[at] = y[i]
            # comparisons with NaN are false, so that a NaN stays
            larger = where_less(gaps[at], gap, gap, gaps[at])
            gaps[at] = where_less(gap, spread(MAX_COEFFICIENT), larger, spread(np.nan))
    for i in range(n):
        y[i] = own[i]
    for c in range(conserved):
        wanted[c] = own[n + c]


@called
def choose_kicks(copies: Copies, lanes: Lanes, course: Course, n: Any, j: Any) -> None:
    """Set shares by which a companion's numbers are moved, which follow from the copy's count of steps."""
    for lane in range(LANES):
        k = lanes.which[lane]
        steps = copies.counts[k, STEPS] if k != NOBODY else 0
        following = (steps * course.companions + j) * n % MANY_KICKS
        for i in range(n):
            lanes.kicks[i * LANES + lane] = course.kicks[following]
            following = following + 1 if following + 1 < MANY_KICKS else 0


def seat_companions(copies: Copies, lanes: Lanes, k: Any, lane: Any) -> None:
    """Give a lane the companions of its copy."""
    for j in range(copies.others.shape[1]):
        n, conserved = copies.others.shape[2], copies.others_wanted.shape[2]
        for i in range(n):
            at = (j * n + i) * LANES + lane
            lanes.others[at], lanes.gaps[at] = copies.others[k, j, i], copies.gaps[k, j, i]
            lanes.sizes[i * LANES + lane] = copies.sizes[k, i]
        for c in range(conserved):
            lanes.others_wanted[(j * conserved + c) * LANES + lane] = copies.others_wanted[k, j, c]


def keep_companions(copies: Copies, lanes: Lanes, k: Any, lane: Any) -> None:
    """Record what a lane's companions have come to."""
    for j in range(copies.others.shape[1]):
        n = copies.others.shape[2]
        for i in range(n):
            at = (j * n + i) * LANES + lane
            copies.others[k, j, i], copies.gaps[k, j, i] = lanes.others[at], lanes.gaps[at]
            copies.sizes[k, i] = lanes.sizes[i * LANES + lane]

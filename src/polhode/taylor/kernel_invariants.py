"""Projects a state onto its conserved quantities, by one Newton step after each step in time."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.taylor.kernel_series import combination, nodes
from polhode.taylor.kernel_space import NOBODY, Lanes, Series
from polhode.taylor.program import CONSTANT, FIRST, SIZE, SLOTS
from polhode.taylor.vectors import LANES, run_code, spread, square_root, vectors, where_less
from polhode.types import Array


def back_onto(integrals: Series, lanes: Lanes, count: Any) -> None:
    """Move states by one Newton step onto what is conserved: the outputs are the values, then their gradients.

    States that are off by less than the slack are left where they are. Gradients that nearly depend on those before
    them are left out, as at an equilibrium, where nothing is to be gained. What has an infinite scale is left too.
    """
    y, scale, wanted, rows = vectors(lanes.states), vectors(lanes.scales), vectors(lanes.wanted), vectors(lanes.rows)
    slack, due = vectors(lanes.slack), vectors(lanes.due)
    n, none, infinite = integrals.whole[SIZE], spread(0.0), spread(np.inf)
    independent = 0.01  # of a squared gradient, that must be left beside the other gradients
    farthest = 1e-3  # of the scale: a run that is off by more is not put back
    compute_outputs(integrals, y)
    due[0] = none
    for c in range(count):
        off = wanted[c] - output(integrals, c)
        rows[c * (n + 1) + n] = off
        due[0] = where_less(slack[c], abs(off), infinite, due[0])
    some = False
    for lane in range(LANES):
        some = some or (lanes.due[lane] > 0.0 and lanes.which[lane] != NOBODY)
    if not some:
        return
    for c in range(count):
        row = c * (n + 1)
        off, square = rows[row + n], spread(0.0)
        for i in range(n):
            # rows of the Jacobian in units of the scale; the shortest move δ with J δ = off is along orthonormal rows,
            # by Gram and Schmidt
            scaled = where_less(scale[i], infinite, output(integrals, count + c * n + i) * scale[i], none)
            rows[row + i] = scaled
            square = square + scaled * scaled
        # what the earlier ones move is taken out, of gradient and of what is missing
        for e in range(c):
            along, earlier = spread(0.0), e * (n + 1)
            for i in range(n):
                along = along + rows[row + i] * rows[earlier + i]
            for i in range(n):
                rows[row + i] = rows[row + i] - along * rows[earlier + i]
            off = off - along * rows[earlier + n]
        left = spread(0.0)
        for i in range(n):
            left = left + rows[row + i] * rows[row + i]
        length = square_root(left)
        small = where_less(abs(off), farthest * length, length, infinite)
        # zero where the gradient is left out
        inverse = 1.0 / where_less(independent * square, left, small, infinite)
        for i in range(n):
            rows[row + i] = where_less(none, inverse, rows[row + i] * inverse, none)
        rows[row + n] = where_less(none, inverse, off * inverse, none)
    for c in range(count):
        row = c * (n + 1)
        for i in range(n):
            moved = y[i] + rows[row + n] * rows[row + i] * scale[i]
            y[i] = where_less(none, due[0], where_less(scale[i], infinite, moved, y[i]), y[i])


def compute_outputs(integrals: Series, y: Array) -> None:
    """Compute what ``output`` gives, at states."""
    for i in range(integrals.whole[SIZE]):
        integrals.z[i] = y[i]
    if integrals.code != 0:
        run_code(integrals.code, integrals.flat, integrals.a, integrals.b, integrals.number, 0, integrals.flat)
    else:
        nodes(integrals, 0)


def output(integrals: Series, o: Any) -> Any:
    whole = integrals.whole
    if integrals.code != 0:
        return integrals.z[whole[SLOTS] + o]
    return combination(integrals, 0, whole[FIRST] + o) + integrals.number[whole[CONSTANT] + o]

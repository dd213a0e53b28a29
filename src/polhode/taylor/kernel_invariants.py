"""Projects a state onto its conserved quantities, by one Newton step after each step in time."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode.taylor.kernel_series import combination, nodes
from polhode.taylor.kernel_space import NOBODY, Lanes, Series
from polhode.taylor.program import CONSTANT, FIRST, SIZE, SLOTS
from polhode.taylor.vectors import LANES, run_code, spread, vectors, where_less
from polhode.types import Array

LARGEST_GRADIENT = 1e140  # by the scale: squares of larger ones overflow


def back_onto(integrals: Series, lanes: Lanes, count: Any) -> None:
    """Move states by one Newton step onto what is conserved: the outputs are the values, then their gradients.

    States that are off by less than the slack are left where they are. Gradients that nearly depend on those before
    them are left out, as at an equilibrium, where nothing is to be gained. What has an infinite scale is left too.
    """
    y, scale, wanted, rows = vectors(lanes.states), vectors(lanes.scales), vectors(lanes.wanted), vectors(lanes.rows)
    slack, due = vectors(lanes.slack), vectors(lanes.due)
    n, none, infinite = integrals.whole[SIZE], spread(0.0), spread(np.inf)
    compute_outputs(integrals, y)
    some_due = none
    width = n + 1 + count  # of a row: a gradient, what is missing, and the row of a matrix
    for c in range(count):
        off = wanted[c] - output(integrals, c)
        rows[c * width + n] = off
        some_due = where_less(slack[c], abs(off), infinite, some_due)
    due[0], some = some_due, False
    for lane in range(LANES):
        some = some or (lanes.due[lane] > 0.0 and lanes.which[lane] != NOBODY)
    if not some:
        return
    for c in range(count):
        size, row = none, c * width
        for i in range(n):
            # in units of the scale
            scaled = output(integrals, count + c * n + i) * scale[i]
            scaled = where_less(scale[i], infinite, scaled, none)
            size = size + abs(scaled)
            rows[row + i] = where_less(abs(scaled), spread(LARGEST_GRADIENT), scaled, none)
        eliminate(rows, n, c, count, size)
    # the shortest move δ with J δ = off is Jᵀλ, (J Jᵀ) λ = off
    for c in range(count - 1, -1, -1):
        row = c * width
        factor = rows[row + n]
        for d in range(c + 1, count):
            factor = factor - rows[d * width + n] * rows[d * width + n + 1 + c]
        rows[row + n] = factor * rows[row + n + 1 + c]
    unmoved = spread(-0.0)  # which leaves all numbers as they are, and a sum is stored sooner than a choice
    for i in range(n):
        move = none
        for c in range(count):
            move = move + rows[c * width + n] * rows[c * width + i]
        move = where_less(scale[i], infinite, move * scale[i], unmoved)
        y[i] = y[i] + where_less(none, some_due, move, unmoved)


def eliminate(rows: Array, n: Any, c: Any, count: Any, size: Any) -> None:
    """Set the c-th row of the factors of a Jacobian times its transpose, and what is missing beside earlier rows.

    These are L D Lᵀ; a row has those of L D, then 1/D, which is zero where its gradient, of some size, is left out.
    """
    independent = 0.01  # of a squared gradient, that must be left beside the other gradients
    least = 1e-290  # that must be left, so that one over it is a number
    farthest = 1e-3  # of the scale: a run that is off by more is not put back
    none, infinite, width = spread(0.0), spread(np.inf), n + 1 + count
    row = c * width
    off, square = rows[row + n], none
    for e in range(c + 1):
        earlier = e * width
        product = none
        for i in range(n):
            product = product + rows[row + i] * rows[earlier + i]
        square = product
        for f in range(e):
            product = product - rows[row + n + 1 + f] * rows[f * width + n + 1 + f] * rows[earlier + n + 1 + f]
        if e < c:
            off = off - product * rows[earlier + n + 1 + e] * rows[earlier + n]
        rows[row + n + 1 + e] = product
    left = rows[row + n + 1 + c]
    near = where_less(off * off, farthest * farthest * left, left, infinite)
    near = where_less(size, spread(LARGEST_GRADIENT), near, infinite)
    inverse = 1.0 / where_less(independent * square + least, left, near, infinite)
    rows[row + n] = where_less(none, inverse, off, none)
    rows[row + n + 1 + c] = inverse


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

"""The turning points of a block of tops, compiled by Numba: the steps of ``formulas_roots``."""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import pair, put, put_record
from polhode.exact._kernel_records import load
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas_reduction import Reduction
from polhode.exact.lagrange_top._formulas_roots import apart, begun, is_found, nearer, turning_points_of
from polhode.exact.lagrange_top._kernel_reduction import is_left


@called
def _apart(w: Any, count: int) -> None:
    """Put the root that stands apart into ROOT, after as many steps as all tops take; UP says which it is."""
    for i in range(count):
        top = load(w, at.TOP + i, Reduction)
        lone = apart(top)
        root = nearer(nearer(begun(lone)))
        good = is_found(root) & (not is_left(top))
        w[at.UP + i] = (1.0 if lone.upper else 0.0) if good else -1.0
        put(w, at.ROOT + i, root[0])
        put(w, at.SLOPE + i, lone.f1)


@called
def _points(w: Any, count: int) -> None:
    """Put the turning points into the store."""
    for i in range(count):
        top = load(w, at.TOP + i, Reduction)
        points = turning_points_of(top, w[at.UP + i] > 0.0, pair(w, at.ROOT + i), pair(w, at.SLOPE + i))
        put_record(w, at.POINTS + i, points)


@called
def turning_points(w: Any, count: int) -> None:
    """Put the turning points into the store; where UP is below zero the tops are left to NumPy."""
    _apart(w, count)
    _points(w, count)

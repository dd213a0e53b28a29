"""The reduction of a block of tops, compiled by Numba, and which of them the kernels take.

Tops without weight and those with numbers farther apart than ``RANGE`` and ``SPREAD`` are left to NumPy: none that the
kernels take has a displacement to be scaled up. They sum exactly only what cancels too much.
"""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_arithmetic import put_record
from polhode.exact._kernel_records import load
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas_reduction import (
    Reduction,
    Scaled,
    Three,
    exactly_reduced,
    plainly_reduced,
    scaled,
    size_of,
)

RANGE = 1e-100, 1e100  # of the first moment, of mgl and of the largest component of momentum
SPREAD = 2.0**-60  # of moments, weight, and components of momentum and attitude that are not zero: nothing underflows
TINY = 2.0**-150  # below it, what is left after cancelling is NumPy's


def is_within(moments: Three, mgl: float, momentum: Three) -> bool:
    """Return whether no number of a top is too large or too small, and the moments are near each other."""
    a, c, weight = moments[0], moments[2], abs(mgl)
    largest = max(max(abs(momentum[0]), abs(momentum[1])), abs(momentum[2]))
    within = RANGE[0] < a < RANGE[1] and RANGE[0] < weight < RANGE[1] and (largest == 0.0 or RANGE[0] < largest)
    return within and largest < RANGE[1] and SPREAD * a < c and SPREAD * c < a


def _apart(x: float) -> bool:
    return x == 0.0 or abs(x) >= SPREAD


def is_near(top: Scaled) -> bool:
    """Return whether weight and components of a scaled top are near enough together."""
    x, y, z = top.momentum
    q0, q1, q2, q3 = top.quaternion
    near = _apart(x) and _apart(y) and _apart(z) and top.G[0] >= 2.0 * SPREAD * top.moments[0]
    return near and _apart(q0) and _apart(q1) and _apart(q2) and _apart(q3)


def _is_left(x: float) -> bool:
    return not (x == 0.0 or abs(x) > TINY)


def is_left(top: Reduction) -> bool:
    """Return whether too little is left after cancelling."""
    left = _is_left(top.p[0]) | _is_left(top.c[0]) | _is_left(top.c_plus[0])
    return left | _is_left(top.twist[0]) | _is_left(top.F[0]) | _is_left(top.D[0])


@called
def _load(moments: Any, mgl: Any, momentum: Any, attitude: Any, w: Any, place: Any) -> int:
    """Scale the tops of a block that the kernels may take; return how many these are. ``place`` has them."""
    count = 0
    for i in range(len(moments)):
        of_moments = moments[i][0], moments[i][1], moments[i][2]
        of_momentum = momentum[i][0], momentum[i][1], momentum[i][2]
        if is_within(of_moments, mgl[i][0], of_momentum):
            q = attitude[i]
            top = scaled(of_moments, mgl[i][0], of_momentum, (q[0], q[1], q[2], q[3]))
            put_record(w, at.SCALED + count, top)
            if is_near(top):
                place[count] = i
                count += 1
    return count


@called
def _reduce(w: Any, count: int) -> None:
    """Form the invariants in double-double; SPARE is below zero if too much cancels."""
    for i in range(count):
        top, w[at.SPARE + i] = plainly_reduced(load(w, at.SCALED + i, Scaled))
        put_record(w, at.TOP + i, top)


@called
def _reduce_exactly(w: Any, i: int) -> None:
    top = load(w, at.SCALED + i, Scaled)
    put_record(w, at.TOP + i, exactly_reduced(top, size_of(top)))


@called
def begin(moments: Any, mgl: Any, momentum: Any, attitude: Any, w: Any, place: Any) -> int:
    """Reduce a block; return how many of its tops the kernels may take. ``place`` has them."""
    count = _load(moments, mgl, momentum, attitude, w, place)
    _reduce(w, count)
    for i in range(count):
        if w[at.SPARE + i] < 0.0:
            _reduce_exactly(w, i)
    return count

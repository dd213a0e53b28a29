"""The steps of ``frequencies`` for a block of bodies, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_agm import start_mean, third_kind
from polhode.exact._kernel_arithmetic import (
    choice,
    halves,
    multiply_float,
    pair,
    put,
    put_record,
    root,
    two_product,
    where,
)
from polhode.exact.free_body import _kernel_store as at
from polhode.exact.free_body._formulas import FIRST
from polhode.exact.free_body._formulas_setup import phase_rates, precession_rate, starts_of_mean


@called
def _begin(w: Any, count: int, s: Any) -> None:
    """Mirror, turn, and begin the arithmetic–geometric mean, ``frequencies.canonical_frequencies``."""
    for i in range(count):
        S0, rest = pair(w, at.S + i)
        long_axis = S0 > 0.0
        sign = -1.0 if long_axis else 1.0
        a, b, c = pair(w, at.A + i), pair(w, at.B + i), pair(w, at.C + i)
        p, q, gg = pair(w, at.P + i), pair(w, at.Q + i), pair(w, at.GG + i)
        a, b = choice(long_axis, b, a), choice(long_axis, a, b)
        p, q = choice(long_axis, q, p), choice(long_axis, p, q)
        x1, x3 = w[at.L1 + i], w[at.L3 + i]
        x1, x3 = where(long_axis, x3, x1), where(long_axis, x1, x3)
        half_turn = -1.0 if x3 < 0.0 else 1.0
        fast, slow, start = starts_of_mean(a, b, c, q, gg, root((-sign * S0, -sign * rest)))
        start_mean(s, i, fast, slow, start)
        w[at.A + i], w[at.B + i], w[at.P + i], w[at.Q + i], w[at.S + i] = a[0], b[0], p[0], q[0], abs(S0)
        put(w, at.LEAD + i, choice(b[0] >= a[0], a, p))
        w[at.X1 + i], w[at.X3 + i], w[at.LONG + i], w[at.HALF + i] = x1 * half_turn, x3 * half_turn, sign, half_turn
        put(w, at.G + i, root(gg))
        put(w, at.FAST + i, fast)
        put(w, at.V + i, multiply_float(two_product(w[at.I1 + i], w[at.I2 + i]), w[at.I3 + i]))


@called
def _put_rates(w: Any, full: int, count: int, m: Any) -> None:
    """Put the two rates [turns per time] into rows 1 to 6 of the motion."""
    for i in range(count):
        moments, mean = (w[at.I1 + i], w[at.I2 + i], w[at.I3 + i]), pair(w, at.MEAN + i)
        precession = precession_rate(
            w[at.LONG + i] < 0.0, w[at.B + i] >= w[at.A + i], moments, pair(w, at.LEAD + i), pair(w, at.SUM + i),
            pair(w, at.GG + i), pair(w, at.G + i), mean,
        )
        first, second = phase_rates(i < full, precession, mean, pair(w, at.V + i), w[at.RATE + i])
        put_record(m, FIRST + i, (*halves(first[0]), first[1], *halves(second[0]), second[1]))


@called
def rates(w: Any, full: int, count: int, steps: Any, who: Any, m: Any) -> None:
    """Mirror the bodies, and put their rates into the motion.

    Args:
        w: store of bodies.
        full: how many take the full form; they come first.
        count: of all bodies.
        steps, who: room for the mean.
        m: columns of the motion in rows of BLOCK.
    """
    _begin(w, count, steps)
    third_kind(w, at.MEAN, at.SUM, count, steps, who)
    _put_rates(w, full, count, m)

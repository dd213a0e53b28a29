"""The steps of ``frequencies`` for a block of tops, compiled by Numba."""

from __future__ import annotations

from typing import Any

from polhode._base.compiled.copying import called
from polhode.exact._kernel_agm import start_mean, third_kind
from polhode.exact._kernel_arithmetic import (
    add,
    halves,
    multiply,
    pair,
    put,
    put_record,
    root,
    scale,
    subtract,
)
from polhode.exact.lagrange_top import _kernel_store as at
from polhode.exact.lagrange_top._formulas import FIRST
from polhode.exact.lagrange_top._formulas_setup import drift, spin, start_of_alpha, start_of_beta, turns_per_time


def _first_alpha(w: Any, i: int) -> bool:
    return w[at.Z_PLUS + i] <= 2.0 * w[at.A + i]


def _first_beta(w: Any, i: int) -> bool:
    return multiply(pair(w, at.G + i), pair(w, at.S2 + i))[0] <= w[at.Z_MINUS + i]


@called
def _begin_alpha(w: Any, count: int, s: Any) -> None:
    for i in range(count):
        a = pair(w, at.A + i)
        root_a = root(a)
        start = start_of_alpha(_first_alpha(w, i), a, pair(w, at.Z_PLUS + i), pair(w, at.T1 + i), pair(w, at.T2 + i))
        start_mean(s, i, root_a, root(pair(w, at.B + i)), start)
        put(w, at.HALF_ROOT + i, scale(root_a, 0.5))


@called
def _begin_beta(w: Any, count: int, s: Any) -> None:
    """Begin the sum of β; the mean is the same."""
    for i in range(count):
        a, b, z, c = pair(w, at.A + i), pair(w, at.B + i), pair(w, at.Z_MINUS + i), pair(w, at.C + i)
        start = start_of_beta(_first_beta(w, i), c, a, b, z, pair(w, at.S1 + i), pair(w, at.S2 + i))
        start_mean(s, i, scale(pair(w, at.HALF_ROOT + i), 2.0), root(b), start)


@called
def _alpha(w: Any, count: int) -> None:
    for i in range(count):
        nutation, g, d = scale(pair(w, at.MEAN + i), 0.5), pair(w, at.G + i), pair(w, at.GAP + i)
        sign = 1.0 if w[at.C_PLUS + i] >= 0.0 else -1.0
        c, t1, t2 = scale(pair(w, at.C_PLUS + i), sign), pair(w, at.T1 + i), pair(w, at.T2 + i)
        rate = drift(_first_alpha(w, i), c, g, pair(w, at.Z_PLUS + i), t1, t2, d, nutation, pair(w, at.SUM + i))
        w[at.SIGN_A + i] = sign
        put(w, at.NUTATION + i, nutation)
        put(w, at.ALPHA + i, scale(rate, sign))


@called
def _beta(w: Any, count: int) -> None:
    for i in range(count):
        nutation, g, d, first = pair(w, at.NUTATION + i), pair(w, at.G + i), pair(w, at.GAP + i), _first_beta(w, i)
        sign = 1.0 if w[at.C + i] >= 0.0 else -1.0
        c, s1, s2 = scale(pair(w, at.C + i), sign), pair(w, at.S1 + i), pair(w, at.S2 + i)
        rate = drift(first, c, g, pair(w, at.Z_MINUS + i), s2, s1, d, nutation, pair(w, at.SUM + i))
        w[at.SIGN_B + i] = sign
        put(w, at.BETA + i, scale(rate, -sign if first else sign))


@called
def _put_rates(w: Any, count: int, m: Any) -> None:
    """Put the rates of the phases of α and β [turns per time] into rows 1 to 6 of the motion."""
    for i in range(count):
        half = scale(spin(w[at.I1 + i], w[at.I3 + i], w[at.L3 + i]), 0.5)
        alpha = turns_per_time(add(pair(w, at.ALPHA + i), half), w[at.I1 + i], w[at.RATE + i])
        beta = turns_per_time(subtract(pair(w, at.BETA + i), half), w[at.I1 + i], w[at.RATE + i])
        put_record(m, FIRST + i, (*halves(alpha[0]), alpha[1], *halves(beta[0]), beta[1]))


@called
def rates(w: Any, count: int, steps: Any, who: Any, m: Any) -> None:
    """Find the three frequencies, and put those of the phases into the motion.

    Args:
        w: store of tops.
        count: of them.
        steps, who: room for the mean.
        m: columns of the motion in rows of BLOCK.
    """
    _begin_alpha(w, count, steps)
    third_kind(w, at.MEAN, at.SUM, count, steps, who)
    _alpha(w, count)
    _begin_beta(w, count, steps)
    third_kind(w, at.MEAN, at.SUM, count, steps, who)
    _beta(w, count)
    _put_rates(w, count, m)

"""The Lagrange top by Taylor integration of its equations: the second oracle, which confirms the first.

It knows nothing of Cayley-Klein parameters or elliptic functions: power series of L' = L × Ω + mgl Γ × e3, Γ' = Γ × Ω
and q' = q Ω / 2 in fixed-point integers, with as many terms as the precision asks for. Slow, so for short times only.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log2
from operator import mul

from flint import arb, ctx

from oracle.lagrange import TopState, largest_momentum
from oracle.measures import rotation_of
from oracle.reference import Exact, exact

ACCURATE_BITS = 150
"""45 digits before the growth of errors, which is e^turn at most."""
STEP = 0.25
"""Fastest rate times the length of one step."""


def integrated_top(
    moments: Sequence[Exact], mgl: Exact, momentum: Sequence[Exact], attitude: Sequence[Exact], t: Exact
) -> TopState:
    """Return the state at ``t`` of a top with moments (I1, I1, I3), from the given state at 0."""
    I1, I3, weight, time = (float(abs(x)) for x in (moments[0], moments[2], mgl, t))
    unit = (sum(float(x) ** 2 for x in momentum) + 4 * weight * I1) ** 0.5 or 1.0  # |L| never exceeds it
    turn = unit / min(I1, I3) * time
    steps = max(1, ceil(turn / STEP))
    largest = float(largest_momentum(moments, mgl, momentum, attitude)) or unit
    bits = ACCURATE_BITS + 2 * ceil(log2(steps + 1)) + ceil(1.45 * turn) + ceil(log2(unit / largest)) + 24
    with ctx.workprec(2 * bits):
        one, size = arb(2) ** bits, arb(unit)
        h = arb(exact(t)) / steps
        norm = sum((arb(exact(x)) ** 2 for x in attitude), arb(0)).sqrt()
        q = [arb(exact(x)) / norm for x in attitude]
        up = rotation_of(q)[2]
        values = [*(arb(exact(x)) / size for x in momentum), *up, *q]
        rates = [h * size / arb(exact(moments[0])), h * size / arb(exact(moments[2])), h * arb(exact(mgl)) / size]
        now, scaled = ([_whole(x * one) for x in row] for row in (values, rates))
        for _ in range(steps):
            now = _step(now, scaled, bits)
        found = [arb(x) / one for x in now]
        return TopState(found[6:], [size * x for x in found[:3]])


def _whole(value: arb) -> int:
    whole = value.mid().floor().unique_fmpz()
    assert whole is not None
    return int(whole)


def _step(values: list[int], rates: list[int], bits: int) -> list[int]:
    """One step; coefficients carry h^k. ``rates`` = |L| h/I1, |L| h/I3, mgl h/|L|, over 2^bits."""
    series = [[x] for x in values]
    l1, l2, l3, u1, u2, u3, w, x, y, z = series
    a1, a3, pull = rates
    order = 0
    while order < 4 or any(abs(s[k]) > 1 for s in series for k in (-1, -2, -3)):
        d1, d2, d3 = l1[::-1], l2[::-1], l3[::-1]

        def turned(s: list[int], down: list[int], rate: int) -> int:
            return (sum(map(mul, s, down)) >> bits) * rate

        new = (
            turned(l2, d3, a3 - a1) + pull * u2[-1],
            turned(l1, d3, a1 - a3) - pull * u1[-1],
            0,
            turned(u2, d3, a3) - turned(u3, d2, a1),
            turned(u3, d1, a1) - turned(u1, d3, a3),
            turned(u1, d2, a1) - turned(u2, d1, a1),
            (-turned(x, d1, a1) - turned(y, d2, a1) - turned(z, d3, a3)) >> 1,
            (turned(w, d1, a1) + turned(y, d3, a3) - turned(z, d2, a1)) >> 1,
            (turned(w, d2, a1) + turned(z, d1, a1) - turned(x, d3, a3)) >> 1,
            (turned(w, d3, a3) + turned(x, d2, a1) - turned(y, d1, a1)) >> 1,
        )
        order += 1
        for s, value in zip(series, new, strict=True):
            s.append((value >> bits) // order)
    return [sum(s) for s in series]

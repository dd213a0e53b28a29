"""Derivatives of the Lagrange top by central differences of its oracle at many digits."""

from __future__ import annotations

import math
from collections.abc import Sequence

from flint import arb, ctx, fmpq

from oracle.lagrange import reference_top
from oracle.reference import exact
from twins.families_of_tops import TopCase

STEP_BITS = 120
"""h = 2^-120: its square, magnified by a passage of the upright from 1e-9 cubed, is still below 1e-40."""
BITS = 330
"""Of every state, so that differences keep 60 digits."""


def reference_change(case: TopCase, direction: Sequence[float]) -> list[float]:
    """Return the change of quaternion (4) and momentum (3) at the case's time.

    Args:
        case: with I1 = I2.
        direction: rates of change of I1, I3, mgl, momentum (3), attitude (4) and time.
    """
    displacement = max(map(abs, case.momentum[:2])) + max(map(abs, case.attitude[1:3]))
    # to a top nearly upright, even 2^-120 may be a push
    finer = max(0, -math.frexp(displacement)[1] - 30) if displacement and case.family == "next_to_nothing" else 0
    start = [case.moments[0], case.moments[2], case.mgl, *case.momentum, *case.attitude, case.time]
    step = fmpq(1, 2) ** (STEP_BITS + finer)

    def state(sense: int) -> list[arb]:
        I1, I3, mgl, *rest = (exact(x) + sense * step * exact(d) for x, d in zip(start, direction, strict=True))
        found = reference_top((I1, I1, I3), mgl, rest[:3], rest[3:7], rest[7], bits=BITS + finer)
        return [*found.quaternion, *found.momentum]

    ahead, behind = state(1), state(-1)
    with ctx.workprec(2 * BITS + finer):
        return [float((x - y) / (2 * arb(step))) for x, y in zip(ahead, behind, strict=True)]

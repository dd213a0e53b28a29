"""Derivatives of the free motion by central differences of the oracle, with hundreds of digits.

The step is a power of two far below every scale that a double can bring in, so that the h² error is negligible even
when the motion magnifies differences by e^{λt} beside the saddle, up to λt = 700; perturbed moments and momenta are
exact rationals.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, ctx, fmpq, fmpz

from oracle.reference import Exact, Reference, exact, reference_state

STEP_BITS = 1200
"""h = 2^-1200: squared, times (e^{345})⁴ of a passage that starts at 1e-150, still below 1e-100."""
ACCURATE_BITS = 160


class Direction(NamedTuple):
    """A direction of change, any part of it zero."""

    moments: Sequence[Exact] = (0, 0, 0)
    momentum: Sequence[Exact] = (0, 0, 0)
    time: Exact = 0


class Derivative(NamedTuple):
    """Directional derivatives: dR = R hat(ξ) with ``turn`` = ξ in body axes, and dL in body axes."""

    turn: list[arb]
    momentum: list[arb]


def reference_derivative(
    moments: Sequence[Exact], momentum: Sequence[Exact], t: Exact, direction: Direction, step_bits: int = STEP_BITS
) -> Derivative:
    """Return the derivative of attitude and momentum at ``t`` along ``direction``, to 40 digits or more.

    Args:
        moments: three positive principal moments, in any order.
        momentum: angular momentum at t = 0, not zero.
        t: time.
        direction: rates of change of moments, momentum and time.
        step_bits: the step is 2^-step_bits times a size at which the change is at most as large as what it changes.

    Returns:
        ξ with dR = R hat(ξ), and dL(t); R(0) is held at the identity.
    """
    start = [exact(v) for v in (*moments, *momentum, t)]
    change = [exact(v) for v in (*direction.moments, *direction.momentum, direction.time)]
    step = fmpq(1, fmpz(2) ** step_bits) * _natural_size(start, change)
    bits = ACCURATE_BITS + step_bits + _magnitude_bits(step, step_bits)
    ahead, here, behind = (
        _state([x + k * step * d for x, d in zip(start, change, strict=True)], bits) for k in (1, 0, -1)
    )
    with ctx.workprec(bits + 64):
        double_step = arb(2 * step)
        difference = [
            [(a - b) / double_step for a, b in zip(row, other, strict=True)]
            for row, other in zip(ahead.rotation, behind.rotation, strict=True)
        ]
        spin = [
            [sum((here.rotation[k][i] * difference[k][j] for k in range(3)), arb(0)) for j in range(3)]
            for i in range(3)
        ]
        turn = [(spin[k][j] - spin[j][k]) / 2 for j, k in ((1, 2), (2, 0), (0, 1))]
        return Derivative(turn, [(a - b) / double_step for a, b in zip(ahead.direction, behind.direction, strict=True)])


def _state(values: list[fmpq], bits: int) -> Reference:
    """The reference state with the momentum itself in place of its direction."""
    state = reference_state(values[:3], values[3:6], values[6], bits)
    with ctx.workprec(bits + 64):
        norm = arb(sum((x * x for x in values[3:6]), fmpq(0))).sqrt()
        return Reference(state.rotation, [norm * n for n in state.direction], state.quaternion)


def _natural_size(start: list[fmpq], change: list[fmpq]) -> fmpq:
    """A power of two near the smallest ratio of what is changed to its change, momenta taken together."""
    groups = [([x], [d]) for x, d in zip(start[:3], change[:3], strict=True)]
    groups += [(start[3:6], change[3:6]), (start[6:], change[6:])]
    sizes = []
    for values, changes in groups:
        largest_change = max(abs(d) for d in changes)
        largest_value = max(abs(x) for x in values)
        if largest_change and largest_value:
            sizes.append(largest_value / largest_change)
    if not sizes:
        return fmpq(1)
    return fmpq(2) ** (_exponent(min(sizes)) - 1)


def _exponent(value: fmpq) -> int:
    return int(value.p).bit_length() - int(value.q).bit_length()


def _magnitude_bits(step: fmpq, step_bits: int) -> int:
    """Bits by which the step is shorter than 2^-step_bits, if it is."""
    return max(0, -_exponent(step) - step_bits)

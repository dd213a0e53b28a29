"""Periodic motions of any system: found by shooting, and judged by their Floquet multipliers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._printing import print_answer, write_numbers
from polhode.analysis._tangent_flow import TangentFlow, check_start, compute_multipliers
from polhode.errors import NotConverged
from polhode.systems.base import AbstractSystem
from polhode.types import ArrayLike, Complex128, Double, Float64, Real


class FloquetLimits(NamedTuple):
    """Numbers that decide whether a motion is periodic."""

    relative_singular_value: float = 1e-8  # smaller ones belong to families and to what is conserved
    closing_gap: float = 1e-9  # of a state's size: a motion that returns so near to its start is periodic
    min_motion: float = 1e-6  # of a state's size in a period: with less it is an equilibrium


LIMITS = FloquetLimits()


class PeriodicMotion(NamedTuple):
    """A periodic motion, and the evolution of small changes over a period.

    Attributes:
        state: the start.
        period: [s].
        gap: by how much it misses its start, relative to the size of the state.
        monodromy: (n, n) the derivative of the state after a period by the state, in the order of a flat state; of
            complex states in real and imaginary parts by turns.
        multipliers: (n,) its eigenvalues, the largest first. One belongs to the direction of the motion and is 1; what
            is conserved adds ones.
        errors: (n,) by how much rounding may have changed each. The ones of a family of motions form Jordan blocks,
            whose errors are the square root of a rounding error.
    """

    state: Double[np.ndarray, "..."]
    period: float
    gap: float
    monodromy: Float64[np.ndarray, "n n"]
    multipliers: Complex128[np.ndarray, "n"]
    errors: Float64[np.ndarray, "n"]

    @property
    def growth(self) -> float:
        """The rate [1/s] at which the fastest small change grows; 0 where no multiplier is beyond the unit circle."""
        beyond = np.abs(self.multipliers) > 1.0 + self.errors
        return float(np.log(np.abs(self.multipliers[beyond])).max(initial=0.0) / abs(self.period))

    @property
    def verdict(self) -> str:
        """``"unstable"``, or ``"spectrally stable"``: no small change grows exponentially, as far as roundings tell."""
        return "unstable" if self.growth > 0.0 else "spectrally stable"

    def __str__(self) -> str:
        return print_answer(
            f"a periodic motion, {self.verdict}", period=write_numbers(self.period, "s"),
            multipliers=write_numbers(self.multipliers),
            growth=write_numbers(self.growth, "1/s") if self.growth else None,
        )


@known_numbers_only
def monodromy(
    system: AbstractSystem, state: Real[ArrayLike, "..."], times: Real[ArrayLike, "2"]
) -> Float64[np.ndarray, "n n"]:
    """Return the derivative (n, n) of the state at a last time by that at a first.

    It moves with the motion by the linearised equations, and is as exact as the motion.

    Args:
        system: what moves.
        state: one, packed as ``simulate`` takes it; n is how many real numbers it has.
        times: first and last [s].

    Raises:
        InvalidInput: for a batch of states, invalid times, or a motion that ends earlier.

    >>> import polhode as ph
    >>> body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))  # about its middle axis, unstable at 3^-½ / s
    >>> bool(abs(ph.analysis.monodromy(body, [0.0, 2.0, 0.0], (0.0, 1.0))[0, 0] - np.cosh(3.0**-0.5)) < 1e-14)
    True
    """
    start, first, last = check_start(system, state, times)
    flow = TangentFlow(system, start, (first, last))
    return flow(first, last, start, np.eye(flow.size))[1]


@known_numbers_only
def periodic_motion(
    system: AbstractSystem, state: Real[ArrayLike, "..."], period: float, first: float = 0.0, fixed: bool = False
) -> PeriodicMotion:
    """Return the periodic motion next to a guess, with its Floquet multipliers.

    Newton's method on the state's return; in a family of periodic motions it finds the nearest one. The period is
    adjusted too, unless it is that of a drive.

    Args:
        system: what moves.
        state: a guess of one state on it, packed as ``simulate`` takes it.
        period: a guess of its period [s].
        first: the time [s] at which it is in the state, which matters to driven systems.
        fixed: whether the period is known, as that of a drive.

    Raises:
        InvalidInput: for a batch of states, or a period that is not positive.
        NotConverged: where there is no periodic motion near the guess.

    >>> import polhode as ph
    >>> body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    >>> periodic = periodic_motion(body, [0.3, 0.1, 2.0], 9.5)
    >>> periodic.verdict, bool(abs(periodic.multipliers - 1.0).max() < 1e-5)
    ('spectrally stable', True)

    Source: Seydel, *Practical Bifurcation and Stability Analysis*, ch. 7; for families Muñoz-Almaraz et al., Physica D
    181 (2003) 1.
    """
    newton_steps = 30
    furthest = 0.3  # of the state's size and of the period: the longest of Newton's steps
    period = check.number("period", period, "s", above=0)
    start, first, _ = check_start(system, state, (first, first + 1.5 * period))
    flow = TangentFlow(system, start, (first, first + 1.5 * period))
    z, T, best = flow.flat(start), float(period), math.inf
    after, M = flow(first, first + T, start, np.eye(flow.size))
    for _ in range(newton_steps):
        gap, size = flow.flat(after) - z, float(np.linalg.norm(z)) or 1.0
        off = float(np.linalg.norm(gap)) / size
        if not math.isfinite(off) or (off >= 0.5 * best and off < LIMITS.closing_gap):
            break
        best = min(best, off)
        slopes = M - np.eye(flow.size)
        if not fixed:
            # x(T) − x(0) = 0: (M − 1) δx + f(x(T)) δT = −gap, δT in units of T, nearest to no change
            slopes = np.column_stack([slopes, T * flow.rates(first + T, after)])
        move = -np.linalg.lstsq(slopes, gap, rcond=LIMITS.relative_singular_value)[0]
        far = max(np.linalg.norm(move[: flow.size]) / size, *np.abs(move[flow.size :]), furthest)
        z, T = z + furthest / far * move[: flow.size], T if fixed else T * float(1.0 + furthest / far * move[-1])
        after, M = flow(first, first + T, flow.state(z), np.eye(flow.size))
    gap, size = flow.flat(after) - z, float(np.linalg.norm(z)) or 1.0
    off = float(np.linalg.norm(gap)) / size
    if off < LIMITS.closing_gap and np.linalg.norm(flow.rates(first, flow.state(z))) * T <= LIMITS.min_motion * size:
        raise NotConverged(
            f"near this `state` is an equilibrium of {type(system).__name__}, no motion with a period. "
            "Give a better guess of `state` and `period`."
        )
    if not off < LIMITS.closing_gap:
        raise NotConverged(
            f"no periodic motion of {type(system).__name__} was found near this `state` and `period` of {period:g} s: "
            f"the nearest miss their start by {min(best, off):.2g} of their size. Give a better guess."
        )
    return PeriodicMotion(flow.state(z), T, off, M, *compute_multipliers(M))

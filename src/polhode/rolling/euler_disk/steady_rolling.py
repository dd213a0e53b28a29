"""Steady rolling of a disk and its stability, judged by energy and by the spectrum.

The two linear integrals J2, J3 of ``_steady_motion`` play the part of Casimirs: if the second variation of E + Σ λ J
is definite on their level, it proves stability. The spectrum of the linearised equations is computed without
them; both must agree.

Source: Routh, *Advanced Rigid Dynamics* (1905), §244; O'Reilly, Nonlinear Dyn. 10 (1996) 287; for energy and linear
integrals Zenkov, J. Nonlinear Sci. 5 (1995) 503.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax
import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import judge_steady_motion
from polhode.errors import InvalidInput
from polhode.rolling.euler_disk._mechanics import RollingMechanics
from polhode.rolling.euler_disk._steady_motion import WITHOUT_DISSIPATION
from polhode.rolling.euler_disk.system import EulerDisk, rolling_parts
from polhode.types import Array, ArrayLike, Float64, Real


@known_numbers_only
def rolling_stability(disk: EulerDisk, state: Real[ArrayLike, "8"]) -> Stability:
    """Return the verdict on a steady motion of a disk: in its tilt and rates, not in heading and place, which drift.

    Args:
        disk: without dissipation.
        state: (8,), as of ``disk.rolling_state``.

    Raises:
        InvalidInput: for a disk with dissipation, which has no steady motion, or a state that is not steady.

    >>> disk = EulerDisk(mass=1.0, radius=1.0, gravity=3.0)
    >>> [rolling_stability(disk, disk.rolling_state(np.pi / 2, 0.0, spin)).verdict for spin in (0.99, 1.01)]
    ['unstable', 'stable']
    """
    return judge_steady_motion(disk.steady_motion(state))


@known_numbers_only
def nutation(disk: EulerDisk, state: Real[ArrayLike, "8"]) -> float | None:
    """Return the frequency [rad/s] of small nutation about a steady motion, None where it is not stable."""
    square = float(_nutation_squared(disk.mechanics, state))
    return math.sqrt(square) if square > 0.0 else None


class SteadyRolling(NamedTuple):
    """A steady motion of a disk without dissipation.

    Attributes:
        state: (8,).
        verdict: on it.
        nutation: frequency of small nutation [rad/s], None where unstable.
    """

    state: Float64[Array, "8"]
    verdict: Stability
    nutation: float | None


@known_numbers_only
def steady_rolling(
    disk: EulerDisk, tilt: float, precession: float | None = None, spin: float | None = None, heading: float = 0.0
) -> SteadyRolling | None:
    """Return the steady motion with these rates or, where they are not steady, with this precession; None without one.

    Args:
        disk: without dissipation.
        tilt: θ [rad].
        precession: φ̇ [rad/s]; by default that at which the centre is at rest.
        spin: ω3 [rad/s]; follows from the precession.
        heading: φ [rad].

    Raises:
        InvalidInput: for a disk with dissipation, which has no steady motion.

    >>> disk = EulerDisk(mass=0.4, radius=0.04)
    >>> motion = steady_rolling(disk, 0.1)
    >>> motion.verdict.verdict, round(motion.nutation / float(disk.precession(motion.state)), 3)
    ('stable', 0.776)
    """
    if disk.dissipation:
        raise InvalidInput(WITHOUT_DISSIPATION)
    for asked in (spin, None):
        try:
            state = disk.rolling_state(tilt, precession, asked, heading)
            return SteadyRolling(state, rolling_stability(disk, state), nutation(disk, state))
        except InvalidInput:
            continue
    return None


@known_numbers_only
def fastest_rolling_rate(disk: EulerDisk, state: Real[ArrayLike, "8"]) -> float:
    """Return the faster of |φ̇|, at which the contact goes round, and |ω| [rad/s], of one state (8,)."""
    rates = [float(rate) for rate in rolling_parts(state)[1:]]
    return max(abs(float(disk.precession(state))), float(np.linalg.norm(rates)))


@known_numbers_only
def rolling_period(disk: EulerDisk, state: Real[ArrayLike, "8"], steady: SteadyRolling | None = None) -> float:
    """Return a characteristic time [s] of one state: that of a turn, or 2π√(a/g) where hardly anything turns.

    Args:
        disk: any.
        state: (8,).
        steady: a motion near by; where it is stable, its small nutation's period is the answer.
    """
    if steady is not None and steady.nutation:
        return 2.0 * math.pi / steady.nutation
    swinging = math.sqrt(float(disk.mechanics.gravity / disk.mechanics.radius))
    return 2.0 * math.pi / max(fastest_rolling_rate(disk, state), swinging)


@known_numbers_only
def critical_rolling_speed(disk: EulerDisk) -> float:
    """Return the speed [m/s] above which rolling straight ahead, upright, is stable: v² = ga/3 if uniform.

    v² = g a³ mA/[C(C+ma²)].

    Raises:
        InvalidInput: for a thick disk, which touches along a line.
    """
    # upright with ω2 = 0: δω2 = Cω3 δθ/A, so that (A + ma²) θ̈ = (mga − C (C + ma²) ω3²/A) δθ; v = aω3
    m, a, A, C, g = _thin_constants(disk)
    return math.sqrt(m * g * a**3 * A / (C * (C + m * a * a)))


@known_numbers_only
def critical_spin_rate(disk: EulerDisk) -> float:
    """Return the rate [rad/s] above which spinning upright on the spot is stable: ω2² = mga/(A + ma²).

    Raises:
        InvalidInput: for a thick disk, which touches along a line.
    """
    # upright with ω3 = 0: δω3 = ma² ω2 δθ/(C + ma²), so that (A + ma²) θ̈ = (mga − (A + ma²) ω2²) δθ
    m, a, A, _, g = _thin_constants(disk)
    return math.sqrt(m * g * a / (A + m * a * a))


@jax.jit
def _nutation_squared(mechanics: RollingMechanics, state: Array) -> Array:
    theta, _, w2, w3 = rolling_parts(state)
    return mechanics.nutation_squared(theta, w2, w3)


def _thin_constants(disk: EulerDisk) -> tuple[float, ...]:
    if not disk.is_thin:
        raise InvalidInput("`disk` must be thin: a thick disk stands upright on a line, not on a point of its rim.")
    k = disk.mechanics
    return tuple(float(x) for x in (k.mass, k.radius, k.diametral_moment, k.axial_moment, k.gravity))

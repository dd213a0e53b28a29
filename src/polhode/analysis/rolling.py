"""Steady rolling of a disk and its stability, judged by energy and by the spectrum.

Without dissipation θ, ω1, ω2, ω3 move by themselves, on levels of two integrals that are linear in ω2 and ω3: along any
motion (ω2, ω3)′ = M(θ) (ω2, ω3). Carried along θ to the tilt of a steady motion they are J2, J3, which play the part of
Casimirs; their first and second derivatives there follow from M and M′ alone, thick or thin. If the second variation of
E + Σ λ J is definite on their level, it proves stability. The spectrum of the linearised equations knows nothing of all
this; both must agree.

Source: Routh, *Advanced Rigid Dynamics* (1905), §244; O'Reilly, Nonlinear Dyn. 10 (1996) 287; for energy and linear
integrals Zenkov, J. Nonlinear Sci. 5 (1995) 503.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.analysis._reasons import Restriction
from polhode.analysis.energy_casimir import Stability, energy_casimir
from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.systems._rolling_mechanics import RollingMechanics
from polhode.systems.euler_disk import EulerDisk, rolling_parts
from polhode.types import Array, ArrayLike, Float64, Real

RESTRICTED = Restriction(within=("tilt", "rates"), without=("heading", "place"))
AT_REST = 1e-8  # of the terms of θ̈, relative: a steady motion found by a solver or typed in


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
    if disk.dissipation:
        raise InvalidInput("`disk` must be without `dissipation`: with it no motion is steady. Judge the disk without.")
    state = disk.check_state(state)
    if jnp.ndim(state) != 1:
        raise InvalidInput(f"`state` must be one state (8,); got shape {jnp.shape(state)}.")
    mechanics, x = disk.mechanics, np.stack([np.asarray(part) for part in rolling_parts(state)])
    flow, slope, curvature, dJ, ddJ, field = (np.asarray(v) for v in _matrices(mechanics, x))
    size = float(mechanics.gravity / mechanics.radius) + float(np.sum(np.asarray(x[1:]) ** 2))
    if abs(field[0]) > AT_REST * math.sqrt(size) or abs(field[1]) > AT_REST * size:
        raise InvalidInput(
            f"the state is not steady: θ̇ = {field[0]:.3g} rad/s and θ̈ = {field[1]:.3g} rad/s². "
            "Make one by `disk.rolling_state`."
        )
    stability = energy_casimir(flow, slope, curvature, dJ, ddJ, ["J2", "J3"], is_equilibrium=True, tolerance=1e-12)
    legend = "J2, J3 are ω2, ω3 carried to this tilt by their linear equations" if "J" in str(stability.reason) else ""
    return replace(stability, legend=legend, restricted=RESTRICTED if stability.verdict == "stable" else None)


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
        raise InvalidInput("`disk` must be without `dissipation`: with it no motion is steady. Judge the disk without.")
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
        InvalidInput: for a thick disk, which stands on a line.
    """
    # upright with ω2 = 0: δω2 = Cω3 δθ/A, so that (A + ma²) θ̈ = (mga − C (C + ma²) ω3²/A) δθ; v = aω3
    m, a, A, C, g = _thin_constants(disk)
    return math.sqrt(m * g * a**3 * A / (C * (C + m * a * a)))


@known_numbers_only
def critical_spin_rate(disk: EulerDisk) -> float:
    """Return the rate [rad/s] above which spinning upright on the spot is stable: ω2² = mga/(A + ma²).

    Raises:
        InvalidInput: for a thick disk, which stands on a line.
    """
    # upright with ω3 = 0: δω3 = ma² ω2 δθ/(C + ma²), so that (A + ma²) θ̈ = (mga − (A + ma²) ω2²) δθ
    m, a, A, _, g = _thin_constants(disk)
    return math.sqrt(m * g * a / (A + m * a * a))


@jax.jit
def _nutation_squared(mechanics: RollingMechanics, state: Array) -> Array:
    theta, _, w2, w3 = rolling_parts(state)
    return mechanics.nutation_squared(theta, w2, w3)


@jax.jit
def _matrices(disk: RollingMechanics, x: Array) -> tuple[Array, ...]:
    """Return linearisation, dE, D²E, dJ (2, 4), D²J (2, 4, 4) and the field at x = (θ, ω1, ω2, ω3)."""

    def field(x: Array) -> Array:
        d2, d3 = disk.transport(x[0], x[2], x[3])
        return jnp.stack([x[1], disk.tilt_acceleration(x[0], x[2], x[3]), d2 * x[1], d3 * x[1]])

    def matrix(theta: Array) -> Array:
        columns = [jnp.stack(disk.transport(theta, *w)) for w in jnp.eye(2)]
        return jnp.stack(columns, axis=1)

    def energy(x: Array) -> Array:
        return disk.energy(x[0], x[1], x[2], x[3])

    w = x[2:]
    M, dM = matrix(x[0]), jax.jacfwd(matrix)(x[0])
    # J(θ, w) = Φ(θ) w with Φ = 1 here and Φ′ = −ΦM
    dJ = jnp.concatenate([(-M @ w)[:, None], jnp.zeros((2, 1)), jnp.eye(2)], axis=1)
    ddJ = jnp.zeros((2, 4, 4)).at[:, 0, 0].set((M @ M - dM) @ w).at[:, 0, 2:].set(-M).at[:, 2:, 0].set(-M)
    return jax.jacfwd(field)(x), jax.grad(energy)(x), jax.hessian(energy)(x), dJ, ddJ, field(x)


def _thin_constants(disk: EulerDisk) -> tuple[float, ...]:
    if not disk.is_thin:
        raise InvalidInput("`disk` must be thin: a thick disk stands upright on a line, not on a point of its rim.")
    k = disk.mechanics
    return tuple(float(x) for x in (k.mass, k.radius, k.diametral_moment, k.axial_moment, k.gravity))

"""Steady rotations of a gyrostat: where its energy is critical on the momentum sphere."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._printing import print_answer, write_numbers
from polhode.analysis._steady_points import steady_points
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import stability
from polhode.systems.body_with_rotor import clean_direction
from polhode.systems.gyrostat import Gyrostat
from polhode.types import Array, ArrayLike, Float64, Real


class GyrostatLimits(NamedTuple):
    """Numbers that decide what is along an axis, followed and flat."""

    axis_sine: float = 1e-9  # of an angle from an axis that counts as none
    max_turn: float = 2.5  # rad between samples; a larger change of angle may have gone the other way round
    flat_curvature: float = 1e-9  # curvatures of the energy below it, relative to the largest, vanish


LIMITS = GyrostatLimits()


class SteadyRotation(NamedTuple):
    """A steady rotation of a gyrostat, by its point on the momentum sphere.

    Attributes:
        along: (3,) unit vector of L, axes of the motion.
        spin: Ω along it [rad/s].
        energy: of the carrier [J].
        extremum: "minimum", "maximum", "saddle" or "flat" of the energy on the sphere.
        circle: whether it represents a circle of them, or the whole sphere.
        nutation: rate at which L goes round it in the body when disturbed a little [rad/s]; None where it does not.
        verdict: on it.
    """

    along: Float64[Array, "3"]
    spin: float
    energy: float
    extremum: str
    circle: bool
    nutation: float | None
    verdict: Stability

    def __str__(self) -> str:
        many = ", one of a circle or sphere of them" if self.circle else ""
        return print_answer(
            f"a steady rotation, {self.verdict.verdict}, at a {self.extremum} of the energy{many}",
            along=write_numbers(self.along), spin=write_numbers(self.spin, "rad/s"),
            energy=write_numbers(self.energy, "J"), nutation=write_numbers(self.nutation, "rad/s"),
        )


@known_numbers_only
def steady_rotations(gyrostat: Gyrostat, momentum_norm: float) -> list[SteadyRotation]:
    """Return all steady rotations at one |L| with verdicts, lowest energy first; none for |L| zero.

    Of a circle of them, one is given. On a carrier of revolution about the rotor's axis, where (Π − h)/I = λ Π, they
    are the two poles and, for |h| I1 < |L| |I1 − I3|, a circle at Π3 = h I1/(I1 − I3).

    Args:
        gyrostat: the body and its rotor.
        momentum_norm: |L| [kg m²/s].

    Raises:
        InvalidInput: for what is not a gyrostat, or a |L| that is negative or not finite.

    Source: Hughes, *Spacecraft Attitude Dynamics*, §6.4 and §6.6.

    >>> rotations = steady_rotations(Gyrostat((1.0, 2.0, 3.0), (0.0, 0.0, 0.5)), 2.0)
    >>> [(rotation.extremum, rotation.verdict.verdict) for rotation in rotations[::2]]
    [('minimum', 'stable'), ('saddle', 'unstable'), ('maximum', 'stable')]
    >>> [rotation.nutation and round(rotation.nutation, 6) for rotation in rotations[::2]]
    [0.866025, None, 1.145644]
    """
    check.instance("`gyrostat`", gyrostat, Gyrostat, "a Gyrostat", "Make one from moments and a rotor.")
    norm = check.number("momentum_norm", momentum_norm, "kg m²/s", least=0)
    if not norm:
        return []
    moments, rotor = np.asarray(gyrostat.moments), np.asarray(gyrostat.rotor)
    rotations = []
    for point, circle in _points(moments, rotor, norm):
        velocity = (point - rotor) / moments
        # Ω = λ Π at a critical point of the energy on the sphere
        multiplier = float(velocity @ point) / norm**2
        along = clean_direction(point / norm)
        energy, bends = 0.5 * float((point - rotor) @ velocity), _curvatures(moments, along, multiplier)
        # the linearised flow on the sphere turns at |L| times the geometric mean of the curvatures
        nutation = norm * math.sqrt(abs(bends[0])) * math.sqrt(abs(bends[1])) if bends[0] * bends[1] > 0.0 else None
        verdict = stability(gyrostat, point)
        rotations.append(
            SteadyRotation(along, multiplier * norm, energy, _extremum(bends), circle, nutation, verdict)
        )
    return sorted(rotations, key=lambda rotation: rotation.energy)


def _points(moments: Array, rotor: Array, norm: float) -> list[tuple[Array, bool]]:
    """Return the equilibria (3,) on the sphere |L| = norm, and whether each represents a circle of them."""
    k = symmetry_axis(moments, rotor)
    if k is None:
        return [(point, False) for point in steady_points(moments, rotor, norm)]
    if (moments == moments[0]).all() and not rotor.any():
        return [(norm * np.eye(3)[0], True)]
    pole, side = np.eye(3)[k], np.eye(3)[(k + 1) % 3]
    points = [(norm * pole, False), (-norm * pole, False)]
    gap = moments[k - 1] - moments[k]
    if abs(rotor[k]) * moments[k - 1] < norm * abs(gap):
        # λ = 1/I1 across, and (Π3 − h)/I3 = Π3/I1 along the axis
        height = rotor[k] * moments[k - 1] / gap
        points.append((height * pole + math.sqrt(norm**2 - height**2) * side, True))
    return points


def _curvatures(moments: Array, along: Array, multiplier: float) -> Float64[np.ndarray, "2"]:
    """Return the energy's curvatures on the sphere: those of ½ Σ (1/I − λ) δΠ² on the tangent plane, flat ones zero."""
    across = np.linalg.svd(along[None])[2][1:]
    bends = np.linalg.eigvalsh(across @ np.diag(1.0 / moments - multiplier) @ across.T)
    return np.where(np.abs(bends) < LIMITS.flat_curvature * np.max(1.0 / moments), 0.0, bends)


def _extremum(bends: Float64[np.ndarray, "2"]) -> str:
    """Return the sort of critical point of the energy on the sphere, by its curvatures, the smaller one first."""
    if (bends == 0).all():
        return "flat"
    if bends[0] < 0 < bends[1]:
        return "saddle"
    return "maximum" if bends[0] < 0 else "minimum"


class SymmetricRates(NamedTuple):
    """Rates [rad/s] at which L goes round the axis of symmetry in the body, and that axis round L in space."""

    nutation: float
    precession: float


@known_numbers_only
def symmetric_rates(gyrostat: Gyrostat, angular_velocity: Real[ArrayLike, "3"]) -> SymmetricRates | None:
    """Return ((I3 − I1) Ω3 + h)/I1 and |L|/I1 of a carrier of revolution with its rotor along its axis; None of others.

    Args:
        gyrostat: the body and its rotor.
        angular_velocity: (3,) Ω [rad/s, principal axes].

    Source: Hughes, *Spacecraft Attitude Dynamics*, §6.4.

    >>> symmetric_rates(Gyrostat((2.0, 2.0, 3.0), (0.0, 0.0, 0.5)), (0.0, 0.0, 1.0))
    SymmetricRates(nutation=0.75, precession=1.75)
    """
    moments, rotor = np.asarray(gyrostat.moments), np.asarray(gyrostat.rotor)
    velocity = np.asarray(angular_velocity, dtype=float)
    k = symmetry_axis(moments, rotor)
    if k is None:
        return None
    across = moments[k - 1]
    nutation = float(((moments[k] - across) * velocity[k] + rotor[k]) / across)
    return SymmetricRates(nutation, float(np.linalg.norm(moments * velocity + rotor) / across))


@known_numbers_only
def mean_winding_rate(
    times: Real[ArrayLike, "time"], vectors: Real[ArrayLike, "time 3"], axis: Real[ArrayLike, "3"]
) -> float | None:
    """Return the mean rate [rad/s] at which samples of a vector go round an axis, by the right hand's rule.

    It is the slope of the straight line through the unwrapped angles by least squares; None where samples lie too far
    apart to be followed, or the vector is along the axis.

    Args:
        times: (T,) [s].
        vectors: (T, 3).
        axis: (3,) of any length.

    >>> t = np.linspace(0.0, 20.0, 201)
    >>> round(mean_winding_rate(t, np.stack([np.cos(2 * t), np.sin(2 * t), t], axis=-1), (0.0, 0.0, 3.0)), 12)
    2.0
    """
    t, v, n = (np.asarray(x, dtype=float) for x in (times, vectors, axis))
    first = rotation.perpendicular(n / np.linalg.norm(n))
    across = np.stack([v @ first, v @ np.cross(n / np.linalg.norm(n), first)])
    if len(t) < 2 or np.hypot(*across).min() <= LIMITS.axis_sine * np.linalg.norm(v, axis=-1).max():
        return None
    angle = np.unwrap(np.arctan2(across[1], across[0]))
    if np.abs(np.diff(angle)).max() > LIMITS.max_turn:
        return None
    return float(np.polyfit(t - t.mean(), angle - angle.mean(), 1)[0])


@known_numbers_only
def angle_from_axis(vectors: Real[ArrayLike, "*times 3"], axis: Real[ArrayLike, "3"]) -> Float64[Array, "*times"]:
    """Return the angle from a unit axis (3,) to each of (…, 3) vectors [rad], 0 to π; zero to one of no length."""
    along, components = np.asarray(axis, dtype=float), np.asarray(vectors, dtype=float)
    return np.asarray(np.arctan2(np.linalg.norm(np.cross(components, along), axis=-1), components @ along))


def symmetry_axis(moments: Float64[Array, "3"], rotor: Float64[Array, "3"] | None = None) -> int | None:
    """Return the axis of symmetry of the moments, if a rotor's momentum, if any, lies along it too; else None."""
    for k in (2, 0, 1):
        i, j = (k + 1) % 3, (k + 2) % 3
        if moments[i] == moments[j] and (rotor is None or not (rotor[i] or rotor[j])):
            return k
    return None

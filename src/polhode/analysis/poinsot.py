"""Poinsot's picture: the inertia ellipsoid Σ I_i x_i² = 1 rolls without slipping on the invariable plane.

The contact point is x = Ω/√(2E). It traces the polhode on the ellipsoid and the herpolhode in the plane, which lies
√(2E)/|L| from the centre, across L. All lengths are in 1/√(kg m²). Source: Poinsot 1834; Whittaker, *Analytical
Dynamics*, §71; Goldstein, *Classical Mechanics*, §5.6.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.arrays import as_float64, known_numbers_only, namespace
from polhode.exact.free_body import FreeMotion
from polhode.exact.free_body._geometry import REGIMES
from polhode.exact.free_body._preparation import canonical_reduction
from polhode.types import Array, ArrayLike, Float64, Real


class Herpolhode(NamedTuple):
    """Radii about the foot of the perpendicular from the centre to the invariable plane, and that distance."""

    inner_radius: float
    outer_radius: float
    plane_distance: float


@known_numbers_only
def herpolhode(motion: FreeMotion) -> Herpolhode | None:
    """Return the herpolhode of one body's motion, None at rest.

    The squared radius is |L × Ω|²/(2E |L|²). At its extremes one of the smaller components of L vanishes, which makes
    it PQ/(2E|L|²) and P|S|/(2E|L|²) in the invariants of the motion, without any difference of squares.
    """
    return Herpolhode(*(float(x) for x in herpolhodes(motion))) if motion.momentum_norm else None


@known_numbers_only
def herpolhodes(motion: FreeMotion) -> tuple[Float64[np.ndarray, "*batch"], ...]:
    """Return inner and outer radii and distances (…) of many motions, as ``herpolhode`` does of one; NaN at rest."""
    norm, energy = np.asarray(motion.momentum_norm), np.asarray(motion.energy)
    motion = motion.along("principal")
    moments, momentum = np.broadcast_arrays(np.asarray(motion.moments), np.asarray(motion.momentum_at_epoch))
    regime = np.asarray(motion.regime)
    still = np.isin(np.array(REGIMES)[regime] if regime.dtype.kind == "i" else regime, ("permanent", "spherical"))
    with np.errstate(all="ignore"):
        body = canonical_reduction(moments, momentum)
        # momentum_scale²/moment_scale is the unit of P, Q, S and 2E alike: the reduction scales both by powers of two
        unit = body.momentum_scale * body.rate_scale
        P, Q, S = (np.sqrt(np.abs(x[0] / body.V[0] * unit)) for x in (body.P, body.Q, body.S))
        size, distance = norm * np.sqrt(2.0 * energy), np.sqrt(2.0 * energy) / norm
        # |L × Ω|² = PQ or P|S| at the extremes; each root by itself, which cannot underflow
        outer, inner = P * Q / size, P * S / size
    rest = norm == 0.0
    fixed = lambda radius: np.where(rest, np.nan, np.where(still, 0.0, radius))  # noqa: E731
    return fixed(inner), fixed(outer), np.where(rest, np.nan, distance)


def contact_point(
    angular_velocity: Real[ArrayLike, "*batch 3"], energy: Real[ArrayLike, "..."]
) -> Float64[Array, "*batch 3"]:
    """Return the point (…, 3) of the inertia ellipsoid that touches the plane, in the frame of the velocity."""
    xp = namespace(angular_velocity, energy)
    return xp.asarray(angular_velocity) / xp.sqrt(xp.asarray(2.0 * energy))


def touching_point(
    momentum: Real[ArrayLike, "*#batch 3"], moments: Real[ArrayLike, "*#batch 3"]
) -> Float64[Array, "*batch 3"]:
    """Return the point (…, 3) of the ellipsoid that touches the plane while L is along the given directions (…, 3)."""
    xp = namespace(momentum, moments)
    direction = xp.asarray(momentum)
    point = direction / xp.asarray(moments)
    return point / xp.sqrt(xp.sum(direction * point, axis=-1, keepdims=True))


def ellipsoid_semi_axes(moments: Real[ArrayLike, "*batch 3"]) -> Float64[Array, "*batch 3"]:
    """Return the semi-axes 1/√I_i (3,) of the inertia ellipsoid along the principal axes."""
    xp = namespace(moments)
    return 1.0 / xp.sqrt(as_float64(xp, moments, "moments"))


@known_numbers_only
def herpolhode_curve(motion: FreeMotion, times: Real[ArrayLike, "time"]) -> Float64[Array, "time 2"]:
    """Return the herpolhode (T, 2) in the invariable plane, about the foot of the perpendicular, for one body.

    The plane's first direction is fixed in space, across L. The view is against L: rolling runs counterclockwise.
    """
    motion, times = motion.along("principal"), np.asarray(times, dtype=float)
    attitude, momentum = motion.state(times)
    point = rotation.rotate(attitude, contact_point(momentum / motion.moments, motion.energy))
    start = motion.state(motion.epoch)
    normal = rotation.rotate(*start)
    normal = normal / np.linalg.norm(normal)
    first = rotation.perpendicular(normal)
    second = np.cross(normal, first)
    return np.stack([point @ first, point @ second], axis=-1)

"""How far the principal axes and the angular velocity of a free body lean from its angular momentum.

Along the polhode L/|L| runs between two points, at which one of its smaller components vanishes. With the invariants
P, Q, S of the motion these are (√(P/C), 0, √(Q/C))/|L| and (0, √(P/B), √(|S|/B))/|L|, of which the last component is
along the encircled axis, so that each angle is an arctangent of two of √P, √Q, √|S|, without any difference of squares.
Source: Whittaker, *Analytical Dynamics*, ch. VI; the invariants are those of ``exact/free_body/reduction``.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.analysis.poinsot import herpolhode
from polhode.exact.free_body import FreeMotion
from polhode.exact.free_body._geometry import REGIMES
from polhode.exact.free_body._preparation import canonical_reduction
from polhode.types import Array, Float64, Shaped

RIGHT = 0.5 * math.pi


class ConeLimits(NamedTuple):
    """Angles that decide what a rotation is called."""

    coning: float = math.radians(45.0)  # rad, the widest cone that looks like a spin about an axis which nutates
    flipping: float = math.radians(60.0)  # rad; the middle axis comes within 30° of L on either side, …
    swinging: float = math.radians(20.0)  # rad; … and the cone opens and closes by this much, …
    dwelling: float = 0.995  # … or L dwells at the middle axis, by the modulus


LIMITS = ConeLimits()


@known_numbers_only
def axis_angles(motion: FreeMotion) -> Float64[np.ndarray, "3 2"] | None:
    """Return the smallest and largest angle [rad] between each principal axis and L over all time, None at rest.

    Angles lie in [0, π], as axes have a direction: one that L circles at the far end has angles near π.

    Args:
        motion: of one body.

    >>> coning = FreeMotion(moments=(2.0, 2.0, 3.0), momentum=(1.0, 0.0, 1.0))
    >>> np.degrees(axis_angles(coning)).round(6).tolist()
    [[45.0, 135.0], [45.0, 135.0], [45.0, 45.0]]
    """
    momentum = np.asarray(motion.along("principal").momentum_at_epoch)
    if not motion.momentum_norm:
        return None
    if motion.encircled_axis is None or motion.regime in ("permanent", "spherical", "separatrix"):
        return _angles_without_period(motion, momentum)
    nearest, farthest = _cone(motion, momentum)
    axis = motion.encircled_axis
    angles = np.empty((3, 2))
    angles[axis] = (nearest, farthest) if momentum[axis] > 0.0 else (math.pi - farthest, math.pi - nearest)
    others = [k for k in range(3) if k != axis]
    middle = int(np.argsort(motion.moments, kind="stable")[1])
    for k in others:
        # of a symmetric body both run as far, and of others the middle one comes closer to L
        least = RIGHT - (farthest if k == middle else nearest)
        angles[k] = least, math.pi - least
    return angles


@known_numbers_only
def cone_angles(motion: FreeMotion) -> tuple[float, float] | None:
    """Return the smallest and largest angle [rad] between L and the encircled axis, taken as a line; None without one.

    These are the half-angles between which the cone of a nutating body opens and closes.
    """
    momentum = np.asarray(motion.along("principal").momentum_at_epoch)
    if not motion.momentum_norm or motion.encircled_axis is None or motion.regime == "spherical":
        return None
    return _cone(motion, momentum)


@known_numbers_only
def velocity_angles(motion: FreeMotion) -> tuple[float, float] | None:
    """Return the smallest and largest angle [rad] between the angular velocity and L over all time; None at rest."""
    curve = herpolhode(motion)
    if curve is None:
        return None
    # in Poinsot's picture the contact point is along the angular velocity, and the plane across L
    inner, outer = (math.atan2(r, curve.plane_distance) for r in (curve.inner_radius, curve.outer_radius))
    return min(inner, outer), max(inner, outer)


@known_numbers_only
def rotation_form(motion: FreeMotion) -> str:
    """Classify the motion of one body as an observer would, by the range of its cone's half-angle.

    "rest"; "steady": L is fixed in the body; "coning": the encircled axis stays within 45° of L; "flipping": the middle
    axis comes within 30° of L at either end, by a cone that swings by 20° and more, or with rests in between;
    "tumbling": all else.
    """
    return str(rotation_forms(motion))


@known_numbers_only
def rotation_forms(motion: FreeMotion) -> Shaped[np.ndarray, "*batch"]:
    """Return the forms (…) of many motions at once, as ``rotation_form`` does of one."""
    motion = motion.along("principal")
    moments, momentum = np.broadcast_arrays(np.asarray(motion.moments), np.asarray(motion.momentum_at_epoch))
    codes = np.asarray(motion.regime)
    regime = np.array(REGIMES)[codes] if codes.dtype.kind == "i" else codes
    nearest, farthest = _cones(moments, momentum)
    modulus = np.asarray(motion.modulus if codes.ndim else motion.modulus or 0.0, dtype=float)
    flipping = (farthest >= LIMITS.flipping) & ((farthest - nearest >= LIMITS.swinging) | (modulus > LIMITS.dwelling))
    choices = {"rest": regime == "rest", "flipping": regime == "separatrix",
               "steady": (regime == "permanent") | (regime == "spherical"),
               "coning": farthest < LIMITS.coning}  # fmt: skip
    return np.select(list(choices.values()), list(choices), np.where(flipping, "flipping", "tumbling"))


def _cone(motion: FreeMotion, momentum: Float64[np.ndarray, "3"]) -> tuple[float, float]:
    nearest, farthest = _cones(np.asarray(motion.moments), momentum)
    return float(nearest), float(farthest)


def _cones(
    moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"]
) -> tuple[Float64[Array, "*batch"], Float64[Array, "*batch"]]:
    """Return the half-angles (…) between which cones open and close."""
    body = canonical_reduction(moments, momentum)
    with np.errstate(invalid="ignore", divide="ignore"):  # at rest there is no cone
        # tan of the half-angles √(P/Q) and √(P/|S|), in any unit
        P, Q, S = (np.sqrt(np.abs(x[0] / body.V[0])) for x in (body.P, body.Q, body.S))
        one, other = np.arctan2(P, Q), np.arctan2(P, S)
        return np.minimum(one, other), np.maximum(one, other)


def _angles_without_period(
    motion: FreeMotion, momentum: Float64[np.ndarray, "3"]
) -> Float64[np.ndarray, "3 2"]:
    """Return the angles where L is fixed in the body, or goes once from one end of the middle axis to the other."""
    scaled = momentum / np.abs(momentum).max()
    still = np.array([math.atan2(math.hypot(*np.delete(scaled, k)), scaled[k]) for k in range(3)])
    angles = np.stack([still, still], axis=1)
    if motion.regime == "separatrix":
        moments = np.asarray(motion.moments)
        low, middle, high = np.argsort(moments, kind="stable")
        a, b, c = (1.0 / moments[k] for k in (low, middle, high))
        # half-way the great circle of the separatrix has this angle from the axis of largest moment
        # 2E = |L|²/I₂ makes (1/I₁ − 1/I₂) L₁² = (1/I₂ − 1/I₃) L₃²
        tilt = math.atan2(math.sqrt(b - c), math.sqrt(a - b))
        for k, least in ((low, RIGHT - tilt), (high, tilt)):
            angles[k] = (least, RIGHT) if momentum[k] > 0.0 else (RIGHT, math.pi - least)
        angles[middle] = 0.0, math.pi
    return angles

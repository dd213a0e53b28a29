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
from polhode.analysis.poinsot import herpolhodes
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
    return many_axis_angles(motion) if motion.momentum_norm else None


@known_numbers_only
def many_axis_angles(motion: FreeMotion) -> Float64[np.ndarray, "*batch 3 2"]:
    """Return the angles (…, 3, 2) of many motions at once, as ``axis_angles`` does of one; NaN at rest."""
    moments, momentum, codes = _of_many(motion)
    axis = np.asarray(-1 if motion.encircled_axis is None else motion.encircled_axis)
    nearest, farthest = _cones(moments, momentum)
    middle, angles = np.argsort(moments, axis=-1, kind="stable")[..., 1], np.empty((*momentum.shape, 2))
    for k in range(3):
        # of a symmetric body both others run as far, and of others the middle one comes closer to L
        least = RIGHT - np.where(middle == k, farthest, nearest)
        ahead = momentum[..., k] > 0.0
        low, high = np.where(ahead, nearest, math.pi - farthest), np.where(ahead, farthest, math.pi - nearest)
        angles[..., k, 0] = np.where(axis == k, low, least)
        angles[..., k, 1] = np.where(axis == k, high, math.pi - least)
    regime = np.asarray(np.array(REGIMES)[codes])
    rest = np.broadcast_to(np.asarray(motion.momentum_norm) == 0.0, codes.shape)
    angles[rest] = np.nan
    without = ((axis < 0) | np.isin(regime, ("permanent", "spherical", "separatrix"))) & ~rest
    for i in map(tuple, np.argwhere(without)):
        angles[i] = _angles_without_period(moments[i], momentum[i], str(regime[i]))
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
    if not motion.momentum_norm:
        return None
    least, most = many_velocity_angles(motion).tolist()
    return least, most


@known_numbers_only
def many_velocity_angles(motion: FreeMotion) -> Float64[np.ndarray, "*batch 2"]:
    """Return the angles (…, 2) of many motions at once, as ``velocity_angles`` does of one; NaN at rest."""
    inner, outer, distance = herpolhodes(motion)
    # in Poinsot's picture the contact point is along the angular velocity, and the plane across L
    radii, heights = np.stack([inner, outer], axis=-1), np.stack([distance, distance], axis=-1)
    # one by one, as NumPy's arctangent of an array may differ in its last digit
    angles = list(map(math.atan2, radii.ravel().tolist(), heights.ravel().tolist()))
    return np.sort(np.reshape(angles, radii.shape), axis=-1)


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
    moments, momentum, codes = _of_many(motion)
    regime = np.array(REGIMES)[codes]
    nearest, farthest = _cones(moments, momentum)
    modulus = np.asarray(motion.modulus if codes.ndim else motion.modulus or 0.0, dtype=float)
    flipping = (farthest >= LIMITS.flipping) & ((farthest - nearest >= LIMITS.swinging) | (modulus > LIMITS.dwelling))
    choices = {"rest": regime == "rest", "flipping": regime == "separatrix",
               "steady": (regime == "permanent") | (regime == "spherical"),
               "coning": farthest < LIMITS.coning}  # fmt: skip
    return np.select(list(choices.values()), list(choices), np.where(flipping, "flipping", "tumbling"))


def _of_many(motion: FreeMotion) -> tuple[Array, Array, Array]:
    """Return moments and momentum (…, 3) along the principal axes, and codes (…) of regimes, of one motion or many."""
    motion = motion.along("principal")
    moments, momentum = np.broadcast_arrays(np.asarray(motion.moments), np.asarray(motion.momentum_at_epoch))
    codes = np.asarray(motion.regime)
    return moments, momentum, codes if codes.dtype.kind == "i" else np.asarray(REGIMES.index(str(codes)))


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
    moments: Float64[Array, "3"], momentum: Float64[Array, "3"], regime: str
) -> Float64[np.ndarray, "3 2"]:
    """Return the angles where L is fixed in the body, or goes once from one end of the middle axis to the other."""
    scaled = momentum / np.abs(momentum).max()
    still = np.array([math.atan2(math.hypot(*np.delete(scaled, k)), scaled[k]) for k in range(3)])
    angles = np.stack([still, still], axis=1)
    if regime == "separatrix":
        low, middle, high = np.argsort(moments, kind="stable")
        a, b, c = (1.0 / moments[k] for k in (low, middle, high))
        # half-way the great circle of the separatrix has this angle from the axis of largest moment
        # 2E = |L|²/I₂ makes (1/I₁ − 1/I₂) L₁² = (1/I₂ − 1/I₃) L₃²
        tilt = math.atan2(math.sqrt(b - c), math.sqrt(a - b))
        for k, least in ((low, RIGHT - tilt), (high, tilt)):
            angles[k] = (least, RIGHT) if momentum[k] > 0.0 else (RIGHT, math.pi - least)
        angles[middle] = 0.0, math.pi
    return angles

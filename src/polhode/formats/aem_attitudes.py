"""From columns of an Attitude Ephemeris Message to attitudes: quaternions, Euler angles, spin axes, and rates.

"From frame A to frame B" is the rotation which takes the axes of A to those of B, and the angular velocity is that of B
against A. With A the space frame this is polhode's body → space attitude without any change.

Source: CCSDS 504.0-B-2, tables 4-3 and 4-4, annex F.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.types import Array, Float64


def _in(unit: str, *keywords: str) -> dict[str, str]:
    return dict.fromkeys(keywords, unit)


VELOCITY = _in("deg/s", "ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z")
_QUATERNION, _ANGLES = _in("", "Q1", "Q2", "Q3", "QC"), _in("deg", "ANGLE_1", "ANGLE_2", "ANGLE_3")
_SPIN = _in("deg", "SPIN_ALPHA", "SPIN_DELTA", "SPIN_ANGLE") | _in("deg/s", "SPIN_ANGLE_VEL")
COLUMNS = {
    "QUATERNION": _QUATERNION,
    "QUATERNION/DERIVATIVE": _QUATERNION | _in("1/s", "Q1_DOT", "Q2_DOT", "Q3_DOT", "QC_DOT"),
    "QUATERNION/ANGVEL": _QUATERNION | VELOCITY,
    "EULER_ANGLE": _ANGLES,
    "EULER_ANGLE/DERIVATIVE": _ANGLES | _in("deg/s", "ANGLE_1_DOT", "ANGLE_2_DOT", "ANGLE_3_DOT"),
    "EULER_ANGLE/ANGVEL": _ANGLES | VELOCITY,
    "SPIN": _SPIN,
    "SPIN/NUTATION": {**_SPIN, "NUTATION": "deg", "NUTATION_PER": "s", "NUTATION_PHASE": "deg"},
    "SPIN/NUTATION_MOM": {**_SPIN, "MOMENTUM_ALPHA": "deg", "MOMENTUM_DELTA": "deg", "NUTATION_VEL": "deg/s"},
}
"""Columns of each type of attitude: the keyword of each, and its unit."""
OLD_NAMES = {"QUATERNION/RATE": "QUATERNION/ANGVEL", "EULER_ANGLE/RATE": "EULER_ANGLE/ANGVEL"}  # of version 1.0
FAR_FROM_UNIT = 1e-3
"""Files print quaternions with five digits or more; a larger distance from unit length is a mistake."""


class Meaning(NamedTuple):
    """The meaning of the columns.

    Attributes:
        kind: the type of attitude, one of ``COLUMNS``.
        sequence: axes of Euler angles like "ZXZ", each about the axes as the rotations before have left them.
        scalar_first: whether quaternions begin with their scalar.
        velocity_in_space: whether the angular velocity has its components along the space axes.
        backward: whether the rotation is that from body to space, so that the space frame turns against the body.
    """

    kind: str
    sequence: str | None = None
    scalar_first: bool = False
    velocity_in_space: bool = False
    backward: bool = False


def attitudes(
    meaning: Meaning, columns: Float64[Array, "n k"]
) -> tuple[Float64[Array, "n 4"], Float64[Array, "n 3"] | None]:
    """Return attitudes (n, 4), body → space, scalar first, and angular velocities (n, 3) [rad/s, body axes] or None.

    Args:
        meaning: of the columns.
        columns: (n, k), degrees and degrees per second.

    Raises:
        ValueError: with the index of the row as second argument, for values that are no rotation.
    """
    family, _, rates = meaning.kind.partition("/")
    with np.errstate(over="ignore"):  # an infinite length is refused
        lengths = np.linalg.norm(columns[:, :4], axis=-1)
    if family == "SPIN":
        return _of_spin_axis(rates, columns)
    if family == "QUATERNION":
        width = 4
        if (far := np.abs(lengths - 1.0) > FAR_FROM_UNIT).any():
            k = int(np.argmax(far))
            raise ValueError(f"must be a quaternion of unit length; got one of length {lengths[k]:.6g}", k)
        raw = _scalar_first(columns[:, :4], meaning.scalar_first) / lengths[:, None]
    else:
        width = 3
        raw = rotation.from_euler_angles(np.radians(columns[:, :3]), meaning.sequence or "")
    attitude = rotation.conjugate(raw) if meaning.backward else raw
    if not rates:
        return attitude, None
    to_body = rotation.conjugate(attitude)
    if rates == "ANGVEL":
        velocity = np.radians(columns[:, width:])
        velocity = rotation.rotate(to_body, velocity) if meaning.velocity_in_space else velocity
    else:
        if family == "QUATERNION":
            change = _scalar_first(columns[:, 4:], meaning.scalar_first) / lengths[:, None]
            velocity = 2.0 * rotation.multiply(rotation.conjugate(raw), change)[:, 1:]
        else:
            velocity = _of_euler_rates(meaning.sequence or "", columns[:, :3], columns[:, 3:])
        # derivatives give the velocity along the frame that the rotation leads to
        velocity = rotation.rotate(to_body, velocity) if meaning.backward else velocity
    return attitude, -velocity if meaning.backward else velocity


def _scalar_first(quaternion: Array, is_so: bool) -> Array:
    return quaternion if is_so else np.concatenate([quaternion[:, 3:], quaternion[:, :3]], axis=-1)


def _about(axis: str, angle: Array) -> Array:
    return rotation.from_axis_angle(np.eye(3)["XYZ".index(axis)], angle)


def _of_euler_rates(sequence: str, degrees: Array, rates: Array) -> Array:
    """Return the angular velocity along B: each rate is about its axis as later rotations have left it in B."""
    velocity = np.zeros((len(degrees), 3))
    for k, axis in enumerate(sequence):
        velocity = rotation.rotate(rotation.conjugate(_about(axis, np.radians(degrees[:, k]))), velocity)
        velocity[:, "XYZ".index(axis)] += np.radians(rates[:, k])
    return velocity


def _of_spin_axis(nutation: str, columns: Array) -> tuple[Array, Array]:
    """Return the attitude of spin data: a body that turns about its z axis, and that axis about L (annex F5)."""
    right_ascension, declination, phase, spin = columns[:, :4].T
    turns = np.stack([right_ascension + 90.0, 90.0 - declination, phase], axis=-1)
    attitude = rotation.from_euler_angles(np.radians(turns), "ZXZ")
    velocity = np.zeros((len(columns), 3))
    velocity[:, 2] = np.radians(spin)
    if nutation == "NUTATION":
        if (still := columns[:, 5] == 0.0).any():
            raise ValueError("must have a nutation period other than zero", int(np.argmax(still)))
        angle, nutation_phase = np.radians(columns[:, 4]), np.radians(columns[:, 6])
        across = np.sin(angle)
        parts = (across * np.cos(nutation_phase), -across * np.sin(nutation_phase), np.cos(angle))
        along = np.stack(parts, axis=-1)
        velocity += (2.0 * np.pi / columns[:, 5:6]) * along
    elif nutation == "NUTATION_MOM":
        alpha, delta = np.radians(columns[:, 4]), np.radians(columns[:, 5])
        along = np.stack([np.cos(delta) * np.cos(alpha), np.cos(delta) * np.sin(alpha), np.sin(delta)], axis=-1)
        velocity += np.radians(columns[:, 6:7]) * rotation.rotate(rotation.conjugate(attitude), along)
    return attitude, velocity

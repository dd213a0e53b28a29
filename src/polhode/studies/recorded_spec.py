"""The spec of a free body from a file with attitude, angular velocity and inertia at one time."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from polhode.errors import InvalidInput
from polhode.formats.labels import AttitudeLabels
from polhode.formats.paths import write_whole
from polhode.motion._trajectory import Trajectory
from polhode.types import Array, Float64

KEYS = ("object_name", "object_id", "center", "reference_frame", "body_frame", "epoch", "time_system", "originator")


def tells_spin(trajectory: Trajectory) -> bool:
    """Whether a recorded motion has all that a spec of a free body needs."""
    return trajectory.frame is not None and trajectory.attitude is not None and trajectory.angular_velocity is not None


def write_spec(trajectory: Trajectory, labels: AttitudeLabels | None, path: Path, source: str) -> Path:
    """Write body, spin and labels of the first sample as a spec; the file appears whole or not at all.

    Args:
        trajectory: with a frame, attitudes and angular velocities.
        labels: of the file, or None.
        path: where to.
        source: the name of the file that it is from, for a comment.

    Raises:
        InvalidInput: for a motion without inertia or angular velocity.
    """
    if not tells_spin(trajectory):
        missing = "inertia" if trajectory.frame is None else "angular velocity"
        why = f" ({trajectory.outcome.message})" if trajectory.outcome.message else ""
        other = ", or give one of the body as `spec`" if missing == "inertia" else ""
        raise InvalidInput(f"{path}: a spec needs attitude, inertia and angular velocity of one body, and {source} "
                           f"gives no such {missing}{why}. Write a dataset, .nc{other}.")
    given, frame = trajectory.along("given"), trajectory.frame
    assert frame is not None and given.attitude is not None and given.angular_velocity is not None
    rows = [_quantities(row, "kg*m^2") for row in _rounded(np.asarray(frame.inertia))]
    mass = "" if frame.mass is None else f'mass = "{frame.mass:.15g} kg"\n'
    attitude = ", ".join(map(repr, np.asarray(given.attitude)[0].tolist()))
    rates = ", ".join(f'"{rate} rad/s"' for rate in map(repr, np.asarray(given.angular_velocity)[0].tolist()))
    text = (
        f"# From {json.dumps(source)}.\n[body]\ninertia = [\n" + "".join(f"    {row},\n" for row in rows) + f"]\n{mass}"
        f"\n[spin]\nangular_velocity = [{rates}]\n"
        f"attitude = [{attitude}]\n{_labels(labels)}"
    )
    with write_whole(path) as draft:
        draft.write_text(text, "utf-8")
    return path


def _rounded(inertia: Float64[Array, "3 3"]) -> list[list[float]]:
    """Return the entries of a matrix without the rounding of its principal axes."""
    digits = 15  # of the largest moment
    unit = float(np.abs(inertia).max())
    return (np.round((inertia + inertia.T) / (2.0 * unit), digits) * unit + 0.0).tolist()


def _quantities(values: list[float], unit: str) -> str:
    return "[" + ", ".join(f'"{value:.15g} {unit}"' for value in values) + "]"


def _labels(labels: AttitudeLabels | None) -> str:
    if labels is None:
        return ""
    lines = [f"{key} = {json.dumps(value)}\n" for key in KEYS if (value := getattr(labels, key))]
    return "\n[export]\n" + "".join(lines)

"""The format ``aem``: CCSDS Attitude Ephemeris Messages."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Content, Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def write(content: Content, path: Path) -> Path:
    """Write the attitude history, with angular velocities where there are any."""
    from polhode.spacecraft.formats.aem import write_aem

    rates = None if content.trajectory.angular_velocity is None else "angular velocity"
    return write_aem(content.trajectory, path, content.labels, rates)


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the trajectory of a message."""
    from polhode.spacecraft.formats.aem_reading import read_aem

    return read_aem(path)


FORM = Form(
    "aem", "AEM", ".aem",
    "CCSDS AEM 2.0, attitude and angular velocity of the given axes; 16 digits, epochs to a picosecond", write, read,
    lambda head: b"CCSDS_AEM_VERS" in head, of_attitudes=True, has_labels=True, resolution=0.5e-12,
)

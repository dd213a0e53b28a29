"""The format ``apm``: CCSDS Attitude Parameter Messages: one attitude, spin and inertia."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the attitude, angular velocity and inertia of a message."""
    from polhode.spacecraft.formats.adm_state import read_apm

    return read_apm(path)


FORM = Form(
    "apm", "APM", ".apm", "CCSDS APM 2.0", None, read, lambda head: b"CCSDS_APM_VERS" in head, of_attitudes=True,
    has_labels=True, resolution=0.5e-12,
)

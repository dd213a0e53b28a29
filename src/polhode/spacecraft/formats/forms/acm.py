"""The format ``acm``: CCSDS Attitude Comprehensive Messages: a history of attitudes, and the inertia."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the attitude, angular velocity and inertia of a message."""
    from polhode.spacecraft.formats.adm_state import read_acm

    return read_acm(path)


FORM = Form(
    "acm", "ACM", ".acm", "CCSDS ACM 2.0", None, read, lambda head: b"CCSDS_ACM_VERS" in head, of_attitudes=True,
    has_labels=True, resolution=0.5e-12,
)

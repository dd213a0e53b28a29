"""The format ``ck``: SPICE C-kernels."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Content, Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def write(content: Content, path: Path) -> Path:
    """Write the attitude history, and the kernels that it needs next to it."""
    from polhode.spacecraft.formats.spice import write_ck

    return write_ck(content.trajectory, path, labels=content.labels)[0]


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the trajectory of a kernel."""
    from polhode.spacecraft.formats.spice_reading import read_ck

    return read_ck(path, sclk=kernels.sclk, fk=kernels.fk, lsk=kernels.lsk, spice_id=kernels.spice_id)


FORM = Form(
    "ck", "C-kernel", ".bc",
    "SPICE C-kernel of the given axes, with its clock, frame and leap seconds next to it; every digit", write, read,
    lambda head: head.startswith((b"DAF/CK", b"NAIF/DAF")), of_attitudes=True, has_labels=True,
)

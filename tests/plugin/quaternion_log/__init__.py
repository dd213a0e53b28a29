"""A form of file of another package: a time and a quaternion wxyz a line, along the given axes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats import Content, Form, Kernels

if TYPE_CHECKING:
    from polhode.motion import Trajectory

HEAD = b"QLOG 1\n"


def write(content: Content, path: Path) -> Path:
    """Write the attitudes."""
    from polhode.formats import single_attitude

    found = content.trajectory.along("given")
    rows = zip(found.times.tolist(), single_attitude(found, "a QLOG").tolist(), strict=True)
    lines = "".join(f"{time!r} {' '.join(map(repr, attitude))}\n" for time, attitude in rows)
    path.write_bytes(HEAD + lines.encode())
    return path


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the attitudes."""
    import numpy as np

    from polhode.motion import ATTITUDE, StateLayout, Trajectory

    table = np.loadtxt(path, skiprows=1, ndmin=2)
    return Trajectory(table[:, 0], table[:, 1:], StateLayout((ATTITUDE,)), attitude=table[:, 1:])


FORM = Form("qlog", "QLOG", ".qlog", "attitudes of the given axes; every digit", write, read,
            lambda head: head.startswith(HEAD), of_attitudes=True)  # fmt: skip

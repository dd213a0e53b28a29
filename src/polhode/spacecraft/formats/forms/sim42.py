"""The format ``42``: attitudes of NASA's simulator 42, qbn.42 with time.42 and wbn.42 next to it.

Source: 42, ``Source/42report.c``: files without names, a line a sample; qn is the quaternion of the body in the
inertial axes, scalar last, wn [rad/s] is along the body's axes, times are seconds.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def is_named(path: Path) -> bool:
    """Whether a file has the name of one with quaternions, qbn.42 or, of one spacecraft among several, qbn00.42."""
    return path.suffix == ".42" and path.stem.rstrip("0123456789") in ("q", "qbn")


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the attitudes, with the angular velocities where their file is there."""
    from polhode.formats.separate_columns import read_42

    return read_42(path)


FORM = Form("42", "42 file", ".42", "attitudes and angular velocities, to seven digits", None, read,
            of_attitudes=True, named=is_named)

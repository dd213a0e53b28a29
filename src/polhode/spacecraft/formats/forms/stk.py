"""The format ``stk``: attitude files of the Systems Tool Kit, ``.a``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the attitudes."""
    from polhode.spacecraft.formats.stk_attitude import read_stk

    return read_stk(path)


def begins(head: bytes) -> bool:
    """Whether a file begins with STK's version and a group of attitudes."""
    return head.lstrip().lower().startswith(b"stk.v") and b"begin attitude" in b" ".join(head.lower().split())


FORM = Form("stk", "STK attitude file", ".a", "attitudes, with angular velocities where the file has them", None, read,
            begins, of_attitudes=True, has_labels=True)

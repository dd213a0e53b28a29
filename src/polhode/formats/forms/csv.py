"""The format ``csv``: a table of numbers with one line of names and units."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Content, Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory

BEGINS = (b"time [s]", b'"time [s]"')


def write(content: Content, path: Path) -> Path:
    """Write the motion as a table."""
    from polhode.formats.csv_table import write_csv

    return write_csv(content.trajectory, path)


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the trajectory of a table that polhode wrote."""
    from polhode.formats.csv_table import read_csv

    return read_csv(path)


FORM = Form(
    "csv", "CSV table", ".csv", "a table along the given axes; every digit", write, read,
    lambda head: head.startswith(BEGINS), is_own=True,
)

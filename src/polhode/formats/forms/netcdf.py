"""The format ``netcdf``: NetCDF, with every quantity of a motion, bit for bit."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Content, Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def write(content: Content, path: Path) -> Path:
    """Write the motion, or the data of a report without one."""
    if content.samples is None and content.save is not None:
        return content.save(path)
    from polhode.formats.dataset import label_attributes, write_dataset

    return write_dataset(content.trajectory, path, {"title": content.name} | label_attributes(content.labels))


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the trajectory of a dataset, a file or a Zarr store."""
    from polhode.formats.dataset_reading import read_dataset

    return read_dataset(path)


FORM = Form(
    "netcdf", "dataset", ".nc", "all quantities along the principal axes, or levels and lines; every digit", write,
    read, lambda head: head.startswith(b"\x89HDF"), of_motion=False, is_own=True, has_labels=True,
)

"""The format ``netcdf``: NetCDF, with every quantity of a motion, bit for bit."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from polhode.formats.form import Content, Form, Kernels

if TYPE_CHECKING:
    from polhode.motion._trajectory import Trajectory


def write(content: Content, path: Path) -> Path:
    """Write the motion, or the levels and lines of what does not move."""
    if content.samples is None:
        return _write_spectrum(content, path)
    from polhode.formats.dataset import label_attributes, write_dataset

    return write_dataset(content.samples, path, {"title": content.name} | label_attributes(content.labels))


def _write_spectrum(content: Content, path: Path) -> Path:
    from polhode.formats.rotor_dataset import rotor_attributes, write_spectrum

    molecule = content.rotor()
    known = rotor_attributes(molecule.rotor, content.name, molecule.temperature)
    return write_spectrum(path, levels=molecule.levels(), lines=molecule.lines(), attributes=known)


def read(path: Path, kernels: Kernels) -> Trajectory:
    """Return the trajectory of a dataset, a file or a Zarr store."""
    from polhode.formats.dataset_reading import read_dataset

    return read_dataset(path)


FORM = Form(
    "netcdf", "dataset", ".nc", "all quantities along the principal axes, or levels and lines; every digit", write,
    read, lambda head: head.startswith(b"\x89HDF"), of_motion=False, is_own=True, has_labels=True,
)  # fmt: skip

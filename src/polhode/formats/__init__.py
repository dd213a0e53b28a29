"""Motions and bodies in files, their own and other tools': read, write, hand on."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from polhode.bodies.frame import BodyFrame
    from polhode.formats.aem import write_aem
    from polhode.formats.aem_reading import read_aem
    from polhode.formats.csv_table import read_csv, write_csv
    from polhode.formats.dataset import as_dataset, write_dataset, write_zarr
    from polhode.formats.dataset_reading import Recording, read_dataset
    from polhode.formats.given_axes import along_given_axes
    from polhode.formats.gltf import write_gltf
    from polhode.formats.labels import AttitudeLabels
    from polhode.formats.mesh import read_mesh
    from polhode.formats.molecule import read_molecule
    from polhode.formats.scipy_rotation import as_rotation, as_rotation_spline
    from polhode.formats.spice import write_ck
    from polhode.formats.spice_reading import read_ck
    from polhode.formats.urdf import read_urdf_inertial, write_urdf_inertial

_HOME = {
    "AttitudeLabels": "polhode.formats.labels",
    "BodyFrame": "polhode.bodies.frame",
    "Recording": "polhode.formats.dataset_reading",
    "along_given_axes": "polhode.formats.given_axes",
    "as_dataset": "polhode.formats.dataset",
    "as_rotation": "polhode.formats.scipy_rotation",
    "as_rotation_spline": "polhode.formats.scipy_rotation",
    "read_aem": "polhode.formats.aem_reading",
    "read_ck": "polhode.formats.spice_reading",
    "read_csv": "polhode.formats.csv_table",
    "read_dataset": "polhode.formats.dataset_reading",
    "read_mesh": "polhode.formats.mesh",
    "read_molecule": "polhode.formats.molecule",
    "read_urdf_inertial": "polhode.formats.urdf",
    "write_aem": "polhode.formats.aem",
    "write_ck": "polhode.formats.spice",
    "write_csv": "polhode.formats.csv_table",
    "write_dataset": "polhode.formats.dataset",
    "write_gltf": "polhode.formats.gltf",
    "write_urdf_inertial": "polhode.formats.urdf",
    "write_zarr": "polhode.formats.dataset",
}
__all__ = [
    "AttitudeLabels",
    "BodyFrame",
    "Recording",
    "along_given_axes",
    "as_dataset",
    "as_rotation",
    "as_rotation_spline",
    "read_aem",
    "read_ck",
    "read_csv",
    "read_dataset",
    "read_mesh",
    "read_molecule",
    "read_urdf_inertial",
    "write_aem",
    "write_ck",
    "write_csv",
    "write_dataset",
    "write_gltf",
    "write_urdf_inertial",
    "write_zarr",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(_HOME[name]), name)
    raise AttributeError(f"module 'polhode.formats' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)

"""The format ``zarr``: the content of ``netcdf`` in a folder of Zarr; it is read as a dataset."""

from __future__ import annotations

from pathlib import Path

from polhode.formats.form import Content, Form


def write(content: Content, path: Path) -> Path:
    """Write the motion as a Zarr store."""
    from polhode.formats.dataset import label_attributes, write_zarr

    return write_zarr(content.trajectory, path, {"title": content.name} | label_attributes(content.labels))


FORM = Form("zarr", "Zarr store", ".zarr", "all quantities along the principal axes; every digit", write)

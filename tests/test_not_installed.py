"""A library that is missing is one message, whose command names the library, for polhode may come from a clone."""

import sys

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput, not_installed
from polhode.formats.dataset import write_zarr
from polhode.formats.dataset_reading import read_dataset
from polhode.formats.spice_kernels import spiceypy
from polhode.viewer.live import _viser

WAYS = {
    "viser": ("viser", lambda path: _viser()),
    "zarr, written": ("zarr.storage", lambda path: write_zarr(motion(), path / "new.zarr")),
    "zarr, read": ("zarr", lambda path: read_dataset(path / "old.zarr")),
    "spiceypy": ("spiceypy", lambda path: spiceypy()),
    "python-flint": ("flint", lambda path: ph.algebra.polynomial_casimirs(ph.algebra.SO3(), 2)),
}


def motion():
    return ph.FreeMotion((1.0, 2.0, 3.0), (0.1, 1.0, 0.1)).sample(np.arange(3.0))


@pytest.mark.parametrize("name", WAYS)
def test_the_library_is_named(name, tmp_path, monkeypatch):
    module, call = WAYS[name]
    write_zarr(motion(), tmp_path / "old.zarr")
    monkeypatch.setitem(sys.modules, module, None)
    library = name.split(",")[0]
    with pytest.raises(InvalidInput, match=rf'need {library}, which is not installed. Run `pip install .*"{library}>='):
        call(tmp_path)
    assert not (tmp_path / "new.zarr").exists()


def test_without_metadata_the_library_alone_is_named():
    assert str(not_installed("Stores", "zarr", "none such", "Or not.")) == (
        'Stores need zarr, which is not installed. Run `pip install "zarr"`. Or not.'
    )

"""A library that is missing is one message, whose command names the library, for polhode may come from a clone."""

import importlib
import re
import shlex
import sys
from pathlib import Path

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput, not_installed
from polhode.formats.dataset import write_zarr
from polhode.formats.dataset_reading import read_dataset
from polhode.proving.symbolic import _gate
from polhode.spacecraft.formats.spice_kernels import spiceypy
from polhode.sweeps.command import SweepOptions, run_sweep
from polhode.sweeps.running import Sweep

WAYS = {
    "zarr, written": ("zarr.storage", lambda path: write_zarr(motion(), path / "new.zarr")),
    "zarr, read": ("zarr", lambda path: read_dataset(path / "old.zarr")),
    "spiceypy": ("spiceypy", lambda path: spiceypy()),
    "python-flint, for proofs": ("flint", lambda path: ph.certify(
        ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), (0.1, 1.0, 0.1), (0.0, 1.0))),
    "python-flint, for proofs of motions": ("flint", lambda path: ph.certify(
        ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 1.0, 0.1)))),
    "sympy": ("sympy", lambda path: importlib.reload(_gate)),
    "python-flint": ("flint", lambda path: ph.algebra.polynomial_casimirs(ph.algebra.SO3(), 2)),
}


PYTHON = re.escape(sys.executable)


def motion():
    return ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 1.0, 0.1)).sample(np.arange(3.0))


@pytest.mark.parametrize("name", WAYS)
def test_the_library_is_named(name, tmp_path, monkeypatch):
    module, call = WAYS[name]
    write_zarr(motion(), tmp_path / "old.zarr")
    monkeypatch.setitem(sys.modules, module, None)
    library = name.split(",")[0]
    said = rf'need {library}, which is not installed. Run `{PYTHON} -m pip install .*"{library}>='
    with pytest.raises(InvalidInput, match=said):
        call(tmp_path)
    assert not (tmp_path / "new.zarr").exists()


def test_a_sweep_without_zarr_is_refused_before_samples_are_tried(tmp_path, monkeypatch):
    spec = tmp_path / "case.toml"
    lines = [
        "[body]", 'moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]', "[sweep]", "samples = 2", 'outputs = ["energy"]',
        "[sweep.inputs]", '"body.moments.1" = { uniform = ["1 kg*m^2", "2 kg*m^2"] }',
    ]  # fmt: skip
    spec.write_text("\n".join(lines))
    monkeypatch.setitem(sys.modules, "zarr", None)
    monkeypatch.setattr(Sweep, "of", lambda plan: pytest.fail("samples are tried"))
    options = SweepOptions(tmp_path / "out.zarr", 1, None, dry_run=False, json=False, no_figures=True)
    with pytest.raises(InvalidInput, match=r"^Sweeps need zarr, which is not installed\. Run "):
        run_sweep(spec, options)


def test_without_metadata_the_library_alone_is_named():
    assert str(not_installed("Stores", "zarr", "none such", "Or not.")) == (
        f'Stores need zarr, which is not installed. Run `{sys.executable} -m pip install "zarr"`. Or not.'
    )


def test_a_python_in_a_folder_with_spaces_is_quoted(monkeypatch):
    monkeypatch.setattr(sys, "executable", "/my programs/python")
    command = str(not_installed("Stores", "zarr", "zarr")).split("`")[1]
    assert shlex.split(command)[:4] == ["/my programs/python", "-m", "pip", "install"]


def test_no_remedy_asks_for_polhode_from_an_index():
    """Nothing in messages or docs installs polhode by its name, which works from no clone."""
    root = Path(__file__).parents[1]
    texts = [*root.glob("src/**/*.py"), *root.glob("docs/*.md"), root / "README.md", root / "CONTRIBUTING.md"]
    asking = re.compile(r"pip install (-\S+ )*[\"']?polhode")
    assert len(texts) > 100 and not [path for path in texts if asking.search(path.read_text("utf-8"))]

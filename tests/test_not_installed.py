"""A library that is missing is one message, whose command names the extra of the polhode that is installed."""

import importlib
import re
import shlex
import subprocess
import sys
import tomllib
from email.message import Message
from importlib import metadata
from pathlib import Path

import numpy as np
import pytest
import trimesh

import polhode as ph
from oracle.numpy_alone import python_alone
from polhode._base.compiled import kernel_modules
from polhode._base.compiled.images import has_images
from polhode._base.extras import LIBRARIES, named, not_installed
from polhode.analysis.twist import racket_twist
from polhode.errors import InvalidInput
from polhode.formats.dataset import write_zarr
from polhode.formats.dataset_reading import read_dataset
from polhode.formats.mesh import read_mesh
from polhode.formats.scipy_rotation import as_rotation_spline
from polhode.proving.symbolic import _gate
from polhode.spacecraft.formats.spice_kernels import spiceypy
from polhode.spectra.formats.rotor_dataset import spectrum_dataset
from polhode.sweeps.command import SweepOptions, run_sweep
from polhode.sweeps.running import Sweep

WAYS = {
    "zarr, written": ("zarr.storage", lambda path: write_zarr(motion(), path / "new.zarr")),
    "zarr, read": ("zarr", lambda path: read_dataset(path / "old.zarr")),
    "xarray": ("xarray", lambda path: ph.as_dataset(motion())),
    "xarray, for stores": ("xarray", lambda path: motion().save(path / "new.zarr")),
    "xarray, for spectra": ("xarray", lambda path: spectrum_dataset()),
    "xarray, read": ("xarray", lambda path: read_dataset(path / "old.nc")),
    "h5netcdf": ("h5netcdf", lambda path: motion().save(path / "new.nc")),
    "h5py": ("h5py", lambda path: motion().save(path / "new.nc")),
    "h5netcdf, read": ("h5netcdf", lambda path: read_dataset(path / "old.nc")),
    "trimesh": ("trimesh", lambda path: read_mesh(path / "old.ply", unit=1.0)),
    "SciPy, for repairs": ("scipy.spatial", lambda path: read_mesh(path / "old.stl", unit=1.0, repair=True)),
    "SciPy, for splines": ("scipy.spatial.transform", lambda path: as_rotation_spline(motion())),
    "SciPy, for twists": ("scipy.optimize", lambda path: racket_twist(
        ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 1.0, 0.1)))),
    "spiceypy": ("spiceypy", lambda path: spiceypy()),
    "python-flint, for proofs": ("flint", lambda path: ph.certify(
        ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), (0.1, 1.0, 0.1), (0.0, 1.0))),
    "python-flint, for proofs of motions": ("flint", lambda path: ph.certify(
        ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 1.0, 0.1)))),
    "SymPy": ("sympy", lambda path: importlib.reload(_gate)),
    "python-flint": ("flint", lambda path: ph.algebra.polynomial_casimirs(ph.algebra.SO3(), 2)),
}


PYTHON = re.escape(sys.executable)
ROOT = Path(__file__).parents[1]
EXTRAS = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["optional-dependencies"]
NAMED = "jax", "app", "molecules", "spice", "prove", "docs"  # by messages
BESIDE = {"numba", "llvmlite", "ipykernel"}  # which no message asks for: two save time, one runs cells of the pages


def installed(monkeypatch, *lines):
    """Let polhode be installed with these lines about what it requires."""
    about = Message()
    for line in lines:
        about.add_header(*line.split(": "))
    monkeypatch.setattr(metadata, "metadata", lambda name: about)


def motion():
    return ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 1.0, 0.1)).sample(np.arange(3.0))


@pytest.mark.parametrize("name", WAYS)
def test_the_library_is_named(name, tmp_path, monkeypatch):
    module, call = WAYS[name]
    for ending in ("zarr", "nc"):
        motion().save(tmp_path / f"old.{ending}")
    for ending in ("ply", "stl"):
        trimesh.creation.box().export(tmp_path / f"old.{ending}")
    monkeypatch.setitem(sys.modules, module, None)
    library = name.split(",")[0]
    remedy = rf'"(polhode\[{LIBRARIES[module.partition(".")[0]].extra}\]|(?i:{library})>=.*)"'
    said = rf"needs? {library}, which is not installed\. Run `{PYTHON} -m pip install {remedy}`\."
    with pytest.raises(InvalidInput, match=said):
        call(tmp_path)
    assert not list(tmp_path.glob("new*"))


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


def test_the_extra_is_named_where_polhode_is_installed_with_it(monkeypatch):
    installed(monkeypatch, "Provides-Extra: app", 'Requires-Dist: zarr>=3.1; extra == "app"')
    assert str(not_installed("Stores need", "zarr", "Or not.")) == (
        f'Stores need zarr, which is not installed. Run `{sys.executable} -m pip install "polhode[app]"`. Or not.'
    )
    assert str(not_installed("Stores need", "zarr", alone=True)).endswith(' install "zarr>=3.1"`.')


def test_of_an_older_polhode_the_library_is_named_with_its_bound(monkeypatch):
    installed(monkeypatch, "Provides-Extra: zarr", 'Requires-Dist: zarr>=3.1; extra == "zarr"')
    assert str(not_installed("Stores need", "zarr")).endswith(' install "zarr>=3.1"`.')
    assert str(not_installed("Proofs need", "flint")).endswith(' install "python-flint"`.')


def test_without_metadata_the_library_alone_is_named(monkeypatch):
    def missing(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "metadata", missing)
    assert str(not_installed("Stores need", "zarr")) == (
        f'Stores need zarr, which is not installed. Run `{sys.executable} -m pip install "zarr"`.'
    )


def test_other_errors_of_imports_stay():
    for name in ("json.nothing", "a_users_own", None):
        error = ModuleNotFoundError("no", name=name)
        assert named("It needs", error) is error


def test_each_library_is_brought_by_the_extra_that_is_named():
    listed = {(re.match(r"[\w.-]+", line)[0].lower(), extra) for extra in NAMED
              for line in EXTRAS[extra] if not line.startswith("polhode[")}  # fmt: skip
    told = {(library.name.lower(), library.extra) for library in LIBRARIES.values()}
    of_others = {("jaxlib", "jax"), ("scipy", "app")}  # required by jax; and by the extra jax, which app includes
    assert told - listed == of_others and {name for name, _ in listed - told} == BESIDE | {"scipy"}
    assert "polhode[jax]" in EXTRAS["app"] and "polhode[app,molecules,spice,prove]" in EXTRAS["test"]


@pytest.mark.long
def test_the_core_needs_no_other_library():
    done = subprocess.run([sys.executable, ROOT / "tests" / "core_alone.py", "--hide"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.long
@pytest.mark.parametrize("module", ["matplotlib", "scipy", "pydantic", "pint", "platformdirs"])
def test_one_library_that_is_missing_is_named(module):
    command = [sys.executable, ROOT / "tests" / "core_alone.py", "--hide-one", module]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.long
def test_pip_takes_an_extra_from_the_polhode_that_is_installed():
    """And not from an index, where another program might have the name."""
    try:
        extras = metadata.metadata("polhode").get_all("Provides-Extra") or []
    except metadata.PackageNotFoundError:
        extras = []
    if "molecules" not in extras or importlib.util.find_spec("pip") is None:
        pytest.skip("polhode is not installed by pip here, or before it had this extra")
    asked = [sys.executable, "-m", "pip", "install", "--no-index", "--dry-run", "polhode[molecules]"]
    done = subprocess.run(asked, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("motion", [
    lambda momenta: ph.FreeMotion((1.0, 2.0, 3.0), momentum=momenta),
    lambda momenta: ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=momenta),
])  # fmt: skip
def test_without_numba_numpy_takes_many(motion, monkeypatch):
    """To the bits of Python's own numbers."""
    momenta = np.random.default_rng(7).normal(size=(400, 3))
    monkeypatch.setattr(kernel_modules, "has_images", lambda: False)  # those that are on the disk need no Numba
    python_alone(monkeypatch)
    by_python = motion(momenta).state(50.0)
    monkeypatch.setattr(kernel_modules, "is_there", lambda name: False)
    by_numpy = motion(momenta).state(50.0)
    for one, other in zip(by_python, by_numpy, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.skipif(not has_images(), reason="images are for Linux on x86-64")
def test_without_numba_few_have_the_bits_of_kernels_on_the_disk_and_without_them(monkeypatch):
    momenta, times = np.random.default_rng(7).normal(size=(3, 3)), np.linspace(0.0, 50.0, 100)
    python_alone(monkeypatch)
    states = lambda: [ph.FreeMotion((1.0, 2.0, 3.0), momentum=row).state(times) for row in momenta]  # noqa: E731
    wanted = states()
    monkeypatch.setattr(kernel_modules, "is_there", lambda name: False)
    for is_on_disk in (True, False):
        monkeypatch.setattr(kernel_modules.KernelModules, "is_on_disk", lambda self, name, there=is_on_disk: there)
        for one, other in zip(states(), wanted, strict=True):
            np.testing.assert_array_equal(one[0], other[0])


def test_a_python_in_a_folder_with_spaces_is_quoted(monkeypatch):
    monkeypatch.setattr(sys, "executable", "/my programs/python")
    command = str(not_installed("Stores need", "zarr")).split("`")[1]
    assert shlex.split(command)[:4] == ["/my programs/python", "-m", "pip", "install"]


def test_no_page_asks_for_polhode_from_an_index():
    """No page installs polhode by its name, which works from no clone; a message does where polhode is installed."""
    texts = [*ROOT.glob("docs/*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
    asking = re.compile(r"pip install (-\S+ )*[\"']?polhode")
    assert len(texts) > 30 and not [path for path in texts if asking.search(path.read_text("utf-8"))]
    sources = [path for path in ROOT.glob("src/**/*.py") if asking.search(path.read_text("utf-8"))]
    assert len(list(ROOT.glob("src/**/*.py"))) > 100 and not sources

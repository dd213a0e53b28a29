"""A report loads what its spec asks for: a bound on the lines of modules, and no wing and no other kind among them."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import polhode
from polhode._base.plugins.wings import wing_names
from polhode.kinds.registry import kind_names

ROOT = Path(__file__).parents[1]
SOURCES = Path(polhode.__file__).parent
MOST_LINES = {"t_handle": 22_000, "gyroscope": 38_000, "cubesat_6u": 36_500, "water_spectrum": 22_000}
"""Lines of the modules of polhode that a report of an example may load: what it does, and a twentieth more."""
OWN = {
    "t_handle": {"kinds.free_body"}, "gyroscope": {"kinds.heavy_top", "kinds.lagrange_top"},
    "cubesat_6u": {"spacecraft.rigid_body"}, "water_spectrum": {"spectra.quantum_rotor"},
}  # fmt: skip
"""The kinds that it may load: its own; a heavy top also asks which other kind has tops in closed form."""
SLOW = pytest.mark.sweep
PROGRAM = """
import atexit, json, sys
def tell():
    files = {name: module.__file__ for name, module in sys.modules.items() if name.partition(".")[0] == "polhode"}
    print("LOADED" + json.dumps(files), file=sys.stderr)
atexit.register(tell)
from polhode.cli.main import main
main()
"""


def load(example, folder, before=""):
    """Return the modules of polhode with their lines that a report of an example loads in a process of its own."""
    spec = ROOT / "examples" / f"{example}.toml"
    command = [sys.executable, "-c", before + PROGRAM, "report", str(spec), "--out", str(folder / "out")]
    known = {**os.environ, "PYTHONPATH": str(SOURCES.parent), "POLHODE_REPORTS_CACHE": ""}
    done = subprocess.run(command, capture_output=True, text=True, env=known, cwd=folder, timeout=600)
    assert done.returncode == 0, done.stderr
    files = json.loads(done.stderr.rpartition("LOADED")[2])
    return {name.removeprefix("polhode").lstrip("."): Path(file).read_text("utf-8").count("\n")
            for name, file in files.items() if file is not None}  # fmt: skip


def too_much(example, loaded):
    """Return what is wrong with the modules that a report loads, in words."""
    wrong = []
    if (lines := sum(loaded.values())) > MOST_LINES[example]:
        wrong.append(f"{len(loaded)} modules with {lines} lines, more than {MOST_LINES[example]}")
    homes = {f"kinds.{path.parent.name}" for path in (SOURCES / "kinds").glob("*/__init__.py")}
    homes |= {".".join(path.parent.relative_to(SOURCES).parts) for path in SOURCES.glob("*/*/kind.py")}
    assert len(homes) == len(kind_names())
    wings = {name for name in wing_names() if name not in {own.partition(".")[0] for own in OWN[example]}}
    wrong += [f"the kind {home}" for home in sorted(homes & set(loaded) - OWN[example])]
    return wrong + [f"the wing {name}" for name in sorted(wings & set(loaded))]


@pytest.mark.long
def test_a_free_body_loads_no_wing_and_no_other_kind(tmp_path):
    loaded = load("t_handle", tmp_path)
    assert too_much("t_handle", loaded) == []
    # of a mesh that is whole and of a motion that nobody differentiates
    others = ("exact.lagrange_top", "exact.free_body._tangent", "bodies._mesh_repair", "formats.molecule", "simulation")
    assert not set(others) & set(loaded)
    assert [name for name in loaded if name.startswith("formats.forms.")] == ["formats.forms.netcdf"]


@pytest.mark.long
@pytest.mark.parametrize(
    "example", ["gyroscope", pytest.param("water_spectrum", marks=SLOW), pytest.param("cubesat_6u", marks=SLOW)]
)
def test_other_kinds_load_what_they_need(tmp_path, example):
    assert too_much(example, load(example, tmp_path)) == []


def test_motions_by_series_load_no_diffrax():
    """It takes a tenth of a first report; a heavy top has a method of ours, whose name the plan says."""
    code = ("import sys, polhode as ph; top = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (0.0, 0.0, 1.0)); "
            "motion = ph.simulate(top, (0.3, 1.0, 0.2, 0.0, 0.6, 0.8), [0.0, 1.0]); "
            "assert 'Splitting' in str(motion.plan); "
            "print(sorted({'diffrax', 'optimistix', 'lineax', 'matplotlib'} & set(sys.modules)))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.long
def test_what_is_loaded_besides_is_seen(tmp_path):
    """A report that imports one more wing, kind or system fails the tests above."""
    more = "polhode.rolling", "polhode.kinds.gyrostat", "polhode.fields.spin_lattice.kind", "polhode.systems.heavy_top"
    loaded = load("t_handle", tmp_path, "".join(f"import {name}\n" for name in more))
    lines, *others = too_much("t_handle", loaded)
    assert f"more than {MOST_LINES['t_handle']}" in lines
    assert others == [
        "the kind fields.spin_lattice", "the kind kinds.gyrostat", "the wing fields", "the wing rolling"
    ]  # fmt: skip

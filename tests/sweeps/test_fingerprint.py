"""A store goes on with the same sweep alone: of the same spec, content of every file it names, and program."""

import ast
import hashlib
import sys
from importlib import metadata
from pathlib import Path

import pytest

import polhode as ph
from polhode._base.plugins import COMPUTED_BY, program
from polhode.errors import InvalidInput
from polhode.formats.dataset import write_dataset
from polhode.formats.opening import content_digest, read_text, record_files
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind, kind_names
from polhode.spec.body_files import body_file_keys
from polhode.spec.models import BodyTable, PartTable, SpecFile, SpinTable
from polhode.sweeps import running
from polhode.sweeps.plan import read_plan
from polhode.sweeps.running import Sweep
from sweeping import first

EXAMPLES = Path(__file__).parents[2] / "examples"
MESH = """[body]
mesh = "body.stl"
mesh_unit = "mm"
mass = "50 g"
[spin]
about = 1
[sweep]
samples = 3
outputs = ["energy"]
[sweep.inputs]
"spin.rate" = { normal = ["120 rpm", "5 rpm"] }
"""
MOLECULE = """[system]
kind = "quantum-rotor"
j_max = 1
j = 1
[body]
molecule = "water.xyz"
[sweep]
outputs = ["partition_function"]
[sweep.inputs]
"system.temperature" = { grid = ["10 K", "40 K"] }
"""
WATER = "3\nwater\nO 0 0 0.1173\nH 0 0.7572 -0.4692\nH 0 -0.7572 -0.4692\n"
URDF = """<robot name="r"><link name="base"><inertial><mass value="2"/>
<inertia ixx="1" iyy="2" izz="2.5" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>
"""
SDF = """<sdf version="1.9"><model name="r"><link name="base"><inertial><mass>2</mass>
<inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz></inertia></inertial></link></model></sdf>
"""
MJCF = """<mujoco><worldbody><body name="base"><inertial pos="0 0 0" mass="2" diaginertia="1 2 2.5"/></body>
</worldbody></mujoco>
"""
BODY = """[body]
moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]
[spin]
about = 1
"""
TABLE = BODY + """[sweep]
outputs = ["energy"]
[sweep.inputs]
"spin.rate" = { table = "runs.csv", column = "rate", unit = "rpm" }
"""


def mesh(folder):
    (folder / "body.stl").write_bytes((EXAMPLES / "t_handle.stl").read_bytes())
    return MESH


def molecule(folder):
    (folder / "water.xyz").write_text(WATER)
    return MOLECULE


def urdf(folder):
    (folder / "robot.urdf").write_text(URDF)
    return MESH.replace('mesh = "body.stl"\nmesh_unit = "mm"\nmass = "50 g"', 'urdf = "robot.urdf"')


def sdf(folder):
    (folder / "robot.sdf").write_text(SDF)
    return MESH.replace('mesh = "body.stl"\nmesh_unit = "mm"\nmass = "50 g"', 'sdf = "robot.sdf"')


def mjcf(folder):
    (folder / "robot.xml").write_text(MJCF)
    return MESH.replace('mesh = "body.stl"\nmesh_unit = "mm"\nmass = "50 g"', 'mjcf = "robot.xml"')


def part(folder):
    (folder / "hub.toml").write_text('[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\nmass = "2 kg"\n')
    return MESH.replace('mesh = "body.stl"\nmesh_unit = "mm"\nmass = "50 g"', '[[body.part]]\nspec = "hub.toml"')


def table(folder):
    (folder / "runs.csv").write_text("rate,other\n60,1\n70,2\n")
    return TABLE


def earlier_run(kind, output):
    """Return what makes a spec that goes on from an earlier run of a kind."""

    def made(folder):
        text = find_kind(kind).example
        head, _, _ = text.partition("[time]")
        coarse = "\n".join("resolution = 6" if line.startswith("resolution") else line for line in head.splitlines())
        (folder / "first.toml").write_text(coarse + '\n[time]\nuntil = "2 ms"\nsamples = 3\n')
        write_dataset(read_spec(folder / "first.toml").report().trajectory, folder / "run.nc")
        sweep = """rotation = "0.5 rad/s"
start_from = "run.nc"
[time]
until = "2 ms"
samples = 3
[sweep]
outputs = ["rotation", "OUTPUT"]
chunk = 1
[sweep.inputs]
"system.rotation" = { grid = ["0.5 rad/s", "0.6 rad/s"] }
"""
        return f'[system]\nkind = "{kind}"\nresolution = 6\n{sweep.replace("OUTPUT", output)}'

    return made


CASES = {
    "mesh": (mesh, "body.stl"), "molecule": (molecule, "water.xyz"), "urdf": (urdf, "robot.urdf"),
    "sdf": (sdf, "robot.sdf"), "mjcf": (mjcf, "robot.xml"), "spec": (part, "hub.toml"),
    "table": (table, "runs.csv"), "fluid": (earlier_run("sphere-fluid", "energy"), "run.nc"),
    "mhd": (earlier_run("sphere-mhd", "magnetic_energy"), "run.nc"),
}  # fmt: skip


def test_every_key_of_a_file_is_among_the_cases():
    """Whoever adds a key of free text says here whether it names a file, and then adds a case."""
    tables = [BodyTable, PartTable, SpinTable, SpecFile, *(find_kind(kind).table for kind in kind_names())]
    texts = {key for model in tables for key, field in model.model_fields.items()
             if field.annotation in (str, str | None) and not field.metadata}  # fmt: skip
    assert texts == {"kind", "name", "link", "mesh", "molecule", "spec", "start_from"}
    assert set(body_file_keys()) <= CASES.keys()


def made(name, folder):
    make, file = CASES[name]
    (folder / "case.toml").write_text(make(folder))
    return Sweep.of(read_plan(folder / "case.toml")), folder / file


def change(path):
    """Change a file as little as one can, so that it is read as well."""
    path.write_bytes(path.read_bytes() + (b"\0" if path.suffix == ".nc" else b"\n"))


@pytest.mark.parametrize("name", first(4, CASES))
def test_every_file_that_is_read_counts(tmp_path, name):
    """On main the fingerprint stayed the same for start_from, which a list by hand had left out."""
    sweep, file = made(name, tmp_path)
    assert list(sweep.read) == [file]
    before = sweep.layout.fingerprint
    again = Sweep.of(read_plan(tmp_path / "case.toml"))
    assert again.layout.fingerprint == before
    change(file)
    assert Sweep.of(read_plan(tmp_path / "case.toml")).layout.fingerprint != before


def stopped(sweep, store):
    """Compute one chunk."""

    def stop(samples):
        raise KeyboardInterrupt

    begun = sweep.begin(store)
    with pytest.raises(KeyboardInterrupt):
        sweep.run(begun, 1, tell=stop)
    assert begun.list_finished() == {0}
    return begun


@pytest.mark.sweep
def test_a_sweep_does_not_go_on_from_another_run(tmp_path):
    """On main the second half went on from the other file, without a word."""
    sweep, file = made("fluid", tmp_path)
    stopped(sweep, tmp_path / "a.zarr")
    earlier = file.read_bytes()
    (tmp_path / "first.toml").write_text((tmp_path / "first.toml").read_text().replace("seed = 3", "seed = 4"))
    write_dataset(read_spec(tmp_path / "first.toml").report().trajectory, file)
    with pytest.raises(InvalidInput, match="holds another sweep: the file run\\.nc changed since"):
        ph.sweep(tmp_path / "case.toml", tmp_path / "a.zarr", workers=1)
    file.write_bytes(earlier)
    ph.sweep(tmp_path / "case.toml", tmp_path / "a.zarr", workers=1)


@pytest.mark.long
def test_a_file_that_changes_while_the_sweep_runs(tmp_path):
    sweep, file = made("fluid", tmp_path)
    begun = sweep.begin(tmp_path / "a.zarr")
    with pytest.raises(InvalidInput, match=r"run\.nc: changed while the sweep ran"):
        sweep.run(begun, 1, tell=lambda samples: change(file))
    assert begun.list_finished() == {0}


def test_where_the_spec_lies_does_not_count(tmp_path):
    for place in ("a", "b"):
        (tmp_path / place).mkdir()
    assert made("mesh", tmp_path / "a")[0].layout.fingerprint == made("mesh", tmp_path / "b")[0].layout.fingerprint


def test_two_tables_that_were_swapped(tmp_path):
    both = TABLE + '"spin.tilt" = { table = "more.csv", column = "rate", unit = "deg" }\n'
    (tmp_path / "case.toml").write_text(both)
    texts, found = ["rate\n1\n2\n", "rate\n3\n4\n"], set()
    for one, other in (texts, texts[::-1]):
        (tmp_path / "runs.csv").write_text(one)
        (tmp_path / "more.csv").write_text(other)
        found.add(Sweep.of(read_plan(tmp_path / "case.toml")).layout.fingerprint)
    assert len(found) == 2


@pytest.mark.parametrize("name", program.SETTINGS)
def test_settings_that_compute_other_bits(monkeypatch, name):
    before = program.program_digest()
    monkeypatch.setenv(name, "another")
    assert program.program_digest() != before


def test_versions_count(monkeypatch):
    before, true_version = program.program_digest(), metadata.version
    program._versions.cache_clear()
    with monkeypatch.context() as patch:
        patch.setattr(metadata, "version", lambda name: "0" if name == "scipy" else true_version(name))
        assert program.program_digest() != before
    program._versions.cache_clear()


@pytest.mark.sweep
def test_every_library_that_computes_is_told(tmp_path):
    """Every library that the rooms of numbers and files import, but those that draw, ask or say."""
    top = Path(ph.__file__).parent
    rooms = {path.name for path in top.iterdir()} - {"cli", "figures", "viewer", "testing"}
    imported = set()
    for room in rooms:
        for file in [top / room] if room.endswith(".py") else (top / room).rglob("*.py"):
            for node in ast.walk(ast.parse(file.read_text("utf-8"))):
                names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else (
                    [node.module] if isinstance(node, ast.ImportFrom) and node.module and not node.level else [])
                imported |= {name.partition(".")[0] for name in names}
    others = imported - sys.stdlib_module_names - {"polhode"}
    silent = {"matplotlib", "IPython", "lazy_loader", "dask", "distributed", "filelock", "astropy_iers_data", "SALib",
              "spiceypy", "flint", "z3", "networkx", "tqdm", "jaxtyping", "typer", "typing_extensions"}  # fmt: skip
    told = {name.replace("-", "_") for name in COMPUTED_BY}
    assert others - silent - told == set()


def test_a_worker_with_another_program_is_refused(tmp_path, monkeypatch):
    sweep, _ = made("table", tmp_path)
    store = sweep.begin(tmp_path / "a.zarr")
    job = running._Job(sweep.plan, sweep.layout, sweep.read, sweep.plugins, program.program_digest(sweep.plugins))
    running._compute_remotely(job, str(store.path), 0)
    other = running._Job(sweep.plan, sweep.layout, sweep.read, sweep.plugins, "another")
    with pytest.raises(InvalidInput, match="has another version of polhode, of Python, of a library or"):
        running._compute_remotely(other, str(store.path), 0)


def test_files_are_recorded_by_content(tmp_path):
    (tmp_path / "a.xyz").write_text("one")
    with record_files() as outer, record_files() as inner:
        read_text(tmp_path / "a.xyz", "molecule", 10)
        with pytest.raises(InvalidInput):
            read_text(tmp_path / "b.xyz", "molecule", 10)
    with record_files() as none:
        pass
    assert inner == outer == {tmp_path / "a.xyz": hashlib.sha256(b"one").hexdigest()} and not none
    (tmp_path / "a.xyz").write_text("two")
    assert content_digest(tmp_path / "a.xyz") == hashlib.sha256(b"two").hexdigest()
    assert content_digest(tmp_path / "b.xyz") == ""


def test_a_file_that_something_else_replaced_has_been_read(tmp_path):
    file = tmp_path / "a.xyz"
    file.write_text("one")
    with record_files() as read:
        read_text(file, "molecule", 10)
        file.unlink()
        file.mkdir()
    assert read == {file: ""}

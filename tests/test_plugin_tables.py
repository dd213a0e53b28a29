"""The tables of wings: what they name is there, the help needs no wing, and without wings the rest works."""

import inspect
import json
import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import polhode
from polhode._base.plugins import GROUPS
from polhode._base.plugins.wings import TABLE, wing_details, wing_names, wing_points
from polhode.cli.commands.records import _list_forms
from polhode.formats import form_registry
from polhode.kinds import registry
from polhode.kinds.base import AbstractKind
from polhode.spec.models import BodyTable

ROOT = Path(__file__).parents[1]
SOURCES = Path(polhode.__file__).parent
EXTRAS = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["optional-dependencies"]


@pytest.mark.parametrize("wing", wing_names())
def test_a_table_has_known_groups_and_names_what_is_there(wing):
    table = tomllib.loads((SOURCES / wing / TABLE).read_text("utf-8"))
    assert {f"polhode.{part}" for part in table} <= set(GROUPS)
    for part in table:
        for name in table[part]:
            assert wing_points(f"polhode.{part}")[name].load() is not None, name


def test_names_are_those_of_one_wing():
    for group in GROUPS:
        parts = [tomllib.loads((SOURCES / wing / TABLE).read_text("utf-8")) for wing in wing_names()]
        named = [name for part in parts for name in part.get(group.removeprefix("polhode."), {})]
        assert len(named) == len(set(named)), group


def test_lines_of_the_help_are_those_of_the_commands():
    lines = {name: details["help"] for name, details in wing_details("polhode.commands").items()}
    points = wing_points("polhode.commands")
    assert lines == {name: " ".join(inspect.getdoc(points[name].load()).split("\n\n")[0].split()) for name in points}


def test_what_is_told_of_kinds_is_so():
    """A kind that a table does not tell about is not asked: its default, its subject and its offers would not count."""
    told = wing_details("polhode.kinds")
    own = {name: registry.find_kind(name) for name in registry._own()}
    assert set(told) <= set(own)
    for name, kind in own.items():
        line = told.get(name, {})
        assert line.get("subject", "") == kind.subject, name
        assert bool(line.get("default")) is kind.is_default, name
        assert ("offers" in line) is (type(kind).offers is not AbstractKind.offers), name
        assert set(line.get("offers", ())) <= set(BodyTable.model_fields), name
        assert set(line) <= {"subject", "default", "offers"}, name


def test_what_is_told_of_formats_is_so():
    """A line is needed by each, as a format without one is imported by every command."""
    told = wing_details("polhode.formats")
    lines = {line.get("name", name): line for name, line in told.items()}
    own = {name: one.load() for name, one in form_registry._own().items()}
    assert lines.keys() == own.keys()
    for name, form in own.items():
        line = lines[name]
        assert (name, line["ending"]) == (form.name, form.ending)
        assert bool(line.get("writes")) is (form.write is not None), name
        assert ("heads" in line, "names" in line) == (form.begins is not None, form.named is not None), name
        assert set(line) <= {"name", "ending", "writes", "heads", "names", "extra"}, name
        assert line.get("extra") in (None, *EXTRAS), name
    assert "ck (extra spice)," in _list_forms()  # in the help of export


HEADS = {
    "acm": b"CCSDS_ACM_VERS = 2.0\n", "aem": b'<?xml version="1.0"?><aem id="CCSDS_AEM_VERS" version="2.0">',
    "apm": b"CCSDS_APM_VERS = 2.0\n", "ardupilot": b"timestamp,ATT.TimeUS,ATT.DESROLL,ATT.Roll,ATT.Pitch,ATT.Yaw\n",
    "basilisk": b"time,Sigma_bn_1,Sigma_bn_2,Sigma_bn_3\n", "ck": b"DAF/CK  \2\0\0\0",
    "csv": b'"time [s]",qw,qx,qy,qz\n',
    "gmat": b"Sat.ElapsedSecs    Sat.Q1    Sat.Q2    Sat.Q3    Sat.Q4\n", "netcdf": b"\x89HDF\r\n\x1a\n",
    "px4": b"TIMESTAMP,q[0],q[1],q[2],q[3]\n",
    "ros": b"%time,field.Orientation.x,field.orientation.y,field.orientation.z,field.orientation.w\n",
    "stk": b"\n STK.v.12.0\nBEGIN   Attitude\n",
}  # fmt: skip
"""What a file of each format may begin with, in letters that differ from those of the table."""
MORE_HEADS = [
    ("ck", b"NAIF/DAF\2\0\0\0"), ("gmat", b"Sat.UTCGregorian  Sat.Q1  Sat.Q2  Sat.Q3  Sat.Q4\n"),
    ("gmat", b"Sat.TAIModJulian  Sat.Q1  Sat.Q2  Sat.Q3  Sat.Q4\n"), (None, b"a,b,c\n1,2,3\n"), (None, b"SIMPLE  = T"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "head"), [*HEADS.items(), *MORE_HEADS])
def test_a_file_is_recognised_as_if_all_formats_were_asked(name, head):
    """Of a C-kernel of the older head the table said nothing, and it was no file that can be read."""
    every = (form for form in form_registry.forms().values() if form.begins is not None)
    first = next((form for form in every if form.begins(head)), None)
    form = form_registry.form_that_begins(head)
    assert form is first and (None if form is None else form.name) == name


def test_each_head_in_the_tables_has_a_specimen():
    told = wing_details("polhode.formats")
    assert {line.get("name", name) for name, line in told.items() if "heads" in line} == HEADS.keys()


def test_a_format_that_is_told_nothing_of_is_asked(monkeypatch):
    """So that a module can be dropped into the folder, before its line is written."""
    asked = {"polhode.formats": {}}
    monkeypatch.setattr(form_registry, "wing_details", lambda group: asked[group])
    form_registry._own.cache_clear()
    try:
        assert "aem" in form_registry.writable_names() and "px4" not in form_registry.writable_names()
        assert form_registry.form_that_begins(b"CCSDS_AEM_VERS = 2.0\n").name == "aem"
        assert form_registry.form_that_is_named(Path("qbn.42")).name == "42"
        assert [form.name for form in form_registry.forms_that_end(".bc")] == ["ck"]
    finally:
        form_registry._own.cache_clear()


def run(code, path, folder):
    """Return what a fresh process prints that finds polhode below a path."""
    known = {**os.environ, "PYTHONPATH": str(path), "POLHODE_REPORTS_CACHE": ""}
    command = [sys.executable, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, env=known, cwd=folder, timeout=300)


def test_the_help_imports_no_wing(tmp_path):
    code = ("import sys; from polhode.cli.main import main\ntry: main(['--help'])\nexcept SystemExit: pass\n"
            "print([m for m in sys.modules if m.startswith('polhode.')], file=sys.stderr)")  # fmt: skip
    done = run(code, SOURCES.parent, tmp_path)
    loaded = {name.split(".")[1] for name in done.stderr.replace("'", " ").split() if name.startswith("polhode.")}
    assert "cli" in loaded and "  wobble  " in done.stdout
    assert not loaded & set(wing_names())


@pytest.fixture(scope="module")
def without_wings(tmp_path_factory):
    """Return a folder with a copy of the package in which no wing is."""
    folder = tmp_path_factory.mktemp("without")
    shutil.copytree(SOURCES, folder / "polhode", ignore=shutil.ignore_patterns("__pycache__", *wing_names()))
    return folder


COMMAND = "import sys; from polhode.cli.main import main; main(sys.argv[1:] or {!r})"


@pytest.mark.long
@pytest.mark.parametrize("example", ["t_handle", "gyroscope"])
def test_a_report_needs_no_wing(without_wings, tmp_path, example):
    spec = ROOT / "examples" / f"{example}.toml"
    done = run(COMMAND.format(["report", str(spec), "--json", "--out", "out"]), without_wings, tmp_path)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["kind"] == {"t_handle": "free-body", "gyroscope": "heavy-top"}[example]


@pytest.mark.long
def test_what_a_hidden_wing_brings_is_not_there(without_wings, tmp_path):
    (tmp_path / "spins.toml").write_text('system.kind = "spin-lattice"\n')
    done = run(COMMAND.format(["report", "spins.toml"]), without_wings, tmp_path)
    assert done.returncode == 2 and "spin-lattice" in done.stderr and "must be one of" in done.stderr
    assert "Traceback" not in done.stderr
    done = run(COMMAND.format(["wobble"]), without_wings, tmp_path)
    assert done.returncode == 2 and "wobble" in done.stderr and "Traceback" not in done.stderr
    assert "wobble" not in run(COMMAND.format(["--help"]), without_wings, tmp_path).stdout


@pytest.mark.long
@pytest.mark.parametrize("wing", [wing for wing in wing_names() if (SOURCES / wing / "__init__.pyi").exists()])
def test_a_wing_is_imported_alone(wing, tmp_path):
    others = [name for name in wing_names() if name != wing]
    code = (f"import sys, polhode.{wing} as w\nfor name in w.__all__: getattr(w, name)\n"
            f"print(*[m for m in sys.modules if m.startswith('polhode.') and m.split('.')[1] in {others!r}])")
    done = run(code, SOURCES.parent, tmp_path)
    assert done.returncode == 0 and done.stdout.split() == [], done.stderr + done.stdout

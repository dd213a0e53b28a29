"""What holds of every kind: those in the folder, and one that another package brings."""

import json
import math
import pickle
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.formats.dataset import write_dataset
from polhode.formats.dataset_reading import read_dataset
from polhode.kinds import registry
from polhode.kinds.page import page_of_report, write_page
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind, kind_names
from polhode.reports.answer import Table, plain, values_of

OWN = tuple(registry._folders())
OTHERS = ("spherical-pendulum",)
KEPT = 1e-9  # drift of what is conserved or balanced: none of the examples is long
ANY_BODY = {"body", "axis", "sphere", "poinsot"}  # panels that the page's own script makes
pytestmark = pytest.mark.usefixtures("plugin")


@pytest.fixture(scope="module", params=[*OWN, *OTHERS])
def kind(request, plugin):
    return find_kind(request.param)


@pytest.fixture(scope="module")
def spec(kind, tmp_path_factory):
    path = tmp_path_factory.mktemp(kind.name) / "example.toml"
    path.write_text(kind.example, "utf-8")
    return read_spec(path)


@pytest.fixture(scope="module")
def report(spec):
    return spec.report()


@pytest.fixture(scope="module")
def moving(kind, report):
    if not kind.has_motion:
        pytest.skip("has no motion")
    return report


def test_what_takes_no_motion_is_what_the_report_says(spec, report):
    """Sweeps ask for these alone; ten kinds have some, to the bit."""
    whole, names = report.as_json_dict(), 0
    for group in spec.kind.answers_without_motion(spec):
        for name, value in plain(values_of([group])).items():
            inside = value if isinstance(value, dict) else {}
            assert whole[name] == value or all(whole[name][key] == inside[key] for key in inside), name
            names += 1
    assert names or not hasattr(spec.kind._part("answers"), "answers_without_motion")


def test_its_name(kind):
    assert kind.name in kind_names() and re.fullmatch(r"[a-z]+(-[a-z]+)*", kind.name)
    if kind.name in OWN:
        assert type(kind).__module__ == f"polhode.kinds.{kind.name.replace('-', '_')}"


def test_its_spec(kind, spec):
    assert spec.kind is kind and isinstance(spec.system, kind.table) and spec.system.kind == kind.name


def test_a_wrong_key_is_named(kind, spec, tmp_path):
    path = tmp_path / "wrong.toml"
    path.write_text(kind.example.replace("[system]\n", "[system]\nnonsense = 1\n"), "utf-8")
    with pytest.raises(InvalidInput, match=r"system\.nonsense: unknown key; known here are kind"):
        read_spec(path)


def test_its_words(report, kind):
    said = [report.summary, *report.notes]
    for group in report.answers:
        rows = group.cells if isinstance(group, Table) else group.lines
        said += [group.title, *(cell for row in rows for cell in row)]
    assert report.kind == kind.name and report.summary.endswith(".")
    assert not [words for words in said if re.search(r"\b(nan|inf|None)\b", words)]


def test_its_json(report, kind):
    values = json.loads(json.dumps(report.as_json_dict(), allow_nan=False))
    assert values["kind"] == kind.name and values["units"]
    for name in values["units"]:
        *levels, last = name.split(".")
        found = values
        for level in levels:
            found = found[level]
        # a unit of a table is that of each of its rows
        rows = found if isinstance(found, list) else [found, *found.values()]
        assert any(isinstance(row, dict) and last in row for row in rows), name


def test_what_it_conserves(moving):
    trajectory = moving.trajectory
    assert trajectory.drift and max(float(np.max(x)) for x in trajectory.drift.values()) < KEPT
    assert all(name in trajectory.invariants or name in trajectory.balances for name in trajectory.drift)
    layout = trajectory.layout  # a point of a dual that is an array has no named parts
    assert (len(layout.parts) or layout.axes > 1) and len(repr(trajectory).splitlines()) <= 20


def test_its_figures(kind, report, tmp_path):
    assert tuple(kind.figures()) == kind.figure_names
    written = report.draw(tmp_path)
    assert written and {path.stem for path in written} <= set(kind.figure_names)
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in written)
    with pytest.raises(InvalidInput, match="must be one of"):
        report.figure("nonsense")


def test_its_files(moving, tmp_path):
    found = read_dataset(write_dataset(moving.trajectory, tmp_path / "motion.nc"))
    wanted = moving.trajectory
    assert np.array_equal(found.times, wanted.times) and found.outcome == wanted.outcome
    for part in found.layout.parts:
        assert np.array_equal(found.part(part.name), wanted.part(part.name)), part.name
    for name in wanted.invariants | wanted.balances:
        assert found.quantity(name).unit == wanted.quantity(name).unit


def test_its_page(kind, spec, moving, tmp_path):
    page = page_of_report(moving, tmp_path / "page.html", surface=spec.surface).read_text("utf-8")
    data = json.loads(re.search(r'id="motion">(.*?)</script>', page, re.DOTALL)[1])
    types = {panel["type"] for panel in data["panels"]}
    made = set(re.findall(r"polhodePanels \?\?= \{\}\)\.(\w+) =", page))
    assert types and types <= ANY_BODY | made
    assert data["name"] == spec.name and data["summary"]


def test_its_motion_is_that_of_its_report(kind, spec, moving):
    moved = spec.motion()
    assert np.array_equal(moved.trajectory.states, moving.trajectory.states)
    assert (moved.trajectory.attitude is None) == (not kind.has_attitude)
    assert (moved.mechanics is None) == (moving.mechanics is None)
    if moved.mechanics is not None:
        assert np.array_equal(moved.mechanics.inertia, moving.mechanics.inertia)
    frames = moved.trajectory.frame, moving.trajectory.frame
    assert frames == (None, None) or np.array_equal(frames[0].moments, frames[1].moments)


def test_no_kind_is_named_outside_its_folder():
    """Nothing else in the package knows one: a third party's is as good as any."""
    home = Path(registry.__file__).parents[1]
    for name in OWN:
        own = home / "kinds" / name.replace("-", "_")
        named = re.compile(rf"""["']{name}["']""")
        others = [path for path in home.rglob("*.py") if not path.is_relative_to(own)]
        assert not [str(path) for path in others if named.search(path.read_text("utf-8"))], name


def test_remedies_name_a_kind_that_is_there(monkeypatch):
    assert registry.other_kind("top", in_closed_form=True).in_closed_form
    assert registry.other_kind("", in_closed_form=True) is None
    assert registry.other_kind("moon", in_closed_form=False) is None
    assert [find_kind(name).is_default for name in OWN].count(True) == 1
    monkeypatch.setattr(registry, "kind_names", lambda: [])
    assert registry.other_kind("top", in_closed_form=True) is None


def test_importing_the_registry_imports_no_kind():
    code = (
        "import sys, polhode.kinds.registry as r; names = r.kind_names();"
        "print([m for m in sys.modules if m.startswith('polhode.kinds.') and '.' in m[14:]], len(names),"
        " [m for m in ('jax', 'matplotlib', 'xarray') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120)
    assert done.stdout.split("] ")[0] == "[" and done.stdout.endswith(f"{len(OWN)} []\n"), done.stdout


def test_a_kind_that_cannot_be_imported_is_named(monkeypatch):
    class Broken:
        name, value = "broken", "broken_package:KIND"

        def load(self):
            raise ImportError("no such thing")

    monkeypatch.setattr(registry, "_others", lambda: {"broken": Broken()})
    with pytest.raises(InvalidInput, match=r"broken.*broken_package:KIND.*no such thing"):
        find_kind("broken")
    monkeypatch.setattr(Broken, "load", lambda self: object())
    with pytest.raises(InvalidInput, match="is not an AbstractKind"):
        find_kind("broken")


# ---------------------------------------------------------------------- the pendulum of the other package


def test_the_pendulum_by_its_command(tmp_path, monkeypatch, capsys):
    """A conical pendulum, ω² = g/(l cos θ), keeps its height."""
    monkeypatch.chdir(tmp_path)
    rate = math.sqrt(9.80665 / math.cos(math.radians(40.0)))
    text = find_kind("spherical-pendulum").example.replace("2 rad/s", f"{rate!r} rad/s")
    (tmp_path / "cone.toml").write_text(text, "utf-8")
    with pytest.raises(SystemExit, match="0"):
        main(["report", "cone.toml", "--json"])
    values = json.loads(capsys.readouterr().out)
    assert values["highest"] - values["lowest"] < 1e-9 and values["files"][0].endswith("path.png")
    assert abs(values["highest"] + math.cos(math.radians(40.0))) < 1e-9


def test_the_pendulum_s_own_rule(tmp_path):
    (tmp_path / "still.toml").write_text('[system]\nkind = "spherical-pendulum"\nlength = "1 m"\n', "utf-8")
    with pytest.raises(InvalidInput, match=r"system: needs lean, like"):
        read_spec(tmp_path / "still.toml")


def test_it_can_be_kept(kind, report):
    """As commands keep it for the next."""
    again = pickle.loads(pickle.dumps(report))
    assert again.as_json_dict() == report.as_json_dict() and again.summary == report.summary
    if kind.has_motion:
        assert np.array_equal(again.trajectory.states, report.trajectory.states)


def test_without_a_motion_what_needs_one_is_refused(kind, spec, report, tmp_path):
    """In words, before anything is computed or written; nothing else is. A page may show what does not move."""
    path = tmp_path / "case.toml"
    path.write_text(kind.example, "utf-8")
    if kind.has_motion:
        assert kind.next_steps(spec)[0].command == "view"
        return
    assert write_page(spec, tmp_path / "page.html").stat().st_size > 500_000
    (tmp_path / "page.html").unlink()
    with pytest.raises(InvalidInput, match="has no motion in time"):
        spec.motion()
    for command in (["export", "--to", "csv"], ["export", "--to", "gltf"]):
        with pytest.raises(SystemExit, match="2"):
            main([*command, str(path)])
    assert [file.name for file in tmp_path.iterdir()] == ["case.toml"] and not report.as_json_dict().get("drift")


def test_a_misspelt_kind_is_one_mistake_with_a_hint(tmp_path):
    spec = tmp_path / "case.toml"
    spec.write_text('[system]\nkind = "euler-dsk"\n')
    with pytest.raises(InvalidInput) as refused:
        read_spec(spec)
    assert "1 mistake" in str(refused.value) and str(refused.value).endswith("did you mean euler-disk?")

"""Figures as files: the same for the same motion, with text as text, and an earlier run's cleared away."""

import json
import re
from dataclasses import replace

import matplotlib.image
import numpy as np
import pytest

import polhode as ph
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.figures import style
from polhode.formats.figure_file import is_ours
from polhode.kinds.reading import read_spec

FREE = """
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "2.6 kg*m^2"]
[spin]
rate = "60 rpm"
about = 2
tilt = "5 deg"
"""
NAMES = ["momentum_sphere", "inertia_ellipsoid", "components", "herpolhode"]


@pytest.fixture
def spec(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "case.toml"
    path.write_text(FREE)
    return path


def run(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        main([str(a) for a in arguments])
    out, err = capsys.readouterr()
    return stopped.value.code or 0, out, err


@pytest.mark.sweep
def test_all_forms_of_all_figures_are_what_they_say(spec, tmp_path):
    read = read_spec(spec)
    report = read.report()
    first, second = tmp_path / "first", tmp_path / "second"
    figures = read.kind.figures()
    for folder, drawn in ((first, figures), (second, {name: figures[name] for name in NAMES[:2]})):
        folder.mkdir()
        replace(report, drawings=lambda drawn=drawn: drawn).draw(folder, "png", "svg", "pdf")
    assert {p.name for p in first.iterdir()} == {f"{name}.{form}" for name in NAMES for form in ("png", "svg", "pdf")}
    assert len(list(second.iterdir())) == 6
    for path in second.iterdir():
        assert path.read_bytes() == (first / path.name).read_bytes()
    for path in first.iterdir():
        assert is_ours(path)
    for name in NAMES:
        assert matplotlib.image.imread(first / f"{name}.png")[..., :3].std() > 0.02
        drawing = (first / f"{name}.svg").read_text("utf-8")
        assert "<text" in drawing and "Verdana" in drawing and not re.search(r'href="https?:', drawing)
        document = (first / f"{name}.pdf").read_bytes()
        assert b"/Type0" in document and b"/FontFile2" in document and b"/Type3" not in document


@pytest.mark.sweep
def test_the_command_writes_the_forms_asked_for_and_clears_its_own(spec, capsys, tmp_path):
    code, out, _ = run(["report", spec, "--json", "--figure-format", "svg,PDF", "--figure-format", "svg"], capsys)
    assert code == 0
    written = [name.split("/")[-1] for name in json.loads(out)["files"]]
    assert sorted(written) == sorted([f"{n}.{f}" for n in NAMES for f in ("svg", "pdf")] + ["motion.nc"])
    folder = tmp_path / "case"
    (folder / "photo.svg").write_text("<svg/>")
    (folder / "tilt.svg").write_text("<svg/>")  # named as a report's, and not polhode's
    for copy in ("for_the_paper.pdf", "comparison.pdf"):
        (folder / copy).write_bytes((folder / f"{NAMES[0]}.pdf").read_bytes())
    (folder / "section.svg").write_bytes((folder / f"{NAMES[0]}.svg").read_bytes())  # another kind's
    code, out, _ = run(["report", spec, "--json"], capsys)
    found = {p.name for p in folder.iterdir()}
    kept = {"motion.nc", "photo.svg", "tilt.svg", "for_the_paper.pdf", "comparison.pdf"}
    assert code == 0 and found == {f"{n}.png" for n in NAMES} | kept
    removed = {f"case/{n}.{f}" for n in NAMES for f in ("svg", "pdf")} | {"case/section.svg"}
    assert set(json.loads(out)["removed"]) == removed
    (folder / "tilt.png").write_bytes((folder / f"{NAMES[0]}.png").read_bytes())
    code, out, _ = run(["report", spec], capsys)
    assert code == 0 and "Removed, of an earlier report: case/tilt.png" in " ".join(out.split())


@pytest.mark.parametrize("forms", ["jpg", "png,", "svg,eps", ""])
def test_forms_that_are_none(spec, capsys, tmp_path, forms):
    code, out, err = run(["report", spec, "--figure-format", forms], capsys)
    said = "png, svg, pdf" if forms else "an argument is empty"
    assert code == 2 and out == "" and said in err
    assert [p.name for p in tmp_path.iterdir()] == ["case.toml"]


def test_one_figure_by_its_name(spec):
    read = read_spec(spec)
    report = read.report()
    assert len(report.figure("components").axes) == 2
    with pytest.raises(InvalidInput, match=r"inertia_ellipsoid.*'tilt'"):
        report.figure("tilt")
    assert list(read.kind.figures()) == NAMES


def test_small_curves_are_enlarged_by_powers_of_ten():
    series = np.array([[1.0, 2e-6, 0.0], [-1.0, 1e-6, 1e-15]])
    assert style.magnifications(series) == [0, 5, 0]
    assert style.magnifications(np.zeros((4, 3))) == [0, 0, 0]
    assert style.magnify("axis 2", 5) == "axis 2 × 10$^{5}$" and style.magnify("axis 2", 0) == "axis 2"


@pytest.mark.long_cases("inertia_ellipsoid")
@pytest.mark.parametrize("name", ["momentum_sphere", "inertia_ellipsoid", "components", "herpolhode"])
def test_a_motion_is_drawn_without_a_spec(name):
    draw = getattr(ph.figures, name)
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), epoch=2.0)
    lines = [line for axes in draw(motion).axes for line in axes.lines]
    assert lines
    for other in (
        ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 1.5)),
        ph.FreeMotion((3.0, 4.0, 6.0), momentum=(1.0, 2.0, 1.0)),
    ):
        draw(other)
    with pytest.raises(InvalidInput, match="Take one of it"):
        draw(ph.FreeMotion((1.0, 2.0, 3.0), momentum=[(0.3, 1.8, 1.5)] * 2))

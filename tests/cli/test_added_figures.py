"""Figures that other packages add to the reports of kinds that are there, and those of them that are broken."""

import contextlib
import io
import json
import pickle
import sys
from importlib.metadata import EntryPoint

import pytest
from matplotlib.figure import Figure

from polhode.cli.main import main
from polhode.kinds import added_figures
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind, known_figures
from polhode.testing import check_kind

SPEC = '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n[time]\nuntil = "1 s"\nsamples = 3\n'
OWN = ["momentum_sphere", "inertia_ellipsoid", "components", "herpolhode"]


@pytest.fixture(autouse=True)
def anew(plugin, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "box.toml").write_text(SPEC)
    (tmp_path / "leaves_at_once.py").write_text("import sys\nsys.exit(4)\n")
    monkeypatch.syspath_prepend(tmp_path)


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments)])
    out, err = capsys.readouterr()
    return end.value.code or 0, out, " ".join(err.split())


def test_one_of_another_package_is_in_the_report(capsys, tmp_path):
    code, out, err = run(capsys, "report", "box.toml", "--json", "--figure-format", "svg")
    said = json.loads(out)
    assert code == 0 and not err and "box/spin_rate.svg" in said["files"]
    assert "|Ω| [rad/s]" in (tmp_path / "box" / "spin_rate.svg").read_text("utf-8")
    (tmp_path / "box.toml").write_text(SPEC + '[spin]\nangular_velocity = ["1 rad/s", "2 rad/s", "3 rad/s"]\n')
    report = read_spec("box.toml").report()
    assert list(report.figures()) == [*OWN, "spin_rate"] and list(report.plot()) == [*OWN, "spin_rate"]
    (line,) = report.figure("spin_rate").axes[0].lines
    speed = (report.trajectory.angular_velocity**2).sum(axis=-1) ** 0.5
    assert line.get_ydata() == pytest.approx(speed, rel=1e-14)
    assert list(pickle.loads(pickle.dumps(report)).figures()) == [*OWN, "spin_rate"]  # as commands keep it
    assert "spin_rate" in known_figures()
    assert "spin_rate" not in added_figures.figures_of(find_kind("lagrange-top"))  # it is of free bodies alone


def test_the_check_of_a_kind_passes_with_it():
    check_kind(find_kind("free-body"))


def test_an_outdated_one_is_removed(capsys, tmp_path):
    run(capsys, "report", "box.toml", "--figure-format", "svg")
    code, _, _ = run(capsys, "report", "box.toml", "--json")
    assert code == 0 and not (tmp_path / "box" / "spin_rate.svg").exists() and (tmp_path / "box/spin_rate.png").exists()


def fail(report):
    raise ZeroDivisionError("x")


def leave(report):
    sys.exit(3)


def give_text(report):
    return "a picture"


def give_nothing(report):
    return None


def give_bad_formula(report):
    figure = Figure()
    figure.subplots().set_title(r"$\nonsense{$")
    return figure


@pytest.fixture(scope="module")
def whole(plugin, tmp_path_factory):
    """What the command says without broken ones."""
    folder, out = tmp_path_factory.mktemp("whole"), io.StringIO()
    (folder / "box.toml").write_text(SPEC)
    with contextlib.chdir(folder), contextlib.redirect_stdout(out), pytest.raises(SystemExit):
        main(["report", "box.toml", "--json"])
    return json.loads(out.getvalue())


@pytest.mark.parametrize(("name", "value", "words"), [
    ("free-body.bad", f"{__name__}:fail", "is left out: it fails (ZeroDivisionError: x). Update or remove it."),
    ("free-body.bad", f"{__name__}:leave", "is left out: it fails (SystemExit: 3). Update or remove it."),
    ("free-body.bad", "leaves_at_once:draw", "cannot be imported: it calls sys.exit with 4. Update or remove it. Its"),
    ("free-body.bad", f"{__name__}:give_text", "it must return a figure of Matplotlib or None; got 'a picture'"),
    ("free-body.bad", f"{__name__}:give_bad_formula", "is left out: it fails (ValueError: "),
    ("free-body.bad", "nowhere:draw", "cannot be imported: No module named 'nowhere'. Update or remove it. Its figure"),
    ("free-body.components", f"{__name__}:fail", "is ignored, as polhode has one of this name itself. Rename or"),
    ("free-body.a/b", f"{__name__}:fail", "is ignored, as its name must be KIND.FIGURE, where FIGURE is words in"),
    ("bad", f"{__name__}:fail", "is ignored, as its name must be KIND.FIGURE, where FIGURE is words in"),
    ("free-boddy.bad", f"{__name__}:fail", "is ignored, as there is no kind 'free-boddy'"),
])  # fmt: skip
def test_one_that_is_broken_is_said_and_takes_nothing_with_it(capsys, add_entry_points, name, value, words, whole):
    add_entry_points(added_figures.GROUP, (name, value))
    code, out, err = run(capsys, "report", "box.toml", "--json")
    assert code == 0 and json.loads(out) == whole
    assert err.count(f"the figure {name} of another package, {value}, ") == 1 and words in err


def test_one_may_have_nothing_to_draw(capsys, add_entry_points):
    add_entry_points(added_figures.GROUP, ("free-body.empty", f"{__name__}:give_nothing"))
    code, out, err = run(capsys, "report", "box.toml", "--json")
    assert code == 0 and not err and not [file for file in json.loads(out)["files"] if "empty" in file]


def test_nothing_is_imported_before_it_is_drawn(add_entry_points):
    add_entry_points(added_figures.GROUP, ("free-body.bad", "nowhere:draw"))
    assert list(read_spec("box.toml").report().figures()) == [*OWN, "bad", "spin_rate"]


def test_one_of_a_wing_is_taken_from_its_table_and_its_mistakes_are_ours(monkeypatch):
    points = {f"free-body.{name}": EntryPoint(f"free-body.{name}", f"{__name__}:{name}", added_figures.GROUP)
              for name in ("give_nothing", "fail")}  # fmt: skip
    monkeypatch.setattr(added_figures, "wing_points", lambda group: points)
    added_figures.added_figures.cache_clear()
    report = read_spec("box.toml").report()
    assert list(report.figures()) == [*OWN, "give_nothing", "fail", "spin_rate"]
    assert report.figure("give_nothing") is None
    with pytest.raises(ZeroDivisionError):
        report.figure("fail")
    added_figures.added_figures.cache_clear()

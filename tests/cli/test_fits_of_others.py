"""Branches of ``fit`` that wings and other packages bring."""

import json
import sys

import pytest

import polhode as ph
from polhode._base.plugins import record_plugins
from polhode._base.plugins.wings import wing_points
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.studies import fit_request as branches

TIMES = "0\n1.001\n2.0\n3.002\n4.0\n"


@pytest.fixture(autouse=True)
def anew(plugin, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "one.swings").write_text(TIMES)
    (tmp_path / "log.csv").write_text("time,a\n0,1\n1,2\n")


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments)])
    out, err = capsys.readouterr()
    return end.value.code or 0, out, err


def test_a_file_of_another_package_is_fitted(capsys):
    with record_plugins() as used:
        assert ph.fit("one.swings").values()["period"] == pytest.approx(2.0002)
    assert [str(plugin) for plugin in used] == ["the fit swings of another package, swing_timer.branch:FIT"]
    code, out, _ = run(capsys, "fit", "one.swings", "--json")
    assert code == 0 and json.loads(out)["kind"] == "swings"
    code, out, err = run(capsys, "fit", "one.swings", "--drag")
    assert code == 2 and not out and "one.swings: times of a swing are fitted alone" in err


def test_own_branches_come_first_and_logs_last(add_entry_points):
    """A branch that says yes to all takes no file that a branch of polhode knows, and no name."""
    add_entry_points(branches.GROUP, ("lines", "math:pi"), ("all", f"{__name__}:GREEDY"))
    with pytest.raises(InvalidInput, match="a molecule is fitted to one file of lines"):
        ph.fit("one.toml")
    with pytest.raises(InvalidInput, match="takes one file of periods alone; got 2 files"):
        ph.fit("a.toml", "b.lin", pendulum=True)
    with pytest.warns(UserWarning, match="the fit lines of another package, math:pi, is ignored"), \
         pytest.raises(InvalidInput, match=r"log\.csv: the fit all of another package fails \(ZeroDiv"):  # fmt: skip
        ph.fit("log.csv")


def fail(request):
    raise ZeroDivisionError("x")


def leave(request):
    sys.exit(0)


LEAVING = branches.FitBranch(leave, fail)
GREEDY = branches.FitBranch(lambda request: True, fail)
EMPTY = branches.FitBranch(lambda request: True, lambda request: None)


@pytest.mark.parametrize(("value", "words"), [
    ("math:pi", "the fit odd of another package, math:pi, is not a FitBranch that knows its files"),
    ("nowhere:FIT", "the fit odd of another package, nowhere:FIT, cannot be imported"),
    ("polhode.measuring.throws.branch:FIT", "is not a FitBranch that knows its files"),
    (f"{__name__}:LEAVING", r"the fit odd of another package fails \(SystemExit: 0\)"),
    (f"{__name__}:EMPTY", "the fit odd of another package gives None, not a StudyReport"),
])  # fmt: skip
def test_one_that_is_none_is_named(add_entry_points, value, words):
    add_entry_points(branches.GROUP, ("odd", value))
    with pytest.raises(InvalidInput, match=words):
        ph.fit("log.csv")


def test_without_the_wings_nothing_is_fitted(monkeypatch):
    """The application has no list of its own."""
    assert wing_points(branches.GROUP).keys() == {"lines", "logs", "pendulum"}
    monkeypatch.setattr(branches, "wing_points", lambda group: {})
    for files in (["log.csv"], ["a.toml", "b.lin"]):
        with pytest.raises(InvalidInput, match=f"{files[0]}: is of no sort that can be fitted"):
            ph.fit(*files)

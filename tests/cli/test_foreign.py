"""A command with an estimator of another package, which no file of polhode names."""

import json
import sys

import pytest

import polhode as ph
from polhode.cli import foreign
from polhode.cli.main import main
from polhode.spacecraft.rigid_body import named


@pytest.fixture(autouse=True)
def anew(plugin):
    """Have each test import the package anew."""
    yield
    for name in [name for name in sys.modules if name.startswith("swing_timer")]:
        del sys.modules[name]


@pytest.fixture
def times(tmp_path):
    path = tmp_path / "times.txt"
    path.write_text("0\n1.001\n2.0\n3.002\n4.0\n")
    return path


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments)])
    out, err = capsys.readouterr()
    return end.value.code or 0, out, err


def test_it_is_listed(capsys):
    code, out, _ = run(capsys, "--help")
    assert code == 0 and "swings   Tell the period of a swing." in out and "report " in out


def test_it_prints_draws_and_writes_as_all_commands_do(capsys, times, tmp_path):
    code, out, _ = run(capsys, "swings", times)
    assert code == 0 and "A swing takes 2.0002 s" in out
    code, out, _ = run(capsys, "swings", times, "--json", "--out", tmp_path / "r.csv", "--figures", tmp_path / "f")
    said = json.loads(out)
    assert code == 0 and said["kind"] == "swings" and said["units"] == {"period": "s", "error": "s"}
    assert said["files"] == [str(tmp_path / "r.csv"), str(tmp_path / "f" / "residuals.png")]
    assert said["period"] == pytest.approx(2.0002)  # by hand: the line through (0, .5, 1, 1.5, 2)


def test_its_mistakes_are_those_of_a_command(capsys, tmp_path):
    code, out, err = run(capsys, "swings", tmp_path / "none.txt")
    assert code == 2 and not out and "none.txt: cannot be read" in err
    code, _, err = run(capsys, "swings", tmp_path, "--out", "a", "--out", "b")
    assert code == 2 and "--out is given 2 times" in err


def test_it_does_not_destroy_what_it_reads(capsys, times, tmp_path):
    before = times.read_bytes()
    code, out, err = run(capsys, "swings", times, "--out", times)
    assert code == 2 and not out and "writing would destroy it" in err and times.read_bytes() == before
    times.write_text("0\nnan\n2\n")
    code, out, err = run(capsys, "swings", times)
    assert code == 2 and not out and "times must be numbers that rise" in err


def test_its_report_is_one(times):
    from swing_timer.report import time_swings

    found = time_swings(times)
    assert "2.0002" in found._repr_html_() and isinstance(found, ph.reports.Report)


def test_one_that_cannot_be_imported_is_named(add_entry_points, capsys):
    broken = ("broken", "nowhere:command")
    add_entry_points(foreign.GROUP, broken)
    code, _, err = run(capsys, "broken")
    assert code == 2 and "the command broken of another package, nowhere:command, cannot be imported" in err
    assert run(capsys, "brokn")[0] == 2
    add_entry_points(foreign.GROUP, ("odd", "math:pi"), broken)
    code, _, err = run(capsys, "odd")
    assert code == 2 and "the command odd of another package, math:pi, cannot be used" in err
    code, out, _ = run(capsys, "--help")
    assert code == 0 and "report " in out and "broken" not in out


def test_names_that_polhode_has_are_its_own(add_entry_points, capsys):
    add_entry_points(foreign.GROUP, ("report", "math:pi"))
    code, _, err = run(capsys, "--help")
    assert code == 0 and "the command report of another package, math:pi, is ignored" in err
    add_entry_points(named.TORQUES.group, ("constant", "math:pi"))
    with pytest.warns(UserWarning, match="the torque constant of another package, math:pi, is ignored"):
        assert "constant" not in named._others(named.TORQUES)

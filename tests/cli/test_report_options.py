"""Options of ``polhode report`` that wings and other packages bring."""

import json
import sys

import pytest

from polhode._base.plugins.wings import wing_points
from polhode.cli import report_options
from polhode.cli.main import main

SPEC = '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n[time]\nuntil = "1 s"\nsamples = 3\n'


@pytest.fixture(autouse=True)
def anew(plugin, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "box.toml").write_text(SPEC)


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments)])
    out, err = capsys.readouterr()
    return end.value.code or 0, out, err


def test_one_of_another_package_is_listed_and_writes(capsys, tmp_path):
    code, out, _ = run(capsys, "report", "--help")
    out = " ".join(out.split())
    assert code == 0 and "--card PATH" in out and "Also write name and summary as a Markdown file, PATH." in out
    assert out.index("--certificates") < out.index("--proof DIR") < out.index("--card PATH") < out.index("--help")
    code, out, _ = run(capsys, "report", "box.toml", "--json", "--card", "box.md")
    said = json.loads(out)
    assert code == 0 and said["files"][-1] == "box.md"
    assert (tmp_path / "box.md").read_text("utf-8") == f"# box\n\n{said['summary']}\n"
    assert "box.md" not in json.loads(run(capsys, "report", "box.toml", "--json")[1])["files"]


def test_mistakes_are_those_of_a_command(capsys, tmp_path):
    code, out, err = run(capsys, "report", "box.toml", "--card", "a", "--card", "b")
    assert code == 2 and not out and "--card is given 2 times" in err
    code, out, err = run(capsys, "report", "box.toml", "--crad", "a")
    assert code == 2 and not out and "--card" in err


def fail(report, path):
    """Also fail."""
    raise ZeroDivisionError("x")


def leave(report, path):
    """Leave."""
    sys.exit(0)


def give_number(report, path):
    """Give no lists."""
    return 3, 4


@pytest.mark.parametrize(("function", "why"), [
    (leave, "SystemExit: 0"), (give_number, "TypeError: 'int' object is not iterable"),
])  # fmt: skip
def test_one_that_leaves_or_gives_no_lists_is_named(capsys, add_entry_points, function, why):
    add_entry_points(report_options.GROUP, ("bad", f"{__name__}:{function.__name__}"))
    code, out, err = run(capsys, "report", "box.toml", "--bad", "a")
    assert code == 2 and not out and f"the option of report bad of another package fails ({why})" in err


def test_one_that_fails_is_named(capsys, add_entry_points):
    add_entry_points(report_options.GROUP, ("bad", f"{__name__}:fail"), ("gone", "nowhere:write"), ("json", "math:pi"))
    code, out, err = run(capsys, "report", "--help")
    assert code == 0 and "--bad PATH" in out and "gone" not in out
    assert "the option of report json of another package, math:pi, is ignored" in err
    code, out, err = run(capsys, "report", "box.toml", "--bad", "a")
    assert code == 2 and not out and "the option of report bad of another package fails (ZeroDivisionError: x)" in err
    code, out, err = run(capsys, "report", "box.toml", "--gone", "a")
    assert code == 2 and not out and "the option of report gone of another package, nowhere:write, cannot" in err
    assert run(capsys, "report", "box.toml")[0] == 0


def test_the_help_imports_no_wing(capsys, monkeypatch):
    point = wing_points(report_options.GROUP)["proof"]
    monkeypatch.delitem(sys.modules, point.module, raising=False)
    assert "--proof DIR" in run(capsys, "report", "--help")[1] and point.module not in sys.modules


def test_without_the_wing_there_is_no_such_option(capsys, monkeypatch):
    """The application has no list of its own."""
    assert wing_points(report_options.GROUP).keys() == {"proof"}
    monkeypatch.setattr(report_options, "wing_points", lambda group: {})
    code, _, err = run(capsys, "report", "box.toml", "--proof", "a")
    assert code == 2 and "--proof" in err

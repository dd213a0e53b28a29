"""``polhode view`` and ``polhode report --html``: where the page goes, and how they refuse."""

import json
import subprocess
import sys
import webbrowser

import pytest

from cli.specs import SPEC
from polhode.cli.main import main

NAMED = f'name = "</script> a body"{SPEC}'


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(NAMED)

    def run(*arguments):
        with pytest.raises(SystemExit) as stopped:
            main(list(arguments))
        out, err = capsys.readouterr()
        return stopped.value.code or 0, out, err

    return run


def test_page_is_named_after_the_spec_and_opened(run, tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(webbrowser, "open", lambda url: asked.append(url) or True)
    assert run("view", "case.toml") == (0, "case.html\n", "")
    assert asked == [(tmp_path / "case.html").as_uri()]
    assert run("view", "case.toml", "--no-open", "--out", "other.html")[0] == 0
    assert len(asked) == 1 and (tmp_path / "other.html").stat().st_size < 1_500_000
    monkeypatch.setattr(webbrowser, "open", lambda url: False)
    code, _, err = run("view", "case.toml")
    assert code == 0 and "there is no browser" in err


@pytest.mark.long
def test_report_puts_it_beside_the_figures(run, tmp_path):
    code, out, _ = run("report", "case.toml", "--html", "--json")
    files = json.loads(out)["files"]
    assert code == 0 and files[-1] == "case/page.html" and len(files) == 6
    assert "a body" in (tmp_path / "case" / "page.html").read_text("utf-8")


@pytest.mark.long
def test_it_is_all_or_nothing(run, tmp_path):
    (tmp_path / "taken" / "page.html").mkdir(parents=True)
    code, _, err = run("report", "case.toml", "--html", "--out", "taken")
    assert code == 2 and "is a folder, where a file has to go" in err
    assert [path.name for path in (tmp_path / "taken").iterdir()] == ["page.html"]


@pytest.mark.parametrize("out", ["nowhere/page.html", "case.toml/page.html", "."])
def test_places_that_cannot_be_written(run, tmp_path, out):
    code, printed, err = run("view", "case.toml", "--no-open", "--out", out)
    assert code == 2 and not printed and err.startswith("polhode: ") and err.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["case.toml"]


@pytest.mark.long
def test_page_of_a_free_body_needs_no_jax(tmp_path):
    text = (
        "import sys, polhode as ph; m = ph.FreeMotion((1, 2, 3), momentum=(0.3, 1.8, 1.5));"
        "ph.show(m.sample([0.0, 1.0]));"
        "sys.exit(len({'jax', 'matplotlib', 'xarray', 'trimesh'} & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", text], cwd=tmp_path, check=False).returncode == 0

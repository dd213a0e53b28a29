"""`polhode learn`: opens what was built, writes worksheets and keys, refuses with a remedy."""

import os

import pytest

from polhode.cli.main import main
from polhode.course import building, site
from polhode.course.exercises import read_chapter


def run(*arguments):
    with pytest.raises(SystemExit) as ended:
        main(["learn", *map(str, arguments)])
    return ended.value.code or 0


@pytest.fixture
def built(tmp_path):
    """A course of two chapters, inside built documentation."""
    (tmp_path / "docs" / "learn" / "panels").mkdir(parents=True)
    (tmp_path / "docs" / "learn" / "chapters").mkdir()
    for page in ("index", "chapters/01_things_that_turn", "chapters/02_omega_is_not_l"):
        (tmp_path / "docs" / "learn" / f"{page}.html").write_text("<p>")
    return tmp_path / "docs"


def test_opens_front_and_chapter(built, capsys):
    assert run("--from", built, "--no-open") == 0
    assert capsys.readouterr().out.strip().endswith("learn/index.html")
    for chapter in ("omega-is-not-l", 2, "02"):
        assert run(chapter, "--from", built / "learn", "--no-open") == 0
        assert capsys.readouterr().out.strip().endswith("02_omega_is_not_l.html")


def test_worksheet_has_the_numbers_of_its_seed(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run("two-surfaces", "--worksheet", "--seed", 4) == 0
    assert run(5, "--key", "--seed", 4, "--out", "k.html") == 0
    sheet, key = (tmp_path / "two-surfaces.html").read_text("utf-8"), (tmp_path / "k.html").read_text("utf-8")
    for exercise in read_chapter("two-surfaces").exercises:
        question = exercise.draw(4)
        assert question.text[:60] in sheet
        assert f"{question.answer:.5g}" in key
        assert question.solution[:40] not in sheet


def test_a_worksheet_and_its_key_are_written_together(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("two-surfaces", "--worksheet", "--key") == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["two-surfaces-key.html", "two-surfaces.html"]


@pytest.mark.parametrize(("arguments", "said"), [
    (["nosuch", "--worksheet"], "must be a number from 1 to 14 or one of"),
    (["15", "--key"], "must be a number from 1 to 14"),
    (["two-surface", "--worksheet"], "Did you mean two-surfaces"),
    (["--worksheet"], "name one of"),
    (["two-surfaces", "--seed", "3"], "Add --worksheet"),
    (["two-surfaces", "--worksheet", "--seed", "-3"], "from 0"),
    (["two-surfaces", "--worksheet", "--out", "a.pdf"], "must end with .html"),
    (["two-surfaces", "--worksheet", "--from", "x"], "Leave it out"),
    (["two-surfaces", "--worksheet", "--key", "--out", "a.html"], "two are written"),
    (["--from", "nowhere", "--no-open"], "holds no course"),
])  # fmt: skip
def test_mistakes_are_told_with_a_remedy(arguments, said, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run(*arguments) == 2
    assert said in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def checkout(tmp_path, monkeypatch):
    """A checkout with a course of one page, and no built course in the package."""
    (tmp_path / "learn").mkdir()
    (tmp_path / "pyproject.toml").write_text("")
    (tmp_path / "learn" / "conf.py").write_text('project = "turns"\n')
    (tmp_path / "learn" / "index.rst").write_text("Turns\n=====\n")
    monkeypatch.setattr(site, "CHECKOUT", tmp_path)
    monkeypatch.setattr(site, "SITE", tmp_path / "none")
    return tmp_path


def test_without_sphinx_a_checkout_says_what_to_install(checkout, monkeypatch, capsys):
    monkeypatch.setattr(building, "is_there", lambda module: module != "furo")
    assert run("--no-open") == 2
    said = capsys.readouterr().err
    assert "polhode needs furo, which is not installed. Run `" in said and said.count("\n") == 1
    assert not (checkout / "build").exists()


def test_a_package_without_sources_says_where_the_course_is(checkout, capsys):
    (checkout / "pyproject.toml").unlink()
    assert run("--no-open") == 2
    said = capsys.readouterr().err
    assert "comes with releases" in said and "--from" in said


@pytest.mark.long
def test_a_checkout_builds_the_course_when_its_sources_have_changed(checkout, monkeypatch, capsys):
    pytest.importorskip("sphinx", reason="needs the extra docs")
    monkeypatch.setattr(building, "is_there", lambda module: True)
    monkeypatch.setattr(building, "_last_change", lambda *folders: (checkout / "learn" / "index.rst").stat().st_mtime)
    front = checkout / "build" / "learn" / "index.html"
    for is_new in (True, False):
        assert run("--no-open") == 0
        out, err = capsys.readouterr()
        assert out == f"{front}\n" and ("building the course" in err) is is_new
    assert [path.name for path in (checkout / "build").iterdir()] == ["learn"]
    (checkout / "learn" / "index.rst").write_text("Spins\n=====\n")
    os.utime(checkout / "learn" / "index.rst", (front.stat().st_mtime + 10,) * 2)
    assert run("--no-open") == 0 and "Spins" in front.read_text("utf-8")


@pytest.mark.long
def test_a_course_that_cannot_be_built_leaves_the_older_one(checkout, monkeypatch, capsys):
    pytest.importorskip("sphinx", reason="needs the extra docs")
    monkeypatch.setattr(building, "is_there", lambda module: True)
    (checkout / "build" / "learn").mkdir(parents=True)
    (checkout / "learn" / "conf.py").write_text('raise ValueError("no such turn")\n')
    assert run("--no-open") == 2
    said = capsys.readouterr().err
    assert "Sphinx cannot build" in said and "no such turn" in said
    assert [path.name for path in (checkout / "build").iterdir()] == ["learn"]

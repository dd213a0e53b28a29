"""Forms of files register themselves, those of other packages too."""

import dataclasses
import re
import sys
from pathlib import Path

import numpy as np
import pytest

import polhode as ph
import polhode.cli.commands  # whose help lists the forms that are there now
from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput
from polhode.formats import form_registry
from polhode.studies.sources import detect_kind

PLUGIN = Path(__file__).parents[1] / "plugin"
SPEC = """[body]
moments = ["1 kg*m^2", "2 kg*m^2", "3 kg*m^2"]
[spin]
angular_velocity = ["0.1 rad/s", "1 rad/s", "0 rad/s"]
[time]
until = "3 s"
samples = 31
"""


@pytest.fixture
def folder(tmp_path, monkeypatch, plugin):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "box.toml").write_text(SPEC)
    yield tmp_path
    form_registry._others.cache_clear()  # which a test has changed


def run(capsys, *arguments):
    with pytest.raises(SystemExit) as end:
        main([*map(str, arguments)])
    out, err = capsys.readouterr()
    return end.value.code or 0, out, err


@pytest.mark.long
def test_it_is_exported_imported_compared_and_fitted(folder, capsys):
    code, out, _ = run(capsys, "export", "box.toml", "--to", "qlog")
    assert code == 0 and "box.qlog: 31 samples, attitudes of the given axes; every digit" in out
    assert detect_kind(folder / "box.qlog") == "qlog"
    wanted = ph.report("box.toml").trajectory
    rows = [[float(word) for word in line.split()] for line in (folder / "box.qlog").read_text().splitlines()[1:]]
    assert np.array_equal(np.array(rows)[:, 1:], wanted.attitude)
    code, out, _ = run(capsys, "import", "box.qlog")
    assert code == 0 and "QLOG with 31 attitudes" in out and (folder / "box_imported.nc").is_file()
    assert ph.compare("box.toml", "box.qlog").comparison.largest < 1e-12
    assert ph.fit("box.qlog").kind == "attitude-fit"


def test_the_docs_show_it_as_it_is():
    page = PLUGIN.parents[1] / "docs" / "add_a_format.md"
    assert (PLUGIN / "quaternion_log" / "__init__.py").read_text("utf-8") in page.read_text("utf-8")


def test_mistakes_name_what_is_wrong(folder, capsys, add_entry_points):
    code, _, err = run(capsys, "export", "box.toml", "--to", "qlg")
    assert code == 2 and "qlog" in err and "Did you mean" in err
    add_entry_points(form_registry.GROUP, ("odd", "nowhere:FORM"), ("no", "math:pi"))
    assert set(form_registry.forms()) >= {"aem", "netcdf"} and "odd" not in form_registry.forms()
    code, _, err = run(capsys, "export", "box.toml", "--to", "odd")
    assert code == 2 and "the format odd of another package, nowhere:FORM, cannot be imported" in err
    code, _, err = run(capsys, "export", "box.toml", "--to", "no")
    assert code == 2 and "the format no of another package, math:pi, is not a Form" in err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("0 1 0 0 0\n1 nan 0 0 0\n", "the attitude of sample 1 is not a unit quaternion"),
        ("0 2 0 0 0\n1 2 0 0 0\n", "the attitude of sample 0 is not a unit quaternion"),
        ("1 1 0 0 0\n0 1 0 0 0\n", "has times that fall"),
        ("", "cannot be read as the format qlog of another package|holds no samples"),
        ("0 1 0 0\n1 1 0 0 0\n", "cannot be read as the format qlog of another package"),
    ],
)
def test_what_its_reader_lets_pass_is_refused(folder, text, words, capsys):
    """Whatever another package's reader does, nothing wrong goes on, and nobody sees its traceback."""
    (folder / "bad.qlog").write_bytes(b"QLOG 1\n" + text.encode())
    for arguments in (("import", "bad.qlog"), ("compare", "box.toml", "bad.qlog"), ("fit", "bad.qlog")):
        code, out, err = run(capsys, *arguments)
        assert code == 2 and not out and re.search(words, err) and "bad.qlog" in err, arguments
    assert sorted(path.name for path in folder.iterdir()) == ["bad.qlog", "box.toml"]


def test_each_has_what_it_needs():
    for name, form in form_registry.forms().items():
        assert form.name == name and form.ending.startswith(".") and form.title
        assert form.write or form.read
        assert (form.read is None) == (form.begins is None and form.named is None)
        assert form.holds if form.write else True


def test_no_form_takes_the_file_of_another(folder):
    """One file of each form that is read is known as that, whatever the order in which forms are asked."""
    spec = ph.read_spec("box.toml")
    report = spec.report()
    from polhode.cli.export import gather_content

    content = gather_content(spec, report)
    for name in ("netcdf", "csv", "aem", "qlog"):
        form = form_registry.forms()[name]
        path = form.write(content, folder / f"one{form.ending}")
        head = path.read_bytes()[:65536]
        assert [other.name for other in form_registry.forms().values() if other.begins and other.begins(head)] == [name]
    (folder / "zeros.bin").write_bytes(bytes(100))
    with pytest.raises(FormatError, match="begins like none of them"):
        detect_kind(folder / "zeros.bin")


def test_the_table_in_the_documents_has_every_form():
    text = (Path(__file__).parents[2] / "docs" / "files.md").read_text("utf-8")
    rows = re.findall(r"^\| `(\w+)` \| `([^`]+)`", text, re.MULTILINE)
    own = {(form.name, form.ending) for form in form_registry.forms().values() if form.write and form.name != "qlog"}
    assert set(rows) == own


class Odd(Exception):
    """What nobody expects."""


def half_written(content, path):
    path.write_bytes(b"half")
    raise Odd("out of ideas")


def leave(content, path):
    sys.exit(0)


def readers():
    """Yield readers of a package that is broken, and what is said of each."""
    def raising(error):
        def read(path, kernels):
            raise error
        return read

    yield raising(Odd("out of ideas")), r"bad\.qlog: cannot be read as the format qlog of another package \(Odd: out of"
    yield raising(RuntimeError("out of ideas")), r"bad\.qlog: cannot be read as the format qlog .* \(RuntimeError: out"
    yield raising(SystemExit(0)), r"bad\.qlog: cannot be read as the format qlog .* \(SystemExit: 0\)"
    yield raising(FormatError("has no samples; a QLOG needs two.")), r"bad\.qlog: has no samples; a QLOG needs two"
    yield lambda path, kernels: None, r"bad\.qlog: the format qlog of another package gives None, not a Trajectory"


@pytest.mark.parametrize(("read", "words"), list(readers()), ids=["own error", "runtime", "exit", "format", "none"])
def test_readers_that_fail_in_any_way_are_told_in_words(folder, capsys, monkeypatch, read, words):
    broken = dataclasses.replace(form_registry.forms()["qlog"], read=read)
    monkeypatch.setitem(form_registry._others(), "qlog", broken)
    (folder / "bad.qlog").write_bytes(b"QLOG 1\n0 1 0 0 0\n")
    code, out, err = run(capsys, "import", "bad.qlog")
    assert code == 2 and not out and re.search(words, err) and err.count("\n") == 1


@pytest.mark.parametrize("error", [Odd("out of ideas"), SystemExit(0)], ids=["own", "exit"])
def test_one_that_fails_to_tell_whether_a_file_is_its_own_is_named(folder, capsys, monkeypatch, error):
    def begins(head):
        raise error

    broken = dataclasses.replace(form_registry.forms()["qlog"], begins=begins)
    monkeypatch.setitem(form_registry._others(), "qlog", broken)
    (folder / "zeros.bin").write_bytes(bytes(100))
    code, out, err = run(capsys, "import", "zeros.bin")
    words = f"the format qlog of another package fails ({type(error).__name__}: {error}). Update or remove it."
    assert code == 2 and not out and words in err and err.count("\n") == 1


@pytest.mark.parametrize(("write", "words"), [
    (leave, "box.qlog: the format qlog of another package cannot write it (SystemExit: 0)"),
    (half_written, "box.qlog: the format qlog of another package cannot write it (Odd: out of ideas)"),
    (lambda content, path: path, "box.qlog: the format qlog of another package wrote nothing"),
])  # fmt: skip
def test_writers_that_fail_leave_what_was_there(folder, capsys, monkeypatch, write, words):
    """Half a file stood in place of the old one, and other formats of the same command stayed."""
    broken = dataclasses.replace(form_registry.forms()["qlog"], write=write)
    monkeypatch.setitem(form_registry._others(), "qlog", broken)
    (folder / "box.qlog").write_bytes(b"old")
    code, _, err = run(capsys, "export", "box.toml", "--to", "csv", "--to", "qlog")
    assert code == 2 and words in err and err.count("\n") == 1
    with pytest.raises(InvalidInput, match=re.escape(words.partition(": ")[2])):
        ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample().save(folder / "box.qlog")
    assert (folder / "box.qlog").read_bytes() == b"old"
    assert sorted(path.name for path in folder.iterdir()) == ["box.qlog", "box.toml"]

"""Reports that commands keep: taken while they are still true, and never after."""

import dataclasses
import os
import subprocess
import sys
import time
import warnings
from pathlib import Path

import jaxtyping
import numpy as np
import pytest

from polhode._base.plugins import Plugin
from polhode.cli import entries, kept
from polhode.formats.dataset import write_dataset
from polhode.formats.labels import AttitudeLabels
from polhode.formats.opening import check_is_file
from polhode.kinds import page
from polhode.kinds.base import Spec
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import find_kind

SPEC = """
name = "a body"
[body]
mesh = "box.obj"
mesh_unit = "m"
mass = "1 kg"
[spin]
rate = "60 rpm"
about = 2
tilt = "1 deg"
[time]
until = "3 s"
samples = 20
"""
BOX = """v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 0\nv 0 0 3\nv 1 0 3\nv 0 2 3\nv 1 2 3
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"""


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.setenv(entries.FOLDER, str(tmp_path / "kept"))
    (tmp_path / "box.obj").write_text(BOX)
    (tmp_path / "case.toml").write_text(SPEC)
    return tmp_path


def computed(spec, monkeypatch):
    """Return the report, and whether it was computed."""
    calls = []
    original = Spec.report
    with monkeypatch.context() as patch:
        patch.setattr(Spec, "report", lambda self: calls.append(1) or original(self))
        return kept.load_or_make_report(spec), bool(calls)


def files(case):
    return sorted((case / "kept").glob("*"))


def test_a_report_is_computed_once(case, monkeypatch):
    path = case / "case.toml"
    first, new = computed(read_spec(path), monkeypatch)
    again, anew = computed(read_spec(path), monkeypatch)
    assert new and not anew and len(files(case)) == 1
    assert again.as_json_dict() == first.as_json_dict() and again.summary == first.summary
    assert np.array_equal(again.trajectory.states, first.trajectory.states)


@pytest.mark.parametrize(("file", "old", "new"), [
    ("case.toml", "60 rpm", "60.000000000000007 rpm"), ("case.toml", "about = 2", "about = 1"),
    ("case.toml", "samples = 20", "samples = 21"), ("case.toml", "3 s", "4 s"), ("case.toml", "1 kg", "2 kg"),
    ("case.toml", "a body", "another"), ("box.obj", "v 1 2 3", "v 1 2 3.0000000000000004"),
    ("case.toml", "[time]", "[export]\nobject_id = 'X'\n[time]"), ("case.toml", '"m"', '"mm"'),
])  # fmt: skip
def test_whatever_changes_is_computed_again(case, monkeypatch, file, old, new):
    computed(read_spec(case / "case.toml"), monkeypatch)
    text = (case / file).read_text()
    assert text.count(old) == 1
    (case / file).write_text(text.replace(old, new))
    spec = read_spec(case / "case.toml")
    found, again = computed(spec, monkeypatch)
    assert again and found.as_json_dict() == spec.report().as_json_dict()


def test_every_field_of_a_spec_counts(case, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)  # any other value does
    spec = read_spec(case / "case.toml")
    others = {"name": "b", "system": 1, "body": None, "spin": None, "until": 3.5, "samples": 7,
              "labels": AttitudeLabels("b"), "source": None, "folder": Path("elsewhere"), "instants": (0.0, 2.0),
              "kind": find_kind("gyrostat"), "body_notes": ("rounded",),
              "plugins": (Plugin("polhode.torques", "a", "b:C"),)}  # fmt: skip
    assert others.keys() == {field.name for field in dataclasses.fields(Spec)}
    digests = {kept._digest(dataclasses.replace(spec, **{name: value})) for name, value in others.items()}
    assert len(digests | {kept._digest(spec)}) == len(others) + 1


def test_another_program_computes_again(case, monkeypatch):
    spec = read_spec(case / "case.toml")
    computed(spec, monkeypatch)
    monkeypatch.setenv("XLA_FLAGS", "--xla_backend_optimization_level=0")
    assert computed(spec, monkeypatch)[1]


@pytest.mark.sweep
def test_a_report_that_goes_on_from_another_file(case, monkeypatch):
    """What a spec names without its content being among its values: the earlier run of a fluid, of 20 and of 40 ms."""
    first = find_kind("sphere-fluid").example.replace("resolution = 10", "resolution = 6").replace("41", "3")
    (case / "first.toml").write_text(first)
    started = 'start_from = "run.nc"\n[time]\nuntil = "10 ms"\nsamples = 3\n'
    (case / "second.toml").write_text(first[: first.index("random")] + started)
    (case / "later.toml").write_text(first.replace("20 ms", "40 ms"))
    write_dataset(read_spec(case / "first.toml").report().trajectory, case / "run.nc")
    one, new = computed(read_spec(case / "second.toml"), monkeypatch)
    assert new and not computed(read_spec(case / "second.toml"), monkeypatch)[1]
    write_dataset(read_spec(case / "later.toml").report().trajectory, case / "run.nc")
    other, new = computed(read_spec(case / "second.toml"), monkeypatch)
    assert new and not np.array_equal(one.trajectory.states[0], other.trajectory.states[0])


@pytest.mark.parametrize("damaged", [b"", b"\x80\x05", b"\x80\x04N.\x80\x04N.", b"not a pickle"])
def test_what_is_damaged_is_computed_again(case, monkeypatch, damaged):
    spec = read_spec(case / "case.toml")
    first, _ = computed(spec, monkeypatch)
    files(case)[0].write_bytes(damaged)
    found, again = computed(spec, monkeypatch)
    assert again and found.as_json_dict() == first.as_json_dict()
    assert not computed(spec, monkeypatch)[1]


def test_a_folder_that_cannot_be_written_changes_nothing(case, monkeypatch):
    (case / "file").write_text("")
    monkeypatch.setenv(entries.FOLDER, str(case / "file"))
    assert computed(read_spec(case / "case.toml"), monkeypatch)[1]


def test_the_oldest_go(case, monkeypatch):
    monkeypatch.setattr(entries, "MOST", 3)
    spec = read_spec(case / "case.toml")
    for k in range(4):
        changed = dataclasses.replace(spec, samples=20 + k)
        kept.load_or_make_report(changed)
        newest = max(files(case), key=lambda path: path.stat().st_mtime)
        os.utime(newest, (1e9 + k, 1e9 + k))
        if k == 2:  # used again, it is no longer the oldest
            kept.load_or_make_report(spec)
    assert len(files(case)) == 3
    assert not computed(spec, monkeypatch)[1]
    assert computed(dataclasses.replace(spec, samples=21), monkeypatch)[1]


def test_large_ones_are_not_kept(case, monkeypatch):
    monkeypatch.setattr(entries, "LARGEST", 1000)
    spec = read_spec(case / "case.toml")
    assert computed(spec, monkeypatch)[1] and computed(spec, monkeypatch)[1] and not files(case)


def test_kinds_of_others_and_unknown_values_are_computed(case, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    spec = read_spec(case / "case.toml")
    foreign = type("Foreign", (type(spec.kind),), {"__module__": "elsewhere"})
    for odd in (dataclasses.replace(spec, kind=foreign()), dataclasses.replace(spec, system={1, 2})):
        assert computed(odd, monkeypatch)[1] and not files(case)


def made(spec, monkeypatch):
    """Return the text of the page, and whether it was made."""
    calls, original = [], page.page_of_answers
    with monkeypatch.context() as patch:
        patch.setattr(page, "page_of_answers", lambda *given: calls.append(1) or original(*given))
        begun = time.time_ns()
        return kept.load_or_make_page(spec, kept.load_or_make_report(spec), begun).text, bool(calls)


def test_a_page_is_made_once(case, monkeypatch):
    path = case / "case.toml"
    first, new = made(read_spec(path), monkeypatch)
    assert new and made(read_spec(path), monkeypatch) == (first, False)
    assert [file.suffix for file in files(case)] == [".page", ".report"]
    (case / "case.toml").write_text(SPEC.replace("60 rpm", "61 rpm"))
    other, new = made(read_spec(path), monkeypatch)
    assert new and other != first
    (case / "case.toml").write_text(SPEC)
    for file in files(case):
        if file.suffix == ".page":
            file.write_bytes(b"not a page")
    assert made(read_spec(path), monkeypatch) == (first, True)
    assert made(read_spec(path), monkeypatch) == (first, False)


def test_a_page_is_made_again_where_a_file_of_the_report_changed(case, monkeypatch):
    """Such as an earlier run, which the spec names without its content being among its values."""
    earlier, original = case / "earlier.nc", Spec.report
    earlier.write_bytes(b"a run")

    def report(spec):
        check_is_file(earlier, "a run")
        return original(spec)

    monkeypatch.setattr(Spec, "report", report)
    spec = read_spec(case / "case.toml")
    assert made(spec, monkeypatch)[1] and not made(spec, monkeypatch)[1]
    earlier.write_bytes(b"another run")
    assert made(spec, monkeypatch)[1] and not made(spec, monkeypatch)[1]


class Earlier:
    """An earlier run that the page reads, if that is its moment, or else the report; another process replaces it."""

    def __init__(self, case, monkeypatch, moment):
        self.path, self.moment = case / "earlier.nc", moment
        self.path.write_bytes(b"a run")
        report, of_answers = Spec.report, page.page_of_answers

        def report_on_it(spec):
            self.read_and_replace(self.moment != "page", "report")
            return report(spec)

        def page_of_it(*given):
            self.read_and_replace(self.moment == "page", "page")
            return of_answers(*given)

        monkeypatch.setattr(Spec, "report", report_on_it)
        monkeypatch.setattr(page, "page_of_answers", page_of_it)

    def read_and_replace(self, reads, moment):
        if reads:
            check_is_file(self.path, "a run")
        if moment == self.moment:
            other = self.path.with_name("other.nc")
            other.write_bytes(b"another run")
            os.utime(other, (1e9, 1e9))  # as a file that was copied may be older than the one in whose place it goes
            other.replace(self.path)


def test_a_report_is_not_kept_where_a_file_was_replaced_meanwhile(case, monkeypatch):
    """The numbers are of the file that was read, and would be taken for those of the one that is there now."""
    earlier, spec = Earlier(case, monkeypatch, "report"), read_spec(case / "case.toml")
    kept.load_or_make_report(spec)
    assert not files(case)
    earlier.moment = ""
    kept.load_or_make_report(spec)
    assert len(files(case)) == 1


@pytest.mark.parametrize("moment", ["between", "page"])
def test_a_page_is_not_kept_where_a_file_was_replaced_meanwhile(case, monkeypatch, moment):
    earlier, spec = Earlier(case, monkeypatch, moment), read_spec(case / "case.toml")
    begun = time.time_ns()
    report = kept.load_or_make_report(spec)
    earlier.read_and_replace(False, "between")
    if moment == "between":  # and another process has kept the report on the new file by then
        kept.load_or_make_report(spec)
    kept.load_or_make_page(spec, report, begun)
    assert [file.suffix for file in files(case)] == [entries.REPORT]


@pytest.mark.parametrize("warns", ["report", "page_of_answers"])
def test_what_warned_is_not_kept(case, monkeypatch, warns):
    owner = {"report": Spec, "page_of_answers": page}[warns]
    original, spec = getattr(owner, warns), read_spec(case / "case.toml")

    def warn(*given):
        warnings.warn("a doubt", stacklevel=2)
        return original(*given)

    monkeypatch.setattr(owner, warns, warn)
    for _ in range(2):
        with pytest.warns(UserWarning, match="a doubt"):
            kept.load_or_make_page(spec, kept.load_or_make_report(spec), time.time_ns())
    assert [file.suffix for file in files(case)] == ([entries.REPORT] if warns == "page_of_answers" else [])


def test_files_that_may_have_changed(case):
    file = case / "box.obj"
    after = max(file.stat().st_mtime_ns, file.stat().st_ctime_ns) + 1
    assert not entries.may_have_changed([file], after) and entries.may_have_changed([file], after - 1)
    os.utime(file, (1e9, 1e9))  # by which only its time of writing is older
    assert entries.may_have_changed([file], after - 1)
    assert entries.may_have_changed([case / "gone"], after) and not entries.may_have_changed([], 0)


@pytest.mark.long
def test_the_library_keeps_nothing(tmp_path):
    code = "import os, sys, polhode as ph; ph.report(sys.argv[1]); assert 'POLHODE_REPORTS_CACHE' not in os.environ"
    (tmp_path / "case.toml").write_text(SPEC)
    (tmp_path / "box.obj").write_text(BOX)
    environment = {k: v for k, v in os.environ.items() if k != entries.FOLDER} | {"XDG_CACHE_HOME": str(tmp_path / "c")}
    subprocess.run([sys.executable, "-c", code, str(tmp_path / "case.toml")], env=environment, check=True, timeout=120)
    assert not (tmp_path / "c").exists()


@pytest.mark.sweep
def test_commands_take_what_another_computed(case, tmp_path, monkeypatch):
    """In processes of their own; arrays of JAX keep their 64 bits."""
    # else commands choose flags for their own process, and this one takes their reports for another program's
    monkeypatch.setenv("XLA_FLAGS", "--xla_cpu_enable_fast_math=false")
    (case / "moon.toml").write_text(find_kind("spin-orbit").example)
    environment = os.environ | {"XDG_CACHE_HOME": str(tmp_path / "c")}

    def run(*arguments):
        command = [sys.executable, "-c", "from polhode.cli.main import main; main()", *arguments]
        done = subprocess.run(command, cwd=case, env=environment, stdout=subprocess.PIPE, timeout=300, check=True)
        return done.stdout

    run("report", "moon.toml", "--json")
    before = {path: path.stat().st_mtime_ns for path in files(case)}
    run("view", "moon.toml", "--no-open")
    after = {path: path.stat().st_mtime_ns for path in files(case)}
    (report,) = (path for path in before if path.suffix == entries.REPORT)
    assert after.keys() == {*before, report.with_suffix(entries.PAGE)} and after[report] != before[report]
    shown = (case / "moon.html").read_bytes()
    run("view", "moon.toml", "--no-open")
    assert (case / "moon.html").read_bytes() == shown
    state = kept._load_report(report).trajectory
    assert state.states.dtype == np.float64

"""Every file that polhode writes for itself and reads back is what was written, or as if it were not there."""

import ast
import json
import os
import stat
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

import polhode
from polhode._base import seals
from polhode._base.arrays.kept_programs import SealedPrograms
from polhode._base.compiled import entries as images
from polhode._base.seals import drop_oldest, read_sealed, seal, unseal, write_sealed
from polhode.cli import compiled, entries, kept, written
from polhode.cli.report import run_report
from polhode.kinds.reading import read_spec
from polhode.spec import kept_units
from polhode.sweeps import marks
from polhode.sweeps.plan import read_plan
from polhode.sweeps.running import Sweep

SOURCES = Path(polhode.__file__).parent
FLIPS, MANY_FLIPS, SEED = 60, 400, 46
LARGE = 10**8
SEALED = {
    "report": "cli/entries.py", "page": "cli/entries.py", "what a report wrote": "cli/entries.py",
    "mark of a chunk": "sweeps/marks.py",
    "compiled by JAX": "_base/arrays/kept_programs.py", "compiled by Numba": "_base/compiled/compiling.py",
    "image": "_base/compiled/entries.py",
    "table of units": "spec/kept_units.py", "flags of the compiler": "cli/compiled.py",
}  # fmt: skip
"""What is kept under a seal, and by which file.

Not under a seal of its own, and why: arrays of a sweep, whose SHA-256 are in the marks; its plan and its documents, of
which nothing is taken, as they are compared with what the sweep says (``tests/sweeps/test_damaged_stores.py`` damages
all of these); locks, which are empty. Python's own compiled files and matplotlib's list of fonts are not polhode's.
"""
# the last one what it has pickled
UNPICKLING = {"cli/kept.py", "_base/compiled/compiling.py", "_base/compiled/entries.py", "testing/kinds.py"}
CACHES = {"POLHODE_REPORTS_CACHE", "POLHODE_UNITS_CACHE", "POLHODE_COMPILED_CACHE"}
SPEC = """
[body]
moments = ["1 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]
[spin]
rate = "60 rpm"
about = 2
tilt = "1 deg"
[time]
until = "3 s"
samples = 20
[sweep]
outputs = ["energy"]
chunk = 2
[sweep.inputs]
"spin.rate" = { grid = ["60 rpm", "61 rpm", "62 rpm"] }
"""


def calls(path):
    """Return the names of functions that a file calls, the last part of dotted ones after that of their module."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Call):
            name = node.func
            if isinstance(name, ast.Attribute):
                found |= {name.attr, f"{getattr(name.value, 'id', '')}.{name.attr}"}
            elif isinstance(name, ast.Name):
                found.add(name.id)
    return found


def test_the_table_has_every_file_that_keeps_something():
    by_file = {path.relative_to(SOURCES).as_posix(): calls(path) for path in SOURCES.rglob("*.py")}
    reads = {name for name, called in by_file.items() if called & {"read_sealed", "unseal"}} - {"_base/seals.py"}
    writes = {name for name, called in by_file.items() if called & {"write_sealed", "seal"}} - {"_base/seals.py"}
    assert reads == writes == set(SEALED.values())
    loads = {"pickle.load", "pickle.loads", "pickle.Unpickler", "marshal.loads", "marshal.load", "shelve.open"}
    assert {name for name, called in by_file.items() if called & loads} == UNPICKLING
    assert SEALED.keys() == {*WHOLE}


def test_the_table_has_every_folder_of_the_users_cache():
    code = ("import os; before = set(os.environ); from polhode.cli.compiled import keep_compiled; keep_compiled()\n"
            "print(*(name for name in set(os.environ) - before if name.endswith(('_CACHE', '_DIR'))))")  # fmt: skip
    left = {key: value for key, value in os.environ.items() if key not in CACHES and not key.startswith("JAX_")}
    done = subprocess.run([sys.executable, "-c", code], env=left, capture_output=True, text=True, check=True)
    assert set(done.stdout.split()) == CACHES


# ---------------------------------------------------------------------- a bit that is lost


def flipped(content, count):
    """Yield the content with one bit changed, at random places and at both ends."""
    rng = np.random.default_rng(SEED)
    ends = [*range(0, 80), *range(len(content) - 8, len(content))]
    places = [*rng.choice(ends, count // 4), *rng.integers(len(content), size=count - count // 4)]
    for place in places:
        changed = bytearray(content)
        changed[place] ^= 1 << int(rng.integers(8))
        yield bytes(changed)


@pytest.fixture
def spec(tmp_path, monkeypatch):
    monkeypatch.setenv(entries.FOLDER, str(tmp_path / "kept"))
    (tmp_path / "case.toml").write_text(SPEC)
    return read_spec(tmp_path / "case.toml")


def facts(report):
    return None if report is None else [report.as_json_dict(), report.summary, report.trajectory.states.tobytes()]


def a_report(folder, spec):
    kept.load_or_make_report(spec)
    place = kept._place(spec)
    return place, lambda: facts(kept._load_report(place))


def a_page(folder, spec):
    begun = time.time_ns()
    kept.load_or_make_page(spec, kept.load_or_make_report(spec), begun)
    place = kept._place(spec).with_suffix(kept.PAGE)
    return place, lambda: kept._load_page(place)


def what_a_report_wrote(folder, spec):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # old libraries warn of others, and nothing that warned is kept
        run_report(folder / "case.toml", True, folder / "out", [])
    asked = written.Asked(folder / "case.toml", ["png"], False)

    def read():
        again = written.write_again(asked, folder / "again")
        if again is None:
            return None
        assert not again.more
        return again.report.as_json_dict(), again.following, {
            name: (folder / "again" / name).read_bytes() for name in again.files}  # fmt: skip

    return asked.place, read


def a_mark(folder, spec):
    sweep = Sweep.of(read_plan(folder / "case.toml"))
    store = sweep.begin(folder / "a.zarr")
    sweep.run(store, 1)
    place = store._mark(1)
    return place, lambda: marks.read_mark(place.read_bytes(), 1, sweep.layout)


def a_program_of_jax(folder, spec):
    store = SealedPrograms(folder / "programs")
    store.put("jit_f-0", np.random.default_rng(1).bytes(3000))
    return store._place("jit_f-0"), lambda: store.get("jit_f-0")


def a_function_of_numba(folder, spec):
    """Numba's index of a function's files, and a file, joined in one for this test."""
    from polhode._base.compiled.compiling import _SealedFiles

    files = _SealedFiles(str(folder), "f-1.py311", "stamp")
    files.save("float64", {"code": np.random.default_rng(1).bytes(3000)})
    return Path(files._index_path), lambda: files.load("float64")


def an_image(folder, spec):
    place = folder / "f.kernel"
    write_sealed(place, np.random.default_rng(1).bytes(3000))
    return place, lambda: read_sealed(place, images.LIMITS.max_bytes)


def a_table_of_units(folder, spec):
    kept_units.load_registry(folder / "units")
    (place,) = (folder / "units").iterdir()
    return place, lambda: read_sealed(place, kept_units.LIMITS.max_bytes)


def the_compilers_flags(folder, spec):
    """In a folder that stands for the user's, by a compiler that knows them all."""
    import platformdirs

    flags = ("--one", "--two")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(platformdirs, "user_cache_path", lambda name: folder / name)
        patch.setattr(compiled, "_starts_with", lambda flags: True)
        compiled._known_flags(flags)
    (place,) = (folder / "polhode" / "flags").iterdir()
    return place, lambda: read_sealed(place, compiled.LIMITS.max_flag_bytes)


WHOLE = {"report": a_report, "page": a_page, "what a report wrote": what_a_report_wrote,
         "mark of a chunk": a_mark, "compiled by JAX": a_program_of_jax,
         "compiled by Numba": a_function_of_numba, "image": an_image, "table of units": a_table_of_units,
         "flags of the compiler": the_compilers_flags}  # fmt: skip


def check_flips(tmp_path, spec, product, count):
    place, read = WHOLE[product](tmp_path, spec)
    wanted = read()
    assert wanted is not None
    for file in sorted(place.parent.glob(f"{place.stem}*")) if product == "compiled by Numba" else [place]:
        content = file.read_bytes()
        for changed in flipped(content, count):
            file.write_bytes(changed)
            assert read() is None
        file.write_bytes(content)
        assert read() == wanted


@pytest.mark.parametrize("product", SEALED)
def test_a_lost_bit(tmp_path, spec, product):
    """Of pickled reports, 118 of 400 bits changed numbers or sentences without a word."""
    check_flips(tmp_path, spec, product, FLIPS)


@pytest.mark.sweep
@pytest.mark.parametrize("product", SEALED)
def test_many_lost_bits(tmp_path, spec, product):
    check_flips(tmp_path, spec, product, MANY_FLIPS)


def test_a_damaged_report_is_computed_again(tmp_path, spec):
    place, read = a_report(tmp_path, spec)
    wanted, content = read(), place.read_bytes()
    for changed in flipped(content, 4):
        place.write_bytes(changed)
        assert facts(kept.load_or_make_report(spec)) == wanted
        assert read() == wanted  # and kept again


def test_a_damaged_table_of_units_is_read_again(tmp_path):
    place, read = a_table_of_units(tmp_path, None)
    whole = read()
    place.write_bytes(next(flipped(place.read_bytes(), 4)))
    assert read() is None
    assert kept_units.load_registry(tmp_path / "units").parse_units("rpm") is not None and read() is not None
    assert json.loads(read()).keys() == json.loads(whole).keys()


@pytest.mark.sweep
def test_a_damaged_function_is_compiled_again(tmp_path):
    """By JAX and by Numba, in processes of their own."""
    (tmp_path / "formulas.py").write_text("def f(x):\n    return 3.0 * x\n")
    code = ("import polhode.algebra, jax, formulas; from polhode._base.compiled.compiling import CompiledFunction\n"
            "print(float(jax.jit(lambda x: 2.0 * x)(1.5)), CompiledFunction('formulas', formulas.f)(1.5))")  # fmt: skip
    left = {key: value for key, value in os.environ.items() if not key.startswith(("JAX_COMP", "POLHODE_"))}
    environment = left | {"POLHODE_COMPILED_CACHE": str(tmp_path / "jax"), "NUMBA_CACHE_DIR": str(tmp_path / "numba"),
                          "PYTHONPATH": str(tmp_path), "JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS": "0",
                          "JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES": "-1"}  # fmt: skip

    def run():
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
        return done.stdout.split()

    assert run() == ["3.0", "4.5"]
    files = [*(tmp_path / "jax").glob("*-cache"), *(tmp_path / "numba").rglob("*.nb?")]
    assert {file.suffix for file in files} >= {".nbi", ".nbc"} and any("jit" in file.name for file in files)
    nodes = {file: file.stat().st_ino for file in files}
    assert run() == ["3.0", "4.5"] and {file: file.stat().st_ino for file in files} == nodes  # all of it was taken
    for k in range(6):
        for file in files:
            file.write_bytes([*flipped(file.read_bytes(), 6)][k])
        assert run() == ["3.0", "4.5"]
        assert all(unseal(file.read_bytes()) is not None for file in files)


# ---------------------------------------------------------------------- whose, and where


def test_what_was_sealed_comes_back(tmp_path):
    place = tmp_path / "new" / "folder" / "entry"
    for content in (b"", b"numbers", b"a\nb\n", bytes(range(256)) * 100):
        write_sealed(place, content)
        assert read_sealed(place, len(content)) == content and unseal(seal(content)) == content
    assert read_sealed(place, len(content) - 1) is None and read_sealed(tmp_path / "none", 10) is None
    assert [path.name for path in place.parent.iterdir()] == ["entry"]


def test_what_came_with_the_code_may_be_anybodys(tmp_path):
    """As in an environment that another user has installed; a lost bit is seen there, too."""
    place = tmp_path / "shipped"
    write_sealed(place, b"numbers")
    place.chmod(0o664)
    assert read_sealed(place, 10) is None and read_sealed(place, 10, installed=True) == b"numbers"
    place.write_bytes(place.read_bytes()[:-1] + b"t")
    assert read_sealed(place, 10, installed=True) is None


def test_under_another_name_it_is_not_there(tmp_path):
    write_sealed(tmp_path / "one", b"numbers")
    (tmp_path / "one").rename(tmp_path / "two")
    assert read_sealed(tmp_path / "two", LARGE) is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="modes of files are Unix's")
@pytest.mark.parametrize("mode", [0o622, 0o602, 0o620, 0o666])
def test_what_others_may_have_written_is_not_read(tmp_path, mode):
    before = os.umask(0)
    try:
        write_sealed(tmp_path / "folder" / "entry", b"numbers")
    finally:
        os.umask(before)
    place = tmp_path / "folder" / "entry"
    assert stat.S_IMODE(place.stat().st_mode) == 0o600 and stat.S_IMODE(place.parent.stat().st_mode) == 0o700
    place.chmod(mode)
    assert read_sealed(place, LARGE) is None
    place.chmod(0o644)
    assert read_sealed(place, LARGE) == b"numbers"


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="users are Unix's")
@pytest.mark.parametrize(("owner", "read"), [(1000, True), (0, True), (1001, False)])
def test_only_files_of_this_user_and_of_root_are_read(monkeypatch, owner, read):
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    status = os.stat_result((stat.S_IFREG | 0o600, 0, 0, 1, owner, 0, 5, 0, 0, 0))
    assert seals._is_of_this_user(status) == read


def test_what_is_no_file_is_not_there(tmp_path):
    write_sealed(tmp_path / "entry", b"numbers")
    (tmp_path / "link").symlink_to(tmp_path / "entry")
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    for name in ("link", "folder", "pipe", "nul\0"):
        assert read_sealed(tmp_path / name, LARGE) is None


def test_readers_see_whole_files_alone(tmp_path):
    place, contents = tmp_path / "entry", [bytes([k]) * 200_000 for k in range(4)]
    write_sealed(place, contents[0])
    writers = [threading.Thread(target=lambda content=content: [write_sealed(place, content) for _ in range(20)])
               for content in contents]  # fmt: skip
    for writer in writers:
        writer.start()
    seen = []
    while any(writer.is_alive() for writer in writers):
        seen.append(read_sealed(place, LARGE))
    for writer in writers:
        writer.join()
    assert seen and set(seen) <= set(contents) and list(tmp_path.iterdir()) == [place]


def test_nothing_is_left_of_what_cannot_be_written(tmp_path, monkeypatch):
    write_sealed(tmp_path / "entry", b"numbers")

    def refuse(self, target):
        raise OSError("no room")

    monkeypatch.setattr(Path, "replace", refuse)
    with pytest.raises(OSError, match="no room"):
        write_sealed(tmp_path / "entry", b"others")
    assert list(tmp_path.iterdir()) == [tmp_path / "entry"] and read_sealed(tmp_path / "entry", LARGE) == b"numbers"


def test_the_oldest_go_first(tmp_path):
    files = [tmp_path / str(k) for k in range(6)]
    for k, file in enumerate(files):
        file.write_bytes(b"x" * 10)
        os.utime(file, (1e9 + k, 1e9 + k))
    (tmp_path / "folder").mkdir()
    drop_oldest(tmp_path.iterdir(), 4)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["2", "3", "4", "5", "folder"]
    drop_oldest(tmp_path.iterdir(), 4, 25)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["4", "5", "folder"]


@pytest.mark.parametrize("head", [
    b"", b"{}", b"not JSON", b"[1]", b'{"format":0,"program":"a","plugins":[],"read":{},"jax":false}',
    b'{"format":1,"program":"a","plugins":[],"read":{},"jax":false}',
    b'{"format":1,"program":"a","plugins":[["no.group","a","b"]],"read":{},"jax":false}'])  # fmt: skip
def test_entries_of_other_versions_are_not_taken(tmp_path, spec, head):
    place, read = a_report(tmp_path, spec)
    write_sealed(place, head + b"\n" + b"cos\nsystem\n(S'false'\ntR.")
    assert read() is None
    assert facts(kept.load_or_make_report(spec)) is not None and read() is not None


def test_a_report_that_is_none_is_computed(tmp_path, spec):
    place, read = a_report(tmp_path, spec)
    whole = read_sealed(place, LARGE)
    head = whole.partition(b"\n")[0]
    for packed in (b"", b"\x80\x04N.", b"(lp0\n."):
        write_sealed(place, head + b"\n" + packed)
        assert read() is None


def test_jax_takes_our_store():
    """Where it takes none, nothing is kept; this says that the newest JAX still does."""
    from jax._src import compilation_cache

    assert callable(compilation_cache.get_file_cache)


def test_numba_takes_our_files(tmp_path, monkeypatch):
    from numba import config

    from polhode._base.compiled.compiling import CompiledFunction, _SealedFiles

    monkeypatch.setattr(config, "CACHE_DIR", str(tmp_path))
    made = CompiledFunction("formulas", lambda x: 3.0 * x)
    assert isinstance(made.dispatcher._cache._cache_file, _SealedFiles)

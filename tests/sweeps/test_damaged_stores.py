"""Stores damaged in many ways: what is said of one is what is said of the whole one, or a refusal in a sentence."""

import json
import os
import shutil
import signal
import warnings
from contextlib import contextmanager

import numpy as np
import pytest

from polhode.cli.main import main
from polhode.errors import FormatError, InvalidInput, PolhodeError
from polhode.sweeps.answers import SweepReport
from polhode.sweeps.marks import read_mark
from polhode.sweeps.plan import read_plan
from polhode.sweeps.running import Sweep
from sweeps import damage

LONGEST = 20  # s for a store of five chunks, of which one takes a hundredth
SPEC = """
[body]
moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]
[spin]
about = 2
rate = "120 rpm"
[sweep]
samples = 150
seed = 7
chunk = 40
keep = "KEEP"
outputs = ["form", "polhode_period", "states.attitude"]
times = ["1 s", "20 s"]
[sweep.inputs]
"spin.tilt" = { uniform = ["0 deg", "90 deg"] }
"body.moments.3" = { uniform = ["2.5 g*cm^2", "3.3 g*cm^2"] }
"""
KEPT = ("all", pytest.param("statistics", marks=pytest.mark.sweep))
FORGED = (damage.forged_mark, damage.negative_counts)  # which a seal cannot tell; they must do no other harm


@contextmanager
def in_time():
    """Fail where something waits for ever, as on a pipe that nobody writes to."""

    def stop(number, frame):
        raise TimeoutError("it hangs")

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


@pytest.fixture(scope="module", params=KEPT)
def made(request, tmp_path_factory):
    """A sweep, its store, its files and what is said of it."""
    place = tmp_path_factory.mktemp("whole")
    (place / "case.toml").write_text(SPEC.replace("KEEP", request.param))
    sweep = Sweep.of(read_plan(place / "case.toml"))
    said = run(sweep, place / "a.zarr")
    return sweep, place / "a.zarr", contents(place / "a.zarr"), said


def run(sweep, path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # that something is computed again
        store = sweep.begin(path)
        sweep.run(store, 1)
    return SweepReport(sweep, store).as_json_dict()


def contents(store):
    return {path.relative_to(store): path.read_bytes() for path in damage.files(store) if path.name != "lock"}


def damaged(made, tmp_path, way, number, stopped):
    """Return a copy of the store that was damaged in a way, after it was stopped or not; None where it has none."""
    _, whole, _, _ = made
    rng = np.random.default_rng([number, stopped, damage.WAYS.index(way)])
    shutil.rmtree(tmp_path / "place", ignore_errors=True)
    store = tmp_path / "place" / "a.zarr"
    shutil.copytree(whole, store)
    if stopped:
        damage.pick(rng, damage.files(store, "/chunks/")).unlink()
    try:
        way(store, rng)
    except damage.NothingThere:
        return None
    return store


def check(made, store, forged):
    sweep, _, files, said = made
    try:
        with in_time():
            found = run(sweep, store)
    except PolhodeError as error:
        assert len(error.args) == 1 and 20 < len(str(error)) < 1000 and "`store`" in str(error), str(error)
        return False
    assert forged or found == said
    left = contents(store)
    assert forged or all(left[name] == content for name, content in files.items() if content != left[name]
                         and name.name not in (".zattrs", ".zmetadata"))  # fmt: skip
    return True


def check_many(made, tmp_path, cases):
    """Return how many damaged stores said the same as the whole one, and how many were refused."""
    same, refused = 0, 0
    for way, number, stopped in cases:
        store = damaged(made, tmp_path, way, number, stopped)
        if store is None:
            continue
        try:
            good = check(made, store, way in FORGED)
        except BaseException as error:
            error.add_note(f"damaged by {way.__name__}, {number}, {stopped}")
            raise
        same, refused = same + good, refused + (not good)
    return same, refused


def test_a_pipe_in_the_place_of_a_chunk_is_called_what_it_is(made, tmp_path):
    sweep, whole, _, _ = made
    store = shutil.copytree(whole, tmp_path / "a.zarr")
    chunks = [path for path in damage.files(store) if path.parent.name == "polhode_period" and path.name == "1"]
    if not chunks:
        pytest.skip("a store of statistics keeps no values")
    (chunk,) = chunks
    chunk.unlink()
    os.mkfifo(chunk)
    with in_time(), pytest.raises(FormatError, match="'1' in 'polhode_period' is neither a file nor"):
        run(sweep, store)


@pytest.mark.long
def test_each_way_of_damage(made, tmp_path):
    same, refused = check_many(made, tmp_path, [(way, 1, k % 2 == 1) for k, way in enumerate(damage.WAYS)])
    assert same + refused >= 25 and same > refused > 3


@pytest.mark.sweep
def test_hundreds_of_damaged_stores(made, tmp_path):
    """Of 219 such stores 64 ended otherwise before: 29 in tracebacks, 17 in wrong statistics, 18 hung."""
    cases = [(way, number, stopped) for way in damage.WAYS for number in range(2, 9) for stopped in (False, True)]
    same, refused = check_many(made, tmp_path, cases)
    assert same + refused > 350
    print(f"{same + refused} stores: {same} said the same, {refused} were refused")


def copied(made, tmp_path):
    store = tmp_path / "a.zarr"
    shutil.copytree(made[1], store)
    return store


@pytest.mark.parametrize("name", ["polhode_period/1", ".sweep/chunks/000000002.mark"])
def test_a_report_that_is_asked_later(made, tmp_path, name):
    """What is held in a script reads the store when it is asked, and looks again at what it reads."""
    sweep = made[0]
    store = sweep.begin(copied(made, tmp_path))
    sweep.run(store, 1)
    path = store.path / name
    if not path.exists():  # of a sweep that keeps statistics alone
        assert sweep.plan.keep == "statistics" and name.startswith("polhode_period")
        return
    os.truncate(path, path.stat().st_size // 2)
    with pytest.raises(FormatError, match=r"is damaged\. Run the sweep again"):
        SweepReport(sweep, store).as_json_dict()
    path.unlink()
    os.mkfifo(path)
    with in_time(), pytest.raises(InvalidInput, match="is a pipe"):
        SweepReport(sweep, store).as_json_dict()


def test_the_command_refuses_in_one_line(made, tmp_path, capsys):
    store = copied(made, tmp_path)
    damage.pipe(store / ".sweep", np.random.default_rng(3))
    with in_time(), pytest.raises(SystemExit) as ended:
        main(["sweep", str(made[0].plan.path), "--out", str(store)])
    said, errors = capsys.readouterr()
    assert ended.value.code == 2 and not said and errors.startswith("polhode: ") and errors.count("\n") == 1


def test_a_mark_counts_once_and_for_its_own_chunk(made, tmp_path):
    """By hand, as on main it doubled samples or exchanged parts: a second mark, and two that were exchanged."""
    store = copied(made, tmp_path)
    first, second = (store / ".sweep" / "chunks" / f"00000000{k}.mark" for k in (0, 1))
    shutil.copy(first, first.with_name("000000077.mark"))
    shutil.copy(first, first.with_name("0.mark"))
    assert run(made[0], store) == made[3]
    contents = first.read_bytes(), second.read_bytes()
    first.write_bytes(contents[1])
    second.write_bytes(contents[0])
    with pytest.warns(UserWarning, match="2 of 4 finished chunks are damaged"):
        begun = made[0].begin(store)
        made[0].run(begun, 1)
    assert SweepReport(made[0], begun).as_json_dict() == made[3]


@pytest.mark.long_cases("all")
def test_marks_of_another_sweep_are_none(made, tmp_path):
    store = copied(made, tmp_path)
    (tmp_path / "other.toml").write_text(SPEC.replace("KEEP", "all").replace("seed = 7", "seed = 8"))
    other = Sweep.of(read_plan(tmp_path / "other.toml"))
    run(other, tmp_path / "b.zarr")
    shutil.copytree(tmp_path / "b.zarr" / ".sweep" / "chunks", store / ".sweep" / "chunks", dirs_exist_ok=True)
    for name in ("form", "polhode_period"):
        shutil.copytree(tmp_path / "b.zarr" / name, store / name, dirs_exist_ok=True)
    assert run(made[0], store) == made[3]


@pytest.mark.parametrize("change", [
    lambda found: found | {"chunk": 1}, lambda found: found | {"reasons": [[200, "x"]]},
    lambda found: found | {"sweep": "0" * 64}, lambda found: found | {"arrays": {}}, lambda found: found | {"more": 1},
    lambda found: found | {"arrays": found["arrays"] | {"form": {"digest": "0" * 64, "summary": {"coning": 41}}}},
    lambda found: found | {"arrays": found["arrays"] | {"form": {"digest": "0" * 64, "summary": {"a": 41, "b": -1}}}},
    lambda found: found | {"arrays": found["arrays"] | {"form": found["arrays"]["polhode_period"]}},
])  # fmt: skip
def test_a_mark_of_another_form_is_none(made, change):
    sweep, store, _, _ = made
    content = (store / ".sweep" / "chunks" / "000000000.mark").read_bytes()
    assert read_mark(content, 0, sweep.layout) is not None
    found = change(json.loads(content.split(b"\n", 1)[1]))
    assert read_mark(damage._sealed(json.dumps(found).encode(), b"new"), 0, sweep.layout) is None

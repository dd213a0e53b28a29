"""A sweep gives the same bits whoever computes it, however often it is stopped, and loses nothing that is finished."""

import os
import signal
import subprocess
import sys
import time
import warnings
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray

import polhode as ph
from formats.test_full_disk import limited
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.sweeps import running
from polhode.sweeps.marks import hash_array
from polhode.sweeps.plan import read_plan
from polhode.sweeps.running import Sweep
from polhode.sweeps.summary import Numbers

PATIENCE = 120  # s in which a chunk must come
SPEC = """
[body]
moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]
[spin]
about = 2
[sweep]
samples = 300
seed = 7
chunk = 64
outputs = ["regime", "form", "polhode_period", "angular_velocity", "states.attitude"]
times = ["1 s", "20 s"]
[sweep.inputs]
"spin.rate" = { normal = ["120 rpm", "5 rpm"] }
"spin.tilt" = { uniform = ["0 deg", "90 deg"] }
"""


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(SPEC)
    return path


def files(store):
    """Return all files of a store, by name."""
    return {str(path.relative_to(store)): path.read_bytes() for path in sorted(store.rglob("*")) if path.is_file()}


def mark_of(store, number):
    return store / ".sweep" / "chunks" / f"{number:09d}.mark"


@pytest.mark.long
def test_xarray_reads_it_with_units(spec, tmp_path):
    report = ph.sweep(spec, tmp_path / "a.zarr")
    found = xarray.open_zarr(tmp_path / "a.zarr")
    assert dict(found.sizes) == {"sample": 300, "time": 2, "quaternion": 4, "axis": 3}
    assert found["polhode_period"].attrs["units"] == "s" and found["spin.rate"].attrs["units"] == "rad/s"
    assert set(np.unique(found["regime"].values)) <= {"short-axis", "long-axis"}
    k = 41
    velocity = found["angular_velocity"].values[k]
    motion = ph.FreeMotion((1.2e-7, 2e-7, 2.9e-7), angular_velocity=velocity)
    assert found["polhode_period"].values[k] == pytest.approx(motion.period, rel=1e-14)
    assert found["states.attitude"].values[k] == pytest.approx(motion.attitude(np.array([1.0, 20.0])), abs=1e-13)
    assert np.linalg.norm(velocity) == pytest.approx(found["spin.rate"].values[k], rel=1e-14)
    values = report.as_json_dict()
    row = next(row for row in values["statistics"] if row["output"] == "polhode_period")
    assert row["mean"] == pytest.approx(found["polhode_period"].values.mean(), rel=1e-13)
    assert row["quantile_95"] == pytest.approx(np.quantile(found["polhode_period"].values, 0.95), rel=1e-15)
    coning = next(row for row in values["probabilities"] if row["value"] == "coning")
    share = (found["form"].values == "coning").mean()
    error = 1.96 * np.sqrt(share * (1.0 - share) / 300)
    assert coning["probability"] == share and coning["high"] - coning["low"] == pytest.approx(2.0 * error, rel=0.05)


@pytest.mark.long
def test_the_same_again_after_a_stop(spec, tmp_path):
    """Marks are taken away as if a process had been killed between data and mark; the rest is computed alike."""
    ph.sweep(spec, tmp_path / "a.zarr")
    ph.sweep(spec, tmp_path / "b.zarr")
    sweep = Sweep.of(read_plan(spec))
    store = sweep.begin(tmp_path / "b.zarr")
    for number in (1, 4):
        mark_of(tmp_path / "b.zarr", number).unlink()
    (tmp_path / "b.zarr" / "polhode_period" / "1").write_bytes(b"torn")
    assert store.list_finished() == {0, 2, 3}
    told = []
    sweep.run(store, 1, tell=told.append)
    assert told == [64, 44]
    assert files(tmp_path / "a.zarr") == files(tmp_path / "b.zarr")


@pytest.mark.sweep
def test_other_chunks_hold_the_same_samples(spec, tmp_path):
    ph.sweep(spec, tmp_path / "a.zarr")
    spec.write_text(SPEC.replace("chunk = 64", "chunk = 17"))
    ph.sweep(spec, tmp_path / "b.zarr")
    assert xarray.open_zarr(tmp_path / "a.zarr").equals(xarray.open_zarr(tmp_path / "b.zarr").chunk())


@pytest.mark.long
def test_statistics_alone_say_the_same(spec, tmp_path):
    whole = ph.sweep(spec, tmp_path / "a.zarr").as_json_dict()
    spec.write_text(SPEC.replace("chunk", 'keep = "statistics"\nchunk'))
    kept = ph.sweep(spec, tmp_path / "b.zarr").as_json_dict()
    assert kept["probabilities"] == whole["probabilities"]
    for one, other in zip(kept["statistics"], whole["statistics"], strict=True):
        assert one["mean"] == other["mean"] and one["standard_deviation"] == other["standard_deviation"]
        assert one["quantile_50"] == pytest.approx(other["quantile_50"], abs=0.05 * (other["standard_deviation"] or 1))
    assert not (tmp_path / "b.zarr" / "polhode_period").exists()


def test_summaries_of_parts_are_those_of_the_whole():
    values = np.random.default_rng(1).standard_t(3, 5000) * 3.0 + 1e6
    values[::50] = np.nan
    parts = [Numbers.of(values[k : k + 777]) for k in range(0, 5000, 777)]
    found = parts[0]
    for part in parts[1:]:
        found = found.join(part)
    known = values[~np.isnan(values)]
    assert found.count == 4900 and (found.low, found.high) == (known.min(), known.max())
    assert found.mean == pytest.approx(known.mean(), rel=1e-15) and found.deviation == pytest.approx(known.std(ddof=1))
    for level, quantile in zip((0.1, 0.5, 0.9), found.quantiles((0.1, 0.5, 0.9)), strict=True):
        assert abs((known < quantile).mean() - level) < 1.0 / 256


@pytest.mark.long_after(1)
@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("seed = 7", "seed = 8"), "holds another sweep"),
        (("2.9 g*cm^2", "2.8 g*cm^2"), "holds another sweep"),
        (("chunk = 64", "chunk = 65"), "chunks of 64 samples"),
    ],
)
def test_stores_of_other_sweeps_are_kept(spec, tmp_path, change, words):
    ph.sweep(spec, tmp_path / "a.zarr")
    before = files(tmp_path / "a.zarr")
    spec.write_text(SPEC.replace(*change))
    with pytest.raises(InvalidInput, match=words):
        ph.sweep(spec, tmp_path / "a.zarr")
    assert files(tmp_path / "a.zarr") == before


@pytest.mark.long
def test_another_mesh_is_another_sweep(spec, tmp_path):
    mesh = Path(__file__).parents[2] / "examples" / "t_handle.stl"
    (tmp_path / "body.stl").write_bytes(mesh.read_bytes())
    body = 'mesh = "body.stl"\nmesh_unit = "mm"\nmass = "50 g"'
    spec.write_text(SPEC.replace('moments = ["1.2 g*cm^2", "2 g*cm^2", "2.9 g*cm^2"]', body))
    ph.sweep(spec, tmp_path / "a.zarr")
    ph.sweep(spec, tmp_path / "a.zarr")
    (tmp_path / "body.stl").write_bytes(mesh.read_bytes() + b"\n")
    with pytest.raises(InvalidInput, match=r"holds another sweep: the file body\.stl changed since"):
        ph.sweep(spec, tmp_path / "a.zarr")


@pytest.mark.long
def test_a_motion_does_not_replace_a_sweep(spec, tmp_path, capsys, monkeypatch):
    """Both are written to case.zarr where no name is given; on main the samples were gone, with exit code 0."""
    spec.write_text(SPEC.replace("about = 2", 'about = 2\nrate = "60 rpm"'))
    monkeypatch.chdir(tmp_path)
    ph.sweep("case.toml")
    before = files(tmp_path / "case.zarr")
    for arguments in (("export", "case.toml", "--to", "zarr"), ("import", "case.zarr")):
        with pytest.raises(SystemExit) as ended:
            main([*arguments])
        assert ended.value.code == 2
    said = capsys.readouterr().err
    assert "not the store of a motion, which could be replaced" in said and "is the store of a sweep" in said
    assert files(tmp_path / "case.zarr") == before


def test_other_folders_are_kept(spec, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("all of it")
    with pytest.raises(InvalidInput, match="not the store of a sweep"):
        ph.sweep(spec, tmp_path / "mine")
    assert (tmp_path / "mine" / "thesis.txt").read_text() == "all of it"


@pytest.mark.long
def test_one_process_at_a_time(spec, tmp_path):
    sweep = Sweep.of(read_plan(spec))
    store = sweep.begin(tmp_path / "a.zarr")
    with store.lock(), pytest.raises(InvalidInput, match="another process computes this sweep now"):
        sweep.run(store, 1)
    sweep.run(store, 1)


def damage_mark(store):
    mark_of(store, 2).write_text("{")


def damage_values(store):
    (store / "polhode_period" / "3").write_bytes(b"junk")


def lose_values(store):
    (store / "states.attitude" / "1.0.0").unlink()


@pytest.mark.long_after(1)
@pytest.mark.parametrize("damage", [damage_mark, damage_values, lose_values])
def test_what_is_damaged_is_computed_again(spec, tmp_path, damage):
    ph.sweep(spec, tmp_path / "a.zarr")
    whole = files(tmp_path / "a.zarr")
    damage(tmp_path / "a.zarr")
    with pytest.warns(UserWarning, match="1 of 5 finished chunks are damaged"):
        ph.sweep(spec, tmp_path / "a.zarr")
    assert files(tmp_path / "a.zarr") == whole


def test_a_store_of_statistics_is_one_that_xarray_opens(spec, tmp_path):
    spec.write_text(SPEC.replace("seed = 7", 'seed = 7\nkeep = "statistics"'))
    ph.sweep(spec, tmp_path / "a.zarr")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not xarray.open_zarr(tmp_path / "a.zarr").data_vars


def test_no_workers_are_refused(spec, tmp_path):
    with pytest.raises(InvalidInput, match="`workers` must be a whole number, at least 1"):
        ph.sweep(spec, tmp_path / "a.zarr", workers=0)


def test_a_cluster_without_workers_is_told(spec, tmp_path, monkeypatch):
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(running, "LIMITS", running.LIMITS._replace(worker_timeout=0.5))
    sweep = Sweep.of(read_plan(spec))
    with distributed.LocalCluster(n_workers=0, processes=False, dashboard_address=None) as cluster:
        told = pytest.warns(UserWarning, match="no workers yet")
        with told, pytest.raises(InvalidInput, match=r"has no workers\. Start"):
            sweep.run(sweep.begin(tmp_path / "a.zarr"), 1, cluster.scheduler_address)


@pytest.mark.sweep
def test_a_full_disk_keeps_what_is_finished(spec, tmp_path):
    """Room ends by a limit on the size of files, below a chunk of attitudes."""
    spec.write_text(SPEC.replace("samples = 300", "samples = 3000").replace("chunk = 64", "chunk = 600"))
    sweep = Sweep.of(read_plan(spec))
    store = sweep.begin(tmp_path / "a.zarr")
    told = []

    def stop_after_two(samples):
        told.append(samples)
        if len(told) == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep.run(store, 1, tell=stop_after_two)
    with limited(2000), pytest.raises(InvalidInput) as caught:
        sweep.run(store, 1)
    said = str(caught.value)
    assert "cannot be written" in said and "Make room there. 2 of 5 chunks are finished" in said
    assert store.list_finished() == {0, 1}
    sweep.run(store, 1)
    ph.sweep(spec, tmp_path / "b.zarr")
    assert files(tmp_path / "a.zarr") == files(tmp_path / "b.zarr")


def test_too_little_room_is_said_before(spec, tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.disk_usage", lambda path: SimpleNamespace(free=1e4))
    with pytest.raises(InvalidInput, match="the disk has 10 kB free"):
        ph.sweep(spec, tmp_path / "a.zarr")
    assert not (tmp_path / "a.zarr").exists()


def test_places_that_cannot_be_written(spec, tmp_path):
    with pytest.raises(InvalidInput, match="is not a folder"):
        ph.sweep(spec, tmp_path / "none" / "a.zarr")


def test_checksums_see_every_bit():
    values = np.arange(3.0)
    others = [np.nextafter(values, 9.0), values.reshape(3, 1), values.view("<i8"), np.array(["x", "y", "z"]), values]
    assert len({hash_array(each) for each in others}) == 5 and hash_array(others[-1]) == hash_array(values[::1])


def command(*arguments, **options):
    program = [sys.executable, "-m", "polhode.cli.main", "sweep", *map(str, arguments)]
    return subprocess.Popen(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def finished(store):
    return list((store / ".sweep" / "chunks").glob("*.mark"))


def wait_for(store, count):
    ends = time.time() + PATIENCE
    while len(finished(store)) < count:
        assert time.time() < ends, "no chunk came in time"
        time.sleep(0.05)


def workers_of(process):
    """Return the workers that a command has started, as processes."""
    children = subprocess.run(["pgrep", "-P", str(process.pid), "-f", "spawn_main"], capture_output=True, text=True)
    return [int(line) for line in children.stdout.split()]


@pytest.mark.sweep
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="processes are told by pgrep")
def test_killed_workers_and_clients(spec, tmp_path):
    spec.write_text(SPEC.replace("samples = 300", "samples = 1000000").replace("chunk = 64", "chunk = 10000"))
    ph.sweep(spec, tmp_path / "a.zarr", workers=1)
    arguments = (spec, "--out", tmp_path / "b.zarr", "--workers", 2, "--no-figures")
    client, store = command(*arguments), tmp_path / "b.zarr"
    wait_for(store, 3)
    os.kill(workers_of(client)[0], signal.SIGKILL)
    wait_for(store, len(finished(store)) + 10)
    workers = workers_of(client)
    client.kill()
    client.wait()
    at = len(finished(store))
    assert 13 <= at < 100
    ends = time.time() + PATIENCE
    while any(Path(f"/proc/{worker}").exists() for worker in workers):
        assert time.time() < ends, "a worker outlived its client"
        time.sleep(0.1)
    said, errors = command(*arguments).communicate(timeout=10 * PATIENCE)
    assert "1,000,000 of 1,000,000 samples" in said, errors
    assert files(tmp_path / "a.zarr") == files(tmp_path / "b.zarr")


@pytest.mark.sweep
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="semaphores are files there")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_leaves_nothing(spec, tmp_path, number):
    """A dozen semaphores were left, and the interpreter said so, while workers were waited for."""
    spec.write_text(SPEC.replace("samples = 300", "samples = 1000000").replace("chunk = 64", "chunk = 20000"))
    before = set(Path("/dev/shm").iterdir())
    client = command(spec, "--out", tmp_path / "a.zarr", "--workers", 2, "--no-figures", start_new_session=True)
    wait_for(tmp_path / "a.zarr", 2)
    os.killpg(client.pid, number)
    said, errors = client.communicate(timeout=PATIENCE)
    assert client.returncode == 128 + number and not said
    assert errors.endswith(f"polhode: stopped by {number.name}.\n")
    assert all(line.startswith("polhode: ") for line in errors.splitlines()), errors
    time.sleep(1.0)  # until what frees them has ended
    assert set(Path("/dev/shm").iterdir()) <= before


@pytest.mark.sweep
def test_workers_that_come_later_are_used(spec, tmp_path):
    """A scheduler with one worker gets another in the middle; who computed a chunk is told by the tasks' own log."""
    from distributed import Client, LocalCluster

    spec.write_text(SPEC.replace("samples = 300", "samples = 400000").replace("chunk = 64", "chunk = 5000"))
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster:
        client, store = command(spec, "--out", tmp_path / "a.zarr", "--scheduler", cluster.scheduler_address,
                                "--no-figures"), tmp_path / "a.zarr"  # fmt: skip
        wait_for(store, 5)
        cluster.scale(2)
        said, errors = client.communicate(timeout=10 * PATIENCE)
        assert "400,000 of 400,000 samples" in said, errors
        with Client(cluster) as watcher:
            done = watcher.run(lambda dask_worker: dask_worker.state.executed_count)
    assert len(done) == 2 and min(done.values()) > 5
    ph.sweep(spec, tmp_path / "b.zarr", workers=1)
    assert files(tmp_path / "a.zarr") == files(tmp_path / "b.zarr")


@pytest.mark.sweep
def test_a_scheduler_that_is_not_there(spec, tmp_path, monkeypatch):
    monkeypatch.setattr(running, "LIMITS", running.LIMITS._replace(answer_timeout=1.0))
    with pytest.raises(InvalidInput, match="does not answer"):
        ph.sweep(spec, tmp_path / "a.zarr", scheduler="tcp://127.0.0.1:9")
    assert not (tmp_path / "a.zarr").exists()

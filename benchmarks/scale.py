"""A large sweep on a cluster of two workers, killed once and resumed: ``python benchmarks/scale.py BODIES TOPS``.

Free bodies (100,000,000 by default), then Lagrange tops (1,000,000): a Dask scheduler, two workers, and the command,
which is killed with a worker when a third of the chunks are done; a new worker and the same command do the rest. Told
are CPU seconds of all workers, samples per second and core, files, bytes and the largest memory of a worker. Then the
store must have every sample once, and some of them the answers of their own reports; ``--judge FOLDER`` looks at one
that ``--into`` kept. With ``--check`` the same sweep runs again on one process without interruption, and must have the
same checksum.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path
from typing import Any

import numpy as np

BODY = """
[body]
moments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]
[spin]
angular_velocity = ["1 rad/s", "1 rad/s", "1 rad/s"]
[sweep]
samples = {samples}
seed = 1
outputs = ["regime", "angular_speed", "polhode_period"]
[sweep.inputs]
"spin.angular_velocity" = {{ sphere = {{ uniform = ["0.5 rad/s", "2 rad/s"] }} }}
"body.moments.2" = {{ uniform = ["1.6 kg*m^2", "2.4 kg*m^2"] }}
"""
TOP = """
[body]
parts = [{{ shape = "disk", mass = "50 g", radius = "30 mm", at = ["0 mm", "0 mm", "40 mm"] }}]
[system]
kind = "lagrange-top"
pivot = ["0 mm", "0 mm", "0 mm"]
lean = "20 deg"
[spin]
rate = "300 rad/s"
about = 3
[sweep]
samples = {samples}
seed = 1
outputs = ["energy", "nutation_period"]
[sweep.inputs]
"spin.rate" = {{ uniform = ["200 rad/s", "400 rad/s"] }}
"system.lean" = {{ uniform = ["5 deg", "60 deg"] }}
"""
JUDGED = 20  # samples whose own reports are made
PART = 1 / 3  # of the chunks, after which the command and a worker are killed
QUIET = {"OMP_NUM_THREADS": "1", "MALLOC_TRIM_THRESHOLD_": "268435456", "MALLOC_MMAP_THRESHOLD_": "134217728"}


class Cluster:
    """A Dask scheduler and workers of one thread, as processes."""

    def __init__(self, folder: Path) -> None:
        self.file, self.folder, self.workers, self.cpu, self.memory = folder / "scheduler.json", folder, [], 0.0, 0
        self.scheduler = self._start("scheduler", "--scheduler-file", self.file, "--no-dashboard", "--port", "0")
        while not self.file.exists():
            time.sleep(0.1)
        self.address = json.loads(self.file.read_text())["address"]

    def add_worker(self) -> None:
        self.workers.append(self._start("worker", self.address, "--nthreads", "1", "--no-dashboard", "--no-nanny"))

    def kill_worker(self) -> None:
        self._end(self.workers.pop(), signal.SIGKILL)

    def close(self) -> None:
        while self.workers:
            self._end(self.workers.pop(), signal.SIGTERM)
        self._end(self.scheduler, signal.SIGTERM)

    def _start(self, *words: Any) -> subprocess.Popen:
        command = [sys.executable, "-m", "distributed.cli.dask_" + words[0], *map(str, words[1:])]
        return subprocess.Popen(command, cwd=self.folder, env=os.environ | QUIET, stderr=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL)  # fmt: skip

    def _end(self, process: subprocess.Popen, how: signal.Signals) -> None:
        process.send_signal(how)
        _, _, used = os.wait4(process.pid, 0)
        process.returncode = 0
        if process is not self.scheduler:
            self.cpu += used.ru_utime + used.ru_stime
            self.memory = max(self.memory, used.ru_maxrss * 1024)


def sweep(spec: Path, store: Path, *words: str) -> subprocess.Popen:
    """Start the command."""
    command = [sys.executable, "-m", "polhode", "sweep", str(spec), "--out", str(store), "--json", *words]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ | QUIET)


def run(name: str, text: str, samples: int, place: Path, check: bool) -> None:
    """Print the row of one sweep, whose store stays in a place.

    Raises:
        SystemExit: if the sweep fails, or ends in other numbers than one without interruption.
    """
    folder = place / name.replace(" ", "-")
    folder.mkdir(parents=True)
    spec, store = folder / "case.toml", folder / "case.zarr"
    spec.write_text(text.format(samples=samples))
    cluster = Cluster(folder)
    for _ in range(2):
        cluster.add_worker()
    begun, first = time.time(), sweep(spec, store, "--scheduler", cluster.address)
    chunks = 0
    while first.poll() is None:
        marks = list(store.glob(".sweep/chunks/*"))
        plan = store / ".sweep" / "plan.json"
        if not chunks and plan.exists():
            held = json.loads(plan.read_text())
            chunks = -(-held["samples"] // held["chunk"])
        if chunks and len(marks) >= PART * chunks:
            first.kill()
            cluster.kill_worker()
            break
        time.sleep(0.5)
    first.communicate()
    done = len(list(store.glob(".sweep/chunks/*")))
    cluster.add_worker()
    printed, said = (second := sweep(spec, store, "--scheduler", cluster.address)).communicate()
    if second.returncode:
        raise SystemExit(f"{name}: the sweep failed: {said}")
    taken = time.time() - begun
    cluster.close()
    found = [path.stat().st_size for path in store.rglob("*") if path.is_file()]
    answers = json.loads(printed)
    print(f"| {name} | {samples:,} | {chunks:,}, killed after {done:,} | {cluster.cpu:.0f} | {taken:.0f} | "
          f"{samples / cluster.cpu:,.0f} | {len(found):,} | {sum(found) / 1e9:.2f} | {cluster.memory / 1e6:.0f} | "
          f"{answers['checksum'][:16]} |", flush=True)  # fmt: skip
    judge(spec, store)
    if check:
        whole, _ = sweep(spec, folder / "whole.zarr", "--workers", "1").communicate()
        if json.loads(whole)["checksum"] != answers["checksum"]:
            raise SystemExit(f"{name}: another checksum without interruption")


def judge(spec: Path, store: Path) -> None:
    """Check that a store has every sample once, and some have the answers of their own reports.

    Raises:
        SystemExit: if not.
    """
    import xarray

    import polhode as ph

    plan = json.loads((store / ".sweep" / "plan.json").read_text())
    samples, size = plan["samples"], plan["chunk"]
    marks = sorted(store.glob(".sweep/chunks/*.mark"))
    if [_chunk(mark) for mark in marks] != list(range(-(-samples // size))):
        raise SystemExit(f"{spec.parent.name}: marks are not of each chunk once")
    text = spec.read_text()
    given, own = tomllib.loads(text)["sweep"], spec.with_name("own.toml")
    names, outputs = list(given["inputs"]), given["outputs"]
    with xarray.open_zarr(store) as kept:
        rows = np.concatenate([kept[name].values.reshape(samples, -1)[:, -1:] for name in names], axis=1)
        first = np.sort(rows[:, 0])
        alike = rows[np.isin(rows[:, 0], first[1:][first[1:] == first[:-1]])]  # few: a draw has 53 bits
        twice = len(alike) - len(np.unique(alike, axis=0))
        lost = int(np.isnan(rows).any(1).sum()) + int((kept["sample_status"] != "done").sum())
        if twice or lost:
            raise SystemExit(f"{spec.parent.name}: {twice} samples are there twice, {lost} are not there or not done")
        for k in np.random.default_rng(0).choice(samples, JUDGED, replace=False):
            alone = text[: text.index("[sweep]")]
            for name in names:
                alone = _put(alone, name, kept[name][k].values, kept[name].attrs["units"])
            own.write_text(alone)
            found = ph.report(own).values()
            for name in outputs:
                if found[name] != kept[name][k].values.item():
                    raise SystemExit(f"{spec.parent.name}: sample {k} has another {name} than its report")
    print(f"{spec.parent.name}: {samples:,} samples, each once; {JUDGED} have the answers of their own reports")


def _chunk(mark: Path) -> int:
    text = mark.read_text()
    return json.loads(text[text.index("{") :])["chunk"]


def _put(text: str, name: str, value: Any, unit: str) -> str:
    """Return a spec with an input in it, that of a list by its place from 1."""
    part, key, *place = name.split(".")
    begin = text.index(f"\n{key} = ", text.index(f"[{part}]")) + 1
    end = text.index("\n", begin)
    words = [f"{float(x)!r} {unit}" for x in value.ravel()]
    if place:
        held = tomllib.loads(text[begin:end])[key]
        held[int(place[0]) - 1] = words[0]
        words = held
    return f"{text[:begin]}{key} = {json.dumps(words if place or value.ndim else words[0])}{text[end:]}"


def main() -> None:
    given = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    given.add_argument("bodies", type=int, nargs="?", default=10**8)
    given.add_argument("tops", type=int, nargs="?", default=10**6)
    given.add_argument("--into", type=Path, help="a new folder in which the results stay")
    given.add_argument("--check", action="store_true", help="compare with a sweep that is not interrupted")
    given.add_argument("--judge", type=Path, help="a folder with the spec and the store of a sweep that was made")
    options = given.parse_args()
    if options.judge:
        judge(options.judge / "case.toml", options.judge / "case.zarr")
        return
    heads = "sweep | samples | chunks | CPU s of workers | s | samples per CPU s | files | GB | MB each | checksum"
    print(f"| {heads} |\n{'|---' * (heads.count('|') + 1)}|")
    with tempfile.TemporaryDirectory() as place:
        for name, text, samples in (("free bodies", BODY, options.bodies), ("Lagrange tops", TOP, options.tops)):
            if samples:
                run(name, text, samples, options.into or Path(place), options.check)


if __name__ == "__main__":
    main()

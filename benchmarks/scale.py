"""A large sweep on a cluster of two workers, killed once and resumed: ``python benchmarks/scale.py BODIES TOPS``.

Free bodies (100,000,000 by default), then Lagrange tops (1,000,000): a Dask scheduler, two workers, and the command,
which is killed with a worker when a third of the chunks are done; a new worker and the same command do the rest. Told
are CPU seconds of all workers, samples per second and core, files, bytes and the largest memory of a worker. With
``--check`` the same sweep runs again on one process without interruption, and must have the same checksum.
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
from pathlib import Path
from typing import Any

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


def run(name: str, text: str, samples: int, check: bool) -> None:
    """Print the row of one sweep.

    Raises:
        SystemExit: if the sweep fails, or ends in other numbers than one without interruption.
    """
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        spec, store = folder / "case.toml", folder / "case.zarr"
        spec.write_text(text.format(samples=samples))
        cluster = Cluster(folder)
        cluster.add_worker(), cluster.add_worker()
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
        if check:
            whole, _ = sweep(spec, folder / "whole.zarr", "--workers", "1").communicate()
            if json.loads(whole)["checksum"] != answers["checksum"]:
                raise SystemExit(f"{name}: another checksum without interruption")


def main() -> None:
    given = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    given.add_argument("bodies", type=int, nargs="?", default=10**8)
    given.add_argument("tops", type=int, nargs="?", default=10**6)
    given.add_argument("--check", action="store_true", help="compare with a sweep that is not interrupted")
    options = given.parse_args()
    heads = "sweep | samples | chunks | CPU s of workers | s | samples per CPU s | files | GB | MB each | checksum"
    print(f"| {heads} |\n{'|---' * (heads.count('|') + 1)}|")
    for name, text, samples in (("free bodies", BODY, options.bodies), ("Lagrange tops", TOP, options.tops)):
        if samples:
            run(name, text, samples, options.check)


if __name__ == "__main__":
    main()

"""Files damaged at random are read as something finite or refused in one message; no reader hangs or crashes."""

import json
import random
import signal
import subprocess
import sys
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

from formats import reader_fuzz
from formats.reader_fuzz import Specimen, complaint
from polhode.errors import FormatError

WORKER = Path(reader_fuzz.__file__)
TEXTS = ["ascii.stl", "ascii.ply", "a.obj", "a.off", "a.gltf", "water.xyz", "ext.xyz", "a.pdb", "a.mol", "a.urdf",
         "a.cat", "a.lin", "a.par"]  # fmt: skip
OTHERS = ["a.stk", "a.apm", "a.acm", "new.xml", "dates.csv"]
DATASETS = ["a.nc", "a.zarr"]  # forty milliseconds a file, ten times the others


def run(folder, seed, count, names):
    """Read damaged files in a process of their own, so that its death is a failure and not the end of the tests."""
    ran = subprocess.run([sys.executable, str(WORKER), str(seed), str(count), str(folder), *names],
                         capture_output=True, text=True, timeout=3000)  # fmt: skip
    at = folder / "at"
    place = at.read_text() if at.exists() else "the start"
    assert ran.returncode == 0, f"ended with {ran.returncode} at {place}: {ran.stderr[-2000:]}"
    found = json.loads(ran.stdout)
    assert not found["wrong"], "\n".join(found["wrong"][:5])
    assert ran.stderr == ""
    assert all(number == count for number in found["read"].values()) and found["read"]


@pytest.mark.sweep
def test_damaged_files(tmp_path):
    run(tmp_path, 0, 8, [])


@pytest.mark.sweep
@pytest.mark.parametrize(("names", "count"), [
    (["a.stl", "a.ply", "a.glb"], 2000), (TEXTS, 2000), (["a.aem", "a.csv"], 2000), (["a.bc"], 2000), (DATASETS, 2000),
    (OTHERS, 2000),
], ids=["meshes", "texts", "tables", "kernels", "datasets", "others"])  # fmt: skip
def test_many_damaged_files(tmp_path, names, count):
    run(tmp_path, 1, count, names)


def warns(path):
    warnings.warn("odd", stacklevel=1)


def says(text):
    def read(path):
        raise FormatError(text.format(path=path))

    return read


def nothing_finite(path):
    from polhode.motion._trajectory import Trajectory

    reader_fuzz.check_trajectory(Trajectory(np.array([np.nan]), np.zeros((1, 3))))


@pytest.mark.parametrize(("read", "words"), [
    (lambda path: 1 / 0, "ZeroDivisionError"), (warns, "warned odd"), (nothing_finite, "not finite"),
    (says("no path"), "message"), (says("{path}" + "\udcff"), None), (says("{path}: broken."), None),
    (lambda path: path.stem, None),
])  # fmt: skip
def test_the_worker_sees_what_is_wrong(tmp_path, read, words):
    said = complaint(Specimen(tmp_path, lambda *_: None, read), tmp_path / "a.txt")
    assert (said is None) if words is None else (words in said)


@pytest.mark.long
def test_the_worker_does_not_outlive_a_hang(tmp_path):
    """What never ends is killed by its own clock; the test sees how the process ended."""
    lines = ["import pathlib, sys", "sys.path.insert(0, sys.argv[1])", "import reader_fuzz", "def hang(path):",
             "    while True: pass", "reader_fuzz.CPU_SECONDS = 0.2",
             "reader_fuzz.complaint(reader_fuzz.Specimen(None, None, hang), pathlib.Path('a'))"]  # fmt: skip
    text = "\n".join(lines)
    begun = time.monotonic()
    ran = subprocess.run([sys.executable, "-c", text, str(WORKER.parent)], timeout=100)
    assert ran.returncode == -signal.SIGPROF and time.monotonic() - begun < 90


def test_damage_is_the_same_for_the_same_seed(tmp_path):
    for name in "ab":
        (tmp_path / name).write_bytes(bytes(range(256)) * 4)
        for case in range(20):
            reader_fuzz.in_bytes(random.Random(f"x {case}"), tmp_path / name)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes() != bytes(range(256)) * 4

"""Writers on a disk without room: they say so, the older file stays as it was, and nothing is left behind.

Room ends by a limit on the size of files, which every Unix has; where this user may mount one, also by a small file
system of its own.
"""

import signal
import subprocess
from contextlib import contextmanager

import numpy as np
import pytest

import polhode as ph
from polhode import formats, spacecraft
from polhode.errors import InvalidInput
from polhode.figures import style
from polhode.formats.figure_file import save_figure
from polhode.formats.paths import write_together, write_whole

MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.1, 2.0, 0.2)).sample(np.linspace(0.0, 60.0, 400))
PATIENCE = 60  # s


def drawn(folder):
    figure = style.new_figure()
    figure.add_subplot().plot(MOTION.momentum)
    with write_together(folder) as draft:
        for form in ("png", "svg", "pdf"):
            save_figure(figure, draft / f"a.{form}")


def text(path):
    with write_whole(path) as draft, draft.open("w") as file:
        for _ in range(10_000):
            file.write("a line")


WRITERS = {
    "a.nc": lambda path: formats.write_dataset(MOTION, path),
    "a.zarr": lambda path: formats.write_zarr(MOTION, path),
    "a.csv": lambda path: formats.write_csv(MOTION, path),
    "a.aem": lambda path: spacecraft.write_aem(MOTION, path),
    "a.bc": lambda path: spacecraft.write_ck(MOTION, path),
    "a.glb": lambda path: formats.write_gltf(MOTION, path),
    "a.png": lambda path: drawn(path.parent),
    "a.txt": text,
}


@contextmanager
def limited(size):
    """Files cannot grow beyond a size in bytes; the signal that goes with it is ignored, as Python does."""
    assert signal.getsignal(signal.SIGXFSZ) == signal.SIG_IGN
    import resource  # which Windows has not, where other tests import this module

    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@contextmanager
def small_disk(place, size):
    """A file system of so many bytes at a place."""
    place.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", place]
    if subprocess.run(mount, capture_output=True, timeout=PATIENCE, check=False).returncode:
        pytest.skip("this user may not mount a small disk; the limit on files' sizes is tested instead")
    try:
        yield
    finally:
        subprocess.run(["umount", place], timeout=PATIENCE, check=True)


def contents(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def largest(found):
    return max(len(data) for data in found.values())


@pytest.mark.long_cases("a.png")
@pytest.mark.parametrize("name", WRITERS)
def test_a_file_that_may_not_grow(tmp_path, name):
    write = WRITERS[name]
    write(tmp_path / name)
    before = contents(tmp_path)
    whole = largest(before)
    for size in {whole - 1, whole // 2, 0}:
        with limited(size), pytest.raises(InvalidInput, match=r"cannot be written .* Make room there"):
            write(tmp_path / name)
        assert contents(tmp_path) == before and not list(tmp_path.glob(".polhode-*")), size


@pytest.mark.long_cases("a.png")
@pytest.mark.parametrize("name", WRITERS)
def test_a_disk_that_is_full(tmp_path, name):
    write, disk = WRITERS[name], tmp_path / "disk"
    write(tmp_path / name)
    made = contents(tmp_path)
    room = sum(-(-len(data) // 4096) * 4096 for data in made.values())
    with small_disk(disk, int(1.5 * room) // 4096 * 4096):
        write(disk / name)
        before = contents(disk)
        assert before.keys() == made.keys()
        with pytest.raises(InvalidInput, match=r"cannot be written .* Make room there"):
            write(disk / name)  # both do not fit
        assert contents(disk) == before and not list(disk.glob(".polhode-*"))


@pytest.mark.parametrize("name", ["a.nc", "a.zarr", "a.png"])
def test_the_message_names_the_file_where_it_was_to_go(tmp_path, name):
    """Not its hidden draft, also where one is written within another, as a report's dataset is."""
    folder = tmp_path / "report"
    with limited(0), pytest.raises(InvalidInput) as caught, write_together(folder) as draft:
        WRITERS[name](draft / name)
    said = str(caught.value)
    assert ".polhode-" not in said and said.startswith(str(folder)) and "cannot be written" in said


def test_a_c_kernel_cut_anywhere_is_noticed(tmp_path):
    """The harness's own teeth: SPICE itself says nothing of most of these sizes."""
    WRITERS["a.bc"](tmp_path / "a.bc")
    before = contents(tmp_path)
    for size in range(0, len(before["a.bc"]), 1024):
        with limited(size), pytest.raises(InvalidInput, match=r"cannot be written .* Make room there"):
            WRITERS["a.bc"](tmp_path / "a.bc")
        assert contents(tmp_path) == before

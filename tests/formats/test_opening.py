"""Input files opened: whatever is not a regular file of bearable size is refused at once, by every reader."""

import os
import re
import socket
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

import polhode as ph
from polhode import formats, spacecraft
from polhode.errors import FormatError, InvalidInput
from polhode.formats import opening
from polhode.formats.opening import check_is_file, open_file, read_file, read_text
from polhode.studies.sources import detect_kind

BROKEN = Path("/proc/self/mem")  # a regular file whose first byte cannot be read
READERS = {
    "mesh.stl": lambda path: formats.read_mesh(path, 1.0),
    "molecule.xyz": formats.read_molecule,
    "robot.urdf": spacecraft.read_urdf_inertial,
    "motion.aem": spacecraft.read_aem,
    "motion.csv": formats.read_csv,
    "motion.txt": lambda path: formats.read_columns(path, formats.ColumnMapping(1, gyro=(2, 3, 4))),
    "motion.nc": formats.read_dataset,
    "motion.bc": lambda path: spacecraft.read_ck(path, sclk=__file__),
    "motion.tsc": lambda path: read_clock(path),
    "anything": detect_kind,
}


def read_clock(path):
    with tempfile.TemporaryDirectory() as folder:
        kernel = Path(folder, "motion.bc")
        kernel.write_bytes(b"DAF/CK  ")
        spacecraft.read_ck(kernel, sclk=path)


def pipe(path):
    os.mkfifo(path)


def listening(path):
    socket.socket(socket.AF_UNIX).bind(str(path))


def device(name):
    return lambda path: path.symlink_to(name)


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize(("make", "words"), [
    (pipe, "is a pipe, not a"),
    (listening, "is a socket, not a"),
    (device("/dev/zero"), "is a device, not a"),
    (device("/dev/full"), "is a device, not a"),
    (device("missing"), "no such"),
    (lambda path: path.symlink_to(path), "no such"),
], ids=["pipe", "socket", "zero", "full", "dangling", "circle"])  # fmt: skip
def test_what_is_no_file_is_refused_at_once(tmp_path, name, make, words):
    """A pipe that nobody writes to would be waited for, and /dev/zero never ends."""
    make(tmp_path / name)
    with pytest.raises(InvalidInput, match=rf"{name}: {words}") as error:
        READERS[name](tmp_path / name)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", READERS)
def test_names_that_no_file_can_have(name, tmp_path):
    for folder in ("a\0b", "a\udcff\ud800", "x" * 5000, "\n"):
        with pytest.raises(InvalidInput, match="no such") as error:
            READERS[name](tmp_path / folder / name)
        assert len(str(error.value)) < 7000


@pytest.mark.parametrize("name", sorted(READERS.keys() - {"anything"}))
def test_what_is_too_large_is_refused_unread(tmp_path, name):
    path = tmp_path / name
    path.touch()
    os.truncate(path, 10**12)  # a hole: nothing is on the disk
    with pytest.raises(InvalidInput, match=r"has 1,000,000 MB; .* may have [\d,]+ MB at most"):
        READERS[name](path)


def test_a_file_is_read_up_to_its_limit(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"12345")
    assert read_file(path, "test", 5) == b"12345"
    with pytest.raises(FormatError, match="has 5 bytes; a test file may have 4 bytes at most"):
        read_file(path, "test", 4)
    with open_file(path, "test", 5) as file:
        assert file.read(2) == b"12" and file.read() == b"345"


def test_a_file_that_grows_is_read_up_to_its_limit():
    """Files below /proc say that they are empty, and a log may grow while it is read."""
    if not Path("/proc/cpuinfo").is_file():
        pytest.skip("no /proc")
    assert len(read_file(Path("/proc/cpuinfo"), "test", 10**7)) > 10
    with pytest.raises(FormatError, match="a test file may have 10 bytes at most"):
        read_file(Path("/proc/cpuinfo"), "test", 10)


def test_text_is_utf_8_without_its_mark(tmp_path):
    path = tmp_path / "text"
    path.write_bytes("\N{BYTE ORDER MARK}Ω\r\n".encode())
    assert read_text(path, "test", 100) == "Ω\r\n"
    path.write_bytes(b"a\nb\0c")
    with pytest.raises(FormatError, match="has a NUL byte in line 2"):
        read_text(path, "test", 100)
    for raw in ("Ω".encode("utf-16"), b"\xff"):
        path.write_bytes(raw)
        with pytest.raises(FormatError, match="text: is not UTF-8 text"):
            read_text(path, "test", 100)


def test_folders_and_files_without_permission(tmp_path, monkeypatch):
    with pytest.raises(InvalidInput, match="is a folder, not a test file"):
        check_is_file(tmp_path, "test")
    path = tmp_path / "secret"
    path.touch()

    def refused(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(opening.os, "open", refused)
    with pytest.raises(InvalidInput, match=re.escape("cannot be read (Permission denied)")):
        read_file(path, "test", 10)


def test_a_file_that_became_a_pipe_is_not_waited_for(tmp_path, monkeypatch):
    """Between the look at a path and its opening another program may put a pipe there."""
    path = tmp_path / "file"
    os.mkfifo(path)
    monkeypatch.setattr(opening, "check_is_file", lambda *_: None)
    with pytest.raises(InvalidInput, match="is a pipe"):
        read_file(path, "test", 10)


def test_the_command_does_not_wait_for_a_pipe(tmp_path):
    command = [sys.executable, "-m", "polhode.cli.main", "import", "/dev/stdin"]
    ran = subprocess.run(command, stdin=subprocess.PIPE, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert ran.returncode == 2 and "/dev/stdin: is a pipe" in ran.stderr and "Traceback" not in ran.stderr


@pytest.mark.skipif(not BROKEN.exists(), reason="needs a file that cannot be read")
@pytest.mark.parametrize("read", READERS)
def test_a_file_that_breaks_while_it_is_read_is_named(read, tmp_path):
    path = tmp_path / read
    path.symlink_to(BROKEN)
    with pytest.raises(InvalidInput, match=rf"{re.escape(str(path))}: cannot be read "):
        READERS[read](path)


def test_a_file_that_a_spec_names_counts_from_its_folder(tmp_path):
    """And is said to where it is missing, which does not concern files named on the command line."""
    spec = tmp_path / "spec.toml"
    spec.write_text('[body]\nmesh = "no.stl"\nmesh_unit = "m"\nmass = "1 kg"\n[spin]\nrate = "1 rpm"\nabout = 1\n')
    with pytest.raises(InvalidInput, match=r"no such mesh file.* counts from the spec.s own folder"):
        ph.read_spec(spec)
    with pytest.raises(InvalidInput, match=r"no such mesh file\. Check the path\.$"):
        formats.read_mesh(tmp_path / "no.stl", 1.0)

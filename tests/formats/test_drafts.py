"""Drafts: gone in the end, whatever ends them."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from polhode.errors import InvalidInput
from polhode.formats import drafts
from polhode.formats.paths import write_together, write_whole

PATIENCE = 60  # s until a process of the tests counts as hanging


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def is_store(path):
    return (path / "mark").is_file()


def run(code, folder):
    """Run Python in a folder and return its exit code."""
    return subprocess.run([sys.executable, "-c", code], cwd=folder, timeout=PATIENCE, check=False).returncode


KILLED = """
import os, signal
from polhode.formats.paths import write_whole
with write_whole("motion.csv") as draft:
    draft.write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_the_draft_of_a_killed_process_goes_with_the_next_one(tmp_path):
    (tmp_path / "motion.csv").write_text("earlier")
    (tmp_path / ".polhode-notes").mkdir()
    assert run(KILLED, tmp_path) == -signal.SIGKILL
    assert (tmp_path / "motion.csv").read_text() == "earlier" and len(names(tmp_path)) == 3
    with write_whole(tmp_path / "other.csv") as draft:
        draft.write_text("whole")
    assert names(tmp_path) == [".polhode-notes", "motion.csv", "other.csv"]


def test_a_draft_in_use_stays(tmp_path):
    with write_whole(tmp_path / "a") as first:
        first.write_text("a")
        with write_whole(tmp_path / "b") as second:
            second.write_text("b")
        assert first.read_text() == "a"
    assert names(tmp_path) == ["a", "b"]


KILLED_WHILE_MOVING = """
import os, signal, pathlib
from polhode.formats.paths import write_whole
move, moved = pathlib.Path.replace, []
def replace(self, target):
    if moved:
        os.kill(os.getpid(), signal.SIGKILL)
    moved.append(self)
    return move(self, target)
pathlib.Path.replace = replace
with write_whole("store", lambda path: True) as draft:
    draft.mkdir()
    (draft / "mark").write_text("later")
"""


def test_a_store_whose_replacement_was_killed_comes_back(tmp_path):
    (tmp_path / "store").mkdir()
    (tmp_path / "store" / "mark").write_text("earlier")
    assert run(KILLED_WHILE_MOVING, tmp_path) == -signal.SIGKILL
    assert not (tmp_path / "store").exists()  # the only moment at which a kill takes it from its place
    with write_whole(tmp_path / "other") as draft:
        draft.write_text("whole")
    assert (tmp_path / "store" / "mark").read_text() == "earlier" and names(tmp_path) == ["other", "store"]


def test_a_store_that_cannot_be_replaced_stays(tmp_path, monkeypatch):
    (tmp_path / "store").mkdir()
    (tmp_path / "store" / "mark").write_text("earlier")
    move = Path.replace

    def replace(path, target):
        if path.parent.name == "new":
            raise PermissionError(13, "Permission denied")
        return move(path, target)

    monkeypatch.setattr(Path, "replace", replace)
    with pytest.raises(InvalidInput, match="Permission denied"):
        with write_whole(tmp_path / "store", is_store) as draft:
            draft.mkdir()
    assert (tmp_path / "store" / "mark").read_text() == "earlier" and names(tmp_path) == ["store"]


def interrupt(*_):
    signal.raise_signal(signal.SIGINT)


@pytest.mark.parametrize("step", ["mkdir", "fsync", "rmtree"])
def test_an_interrupt_in_any_step_leaves_the_old_or_the_new_and_nothing_else(tmp_path, monkeypatch, step):
    (tmp_path / "a").write_text("earlier")
    home = {"mkdir": Path, "fsync": os, "rmtree": drafts.shutil}[step]
    done = getattr(home, step)

    def interrupted(*arguments, **more):
        done(*arguments, **more)
        interrupt()

    monkeypatch.setattr(home, step, interrupted)
    with pytest.raises(KeyboardInterrupt), write_together(tmp_path) as draft:
        (draft / "a").write_text("later")
    monkeypatch.undo()
    assert names(tmp_path) == ["a"]
    assert (tmp_path / "a").read_text() == ("later" if step == "rmtree" else "earlier")


def test_an_interrupt_while_files_take_their_names_waits(tmp_path, monkeypatch):
    for name in "ab":
        (tmp_path / name).write_text("earlier")
    move = Path.replace

    def replace(path, target):
        interrupt()
        return move(path, target)

    monkeypatch.setattr(Path, "replace", replace)
    with pytest.raises(KeyboardInterrupt), write_together(tmp_path) as draft:
        for name in "ab":
            (draft / name).write_text("later")
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"a": "later", "b": "later"}


def test_files_are_on_the_disk_before_they_take_their_names(tmp_path, monkeypatch):
    def full(descriptor):
        raise OSError(28, "No space left on device")

    (tmp_path / "a").write_text("earlier")
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InvalidInput, match=r"No space left on device\)\. Make room"):
        with write_whole(tmp_path / "a") as draft:
            draft.write_text("later")
    assert (tmp_path / "a").read_text() == "earlier" and names(tmp_path) == ["a"]


ENDED_AT_ONCE = """
import os
from polhode.formats import drafts
from polhode.formats.paths import write_together
with write_together("{folder}") as new:
    (new / "a.txt").write_text("half")
    drafts.remove_live_drafts()
    os._exit(3)
"""


def test_folders_made_for_files_go_where_the_process_ends_at_once(tmp_path):
    (tmp_path / "before").mkdir()
    for folder in ("R", "before/in/deep", "before"):
        assert run(ENDED_AT_ONCE.format(folder=folder), tmp_path) == 3
        assert names(tmp_path) == ["before"] and names(tmp_path / "before") == []


def test_where_open_files_stay_and_folders_are_not_opened_nothing_is_left(tmp_path, monkeypatch):
    """As on Windows: the lock's file goes once the lock is let go of; what is synced is a file, open for writing."""
    synced, removed, sync = [], drafts.shutil.rmtree, os.fsync

    def rmtree(folder, ignore_errors):
        try:
            with drafts.FileLock(folder / "lock").acquire(blocking=False):
                pass
        except TimeoutError:  # held, so open
            for path in set(folder.iterdir()) - {folder / "lock"}:
                removed(path)
        else:
            removed(folder, ignore_errors=ignore_errors)

    def fsync(descriptor):
        os.write(descriptor, b"")  # which fails for folders and what is open for reading alone
        synced.append(descriptor)
        sync(descriptor)

    (tmp_path / "store").mkdir()
    (tmp_path / "store" / "mark").write_text("earlier")
    monkeypatch.setattr(drafts, "WINDOWS", True)
    monkeypatch.setattr(drafts.shutil, "rmtree", rmtree)
    monkeypatch.setattr(os, "fsync", fsync)
    with write_whole(tmp_path / "store", is_store) as draft:
        draft.mkdir()
        (draft / "mark").write_text("later")
    assert (tmp_path / "store" / "mark").read_text() == "later" and names(tmp_path) == ["store"]
    assert len(synced) == 1

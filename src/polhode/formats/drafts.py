"""Hidden folders in which files are written before they take their names.

A draft is a folder ``.polhode-…`` next to the files it is for: new files are in ``new``, and a store that is to be
replaced waits in ``old``. The process that writes it holds the file ``lock``. The system releases the lock when the
process ends, however it ends; so the next process that writes there recognises an abandoned draft, puts back the
content of its ``old``, and removes it.
"""

from __future__ import annotations

import contextlib
import os
import re
import secrets
import shutil
import signal
import threading
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from filelock import FileLock

WINDOWS = os.name == "nt"  # where open files cannot be removed, and folders not opened
PREFIX = ".polhode-"
_NAME = re.compile(r"\.polhode-[0-9a-f]{16}")
_SIGNALS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP", "SIGINT") if hasattr(signal, name)]
_live: set[Draft] = set()
_made: set[Path] = set()  # folders for files that are not there yet
_moving = threading.RLock()  # held while files take their names or drafts are removed


class DraftLimits(NamedTuple):
    """A number that decides whether a draft is removed."""

    min_age: float = 60.0  # s of a draft without ``new``; a younger one may be about to be locked


LIMITS = DraftLimits()


class Draft:
    """A folder of files to come.

    Attributes:
        folder: their final one.
        new: where they are written.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.home = folder / f"{PREFIX}{secrets.token_hex(8)}"
        self.new, self._old = self.home / "new", self.home / "old"
        self._lock = _lock_of(self.home)

    def make(self) -> None:
        """Make the folder and lock it."""
        self.home.mkdir()
        with contextlib.suppress(OSError):  # systems without locks; there, abandoned drafts stay
            self._lock.acquire(blocking=False)
        self._old.mkdir()
        self.new.mkdir()  # last: a draft that has it has been locked

    def take_place(self) -> None:
        """Move all files to their final names, once they are safely on the disk."""
        written = sorted(self.new.iterdir())
        for path in written:
            for part in [path, *path.rglob("*")] if path.is_dir() else [path]:
                sync_to_disk(part)
        with _moving, hold_signals():
            for path in written:
                target, aside = self.folder / path.name, self._old / path.name
                if target.is_dir():
                    target.replace(aside)
                try:
                    path.replace(target)
                except BaseException:
                    _put_back(aside, target)
                    raise
            sync_to_disk(self.folder)

    def remove(self) -> None:
        """Remove the folder and release the lock."""
        with _moving, hold_signals():
            shutil.rmtree(self.home, ignore_errors=True)  # all but the lock's file, where open files stay
            self._lock.release()
            if self.home.exists():
                shutil.rmtree(self.home, ignore_errors=True)


@contextlib.contextmanager
def draft_in(folder: Path) -> Iterator[Draft]:
    """Yield a draft in a folder, and always remove it at the end.

    Raises:
        OSError: as the system does.
    """
    remove_abandoned(folder)
    draft = Draft(folder)
    _live.add(draft)
    try:
        draft.make()
        yield draft
    finally:
        draft.remove()
        _live.discard(draft)


@contextlib.contextmanager
def make_folder(folder: Path) -> Iterator[None]:
    """Make a folder and those above it where they are missing; they are gone again if the block fails.

    Raises:
        OSError: as the system does.
    """
    folders = []
    try:
        for path in reversed([folder, *folder.parents]):
            if not path.exists():
                folders.append(path)
                _made.add(path)
                path.mkdir(exist_ok=True)
        yield
    except BaseException:
        _remove_empty(folders)
        raise
    finally:
        _made.difference_update(folders)


def _remove_empty(folders: Iterable[Path]) -> None:
    for path in sorted(folders, key=lambda path: len(path.parts), reverse=True):
        with contextlib.suppress(OSError):
            path.rmdir()


def remove_live_drafts() -> None:
    """Remove the drafts of this process, before it ends at once; files that take their names now get there first."""
    with _moving:
        for draft in list(_live):
            draft.remove()
            _live.discard(draft)
        _remove_empty(list(_made))


def remove_abandoned(folder: Path) -> None:
    """Remove the drafts in a folder whose process was killed; a store that was to be replaced is put back."""
    for home in folder.glob(f"{PREFIX}*"):
        if not _NAME.fullmatch(home.name) or home.is_symlink() or not home.is_dir():
            continue
        with contextlib.suppress(OSError):  # in use, or gone meanwhile
            if not (home / "new").is_dir() and time.time() - home.stat().st_mtime < LIMITS.min_age:
                continue
            with _lock_of(home).acquire(blocking=False):
                for aside in (home / "old").glob("*"):
                    _put_back(aside, folder / aside.name)
                shutil.rmtree(home, ignore_errors=True)
            if home.exists():
                shutil.rmtree(home, ignore_errors=True)


@contextlib.contextmanager
def hold_signals() -> Iterator[None]:
    """Delay signals until the end of the block; only the main thread receives any."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    before: dict[int, Any] = {}
    try:
        for number in _SIGNALS:
            if callable(handler := signal.getsignal(number)):  # others do not interrupt Python
                before[number] = handler
                signal.signal(number, lambda number, frame: came.append(number))
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for number in came[:1]:
            signal.raise_signal(number)


def _put_back(aside: Path, target: Path) -> None:
    if aside.exists() and not target.exists():
        aside.replace(target)


def _lock_of(home: Path) -> FileLock:
    """Return the lock of a draft, which any thread may release: the one that ends a stopped process does."""
    return FileLock(home / "lock", thread_local=False)


def sync_to_disk(path: Path) -> None:
    """Wait until a file's bytes, or a folder's entries, are on the disk: some systems report a full disk only then.

    Raises:
        OSError: as the system does; it may have no such call for folders.
    """
    folder = path.is_dir()
    if folder and WINDOWS:
        return
    descriptor = os.open(path, os.O_RDWR if WINDOWS else os.O_RDONLY)
    try:
        os.fsync(descriptor)
    except OSError:
        if not folder:  # some systems have no such call for folders
            raise
    finally:
        os.close(descriptor)

"""One process compiles while others that need the same wait for it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple


class EntryLimits(NamedTuple):
    """Numbers that decide how long another process is waited for, and which files are read and stay."""

    max_wait: float = 600.0  # s that another process may take to compile
    max_bytes: int = 100_000_000  # of an image, of which the largest has some hundred thousand
    max_images: int = 24  # of one function: those of some processors, forms of arguments and earlier versions


LIMITS = EntryLimits()


@contextmanager
def alone(path: Path, max_wait: float) -> Iterator[None]:
    """Have one process do something, while others wait for so long [s], where files can be locked."""
    try:
        from filelock import FileLock

        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        lock = FileLock(path, timeout=max_wait)
        lock.acquire()
    except (ImportError, OSError, NotImplementedError):  # not there, read-only, without locks, held for too long
        yield
        return
    try:
        yield
    finally:
        lock.release()

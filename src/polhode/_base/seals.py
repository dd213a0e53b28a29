"""Seals of files that polhode writes for itself and reads back: reports, pages, marks of sweeps, compiled functions.

A disk or a memory that loses a bit changes a number silently, and bytes that are unpickled or run as machine code
may do anything. So such a file begins with the SHA-256 of the rest, which is read only where both agree; a damaged file
counts as missing, and its content is made again.

What follows begins with the file's own name, so that a copy or a renamed file counts as missing. Only files that nobody
but this user or root can have written are read: a seal tells damage, not intent. Files appear whole or not at all, so
that several processes may write one, and any of them may win.
"""

from __future__ import annotations

import hashlib
import os
import stat
import tempfile
from collections.abc import Iterable
from pathlib import Path

SEAL = 64  # characters of the first line
OF_OTHERS = stat.S_IWGRP | stat.S_IWOTH  # modes under which others can write
_PLAIN = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


def seal(content: bytes) -> bytes:
    """Return content under its seal."""
    return f"{hashlib.sha256(content).hexdigest()}\n".encode() + content


def unseal(sealed: bytes) -> bytes | None:
    """Return the content under a seal; None where the two disagree.

    >>> unseal(seal(b"numbers")), unseal(seal(b"numbers")[:-1] + b"t")
    (b'numbers', None)
    """
    first, content = sealed[: SEAL + 1], sealed[SEAL + 1 :]
    return content if first == f"{hashlib.sha256(content).hexdigest()}\n".encode() else None


def write_sealed(path: Path, content: bytes) -> None:
    """Write a file under a seal, whole or not at all, that only this user can read and write.

    Raises:
        OSError: as the system does.
    """
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor, draft = tempfile.mkstemp(dir=path.parent)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(seal(f"{path.name}\n".encode() + content))
        Path(draft).replace(path)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise


def read_sealed(path: Path, largest: int, installed: bool = False) -> bytes | None:
    """Return the content of a sealed file; None for a missing or damaged one, and for one that others may have written.

    Args:
        path: the file.
        largest: bytes that its content may have.
        installed: whether it came with the code that reads it, and is whoever's that is.
    """
    most = largest + SEAL + 2 + len(path.name.encode())
    try:
        descriptor = os.open(path, os.O_RDONLY | _PLAIN)
        with os.fdopen(descriptor, "rb") as file:
            status = os.fstat(descriptor)
            if not (stat.S_ISREG(status.st_mode) and status.st_size <= most):
                return None
            if not installed and not _is_of_this_user(status):
                return None
            sealed = file.read(most + 1)
    except (OSError, ValueError):
        return None
    content = unseal(sealed)
    name, _, rest = (content or b"").partition(b"\n")
    return rest if content is not None and name == path.name.encode() else None


def drop_oldest(files: Iterable[Path], most: int, size: int | None = None) -> None:
    """Remove the files that were used longest ago, until there are few enough and they are small enough.

    Args:
        files: that may go.
        most: how many may stay.
        size: bytes that may stay; None for any.
    """
    states = []
    for path in files:
        try:
            status = path.lstat()
        except OSError:  # gone meanwhile
            continue
        if stat.S_ISREG(status.st_mode):
            states.append((status.st_mtime, status.st_size, path))
    kept = 0
    for rank, (_, bytes_, path) in enumerate(sorted(states, reverse=True)):
        kept += bytes_
        if rank >= most or (size is not None and kept > size):
            try:
                path.unlink(missing_ok=True)
            except OSError:  # somebody else's
                continue


def _is_of_this_user(status: os.stat_result) -> bool:
    if not hasattr(os, "geteuid"):  # on Windows, where a user's folders are not for others by themselves
        return True
    return status.st_uid in (os.geteuid(), 0) and not status.st_mode & OF_OTHERS

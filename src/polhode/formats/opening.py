"""Opens input files: regular files only, without waiting, and no more bytes than the format's limit.

A pipe that nobody writes to would block the opening for ever, and a device such as /dev/zero never ends. Who keeps what
was computed from files has them recorded here, so that it is known, by content, which they were.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import stat
from collections.abc import Iterable, Iterator
from contextvars import ContextVar
from functools import lru_cache
from pathlib import Path
from typing import Any, BinaryIO

from polhode.errors import FormatError, InvalidInput

MB = 10**6  # bytes; formats state their limits in it
_for_a_spec: ContextVar[bool] = ContextVar("for_a_spec", default=False)
_recordings: ContextVar[tuple[set[Path], ...]] = ContextVar("recordings", default=())
_WITHOUT_WAITING = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0) | getattr(os, "O_BINARY", 0)
_KINDS_OF_NODE = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}


@contextlib.contextmanager
def open_for_a_spec() -> Iterator[None]:
    """Say of files that are missing how a spec's paths count."""
    before = _for_a_spec.set(True)
    try:
        yield
    finally:
        _for_a_spec.reset(before)


@contextlib.contextmanager
def record_files() -> Iterator[dict[Path, str]]:
    """Yield a dictionary that holds, after the block succeeds, every file that was read in it.

    Absolute path → SHA-256 of the content after the block, "" where it cannot be read any more: of files opened here,
    and of those that ``check_is_file`` checked before a library opened them. Other threads are not recorded.
    """
    opened: set[Path] = set()
    digests: dict[Path, str] = {}
    before = _recordings.set((*_recordings.get(), opened))
    try:
        yield digests
    finally:
        _recordings.reset(before)
    for path in sorted(opened):
        try:
            digests[path] = content_digest(path)
        except InvalidInput:  # what was read is no reason to fail
            digests[path] = ""


def content_digest(path: Path) -> str:
    """Return the SHA-256 of a file's content, "" where there is none; it is read again only when it was written.

    Raises:
        InvalidInput: for a path that is no regular file or may not be read.
    """
    try:
        status = path.stat()
    except (OSError, ValueError):
        return ""
    return _digest(path, status.st_size, status.st_mtime_ns, status.st_ctime_ns, status.st_ino)


@lru_cache(maxsize=1024)
def _digest(path: Path, *state: int) -> str:
    with open_file(path, "input") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()  # type: ignore[arg-type]


def check_is_file(path: Path, kind: str, limit: int | None = None) -> None:
    """Refuse a path that is not a regular file, or one of more bytes than ``limit``; nothing is opened.

    Names that the system cannot even look up, such as those with a NUL, belong to no file. A file that passes is
    recorded as read.

    Args:
        path: the file.
        kind: of file that it should be, for messages.
        limit: bytes that the file may have; None where they are not to be counted.

    Raises:
        InvalidInput: naming what the path is instead.
        FormatError: for a file that is too large.
    """
    try:
        status = path.stat()
    except (OSError, ValueError):
        within = "; in a spec it counts from the spec's own folder" if _for_a_spec.get() and kind != "spec" else ""
        why = f"no such {kind} file. Check the path{within}."
        raise InvalidInput(f"{path}: {why}") from None
    _check(path, kind, status, limit)
    note_files([path])


def note_files(paths: Iterable[Path]) -> None:
    """Record files as read."""
    absolute = {path.absolute() for path in paths}
    for opened in _recordings.get():
        opened.update(absolute)


def is_folder(path: Path) -> bool:
    """Whether a path leads to a folder; names that the system cannot look up do not."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def open_file(path: Path, kind: str, limit: int | None = None) -> BinaryIO:
    """Open a regular file to read its bytes.

    Raises:
        InvalidInput: for a file that is missing, not regular, or may not be read.
        FormatError: for a file that is too large.
    """
    check_is_file(path, kind, limit)
    try:
        file = io.BufferedReader(_File(path, os.open(path, os.O_RDONLY | _WITHOUT_WAITING)))
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be read ({error.strerror}). Check the path.") from None
    try:
        _check(path, kind, os.fstat(file.fileno()), limit)  # of the opened file, whatever is at the path by now
    except InvalidInput:
        file.close()
        raise
    return file


class _File(io.FileIO):
    """A file whose errors of reading name it, in libraries too."""

    def __init__(self, path: Path, descriptor: int) -> None:
        super().__init__(descriptor, "rb")
        self.path = path

    def readinto(self, buffer: Any) -> int | None:
        with self._name_errors():
            return super().readinto(buffer)

    def readall(self) -> bytes:
        with self._name_errors():
            return super().readall()

    @contextlib.contextmanager
    def _name_errors(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            raise InvalidInput(f"{self.path}: cannot be read ({error.strerror}). Check the disk.") from None


def read_file(path: Path, kind: str, limit: int) -> bytes:
    """Return the bytes of a regular file.

    Raises:
        InvalidInput: for a file that is missing, not regular, or cannot be read.
        FormatError: for a file that is too large.
    """
    with open_file(path, kind, limit) as file:
        content = file.read(limit + 1)
    if len(content) > limit:
        raise FormatError(_too_large(path, kind, "more", limit))
    return content


def read_text(path: Path, kind: str, limit: int) -> str:
    """Return the text of a regular file in UTF-8, without a byte-order mark, line ends as they are.

    Raises:
        InvalidInput: for a file that is missing, not regular, or cannot be read.
        FormatError: for a file that is too large, or not text.
    """
    try:
        text = read_file(path, kind, limit).decode("utf-8-sig")
    except UnicodeDecodeError:
        what = f"is not UTF-8 text, so it is not {_article(kind)} {kind} file. Save it as UTF-8."
        raise FormatError(f"{path}: {what}") from None
    if (place := text.find("\0")) >= 0:
        line = text.count("\n", 0, place) + 1
        what = f"has a NUL byte in line {line}, so it is not {_article(kind)} {kind} file"
        raise FormatError(f"{path}: {what}. Save it as UTF-8 text without one.")
    return text


def _check(path: Path, kind: str, status: os.stat_result, limit: int | None) -> None:
    if not stat.S_ISREG(status.st_mode):
        what = _KINDS_OF_NODE.get(stat.S_IFMT(status.st_mode), "something else")
        remedy = "Check the path." if stat.S_ISDIR(status.st_mode) else "Save what it gives as a file first."
        raise InvalidInput(f"{path}: is {what}, not {_article(kind)} {kind} file. {remedy}")
    if limit is not None and status.st_size > limit:
        raise FormatError(_too_large(path, kind, _format_size(status.st_size), limit))


def _too_large(path: Path, kind: str, size: str, limit: int) -> str:
    most = f"{_article(kind)} {kind} file may have {_format_size(limit)} at most"
    return f"{path}: has {size}; {most}. Give a part of it, or check the path."


def _article(kind: str) -> str:
    return "an" if kind.startswith("A") else "a"


def _format_size(size: int) -> str:
    return f"{size // MB:,} MB" if size >= MB else f"{size} bytes"

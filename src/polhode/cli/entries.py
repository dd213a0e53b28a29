"""Entries of the user's cache of reports: each is sealed, says what it came from, and is true while that is the same.

A command asks for one before it imports what would make it, so this file imports little.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import sys
import warnings
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.plugins import Plugin, list_modules_of_others
from polhode._base.plugins.program import program_digest
from polhode._base.seals import drop_oldest, read_sealed, write_sealed
from polhode.errors import PolhodeError
from polhode.formats.opening import content_digest, note_files

FOLDER = "POLHODE_REPORTS_CACHE"  # in the environment: where reports are kept; empty to keep none
REPORT, PAGE, WRITTEN = ".report", ".page", ".written"  # ends of names
MOST, LARGEST = 32, 50_000_000  # entries of one ending, and bytes of one
FORMAT = 1


class Origin(NamedTuple):
    """What an entry came from besides its spec, and what it needs: its first line.

    Attributes:
        format: of the entry.
        program: digest of the program and of the other packages' code.
        plugins: what took part of these.
        read: files, with SHA-256 of their content.
        jax: whether there are arrays of JAX, which are cut to 32 bits unless it is switched to 64.
    """

    format: int
    program: str
    plugins: tuple[Plugin, ...]
    read: dict[str, str]
    jax: bool

    @classmethod
    def of(cls, plugins: Iterable[Plugin], read: dict[Path, str], before: dict[str, str] | None = None) -> Origin:
        """Return the origin of what is made in this process.

        Args:
            plugins: that took part.
            read: files that were read for it, with their digests.
            before: those that what it was made from had read.
        """
        used = tuple(sorted(set(plugins)))
        # what code of others imported by names that it put together is in no text, but has been imported by now
        modules = list_modules_of_others() if used else []
        digests = {str(path): content_digest(path) for path in modules}
        named = (before or {}) | {str(path): digest for path, digest in read.items()} | digests
        return cls(format=FORMAT, program=program_digest(used), plugins=used, read=named, jax="jax" in sys.modules)

    @classmethod
    def from_line(cls, line: bytes) -> Origin | None:
        """Return the origin that a line is; None where it is none, as of another version."""
        try:
            given = json.loads(line)
            plugins = tuple(Plugin(*map(str, one)) for one in given.pop("plugins"))
            origin = cls(plugins=plugins, **given)
        except (ValueError, TypeError, KeyError, AttributeError):
            return None
        return origin if isinstance(origin.read, dict) else None

    @property
    def line(self) -> bytes:
        """The line that ``from_line`` reads."""
        return json.dumps(self._asdict()).encode() + b"\n"

    @property
    def is_unchanged(self) -> bool:
        """Whether files and code are still the same."""
        return (self.format == FORMAT and program_digest(self.plugins) == self.program
                and all(content_digest(Path(path)) == digest for path, digest in self.read.items()))


def folder_of_entries() -> Path | None:
    """Return where entries are kept; None for nowhere."""
    named = os.environ.get(FOLDER)
    return Path(named) if named else None


def load_entry(place: Path) -> tuple[Origin, bytes] | None:
    """Return an entry that is whole and still true; None where there is none."""
    content = read_sealed(place, LARGEST)
    if content is None:
        return None
    first, _, packed = content.partition(b"\n")
    try:
        origin = Origin.from_line(first)
        if origin is None or not origin.is_unchanged:
            return None
    except (PolhodeError, OSError):
        return None
    note_files(map(Path, origin.read))  # what is made from this has read them too
    with contextlib.suppress(OSError):
        os.utime(place)
    return origin, packed


def keep_entry(packed: bytes, origin: Origin, place: Path) -> None:
    """Keep an entry, unless it is too large, in place of the one that was used longest ago."""
    content = origin.line + packed
    if len(content) > LARGEST:
        return
    write_sealed(place, content)
    drop_oldest([path for path in place.parent.iterdir() if _find_ending(path) == _find_ending(place)], MOST)


@contextlib.contextmanager
def record_warnings() -> Iterator[list[str]]:
    """Yield a list of the warnings that are shown while the block runs; whoever loads an entry would not see them."""
    shown: list[str] = []
    show = warnings.showwarning

    def record_and_show(message: Warning | str, *where: Any, **more: Any) -> None:
        shown.append(str(message))
        show(message, *where, **more)

    warnings.showwarning = record_and_show
    try:
        yield shown
    finally:
        warnings.showwarning = show


def may_have_changed(paths: Iterable[Path | str], begun: int) -> bool:
    """Whether any file may be another one than was read, as its digest is taken later.

    Args:
        paths: of files that were read.
        begun: when reading began [ns since 1970].
    """
    return any(_time_of_change(Path(path)) >= begun for path in paths)


def _time_of_change(path: Path) -> float:
    """Return when a file was last written or put in its place [ns]; infinity for one that is gone."""
    try:
        status = path.stat()
    except OSError:
        return math.inf
    return max(status.st_mtime_ns, status.st_ctime_ns)


def _find_ending(path: Path) -> str:
    """Return the ending of an entry; drafts that were left behind go with the reports."""
    return path.suffix if path.suffix in (PAGE, WRITTEN) else REPORT

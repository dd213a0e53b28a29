"""Zip archives with the tables of a gyro log: only the wanted tables are taken out, within bounds."""

from __future__ import annotations

import contextlib
import tempfile
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from polhode.errors import FormatError, InvalidInput
from polhode.formats.opening import MB, open_file

TABLES = (".csv", ".tsv", ".txt", ".dat", ".tab")
_END = b"PK\x05\x06"
_UNPACK = "Unpack it, and name the folder or the file."


class ArchiveThresholds(NamedTuple):
    """Numbers that decide which archives are refused, in bytes unless said otherwise.

    Attributes:
        max_archive: of an archive.
        max_unpacked: of all members together that are unpacked.
        max_directory: of the list of members, some 50,000 names.
        max_ratio: unpacked over packed; tables of a gyro have some 3 to 20.
        min_dense: of an unpacked member, from which its ratio counts.
    """

    max_archive: int = 1000 * MB
    max_unpacked: int = 1000 * MB
    max_directory: int = 5 * MB
    max_ratio: int = 200
    min_dense: int = 20 * MB


LIMITS = ArchiveThresholds()


def is_archive(path: Path) -> bool:
    """Whether a regular file begins as a zip archive does.

    Raises:
        InvalidInput: for what is missing, or cannot be read.
    """
    with open_file(path, "log") as file:
        return file.read(4) in (b"PK\x03\x04", _END)


@contextlib.contextmanager
def unpack_log(path: Path, wanted: Sequence[str], beside: Sequence[str]) -> Iterator[tuple[Path, str]]:
    """Yield the log of an archive as a file in a temporary folder, and its name in the archive.

    Args:
        path: of the archive.
        wanted: possible names of the log's table, the likeliest first; else the archive may have one table only.
        beside: names of tables that are taken out with it, where they lie in the same folder of the archive.

    Raises:
        FormatError: for what cannot be unpacked within bounds.
        InvalidInput: for an archive without such a table, or with several.
    """
    _check_directory(path)
    with tempfile.TemporaryDirectory() as place:
        try:
            with zipfile.ZipFile(path) as archive:
                members = [member for member in archive.infolist() if not member.is_dir()]
                log = _log_in(path, members, wanted)
                inside = PurePosixPath(log.filename)
                taken = [member for member in members if PurePosixPath(member.filename).name in beside
                         and PurePosixPath(member.filename).parent == inside.parent and member is not log]
                _check_sizes(path, [log, *taken])
                for member in (log, *taken):
                    _take_out(archive, member, Path(place))
        # raised by zipfile and zlib for damaged, encrypted or unknown members, by the evidence of fuzzing
        except (zipfile.BadZipFile, RuntimeError, NotImplementedError, EOFError, ValueError, OSError,
                zlib.error) as error:
            if isinstance(error, FormatError | InvalidInput):
                raise
            raise FormatError(f"{path}: is not an archive that can be unpacked ({error}). {_UNPACK}") from None
        yield Path(place) / inside.name, str(inside)


def _check_directory(path: Path) -> None:
    """Refuse an archive whose list of members alone would fill the memory."""
    with open_file(path, "log", LIMITS.max_archive) as file:
        size = file.seek(0, 2)
        end_size, longest_comment = 22, 65535  # of the format
        file.seek(max(size - end_size - longest_comment, 0))
        tail = file.read()
    begin = tail.rfind(_END)
    if begin < 0 or len(tail) < begin + end_size:
        raise FormatError(f"{path}: begins like a zip archive and does not end like one, so it is cut off. Save it "
                          "again.")
    if int.from_bytes(tail[begin + 12 : begin + 16], "little") > LIMITS.max_directory:
        most = LIMITS.max_directory // MB
        raise FormatError(f"{path}: lists more members than a log has, over {most} MB of names. {_UNPACK}")


def _log_in(path: Path, members: Sequence[zipfile.ZipInfo], wanted: Sequence[str]) -> zipfile.ZipInfo:
    named = {name: [m for m in members if PurePosixPath(m.filename).name == name] for name in wanted}
    logs = next((each for each in named.values() if each), [])
    tables = [m for m in members if PurePosixPath(m.filename).suffix.lower() in TABLES
              and not PurePosixPath(m.filename).name.startswith("._")]
    logs = logs or (tables if len(tables) == 1 else [])
    if not logs:
        has = f"; its tables are {_name_all(tables)}" if tables else ""
        raise InvalidInput(f"{path}: has no {' or '.join(wanted)}{has}. Unpack it, and name the file with the angular "
                           "velocities.")
    if len(logs) > 1:
        raise InvalidInput(f"{path}: has {len(logs)} logs, {_name_all(logs)}. Unpack it, and name those of one body.")
    return logs[0]


def _name_all(members: Sequence[zipfile.ZipInfo]) -> str:
    listed = 4
    more = f" and {len(members) - listed} more" if len(members) > listed else ""
    return ", ".join(member.filename for member in members[:listed]) + more


def _check_sizes(path: Path, members: Sequence[zipfile.ZipInfo]) -> None:
    for member in members:
        if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise FormatError(f"{path}: {member.filename} in it is packed by another method than deflate. {_UNPACK}")
        if member.file_size > max(LIMITS.min_dense, LIMITS.max_ratio * member.compress_size):
            raise FormatError(f"{path}: {member.filename} in it has {member.file_size // MB} MB packed into "
                              f"{member.compress_size} bytes, which no log is. {_UNPACK}")
    if (total := sum(member.file_size for member in members)) > LIMITS.max_unpacked:
        most = LIMITS.max_unpacked // MB
        raise FormatError(f"{path}: its log has {total // MB:,} MB unpacked; {most:,} MB are taken at most. {_UNPACK}")


def _take_out(archive: zipfile.ZipFile, member: zipfile.ZipInfo, place: Path) -> None:
    """Write a member under its bare name; refuse it beyond the size that was announced and checked."""
    left = member.file_size
    with archive.open(member) as source, (place / PurePosixPath(member.filename).name).open("wb") as target:
        while chunk := source.read(min(1 << 20, left + 1)):
            left -= len(chunk)
            if left < 0:
                raise zipfile.BadZipFile(f"{member.filename} has more bytes than it says")
            target.write(chunk)

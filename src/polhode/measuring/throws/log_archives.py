"""Zip archives with the tables of a gyro log: only the wanted tables are taken out, within bounds."""

from __future__ import annotations

import contextlib
import tempfile
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath

from polhode.errors import FormatError, InvalidInput
from polhode.formats.opening import MB, open_file

LARGEST_ARCHIVE = 1000 * MB
LARGEST_UNPACKED = 1000 * MB  # all that is taken out of one archive together
LARGEST_DIRECTORY = 5 * MB  # some 50,000 names
DENSEST, DENSE_FROM = 200, 20 * MB  # bytes out of one, of members of so many; tables of a gyro give some 3 to 20
TABLES = (".csv", ".tsv", ".txt", ".dat", ".tab")
SHOWN = 4
_END = b"PK\x05\x06"
_END_SIZE, _LONGEST_COMMENT = 22, 65535
_CHUNK = 1 << 20
_UNPACK = "Unpack it, and name the folder or the file."


def is_archive(path: Path) -> bool:
    """Whether a regular file begins as a zip archive does.

    Raises:
        InvalidInput: for what is missing, or cannot be read.
    """
    with open_file(path, "log") as file:
        return file.read(4) in (b"PK\x03\x04", _END)


@contextlib.contextmanager
def unpack_log(path: Path, wanted: Sequence[str], beside: Sequence[str]) -> Iterator[tuple[Path, str]]:
    """Yield the log of an archive as a file in a folder that goes afterwards, and its name in the archive.

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
                         and PurePosixPath(member.filename).parent == inside.parent and member is not log]  # fmt: skip
                _check_sizes(path, [log, *taken])
                for member in (log, *taken):
                    _take_out(archive, member, Path(place))
        # what zipfile and zlib raise of damaged, encrypted or unknown members, as fuzzing found
        except (zipfile.BadZipFile, RuntimeError, NotImplementedError, EOFError, ValueError, OSError,
                zlib.error) as error:  # fmt: skip
            if isinstance(error, FormatError | InvalidInput):
                raise
            raise FormatError(f"{path}: is not an archive that can be unpacked ({error}). {_UNPACK}") from None
        yield Path(place) / inside.name, str(inside)


def _check_directory(path: Path) -> None:
    """Refuse an archive whose list of members alone would fill the memory."""
    with open_file(path, "log", LARGEST_ARCHIVE) as file:
        size = file.seek(0, 2)
        file.seek(max(size - _END_SIZE - _LONGEST_COMMENT, 0))
        tail = file.read()
    begin = tail.rfind(_END)
    if begin < 0 or len(tail) < begin + _END_SIZE:
        raise FormatError(f"{path}: begins like a zip archive and does not end like one, so it is cut off. Save it "
                          "again.")  # fmt: skip
    if int.from_bytes(tail[begin + 12 : begin + 16], "little") > LARGEST_DIRECTORY:
        most = LARGEST_DIRECTORY // MB
        raise FormatError(f"{path}: lists more members than a log has, over {most} MB of names. {_UNPACK}")


def _log_in(path: Path, members: Sequence[zipfile.ZipInfo], wanted: Sequence[str]) -> zipfile.ZipInfo:
    named = {name: [m for m in members if PurePosixPath(m.filename).name == name] for name in wanted}
    logs = next((each for each in named.values() if each), [])
    tables = [m for m in members if PurePosixPath(m.filename).suffix.lower() in TABLES
              and not PurePosixPath(m.filename).name.startswith("._")]  # fmt: skip
    logs = logs or (tables if len(tables) == 1 else [])
    if not logs:
        has = f"; its tables are {_name_all(tables)}" if tables else ""
        raise InvalidInput(f"{path}: has no {' or '.join(wanted)}{has}. Unpack it, and name the file with the angular "
                           "velocities.")  # fmt: skip
    if len(logs) > 1:
        raise InvalidInput(f"{path}: has {len(logs)} logs, {_name_all(logs)}. Unpack it, and name those of one body.")
    return logs[0]


def _name_all(members: Sequence[zipfile.ZipInfo]) -> str:
    more = f" and {len(members) - SHOWN} more" if len(members) > SHOWN else ""
    return ", ".join(member.filename for member in members[:SHOWN]) + more


def _check_sizes(path: Path, members: Sequence[zipfile.ZipInfo]) -> None:
    for member in members:
        if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise FormatError(f"{path}: {member.filename} in it is packed by another method than deflate. {_UNPACK}")
        if member.file_size > DENSE_FROM and member.file_size > DENSEST * member.compress_size:
            raise FormatError(f"{path}: {member.filename} in it has {member.file_size // MB} MB packed into "
                              f"{member.compress_size} bytes, which no log is. {_UNPACK}")  # fmt: skip
    if (total := sum(member.file_size for member in members)) > LARGEST_UNPACKED:
        most = LARGEST_UNPACKED // MB
        raise FormatError(f"{path}: its log has {total // MB:,} MB unpacked; {most:,} MB are taken at most. {_UNPACK}")


def _take_out(archive: zipfile.ZipFile, member: zipfile.ZipInfo, place: Path) -> None:
    """Write a member under its bare name; refuse it beyond the size that was announced and checked."""
    left = member.file_size
    with archive.open(member) as source, (place / PurePosixPath(member.filename).name).open("wb") as target:
        while chunk := source.read(min(_CHUNK, left + 1)):
            left -= len(chunk)
            if left < 0:
                raise zipfile.BadZipFile(f"{member.filename} has more bytes than it says")
            target.write(chunk)

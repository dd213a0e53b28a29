"""The text of a CCSDS Attitude Ephemeris Message taken apart: keywords, epochs, numbers.

Source: CCSDS 504.0-B-2, sections 4 and 6, annex J for version 1.0.
"""

from __future__ import annotations

import difflib
import io
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.aem_attitudes import COLUMNS, OLD_NAMES
from polhode.formats.epochs import TIME_SYSTEMS, read_epoch
from polhode.formats.labels import plain
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, open_file
from polhode.types import Array, Float64, Integer

LONGEST_LINE = 16_384  # characters; the standard allows 254
LARGEST_FILE = 2000 * MB  # fifteen million attitudes
CHUNK = 50_000  # lines that are in memory as text at once
HEADER = ("CLASSIFICATION", "CREATION_DATE", "ORIGINATOR", "MESSAGE_ID")
NEEDED = (
    "OBJECT_NAME", "OBJECT_ID", "REF_FRAME_A", "REF_FRAME_B", "TIME_SYSTEM", "START_TIME", "STOP_TIME", "ATTITUDE_TYPE",
)  # fmt: skip
OPTIONAL = (
    "CENTER_NAME", "USEABLE_START_TIME", "USEABLE_STOP_TIME", "EULER_ROT_SEQ", "ANGVEL_FRAME", "INTERPOLATION_METHOD",
    "INTERPOLATION_DEGREE", "ATTITUDE_DIR", "QUATERNION_TYPE", "RATE_FRAME",
)  # fmt: skip
Lines = Iterator[tuple[int, str]]


@dataclass(eq=False)
class Segment:
    """One block of metadata with its data, as they stand in the file.

    Attributes:
        path: the file.
        old: whether it is of version 1.0.
        values: keyword → value, of the header too.
        lines: keyword → its line in the file.
        comments: in the metadata.
        whole: (n,) instants of the data, seconds.
        picoseconds: (n,) the rest of them.
        columns: (n, k) numbers of the data.
        numbers: (n,) lines of the data in the file.
    """

    path: Path
    old: bool
    values: dict[str, str]
    lines: dict[str, int]
    comments: list[str]
    whole: Integer[Array, "n"] = field(init=False)
    picoseconds: Integer[Array, "n"] = field(init=False)
    columns: Float64[Array, "n k"] = field(init=False)
    numbers: Integer[Array, "n"] = field(init=False)

    def wrong(self, keyword: str, what: str) -> NoReturn:
        """Say what is wrong with the value of a keyword, or without one.

        Raises:
            FormatError: always.
        """
        refuse(self.path, self.lines.get(keyword, self.lines["META_START"]), f"{keyword} {what}")

    @property
    def kind(self) -> str:
        """The type of attitude, as version 2.0 names it."""
        name = plain(self.values["ATTITUDE_TYPE"]).replace(" ", "_")
        name = OLD_NAMES.get(name, name) if self.old else name
        if name not in COLUMNS:
            self.wrong(
                "ATTITUDE_TYPE", f"must be one of {', '.join(COLUMNS)}; got "
                f"{shown(self.values['ATTITUDE_TYPE'])}"
            )
        return name

    @property
    def time_system(self) -> str:
        """The time system of all epochs but that of creation."""
        name = plain(self.values["TIME_SYSTEM"])
        if name not in TIME_SYSTEMS:
            self.wrong("TIME_SYSTEM", f"must be one of {', '.join(TIME_SYSTEMS)} to be read here; got {shown(name)}")
        return name

    def epoch(self, keyword: str) -> tuple[int, int]:
        """Return the instant that a keyword gives.

        Raises:
            FormatError: if it is none.
        """
        try:
            return read_epoch(self.values[keyword], self.time_system)
        except ValueError as error:
            self.wrong(keyword, str(error))


def refuse(path: Path, number: int | None, what: str) -> NoReturn:
    """Say what is wrong in a file.

    Raises:
        FormatError: always.
    """
    raise FormatError(f"{path}, line {number}: {what}." if number else f"{path}: {what}.")


class WrittenInXml(Exception):
    """The file begins as XML does."""


def read_segments(path: Path) -> list[Segment]:
    """Return the segments of a file in keyword = value form.

    Raises:
        InvalidInput: if the file is missing.
        FormatError: naming the line, if it is no AEM.
        WrittenInXml: if it is XML, which ``aem_xml`` reads.
    """
    lines = _lines(path)
    number, first = next(lines, (None, ""))
    if first.startswith("<"):
        raise WrittenInXml
    if "=" not in first or first.split("=")[0].strip() != "CCSDS_AEM_VERS":
        refuse(path, number,
            f"an AEM begins with CCSDS_AEM_VERS = 2.0; got {shown(first[:60])}. "
            "It is another kind of file"
        )
    version = first.split("=")[1].strip()
    if version not in ("1.0", "2.0"):
        refuse(path, number, f"CCSDS_AEM_VERS must be 1.0 or 2.0; got {shown(version)}. Have it written in version 2.0")
    header, places, segments = {}, {}, []
    for number, text in lines:
        if text == "META_START":
            one = Segment(path, version == "1.0", dict(header), places | {"META_START": number}, [])
            _read_metadata(lines, one)
            _read_data(lines, one)
            segments.append(one)
        elif segments and not _is_comment(text):
            refuse(path, number, f"must be META_START of the next segment; got {shown(text[:60])}")
        elif not _is_comment(text):
            _assign(path, number, text, HEADER, header, places)
    if not segments:
        refuse(path, None, "holds no segment, META_START … DATA_STOP; it is cut short. Get it whole")
    return segments


def _lines(path: Path) -> Lines:
    """Yield numbered lines that are not blank."""
    try:
        with io.TextIOWrapper(open_file(path, "AEM", LARGEST_FILE), "utf-8-sig") as file:
            for number, line in enumerate(iter(lambda: file.readline(LONGEST_LINE + 1), ""), 1):
                if len(line) > LONGEST_LINE:
                    refuse(path, number, f"has more than {LONGEST_LINE} characters. It is another kind of file")
                if not (text := line.strip()):
                    continue
                if not text.isprintable() and not text.replace("\t", " ").isprintable():
                    refuse(path, number, f"must be printable text; got {shown(text)}")
                yield number, text
    except UnicodeDecodeError:
        raise FormatError(f"{path}: is not text, so it is no AEM in keyword = value form.") from None
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be read ({error.strerror}). Check the path.") from None


def _is_comment(text: str) -> bool:
    return text.split(None, 1)[0] == "COMMENT"


def _assign(
    path: Path, number: int, text: str, known: tuple[str, ...], values: dict[str, str], places: dict[str, int]
) -> None:
    keyword, equals, value = (part.strip() for part in text.partition("="))
    if not equals:
        refuse(path, number, f"must be keyword = value here; got {shown(text[:60])}")
    if keyword not in known:
        near = difflib.get_close_matches(keyword, known, n=1)
        hint = f"did you mean {near[0]}?" if near else f"known here are {', '.join(known)}"
        refuse(path, number, f"unknown keyword {shown(keyword)}; {hint}")
    if keyword in values:
        refuse(path, number, f"{keyword} is there already, in line {places[keyword]}. Leave out one")
    if not value:
        refuse(path, number, f"{keyword} must have a value")
    values[keyword], places[keyword] = value, number


def _read_metadata(lines: Lines, one: Segment) -> None:
    begun = one.lines["META_START"]
    for number, text in lines:
        if text == "META_STOP":
            break
        if _is_comment(text):
            one.comments.append(text[len("COMMENT") :].strip())
        else:
            _assign(one.path, number, text, NEEDED + OPTIONAL, one.values, one.lines)
    else:
        refuse(one.path, begun, "META_START has no META_STOP; the file is cut short. Get it whole")
    check_metadata(one)


def check_metadata(one: Segment) -> None:
    """Refuse metadata without a keyword that is needed, and spans that end before they begin.

    Raises:
        FormatError: naming the line.
    """
    begun = one.lines["META_START"]
    if missing := [keyword for keyword in NEEDED if keyword not in one.values]:
        refuse(one.path, begun, f"the metadata need {' and '.join(missing)}")
    for first, last in (("START_TIME", "STOP_TIME"), ("USEABLE_START_TIME", "USEABLE_STOP_TIME")):
        if first in one.values and last in one.values and one.epoch(last) < one.epoch(first):
            one.wrong(last, f"must not lie before {first}; got {one.values[last]}, and {one.values[first]} there")


def _read_data(lines: Lines, one: Segment) -> None:
    number, text = next(lines, (None, "nothing"))
    if text != "DATA_START":
        refuse(one.path, number, f"DATA_START must follow META_STOP; got {shown(text[:60])}")
    begun, parts, rows = number, [], []
    time_system = one.time_system
    for number, text in lines:
        if text == "DATA_STOP":
            break
        if not text[0].isdigit() and _is_comment(text):
            continue
        rows.append((number, text))
        if len(rows) == CHUNK:
            parts.append(_values(one.path, rows, one.kind, time_system))
            rows = []
    else:
        refuse(one.path, begun, "DATA_START has no DATA_STOP; the file is cut short. Get it whole")
    parts.append(_values(one.path, rows, one.kind, time_system))
    whole, picoseconds, columns, numbers = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    if not len(whole):
        refuse(one.path, begun, "there are no data between DATA_START and DATA_STOP")
    keep_data(one, whole, picoseconds, columns, numbers)


def keep_data(
    one: Segment, whole: Integer[Array, "n"], picoseconds: Integer[Array, "n"], columns: Float64[Array, "n k"],
    numbers: Integer[Array, "n"],
) -> None:  # fmt: skip
    """Put instants, columns and the numbers of their lines into a segment.

    Raises:
        FormatError: naming the line of an epoch that does not come after the one before.
    """
    steps = np.diff(whole)
    ascending = (steps > 0) | ((steps == 0) & (np.diff(picoseconds) > 0))
    if not ascending.all():
        place = int(numbers[1:][~ascending][0])
        refuse(one.path, place, "epochs must ascend, without repetition; this one does not come after the one before")
    one.whole, one.picoseconds, one.columns, one.numbers = whole, picoseconds, columns, numbers


def _values(path: Path, rows: list[tuple[int, str]], kind: str, time_system: str) -> tuple[Array, ...]:
    """Return seconds, picoseconds, numbers (n, k) and line numbers of data lines."""
    width = COLUMNS[kind]
    fields = [text.split() for _, text in rows]
    for (number, text), row in zip(rows, fields, strict=True):
        if len(row) != width + 1:
            refuse(path, number, f"must be an epoch and {width} numbers, as ATTITUDE_TYPE says; got {shown(text[:60])}")
    instants = np.zeros((len(rows), 2), dtype=np.int64)
    for k, row in enumerate(fields):
        try:
            instants[k] = read_epoch(row[0], time_system)
        except ValueError as error:
            refuse(path, rows[k][0], f"the epoch {error}")
    columns = np.array([[_number(word) for word in row[1:]] for row in fields]).reshape(-1, width)
    if not (good := np.isfinite(columns)).all():
        k, column = np.argwhere(~good)[0]
        word = fields[k][column + 1]
        what = f"number {column + 1} of the {width} that make {kind} must be finite, in decimal digits"
        refuse(path, rows[k][0], f"{what}; got {shown(word)}")
    return instants[:, 0], instants[:, 1], columns, np.array([number for number, _ in rows], dtype=np.int64)


def _number(word: str) -> float:
    try:
        return read_number(word)
    except ValueError:
        return float("nan")

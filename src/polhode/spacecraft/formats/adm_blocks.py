"""A block of a CCSDS Attitude Data Message: its keywords with their lines, and what they say of frames and times."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from polhode.errors import FormatError, shown
from polhode.formats.aem_attitudes import Meaning, attitudes
from polhode.formats.epochs import TIME_SYSTEMS, read_epoch
from polhode.formats.labels import is_in_spacecraft, plain
from polhode.formats.numerals import read_number
from polhode.types import Array, Bool, Float64, Integer, Shaped

_UNIT = re.compile(r"\s*\[(?P<unit>[^\]]*)\]\s*$")
_ROTATION_SEQUENCE = re.compile(r"([XYZ])(?!\1)([XYZ])(?!\2)[XYZ]")
CHECK = "Check the file."


def refuse(path: Path, line: int | None, what: str) -> NoReturn:
    """Say what is wrong in a file.

    Raises:
        FormatError: always.
    """
    raise FormatError(f"{path}, line {line}: {what}" if line else f"{path}: {what}")


@dataclass(eq=False)
class Block:
    """A block of a message.

    Attributes:
        path: the file.
        name: "QUAT" for what stands between QUAT_START and QUAT_STOP; "" for header, and metadata that go with it.
        line: where it begins.
        values: keyword → value, with its unit in brackets, and line.
        comments: in it.
        rows: lines of numbers, each with its line, until they are converted.
        parts: what they were converted to, piece by piece.
        states: the elements of XML that have an attitude each.
    """

    path: Path
    name: str
    line: int
    values: dict[str, tuple[str, int]] = field(default_factory=dict)
    comments: list[str] = field(default_factory=list)
    rows: list[tuple[int, str]] = field(default_factory=list)
    parts: list[tuple[Array, ...]] = field(default_factory=list)
    states: list[Block] = field(default_factory=list)

    def wrong(self, keyword: str, what: str, remedy: str = CHECK) -> NoReturn:
        """Say what is wrong with a keyword, or without it, and what to do about it.

        Raises:
            FormatError: always.
        """
        line = self.values[keyword][1] if keyword in self.values else self.line
        refuse(self.path, line, f"{keyword} {what}. {remedy}")

    def text(self, keyword: str, default: str | None = None) -> str:
        """Return the value of a keyword.

        Raises:
            FormatError: where it is missing, and has no default.
        """
        if keyword not in self.values:
            if default is None:
                self.wrong(keyword, f"is missing in this block {self.name}" if self.name else "is missing")
            return default
        return self.values[keyword][0]

    def number(self, keyword: str, unit: str, default: float | None = None) -> float:
        """Return the number of a keyword, in the one unit that the standard has for it.

        Raises:
            FormatError: where it is missing and has no default, is no number, or has another unit.
        """
        if default is not None and keyword not in self.values:
            return default
        text = self.text(keyword)
        if match := _UNIT.search(text):
            text = text[: match.start()]
            if match["unit"].replace(" ", "") != unit:
                self.wrong(keyword, f"must be in {unit or 'no unit'}; got {shown(match['unit'])}")
        try:
            return read_number(text)
        except ValueError as error:
            self.wrong(keyword, f"{error}; got {shown(text)}")

    def numbers(self, units: dict[str, str]) -> list[float]:
        """Return the numbers of several keywords, each in its unit; raises as ``number`` does."""
        return [self.number(keyword, unit) for keyword, unit in units.items()]

    def read_rows(self, instant: Callable[[str], Any], width: int | None, why: str) -> tuple[
        Shaped[Array, "n *more"], Float64[Array, "n width"], Integer[Array, "n"]
    ]:
        """Return instants (n, …), numbers (n, width) and line numbers (n,) of the rows.

        Args:
            instant: of a row's first word; raises ValueError.
            width: how many numbers must follow; None for as many as in the first row.
            why: so many must follow.

        Raises:
            FormatError: naming the line.
        """
        instants, columns = [], []
        for line, text in self.rows:
            time, *words = text.split()
            width, row = len(words) if width is None else width, []
            if len(words) != width:
                refuse(self.path, line, f"must be an epoch and {width} numbers, {why}; got {shown(text[:60])}. {CHECK}")
            try:
                instants.append(instant(time))
            except ValueError as error:
                refuse(self.path, line, f"the epoch {error}. {CHECK}")
            try:
                for word in words:
                    row.append(read_number(word))
            except ValueError as error:
                k = len(row)
                refuse(self.path, line, f"number {k + 1} of the {width} {error}; got {shown(words[k])}. {CHECK}")
            columns.append(row)
        lines = np.array([line for line, _ in self.rows], dtype=np.int64)
        return np.array(instants), np.array(columns), lines

    def turn(
        self, meaning: Meaning, columns: Float64[Array, "n k"], lines: Integer[Array, "n"]
    ) -> tuple[Float64[Array, "n 4"], Float64[Array, "n 3"] | None]:
        """Return attitudes and angular velocities, or None, as ``attitudes`` does, of numbers with their lines.

        Raises:
            FormatError: naming the line of what is no rotation, or is too large.
        """
        try:
            with np.errstate(all="ignore"):  # what overflows is not finite, and refused
                attitude, velocity = attitudes(meaning, columns)
        except ValueError as error:
            what, k = error.args
            refuse(self.path, int(lines[k]), f"{what}. {CHECK}")
        self.check_finite("a rotation or a rate", lines, attitude, velocity)
        return attitude, velocity

    def check_finite(self, what: str, lines: Integer[Array, "n"], *samples: Float64[Array, "n _"] | None) -> None:
        """Refuse samples (n, k) that came out infinite.

        Raises:
            FormatError: naming the line.
        """
        columns = np.concatenate([sample for sample in samples if sample is not None], axis=-1)
        if (wrong := ~np.isfinite(columns).all(axis=-1)).any():
            refuse(self.path, int(lines[np.argmax(wrong)]), f"gives {what} too large for numbers. {CHECK}")

    def check_ascending(self, ascending: Bool[Array, "n_less_one"], lines: Integer[Array, "n"]) -> None:
        """Refuse instants that do not come after the one before.

        Args:
            ascending: whether the second instant and each later one do.
            lines: of all.

        Raises:
            FormatError: naming the line.
        """
        if not ascending.all():
            line = int(lines[1:][~ascending][0])
            refuse(self.path, line, "epochs must ascend, without repetition; this one does not come after the one "
                                    f"before. {CHECK}")

    def has(self, keywords: list[str]) -> bool:
        """Whether the block has all of these."""
        return all(keyword in self.values for keyword in keywords)

    @property
    def time_system(self) -> str:
        """The time system of all epochs but that of creation."""
        name = plain(self.text("TIME_SYSTEM"))
        if name not in TIME_SYSTEMS:
            self.wrong("TIME_SYSTEM", f"must be one of {', '.join(TIME_SYSTEMS)} to be read here; got {shown(name)}")
        return name

    def epoch(self, keyword: str) -> tuple[int, int]:
        """Return the instant that a keyword gives: seconds, picoseconds.

        Raises:
            FormatError: if it is none.
        """
        text, time_system = self.text(keyword), self.time_system  # what they refuse is a ValueError too
        try:
            return read_epoch(text, time_system)
        except ValueError as error:
            self.wrong(keyword, str(error))

    def frames(self) -> tuple[str, str, bool]:
        """Return the space frame, the body's, and whether frame A is the body's.

        Raises:
            FormatError: where one is missing, or both are one, between which nothing turns.
        """
        a, b = self.text("REF_FRAME_A"), self.text("REF_FRAME_B")
        if plain(a) == plain(b):
            self.wrong("REF_FRAME_B", f"must be another frame than REF_FRAME_A; got {shown(b)} for both")
        backward = is_in_spacecraft(a) and not is_in_spacecraft(b)
        return (b, a, True) if backward else (a, b, False)

    def sequence(self) -> str:
        """Return the axes of the Euler angles, like "ZXZ".

        Raises:
            FormatError: for what are no three axes, neighbours different.
        """
        text = self.text("EULER_ROT_SEQ", "")
        sequence = text.upper().translate(str.maketrans("123", "XYZ"))
        if not _ROTATION_SEQUENCE.fullmatch(sequence):
            self.wrong("EULER_ROT_SEQ", "must be three axes, neighbours different, like ZXZ; got "
                                        f"{shown(text or 'nothing')}")
        return sequence

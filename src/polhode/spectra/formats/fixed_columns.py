"""Text in fixed columns, as spectroscopists use it: fields may touch, and their position alone identifies them.

Whole numbers that are too long for their field begin with a letter: in two columns A0 is 100 and Z9 is 359, a0 is −10.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple, TypeVar

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.numerals import read_number

Row = TypeVar("Row")
WIDEST_CODED = 3  # columns; numbers in wider fields have digits alone


class Field(NamedTuple):
    """A field: its name, its first column from 0, its width, and its number of decimals."""

    name: str
    begin: int
    width: int
    decimals: int = 0

    def real(self, line: str) -> float:
        """Return the number in a line.

        Raises:
            ValueError: naming the columns.
        """
        word = line[self.begin : self.begin + self.width].strip()
        try:
            return read_number(word)
        except ValueError as error:
            raise ValueError(f"{self.place}: {self.name} {error}; got {shown(word)}") from None

    def whole(self, line: str) -> int:
        """Return the whole number in a line.

        Raises:
            ValueError: naming the columns.
        """
        word = line[self.begin : self.begin + self.width].strip()
        try:
            return read_coded(word, self.width)
        except ValueError:
            rule = "must be a whole number"
            raise ValueError(f"{self.place}: {self.name} {rule}; got {shown(word)}") from None

    def write_value(self, value: float) -> str:
        """Return a number in as many columns as the field has.

        Raises:
            ValueError: for one that is too long.
        """
        text = f"{value:{self.width}.{self.decimals}f}" if self.decimals else write_coded(int(value), self.width)
        if len(text) > self.width:
            raise ValueError(f"{self.place}: {self.name} must fit into {self.width} columns; got {value:.15g}")
        return text

    @property
    def place(self) -> str:
        """Its columns in words, from 1."""
        return f"columns {self.begin + 1} to {self.begin + self.width}"


def read_coded(word: str, width: int) -> int:
    """Return a whole number whose first digit may be a letter.

    Raises:
        ValueError: for anything else.

    >>> [read_coded(word, 2) for word in ("7", "-3", "A0", "Z9", "a0", "b5")]
    [7, -3, 100, 359, -10, -25]
    """
    digits = word[1:]
    if not word.isascii():
        raise ValueError(word)
    if word[:1].isalpha() and len(word) == width <= WIDEST_CODED and digits.isdigit():
        unit = 10 ** (width - 1)
        if word[0].isupper():
            return (ord(word[0]) - ord("A") + 10) * unit + int(digits)
        return -((ord(word[0]) - ord("a") + 1) * unit + int(digits))
    if not word.removeprefix("-").isdigit():
        raise ValueError(word)
    return int(word)


def write_coded(value: int, width: int) -> str:
    """Return a whole number in so many columns, its first digit a letter where it needs one.

    >>> [write_coded(value, 2) for value in (7, -3, 100, 359, -10, 360)]
    [' 7', '-3', 'A0', 'Z9', 'a0', '360']
    """
    text, unit = str(value), 10 ** (width - 1)
    first, rest = divmod(abs(value), unit)
    if len(text) > width <= WIDEST_CODED and (10 <= first < 36 if value > 0 else 1 <= first < 27):
        letter = chr(ord("A") + first - 10) if value > 0 else chr(ord("a") + first - 1)
        return f"{letter}{rest:0{width - 1}d}"
    return text.rjust(width)


def read_rows(
    path: Path, text: str, read: Callable[[str], Row], remedy: str, ends_at_blank: bool = False
) -> Iterator[tuple[Row, str]]:
    """Yield what each line holds, and its text with its end and blank lines around it.

    Args:
        ends_at_blank: whether the first blank line ends what is read; the text behind goes with the last line.

    Raises:
        FormatError: naming file, line and columns, for what ``read`` refuses, and for a file without lines.
    """
    pending, held = "", None
    lines = _with_ends(text)
    for number, line in enumerate(lines, 1):
        if not line.strip() and ends_at_blank:
            pending = "".join(lines[number - 1 :])
            break
        if not line.strip():
            pending += line
            continue
        if held is not None:
            yield held[0], held[1]
        try:
            held = (read(line.rstrip("\r\n")), pending + line)
        except ValueError as error:
            raise FormatError(f"{path}, line {number}, {error}. {remedy}") from None
        pending = ""
    if held is None and pending.strip():
        raise FormatError(f"{path}: line 1 is blank, and reading ends at the first blank line. Take it out.")
    if held is None:
        raise FormatError(f"{path}: holds no lines. Check the path.")
    yield held[0], held[1] + pending


def write_rows(rows: Sequence[Row], kept: Sequence[str] | None, read: Callable[[str], Row],
            write: Callable[[Row], str]) -> str:
    """Return rows as the text of a file; rows whose values did not change keep their original text.

    Raises:
        InvalidInput: for a row that does not fit into its columns.
    """
    parts = []
    for k, row in enumerate(rows):
        text = kept[k] if kept is not None and k < len(kept) else None
        if text is None or read(next(line for line in _with_ends(text) if line.strip()).rstrip("\r\n")) != row:
            try:
                text = write(row) + "\n"
            except ValueError as error:
                raise InvalidInput(f"line {k + 1} cannot be written, {error}. Leave it out, or change it.") from None
        parts.append(text)
    return "".join(parts)


def _with_ends(text: str) -> list[str]:
    """Return lines with their ends; only a line feed ends one, unlike in ``splitlines``."""
    return [line for line in re.split(r"(?<=\n)", text) if line]

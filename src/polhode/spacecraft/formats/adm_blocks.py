"""CCSDS Attitude Parameter and Comprehensive Messages taken apart into blocks of keywords and lines of numbers.

Both are read in keyword = value, and the first in XML too, whose elements have the same names.

Source: CCSDS 504.0-B-2, sections 3, 5 and 7.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

from polhode.errors import FormatError, shown
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, read_text
from polhode.formats.xml_nodes import Node, read_xml
from polhode.spacecraft.formats.adm_keywords import WITH_ROWS, explain_block, explain_element, explain_keyword

LARGEST_FILE = 200 * MB
XML_BLOCKS = {"quaternionState": "QUAT", "eulerAngleState": "EULER", "angularVelocity": "ANGVEL", "spin": "SPIN",
              "inertia": "INERTIA", "maneuverParameters": "MAN"}  # fmt: skip
_UNIT = re.compile(r"\s*\[(?P<unit>[^\]]*)\]\s*$")


@dataclass
class Block:
    """A block of a message.

    Attributes:
        path: the file.
        kind: of the message, "APM" or "ACM".
        name: "QUAT" for what stands between QUAT_START and QUAT_STOP; "" for header and metadata.
        line: where it begins.
        values: keyword → value and line; units in brackets are in ``units``.
        units: keyword → its unit, where one is written.
        rows: lines of numbers, each with its line.
    """

    path: Path
    kind: str
    name: str
    line: int
    values: dict[str, tuple[str, int]] = field(default_factory=dict)
    units: dict[str, str] = field(default_factory=dict)
    rows: list[tuple[int, list[str]]] = field(default_factory=list)

    def wrong(self, keyword: str, what: str, remedy: str = "Check the file.") -> NoReturn:
        """Say what is wrong with a keyword, and what to do about it.

        Raises:
            FormatError: always.
        """
        line = self.values[keyword][1] if keyword in self.values else self.line
        raise FormatError(f"{self.path}, line {line}: {keyword} {what}. {remedy}")

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
        if self.units.get(keyword, unit).replace(" ", "") != unit:
            self.wrong(keyword, f"must be in {unit}; got {shown(self.units[keyword])}")
        try:
            return read_number(text)
        except ValueError as error:
            self.wrong(keyword, f"{error}; got {shown(text)}")

    def numbers(self, keywords: tuple[str, ...], unit: str) -> list[float]:
        """Return the numbers of several keywords; raises as ``number`` does."""
        return [self.number(keyword, unit) for keyword in keywords]

    def has(self, *keywords: str) -> bool:
        """Whether the block has all of these."""
        return all(keyword in self.values for keyword in keywords)


def read_blocks(path: Path, kind: str) -> list[Block]:
    """Return header and metadata as the first block, and the others in the order of the file.

    Args:
        path: of the file.
        kind: "APM" or "ACM".

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is no such message.
    """
    text = read_text(path, kind, LARGEST_FILE)
    if text.lstrip().startswith("<"):
        if kind != "APM":
            raise FormatError(f"{path}: is an {kind} in XML, and read here is keyword = value. Convert it.")
        return _from_xml(path, read_xml(path, kind, LARGEST_FILE))
    first, lines = Block(path, kind, "", 1), enumerate(text.splitlines(), 1)
    blocks = [first]
    for number, line in _without_comments(lines):
        keyword, equals, value = (part.strip() for part in line.partition("="))
        if not equals and keyword.endswith("_START"):
            name = keyword.removesuffix("_START")
            _refuse(path, number, explain_block(kind, name))
            block = first if name == "META" else Block(path, kind, name, number)
            if block is not first:
                blocks.append(block)
            _fill(block, lines, f"{name}_STOP", number)
        elif not equals:
            _refuse(path, number, _explain_bare(line))
        else:
            _put(first, keyword, value, number)
            if keyword == f"CCSDS_{kind}_VERS":  # before keywords of other versions are called unknown
                _check_version(first, kind)
    _check_version(first, kind)
    return blocks


def _without_comments(lines: Iterator[tuple[int, str]]) -> Iterator[tuple[int, str]]:
    for number, line in lines:
        words = line.split()
        if words and words[0] != "COMMENT":
            yield number, line.strip()


def _fill(block: Block, lines: Iterator[tuple[int, str]], stop: str, begun: int) -> None:
    for number, line in _without_comments(lines):
        if line == stop:
            return
        keyword, equals, value = (part.strip() for part in line.partition("="))
        if equals:
            _put(block, keyword, value, number)
        elif block.name == "AD" and keyword in ("SENSOR_START", "SENSOR_STOP"):
            continue
        elif keyword.endswith(("_START", "_STOP")):  # of another block
            break
        elif block.name in WITH_ROWS:
            block.rows.append((number, line.split()))
        else:
            _refuse(block.path, number, _explain_bare(line))
    raise FormatError(f"{block.path}, line {begun}: this block has no {stop}; the file is cut short. Get it whole.")


def _explain_bare(line: str) -> str:
    return f"must be keyword = value here; got {shown(line[:60])}. Check the file."


def _refuse(path: Path, number: int, what: str) -> None:
    """Say what is wrong in a line, if anything is.

    Raises:
        FormatError: for any words.
    """
    if what:
        raise FormatError(f"{path}, line {number}: {what}")


def _put(block: Block, keyword: str, value: str, number: int) -> None:
    _refuse(block.path, number, explain_keyword(block.kind, block.name, keyword))
    if match := _UNIT.search(value):
        block.units[keyword] = match["unit"]
        value = value[: match.start()]
    if keyword in block.values and not keyword.startswith("SENSOR_"):  # each sensor has its own
        _refuse(block.path, number, f"{keyword} stands in line {block.values[keyword][1]} too, and one of them must be "
                                    "wrong. Take that out.")  # fmt: skip
    block.values.setdefault(keyword, (value.strip(), number))


def _check_version(first: Block, kind: str) -> None:
    version = first.text(f"CCSDS_{kind}_VERS")
    if version != "2.0":
        first.wrong(f"CCSDS_{kind}_VERS", f"must be 2.0 to be read here, so have it written in that; got "
                                          f"{shown(version)}")  # fmt: skip


def _from_xml(path: Path, root: Node) -> list[Block]:
    message = next((node for node in root.walk() if node.tag == "apm"), None)
    if message is None:
        raise FormatError(f"{path}: is XML, and no APM. Check the file.")
    first = Block(path, "APM", "", message.line)
    _put(first, "CCSDS_APM_VERS", message.attributes.get("version", ""), message.line)
    _check_version(first, "APM")
    blocks = [first]
    for node in message.walk():
        if node.tag in ("header", "metadata", "data"):
            _put_leaves(first, node.children)
            for child in node.children if node.tag == "data" else ():
                if child.children and child.tag not in XML_BLOCKS:
                    _refuse(path, child.line, explain_element(child.tag, tuple(XML_BLOCKS)))
        elif node.tag in XML_BLOCKS:
            block = Block(path, "APM", XML_BLOCKS[node.tag], node.line)
            _put_leaves(block, [leaf for leaf in node.walk() if leaf is not node])
            blocks.append(block)
    return blocks


def _put_leaves(block: Block, nodes: list[Node]) -> None:
    for node in nodes:
        if not node.children and node.tag != "COMMENT":
            _put(block, node.tag, node.text.strip(), node.line)
            if "units" in node.attributes:
                block.units[node.tag] = node.attributes["units"]

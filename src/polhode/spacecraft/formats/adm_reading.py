"""Reads CCSDS Attitude Data Messages, in keyword = value or XML, as one list of blocks.

Source: CCSDS 504.0-B-2, sections 6 and 7; CCSDS 505.0, Navigation Data Messages XML specification.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from pathlib import Path

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.opening import open_file
from polhode.formats.xml_nodes import Node, read_xml
from polhode.spacecraft.formats.adm_blocks import CHECK, Block, refuse
from polhode.spacecraft.formats.adm_keywords import OLD_RATES, STATE, Message, explain_unknown
from polhode.types import Array

Convert = Callable[[Block], tuple[Array, ...]]
Lines = Iterator[tuple[int, str]]
_CUT_SHORT = "the file is cut short. Get it whole."
_OLD_ANGLES = {f"rotation{k}": (f"ANGLE_{k}",) for k in (1, 2, 3)}
_OLD_RATES = {f"rotation{k}": pair for k, pair in enumerate(OLD_RATES.items(), 1)}
"""In version 1.0 angles and rates have one name, in the order of the turns."""
_ATTRIBUTES = {f"rotation{k}": ("units", "angle", "rate") for k in (1, 2, 3)}
"""Of elements; others have units alone."""


def read_blocks(path: Path, message: Message, convert: Convert | None = None) -> list[Block]:
    """Return what stands before all blocks as the first one, and the others in the order of the file.

    Args:
        path: of the file.
        message: its kind.
        convert: takes the rows that a block has so far to arrays, so that a large file is not in memory as text; None
            to leave the rows as they are.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is no such message.
    """
    lines = _lines(path, message)
    number, line = next(lines, (None, ""))
    if line.startswith("<"):
        if not message.elements:
            refuse(path, None, f"is an {message.kind} in XML, and read here is keyword = value. Convert it.")
        return _from_xml(path, message, read_xml(path, message.kind, message.max_xml_size))
    blocks, last = [Block(path, "", 1)], ""
    while number is not None:
        keyword, equals, value = (part.strip() for part in line.partition("="))
        name, wanted = keyword.removesuffix("_START"), message.order.get(last)
        if _is_comment(line):
            pass
        elif wanted and keyword != f"{wanted}_START" and (last or (name != keyword and not equals)):
            refuse(path, number, f"{wanted}_START must follow {f'{last}_STOP' if last else 'the header'}; got "
                                 f"{shown(line[:60])}. {CHECK}")
        elif equals:
            _put(message, blocks[0], "", keyword, value, number)
        else:
            _check_version(message, blocks[0], number, line)
            if what := _explain_bare(line) if name == keyword else message.explain_block(name):
                refuse(path, number, what)
            _fill(message, _open(message, blocks, name, number), name, lines, number, convert)
            last = name
        number, line = next(lines, (None, ""))
    _check_version(message, blocks[0], number, "nothing")
    if message.order.get(last) and message.order[last] != message.order[""]:
        refuse(path, None, f"{last}_STOP has no {message.order[last]}_START after it; {_CUT_SHORT}")
    return blocks


def _lines(path: Path, message: Message) -> Lines:
    """Yield numbered lines that are not blank."""
    try:
        with io.TextIOWrapper(open_file(path, message.kind, message.max_size), "utf-8-sig") as file:
            for number, line in enumerate(iter(lambda: file.readline(message.max_line + 1), ""), 1):
                if len(line) > message.max_line:
                    refuse(path, number, f"has more than {message.max_line} characters. It is another kind of file.")
                if not (text := line.strip()):
                    continue
                if not text.isprintable() and not " ".join(text.split()).isprintable():
                    refuse(path, number, f"must be printable text; got {shown(text)}. Save it as UTF-8 text.")
                yield number, text
    except UnicodeDecodeError:
        raise FormatError(f"{path}: is not text, so it is no {message.kind} in keyword = value form. Save it as UTF-8.",
                          ) from None
    except OSError as error:
        raise InvalidInput(f"{path}: cannot be read ({error.strerror}). Check the path.") from None


def _is_comment(line: str) -> bool:
    return line.startswith("COMMENT") and line.split(None, 1)[0] == "COMMENT"


def _explain_bare(line: str) -> str:
    return f"must be keyword = value here; got {shown(line[:60])}. {CHECK}"


def _open(message: Message, blocks: list[Block], name: str, line: int) -> Block:
    """Return the block that a part of the file belongs to; a new one is put behind the others."""
    whole = message.continues.get(name, name)
    if whole == STATE:
        blocks[-1].states.append(Block(blocks[0].path, STATE, line))
        return blocks[-1].states[-1]
    if name in message.once and (earlier := next((block for block in blocks if block.name == name), None)):
        refuse(earlier.path, line, f"{name}_START is there already, in line {earlier.line}, and an {message.kind} has "
                                   "one. Leave out one.")
    if whole == name and name:
        values = dict(blocks[0].values) if message.order else {}  # the header is that of each segment
        blocks.append(Block(blocks[0].path, name, line, values))
    return blocks[-1] if whole else blocks[0]


def _fill(message: Message, block: Block, name: str, lines: Lines, begun: int, convert: Convert | None) -> None:
    stop, keywords, chunk = f"{name}_STOP", bool(message.blocks.get(name, True)), 50_000
    for number, line in lines:
        if line == stop:
            if convert and name in message.rows:
                block.parts.append(convert(block))
                block.rows.clear()
            return
        if _is_comment(line):
            _keep_comment(message, block, name, line.removeprefix("COMMENT"))
        elif keywords and "=" in line:
            keyword, _, value = (part.strip() for part in line.partition("="))
            _put(message, block, name, keyword, value, number)
        elif name == "AD" and line in ("SENSOR_START", "SENSOR_STOP"):
            continue
        elif line.endswith(("_START", "_STOP")):  # of another block
            break
        elif name in message.rows:
            block.rows.append((number, line))
            if convert and len(block.rows) == chunk:
                block.parts.append(convert(block))
                block.rows.clear()
        else:
            refuse(block.path, number, _explain_bare(line))
    refuse(block.path, begun, f"{name}_START has no {stop}; {_CUT_SHORT}")


def _keep_comment(message: Message, block: Block, name: str, text: str) -> None:
    if not message.continues.get(name):  # those within data are not about the object
        block.comments.append(text.strip())


def _put(message: Message, block: Block, name: str, keyword: str, value: str, line: int) -> None:
    name = message.continues.get(name, name) if name not in message.blocks else name
    if name != STATE and (what := message.explain_keyword(name, keyword)):
        if not name:
            _check_version(message, block, line, f"{keyword} = {value}")
        refuse(block.path, line, what)
    if keyword not in block.values:
        block.values[keyword] = (value, line)
    elif not keyword.startswith("SENSOR_"):  # each sensor has its own
        refuse(block.path, line, f"{keyword} is there already, in line {block.values[keyword][1]}, and one of them "
                                 "must be wrong. Leave out one.")
    if keyword == message.version_keyword:  # before keywords of other versions are called unknown
        _check_version(message, block, line, value)


def _check_version(message: Message, first: Block, line: int | None, text: str) -> None:
    keyword, versions = message.version_keyword, " or ".join(message.versions)
    if keyword not in first.values:
        refuse(first.path, line, f"an {message.kind} begins with {keyword} = {message.versions[-1]}; got "
                                 f"{shown(text[:60])}. It is another kind of file.")
    if first.text(keyword) not in message.versions:
        first.wrong(keyword, f"must be {versions} to be read here; got {shown(first.text(keyword))}",
                    f"Have it written in version {message.versions[-1]}.")


def _from_xml(path: Path, message: Message, root: Node) -> list[Block]:
    kind, sections = message.kind, ("header", "metadata", "data")
    tops = [node for node in root.walk() if node.tag == kind.lower()]
    if len(tops) != 1:
        refuse(path, root.line, f"has {len(tops)} {kind}s in it. Leave one." if tops
               else f"is XML, and no {kind}. {CHECK}")
    blocks = [Block(path, "", tops[0].line)]
    _put(message, blocks[0], "", message.version_keyword, tops[0].attributes.get("version", ""), tops[0].line)
    for node in tops[0].walk():
        if node.tag not in message.elements:
            continue
        name = message.elements[node.tag]
        _put_leaves(message, _open(message, blocks, name, node.line), name, node, node.tag not in sections)
        for child in node.children if node.tag == "data" else ():
            if child.children and child.tag not in message.elements:
                inside = [tag for tag in message.elements if tag not in sections]
                refuse(path, child.line, explain_unknown("element", child.tag, inside))
    return blocks


def _put_leaves(message: Message, block: Block, name: str, node: Node, deep: bool) -> None:
    old = _OLD_RATES if node.tag == "rotationRates" else _OLD_ANGLES
    for child in node.children:
        if deep or not child.children:
            _check_attributes(block, child)
        if child.children:
            if deep:
                _put_leaves(message, block, name, child, deep)
        elif child.tag == "COMMENT":
            _keep_comment(message, block, name, child.text)
        else:
            unit = f" [{units}]" if (units := child.attributes.get("units")) else ""
            for keyword in old.get(child.tag, (child.tag,)):
                _put(message, block, name, keyword, child.text.strip() + unit, child.line)


def _check_attributes(block: Block, node: Node) -> None:
    """Refuse attributes that the schema does not have: with ``unit="rad/s"`` a number would be one of deg/s.

    Raises:
        FormatError: naming the line.
    """
    known = _ATTRIBUTES.get(node.tag, ("units",))
    for name in node.attributes:
        if name not in known and name.partition(":")[0] not in ("xml", "xmlns", "xsi"):
            refuse(block.path, node.line, explain_unknown(f"attribute of {node.tag}", name, known))

"""XML as a small tree whose nodes know their lines; documents that define entities are refused."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

from polhode.errors import FormatError
from polhode.formats.opening import open_file


class XmlLimits(NamedTuple):
    """A number beyond which XML is refused."""

    max_depth: int = 30  # of elements within each other; messages have nine


LIMITS = XmlLimits()


@dataclass
class Node:
    """An element.

    Attributes:
        tag: its name.
        line: where it begins.
        attributes: by name.
        text: in it, without that of its children.
        children: the elements in it.
    """

    tag: str
    line: int
    attributes: dict[str, str]
    text: str = ""
    children: list[Node] = field(default_factory=list)

    def find(self, tag: str) -> Node | None:
        """Return the first child of a name; None without one."""
        return next((child for child in self.children if child.tag == tag), None)

    def find_all(self, tag: str) -> list[Node]:
        """Return the children of a name."""
        return [child for child in self.children if child.tag == tag]

    def walk(self) -> Iterator[Node]:
        """Yield the element and all within it."""
        yield self
        for child in self.children:
            yield from child.walk()


def read_xml(path: Path, kind: str, limit: int) -> Node:
    """Return the root of an XML document.

    Raises:
        InvalidInput: where the file is missing, or cannot be read.
        FormatError: for anything but XML, and for documents with a DOCTYPE, whose entities may grow without bounds.
    """
    parser = expat.ParserCreate()
    parser.buffer_text = True
    root, stack = Node("", 0, {}), []

    def start(tag: str, attributes: dict[str, str]) -> None:
        if len(stack) > LIMITS.max_depth:
            raise FormatError(f"{path}, line {parser.CurrentLineNumber}: elements lie too deep within each other. "
                              "It is another kind of file.")
        node = Node(tag.rpartition(":")[2], parser.CurrentLineNumber, attributes)
        (stack[-1] if stack else root).children.append(node)
        stack.append(node)

    def end(tag: str) -> None:
        stack.pop()

    def text(words: str) -> None:
        if stack:
            stack[-1].text += words

    def refuse_entities(*_: object) -> None:
        raise FormatError(f"{path}, line {parser.CurrentLineNumber}: has a DOCTYPE, and messages have none. Remove it.")

    parser.StartElementHandler, parser.EndElementHandler, parser.CharacterDataHandler = start, end, text
    parser.StartDoctypeDeclHandler = refuse_entities
    try:
        with open_file(path, kind, limit) as file:
            parser.ParseFile(file)
    except expat.ExpatError as error:
        raise FormatError(f"{path}, line {error.lineno}: is not well-formed XML ({expat.ErrorString(error.code)}). "
                          "Get the file whole.") from None
    return root.children[0]

"""Text that is broken into lines where it is too long, at the outermost places first.

A document is a text, a tuple of documents, or one of the classes here. Source: Wadler, *A prettier printer* (2003).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

WIDTH = 120


@dataclass(frozen=True)
class Line:
    """A line's end if its group is broken, and else a text."""

    otherwise: str = " "


@dataclass(frozen=True)
class Nest:
    """What is one step further to the right where it is broken."""

    inner: Document


@dataclass(frozen=True)
class Group:
    """What stands in one line, if it fits there."""

    inner: Document


@dataclass(frozen=True)
class Loose:
    """What stands in one line, if it fits there with what follows up to the next place that can be broken."""

    inner: Document


@dataclass(frozen=True)
class Broken:
    """A text that only a broken group has."""

    text: str


Document = str | tuple["Document", ...] | Line | Nest | Group | Loose | Broken
SOFT = Line("")


def joined(parts: Iterable[Document], separator: Document) -> Document:
    """Return documents with another one between them."""
    first, *rest = [*parts] or [""]
    return (first, *((separator, part) for part in rest))


def enclosed(opening: str, parts: Iterable[Document], closing: str, inside: str = "", last: str = ",") -> Document:
    """Return a list in brackets, each part in its own line where it is broken.

    Args:
        inside: between brackets and parts in one line.
        last: after the last part where it is broken.
    """
    parts = [*parts]
    if not parts:
        return opening + closing
    edge = Line(inside)
    return Group((opening, Nest((edge, joined(parts, (",", Line())))), Broken(last), edge, closing))


def laid_out(document: Document, step: int, indent: int = 0, reserved: int = 0) -> str:
    """Return the text of a document.

    Args:
        step: blanks for each nesting.
        indent: of the lines, in blanks; the first one has it from elsewhere.
        reserved: places that are taken in the last line by what follows.
    """
    out: list[str] = []
    column = indent
    waiting: list[tuple[int, bool, Document]] = [(indent, True, document)]
    while waiting:
        margin, broken, part = waiting.pop()
        match part:
            case str():
                out.append(part)
                column += len(part)
            case tuple():
                waiting += [(margin, broken, inner) for inner in reversed(part)]
            case Nest(inner):
                waiting.append((margin + step, broken, inner))
            case Group(inner) | Loose(inner):
                waiting.append((margin, not _fits(inner, waiting, WIDTH - column - reserved), inner))
            case Broken(text):
                waiting.append((margin, broken, text if broken else ""))
            case Line(otherwise) if not broken:
                waiting.append((margin, broken, otherwise))
            case Line():
                out.append("\n" + " " * margin)
                column = margin
    return "".join(out)


def _fits(document: Document, after: list[tuple[int, bool, Document]], room: int) -> bool:
    """Return whether a document, and what follows up to the next end of a line, fits into one line."""
    parts: list[tuple[bool, Document]] = [(broken, part) for _, broken, part in after] + [(False, document)]
    while parts and room >= 0:
        broken, part = parts.pop()
        match part:
            case str():
                room -= len(part)
            case tuple():
                parts += [(broken, inner) for inner in reversed(part)]
            case Nest(inner):
                parts.append((broken, inner))
            case Group(inner):
                parts.append((False, inner))
            case Loose(inner):
                parts.append((broken, inner))
            case Broken(text):
                room -= len(text) if broken else 0
            case Line(otherwise):
                if broken:
                    return True
                room -= len(otherwise)
    return room >= 0

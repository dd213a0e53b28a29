"""The Python of the formulas as ``ast`` has it, with what that leaves out: comments, and values of constants."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from printing.tree import Notes

FOR_TOOLS = re.compile(r"\s*(fmt:|type:|noqa|pyright:).*")
SECTION = re.compile(r"-{20,} (.*)")


@dataclass(frozen=True)
class Comment:
    text: str
    stands_alone: bool


class Source:
    """A module: what it defines by name, what it imports from where, its comments by line.

    Attributes:
        defined: functions, classes, and the assignments of constants and types.
        imported: name → (module, name there).
    """

    def __init__(self, name: str) -> None:
        self.name = name
        self.module = import_module(name)
        text = text_of(Path(str(self.module.__file__)))
        self.tree = ast.parse(text)
        self.docstring = ast.get_docstring(self.tree) or ""
        self.comments = _comments(text)
        self.defined: dict[str, ast.stmt] = {}
        self.imported: dict[str, tuple[str, str]] = {}
        for node in self.tree.body:
            match node:
                case ast.ImportFrom():
                    self.imported |= {x.asname or x.name: (str(node.module), x.name) for x in node.names}
                case ast.FunctionDef() | ast.ClassDef():
                    self.defined[node.name] = node
                case ast.Assign() | ast.AnnAssign():
                    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                    names = [x.id for target in targets for x in ast.walk(target) if isinstance(x, ast.Name)]
                    self.defined |= dict.fromkeys(names, node)

    def value(self, name: str) -> Any:
        return getattr(self.module, name)

    def origin(self, name: str) -> tuple[Source, str] | None:
        """Return the module that defines what has a name here, and its name there."""
        if name in self.defined:
            return self, name
        if name in self.imported:
            module, there = self.imported[name]
            return source(module).origin(there)
        return None

    def notes(self, node: ast.stmt | ast.expr, after: int) -> Notes:
        """Return the comments of a statement: those after a line, and those in its own lines."""
        end = node.end_lineno or node.lineno
        lines = [(k, self.comments[k]) for k in range(after + 1, end + 1) if k in self.comments]
        above = tuple(x.text for _, x in lines if x.stands_alone and not SECTION.match(x.text))
        beside = " ".join(x.text for k, x in lines if not x.stands_alone and k >= node.lineno)
        return Notes(above, beside)

    def line_above(self, line: int) -> int:
        """Return the last line before those that are comments right above a line."""
        while line - 1 in self.comments and self.comments[line - 1].stands_alone:
            line -= 1
        return line - 1

    def section(self, first: int, last: int) -> str | None:
        """Return the title between two lines, if there is one."""
        found = [SECTION.match(self.comments[k].text) for k in range(first, last) if k in self.comments]
        return next((x[1] for x in found if x), None)


def text_of(path: Path) -> str:
    return path.read_text("utf-8")


@cache
def source(name: str) -> Source:
    return Source(name)


def _comments(text: str) -> dict[int, Comment]:
    found = {}
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        said = token.string.removeprefix("#").removeprefix(" ")
        if token.type == tokenize.COMMENT and not FOR_TOOLS.fullmatch(said):
            found[token.start[0]] = Comment(said, token.line[: token.start[1]].isspace() or token.start[1] == 0)
    return found

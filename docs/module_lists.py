"""The lists of files in docs/data_flow.md: each module with the first sentence of its docstring."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1] / "src" / "polhode"


def files_of(room: str) -> list[Path]:
    """Return the modules of a room, a folder or a single file of the package, in the order of their paths."""
    folder = PACKAGE / room
    return sorted(folder.rglob("*.py")) if folder.is_dir() else [folder.with_suffix(".py")]


@cache
def purpose(path: Path) -> str:
    """Return the first line of a module's docstring; empty if it has none."""
    return (ast.get_docstring(ast.parse(path.read_text("utf-8"))) or "").partition("\n")[0]


def rooms() -> set[str]:
    """Return the folders and files directly in the package, which hold all modules but the package's own."""
    folders = {path.parent.name for path in PACKAGE.glob("*/__init__.py")}
    return folders | {path.stem for path in PACKAGE.glob("*.py")} - {"__init__", "__main__"}


def markdown_list(room: str) -> str:
    """Return a room's files as a Markdown list, one line each: the path in the package, and what the file is for."""
    entries = []
    for path in files_of(room):
        words = re.sub(r"``", "`", purpose(path))
        words = re.sub(r"(`[^`]*`)|([*<\[_])", lambda m: m[1] or "\\" + m[2], words)
        entries.append(f"- `{path.relative_to(PACKAGE).as_posix()}`: {words}")
    return "\n".join(entries)

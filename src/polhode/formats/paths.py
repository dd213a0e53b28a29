"""Paths as users write them."""

from __future__ import annotations

from pathlib import Path

from polhode.errors import InvalidInput


def check_is_file(path: Path, kind: str) -> None:
    """Refuse a path that is no file; names that the system cannot even look up are none.

    Raises:
        InvalidInput: saying what is there instead.
    """
    try:
        if path.is_file():
            return
        found = "is a folder, not a" if path.is_dir() else "no such"
    except OSError:
        found = "no such"
    raise InvalidInput(f"{path}: {found} {kind} file. Check the path; it counts from the spec's own folder.")

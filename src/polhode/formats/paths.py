"""Paths as users write them."""

from __future__ import annotations

from pathlib import Path


def is_file(path: Path) -> bool:
    """Whether a path is a file; names that the system cannot even look up are none."""
    try:
        return path.is_file()
    except OSError:
        return False

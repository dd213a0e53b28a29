"""Checks where a command may write."""

from __future__ import annotations

from pathlib import Path

from polhode.errors import InvalidInput


def check_spares(destination: Path, source: Path) -> None:
    """Refuse to write where the command's own input is.

    Raises:
        InvalidInput: naming the file.
    """
    if destination.exists() and source.exists() and destination.samefile(source):
        raise InvalidInput(f"{destination}: is the file that is read; writing would destroy it. Name another by --out.")

"""The names of arguments and files in messages."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path

from polhode.errors import InvalidInput, NotConverged


def name_arguments(names: Sequence[str]) -> str:
    """Return arguments for a message, which names them as Python does; the command says its options instead.

    >>> name_arguments(["mass", "added_weight"])
    '`mass`, `added_weight`'
    """
    return ", ".join(f"`{name}`" for name in names)


@contextlib.contextmanager
def name_file_in_errors(path: Path | str) -> Iterator[None]:
    """Name the file in refusals."""
    try:
        yield
    except (InvalidInput, NotConverged) as error:
        raise error if str(error).startswith(str(path)) else type(error)(f"{path}: {error}") from None


@contextlib.contextmanager
def warnings_as_notes(path: Path | str) -> Iterator[list[str]]:
    """Name the file in refusals, and yield a list that takes the warnings as notes."""
    notes: list[str] = []
    with warnings.catch_warnings(record=True) as caught, name_file_in_errors(path):
        warnings.simplefilter("always", UserWarning)
        yield notes
    notes += dict.fromkeys(str(warning.message) for warning in caught)

"""How messages name an input: as an argument of Python, or as an option of a command."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

from polhode.errors import InvalidInput, NotConverged

Called = Callable[[str], str]
"""Returns how an argument is called where it is given."""


def in_python(name: str) -> str:
    """Return how an argument is called in Python.

    >>> in_python("added_weight")
    '`added_weight`'
    """
    return f"`{name}`"


def as_option(name: str) -> str:
    """Return how an argument is called on the command line.

    >>> as_option("added_weight")
    '--added-weight'
    """
    return f"--{name.replace('_', '-')}"


@contextlib.contextmanager
def name_file_in_errors(path: Path | str) -> Iterator[None]:
    """Name the file in what is refused."""
    try:
        yield
    except (InvalidInput, NotConverged) as error:
        raise error if str(error).startswith(str(path)) else type(error)(f"{path}: {error}") from None


@contextlib.contextmanager
def warnings_as_notes(path: Path | str) -> Iterator[list[str]]:
    """Name the file in what is refused, and yield a list that takes the warnings as notes."""
    notes: list[str] = []
    with warnings.catch_warnings(record=True) as caught, name_file_in_errors(path):
        warnings.simplefilter("always", UserWarning)
        yield notes
    notes += dict.fromkeys(str(warning.message) for warning in caught)

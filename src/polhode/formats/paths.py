"""Writes files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from pathlib import Path

from polhode.errors import InvalidInput, PolhodeError, one_line, shown
from polhode.formats.drafts import Draft, draft_in, make_folder

# errors of a full disk, and of a user's quota
FULL = (errno.ENOSPC, errno.EFBIG, getattr(errno, "EDQUOT", errno.ENOSPC))
_common_draft: ContextVar[Draft | None] = ContextVar("common_draft", default=None)


def as_path(name: str, value: str | os.PathLike[str]) -> Path:
    """Return a path.

    Args:
        name: of the argument, for messages.
        value: by a user.

    Raises:
        InvalidInput: for anything else than a path that is not empty.

    >>> as_path("path", "motion.nc").name
    'motion.nc'
    """
    if not isinstance(value, str | os.PathLike) or not os.fspath(value):
        raise InvalidInput(f"`{name}` must be the path of a file or folder; got {shown(value)}. Name one.")
    return Path(value)


@contextlib.contextmanager
def write_whole(path: str | Path, replaces: Callable[[Path], bool] | None = None) -> Iterator[Path]:
    """Yield a draft path that takes the place of ``path`` when the block ends well, and leaves no trace otherwise.

    The draft has the name of the file, ending included, in a hidden folder next to it. It may become a folder too, such
    as a Zarr store.

    Args:
        path: where the file has to go; a file that is there already is replaced.
        replaces: returns whether a folder that is there already is a store that may be replaced; without it none may.

    Raises:
        InvalidInput: for a folder that is missing or cannot be written to, a destination that is not a file, and for
            errors of the system while the block writes.
    """
    path = Path(path)
    with _reword_errors(path):
        _check_can_go(path, replaces)
        common = _common_draft.get()
        if common is not None and common.folder.resolve() == path.parent.resolve():
            with _correct_paths_in_errors(common.new, path.parent):
                yield common.new / path.name
            return
        with draft_in(path.parent) as draft:
            with _correct_paths_in_errors(draft.new, path.parent):
                yield draft.new / path.name
            draft.take_place()


@contextlib.contextmanager
def write_all_or_none(folder: str | Path) -> Iterator[None]:
    """Let all files that ``write_whole`` writes into a folder take their names when the block ends well, else none.

    Args:
        folder: that is there.

    Raises:
        InvalidInput: as ``write_whole`` does.
    """
    folder = Path(folder)
    with _reword_errors(folder), draft_in(folder) as draft:
        before = _common_draft.set(draft)
        try:
            yield
        finally:
            _common_draft.reset(before)
        draft.take_place()


@contextlib.contextmanager
def write_together(folder: str | Path) -> Iterator[Path]:
    """Yield an empty draft folder whose files take their names in ``folder``, all of them when the block ends well.

    The folder is made where it is missing, and is gone again if the block fails.

    Args:
        folder: for the files; namesakes there are replaced, all others stay.

    Raises:
        InvalidInput: as ``write_whole`` does, and where a folder is in a file's place.
    """
    folder = Path(folder)
    with _reword_errors(folder, "Choose another folder."):
        if folder.exists() and not folder.is_dir():
            raise InvalidInput(f"{folder}: is a file, where a folder is needed. Choose another.")
        with make_folder(folder), draft_in(folder) as draft:
            with _correct_paths_in_errors(draft.new, folder):
                yield draft.new
            for written in draft.new.iterdir():
                _check_can_go(folder / written.name)
            draft.take_place()


@contextlib.contextmanager
def _correct_paths_in_errors(draft: Path, folder: Path) -> Iterator[None]:
    """Make errors name the final paths, not the hidden draft, which is gone by then."""
    hidden, inside, meant, inside_meant = (one_line(text) for place in (draft, folder) for text in (
        str(place), str(place / "x")[:-1]))
    try:
        yield
    except PolhodeError as error:
        if not any(hidden in line for line in error.args):
            raise
        raise type(error)(*(line.replace(inside, inside_meant).replace(hidden, meant) for line in error.args)) from None


@contextlib.contextmanager
def _reword_errors(path: Path, remedy: str = "Choose a place that you may write to.") -> Iterator[None]:
    """Turn errors of the system into one that names the file."""
    try:
        yield
    except OSError as error:
        why = error.strerror or type(error).__name__  # its own text names the draft, which is hidden and gone
        room = "Make room there, or choose another place." if error.errno in FULL else remedy
        raise InvalidInput(f"{path}: cannot be written ({why}). {room}") from None


def _check_can_go(path: Path, replaces: Callable[[Path], bool] | None = None) -> None:
    if not path.parent.is_dir():
        raise InvalidInput(f"{path}: cannot be written, as {path.parent} is not a folder. Make it, or choose another.")
    if path.is_dir():
        if replaces is None:
            raise InvalidInput(f"{path}: is a folder, where a file has to go. Choose another name, or move it away.")
        if not replaces(path):
            raise InvalidInput(f"{path}: is a folder, but not the store of a motion, which could be replaced. Choose "
                               "another name, or move it away.")
    elif path.exists() and not path.is_file():
        raise InvalidInput(f"{path}: is not a file that could be replaced. Choose another name.")

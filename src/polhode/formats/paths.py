"""Paths as users write them, and files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from polhode.errors import InvalidInput


@contextlib.contextmanager
def written_whole(path: str | Path, store: str | None = None) -> Iterator[Path]:
    """Yield a draft path that takes the place of ``path`` when the block ends well, and leaves no trace otherwise.

    The draft has the name of the file, ending included, in a hidden folder beside it. What is written there may be a
    folder too, such as a Zarr store.

    Args:
        path: where the file has to go; a file that is there already is replaced.
        store: name of the file by which a folder that is there already is known to be a store of the same kind, and is
            replaced; without it no folder is.

    Raises:
        InvalidInput: for a folder that is missing or cannot be written to, a destination that is no file, and for what
            the system refuses while the block writes.
    """
    path = Path(path)
    draft = None
    try:
        _check_can_go(path, store)
        draft = Path(tempfile.mkdtemp(dir=path.parent, prefix=".polhode-"))
        written = draft / path.name
        yield written
        if path.is_dir():
            path.replace(draft / f"{path.name}.old")
        written.replace(path)
    except OSError as error:
        why = error.strerror or str(error)
        raise InvalidInput(f"{path}: cannot be written ({why}). Choose a place that you may write to.") from None
    finally:
        if draft is not None:
            shutil.rmtree(draft, ignore_errors=True)


def _check_can_go(path: Path, store: str | None) -> None:
    if not path.parent.is_dir():
        raise InvalidInput(f"{path}: cannot be written, as {path.parent} is no folder. Make it, or choose another.")
    if path.is_dir():
        if store is not None and not (path / store).is_file():
            raise InvalidInput(f"{path}: is a folder, but no store that could be replaced. Choose another name, or "
                               "move it away.")  # fmt: skip
        if store is None:
            raise InvalidInput(f"{path}: is a folder, where a file has to go. Choose another name, or move it away.")
    elif path.exists() and not path.is_file():
        raise InvalidInput(f"{path}: is no file that could be replaced. Choose another name.")

"""The list of formats of files that hold a body, by the keys of [body]: those of wings, and those of other packages."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from polhode._base.plugins import FAILURES, find_entry_points, load_entry_point
from polhode._base.plugins.wings import wing_points
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, PolhodeError, one_line, shown
from polhode.formats.body_file import BodyFile, Pose
from polhode.formats.opening import check_is_file

GROUP = "polhode.bodies"
_reserved: set[str] = set()  # keys of [body] itself


def reserve_keys(keys: Iterable[str]) -> None:
    """Register the keys of [body] itself, which no format of another package may take."""
    _reserved.update(keys)


def body_file_keys() -> tuple[str, ...]:
    """Return the keys of [body] that name such files; no format is imported."""
    return (*wing_points(GROUP), *sorted(_others()))


def read_body_file(key: str, path: Path, link: str | None, joints: Pose | None, digits: int | None) -> Body:
    """Return the body in a file.

    Args:
        key: of [body], one that ``body_file_keys`` lists.
        path: the file.
        link: the name of one link, or None.
        joints: their positions, to take all links together; None for one link.
        digits: to which the entries of inertias are rounded; None for exact ones.

    Raises:
        InvalidInput: if the file is missing, it is open which body is meant, or the format of another package cannot
            be imported.
        FormatError: for a file of another format, and any error of another package's reader.
    """
    if key in wing_points(GROUP):
        return _read(wing_points(GROUP)[key].load(), path, link, joints, digits)
    file = load_entry_point(_others()[key])
    of_others = f"the format of bodies {key} of another package"
    if not isinstance(file, BodyFile):
        raise InvalidInput(f"{of_others}, {_others()[key].value}, is not a BodyFile. Update it.")
    check_is_file(path, key)  # and so it is known to have been read, however the reader opens it
    try:
        body = _read(file, path, link, joints, digits)
    except PolhodeError:
        raise
    except FAILURES as error:
        what = f"{type(error).__name__}: {one_line(str(error))}"
        raise FormatError(f"{path}: {of_others} cannot read it ({what}). Check the file, or update the package.") \
            from error
    if not isinstance(body, Body):
        raise FormatError(f"{path}: {of_others} gives {shown(body)}, not a Body. Update it.")
    return body


def _read(file: BodyFile, path: Path, link: str | None, joints: Pose | None, digits: int | None) -> Body:
    if joints is None:
        return file.read(path, link, digits)
    if file.read_at_pose is None:
        raise InvalidInput(f"{path}: is of a format without joints; leave `joints` out")
    return file.read_at_pose(path, joints, digits)


@cache
def _others() -> dict[str, Any]:
    """Return entry points by name."""
    return find_entry_points(GROUP, {*_reserved, *wing_points(GROUP)})

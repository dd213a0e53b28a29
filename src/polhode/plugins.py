"""What other packages add by entry points: kinds, formats, torques, commands."""

from __future__ import annotations

import warnings
from collections.abc import Collection
from importlib.metadata import entry_points
from typing import Any

from polhode.errors import InvalidInput


def find_entry_points(group: str, word: str, own: Collection[str]) -> dict[str, Any]:
    """Return the entry points of a group by name, but those that have the name of something of polhode's own.

    Where ``importlib_metadata`` has been imported, they are of its class.

    Args:
        group: like "polhode.kinds".
        word: for one of them, in messages.
        own: names that are taken, which a warning tells.
    """
    found = {point.name: point for point in entry_points(group=group)}
    for name in sorted(found.keys() & set(own)):
        warnings.warn(f"the {word} {name} of another package, {found.pop(name).value}, is ignored, as polhode has one "
                      "of this name itself. Rename or remove it.", stacklevel=2)  # fmt: skip
    return found


def load_entry_point(point: Any, word: str) -> Any:
    """Return what an entry point names.

    Raises:
        InvalidInput: where it cannot be imported.
    """
    try:
        return point.load()
    except Exception as error:  # whatever another package may do
        why = f"the {word} {point.name} of another package, {point.value}, cannot be imported: {error}"
        raise InvalidInput(f"{why}. Update or remove it.") from error

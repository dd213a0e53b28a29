"""What a kind finds in its folder: functions and objects by the names of their files, texts and scripts."""

from __future__ import annotations

import sys
from functools import cache
from importlib import import_module, resources
from importlib.resources.abc import Traversable
from importlib.util import find_spec
from typing import Any


class InFolder:
    """An object of a module in a folder of its own, or of a package's single module.

    The class that has this one as its base looks for nothing itself, only those derived from it.
    """

    def _find(self, file: str, name: str) -> Any:
        """Return the object of a name in a file of the kind's folder, or of a base kind's folder; else None."""
        for kind in type(self).__mro__:
            if InFolder in kind.__bases__:
                break
            module = f"{getattr(sys.modules.get(kind.__module__), '__package__', None) or kind.__module__}.{file}"
            if _is_there(module) and (thing := getattr(import_module(module), name, None)) is not None:
                return thing
        return None

    def _call(self, file: str, name: str, *args: Any, otherwise: Any = None) -> Any:
        """Return the result of such a function; ``otherwise`` where there is none."""
        function = self._find(file, name)
        return otherwise if function is None else function(*args)

    def _scripts(self) -> tuple[str, ...]:
        drawn = self._folder / "panel.js"
        return (drawn.read_text("utf-8"),) if drawn.is_file() else ()

    def _file(self, name: str) -> str:
        return (self._folder / name).read_text("utf-8")

    @property
    def _folder(self) -> Traversable:
        """The folder of the module that has the kind, or that is the kind's package."""
        module = type(self).__module__
        return resources.files(import_module(module).__package__ or module)


@cache
def _is_there(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except ModuleNotFoundError:  # a kind in a single module has no folder
        return False

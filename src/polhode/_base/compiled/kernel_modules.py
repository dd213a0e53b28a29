"""The modules of a kernel, as Python runs them and as Numba compiles them, with equal bits.

Numba takes some seconds to compile a kernel, once for an installation, which is not worth it for little work. polhode
does without it where it is not installed.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from importlib.util import find_spec
from inspect import unwrap
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from polhode._base.compiled.copying import NOTHING, Space, copy_modules
from polhode._base.compiled.entries import Entry
from polhode._base.compiled.images import has_images, is_switched_off
from polhode._base.extras import is_there


class LoadingTimes(NamedTuple):
    """Time [s] without it from which loading what lies on the disk is worth it: about what that takes."""

    of_image: float = 2e-3  # most of it for reading the sources that it has to come from
    by_numba: float = 0.3  # whose import takes longer


LOADING = LoadingTimes()


def can_compile() -> bool:
    """Return whether Numba is installed and may compile, without which no kernel is compiled."""
    return is_there("numba") and is_there("llvmlite") and not is_switched_off()


def loading_time() -> float:
    """Return the time [s] without a kernel from which loading it is worth it."""
    return LOADING.of_image if has_images() else LOADING.by_numba


def is_worth(spent: float, compiling: float, is_on_disk: Callable[[], bool]) -> bool:
    """Return whether a kernel is to be compiled or loaded.

    Args:
        spent: time [s] that the kernel's work has taken without it, or will have.
        compiling: time [s] that Numba takes to compile it.
        is_on_disk: says whether it has been compiled before.
    """
    can_load = has_images() or can_compile()
    return (can_compile() and spent >= compiling) or (can_load and spent >= loading_time() and is_on_disk())


class KernelModules:
    """Modules whose functions call each other, see ``copying``.

    Args:
        name: under which it is kept on disk, apart from kernels with functions of equal names.
        what: words for what it computes.
        modules: with their functions and constants.
        numba: returns functions for Numba in place of some of theirs, by name.
        from_modules: the names of the modules, which import Numba, from which these are.
        joined: whether the modules are copied into one.
    """

    def __init__(
        self, name: str, what: str, modules: Sequence[ModuleType], numba: Callable[[], Mapping[str, Any]],
        from_modules: Sequence[str], joined: bool = False,
    ) -> None:
        self.what, self.modules, self.joined = what, modules, joined
        self._name, self._numba, self._from = name, numba, from_modules

    def by_python(self, replaced: Mapping[str, Any] = NOTHING) -> dict[str, Space]:
        """Return the names of the modules, by theirs, with other functions in place of some."""
        return copy_modules(self.modules, lambda function, _: function, replaced, self.joined)

    @cached_property
    def by_numba(self) -> dict[str, Space]:
        """The names, with functions that Numba compiles when they are first called."""
        from polhode._base.compiled.compiling import compile_later  # which loads Numba

        make = lambda function, mark: compile_later(function, mark, self.what, self.kept_name)  # noqa: E731
        return copy_modules(self.modules, make, self._numba(), self.joined)

    def entry(self, name: str) -> Any:
        """Return a function that is compiled, or loaded from the disk, when it is first called."""
        (module,) = (module for module in self.modules if _has_entry(module, name))
        if not has_images():
            return self.by_numba[module.__name__][name]
        compiles = can_compile()
        written = lambda: (self.by_numba if compiles else self.by_python())[module.__name__][name]  # noqa: E731
        return Entry(f"{name}_{self.kept_name}", self.what, Path(str(module.__file__)), written, compiles)

    @cached_property
    def kept_name(self) -> str:
        """The end of the names under which its functions are kept, with the digest of their sources."""
        from polhode._base.compiled.kept import digest_compiled

        specs = [find_spec(name) for name in self._from]  # without loading Numba
        return f"{self._name}_{digest_compiled(self.modules, [spec.origin for spec in specs if spec and spec.origin])}"

    def is_on_disk(self, name: str) -> bool:
        """Return whether a function has been compiled before; mostly without Numba, whose import takes longer."""
        if has_images():
            return self.entry(name).is_on_disk()
        (module,) = (module for module in self.modules if _has_entry(module, name))
        named, folder = os.environ.get("NUMBA_CACHE_DIR"), Path(str(module.__file__)).parent / "__pycache__"
        if named or os.access(folder, os.W_OK):  # else Numba chooses another place
            place, within = (Path(named), "*/") if named else (folder, "")
            if not any(place.glob(f"{within}*{name}_{self.kept_name}-*.nbi")):
                return False
        return self.entry(name).is_on_disk()


def _has_entry(module: ModuleType, name: str) -> bool:
    function = vars(module).get(name)
    plain: Any = unwrap(function) if function else None
    return getattr(plain, "kernel_mark", "") == "entry" and plain.__module__ == module.__name__

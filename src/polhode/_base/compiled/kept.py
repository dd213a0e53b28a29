"""The digest of the sources of everything that is compiled into a function, by which it is kept on disk.

Numba looks at the file of one function alone for changes. But with it are compiled all functions that it calls, and the
values of constants, wherever they are written: numbers of operations, lengths of tables. Other sources of polhode do
not count here, so that not every change of it compiles everything again.
"""

from __future__ import annotations

import hashlib
import importlib
import inspect
from collections.abc import Iterable, Iterator
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

CONSTANTS = bool | int | float | complex | str | tuple | frozenset | None


def digest_compiled(modules: Iterable[ModuleType], files: Iterable[str] = ()) -> str:
    """Return a short digest of the functions of modules, of those of polhode that they call, and of constants.

    Args:
        modules: whose functions are compiled.
        files: further ones that decide how, beside those of this room.
    """
    digest = hashlib.sha256()
    for path in (*sorted(Path(__file__).parent.glob("*.py")), *files):
        digest.update(Path(path).read_bytes())
    waiting, digested = [module.__name__ for module in modules], set[str]()
    while waiting:
        name = waiting.pop()
        if name in digested or not name.startswith("polhode."):
            continue
        digested.add(name)
        module = importlib.import_module(name)
        digest.update(f"{name}\n".encode() + Path(str(module.__file__)).read_bytes())
        for used in sorted(set(_names(module))):
            value = vars(module).get(used)
            if isinstance(value, CONSTANTS):
                digest.update(f"{used} = ".encode() + _as_text(value).encode())
            elif isinstance(value, np.ndarray):
                digest.update(f"{used} = {value.dtype} {value.shape}\n".encode())
                digest.update(np.ascontiguousarray(value).tobytes())
            else:
                home = value.__name__ if isinstance(value, ModuleType) else getattr(value, "__module__", None)
                waiting += [home] if isinstance(home, str) else []
    return digest.hexdigest()[:16]


def _as_text(value: Any) -> str:
    """Return a constant as text that is the same in every process: sets have another order in each."""
    if isinstance(value, frozenset | tuple):
        parts = map(_as_text, value)
        return f"{type(value).__name__}({', '.join(sorted(parts) if isinstance(value, frozenset) else parts)})"
    return repr(value)


def _names(module: ModuleType) -> Iterator[str]:
    """Yield the names that functions of a module use."""
    home = module.__name__
    for value in vars(module).values():
        function = inspect.unwrap(value) if hasattr(value, "__wrapped__") else value  # kept ones, and tests wrap all
        if isinstance(function, FunctionType) and function.__module__ == home:
            yield from _names_in(function.__code__)


def _names_in(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield from _names_in(inner)

"""Copies of modules whose functions call each other, with some replaced: by those of Numba, or of arrays.

All functions of such a module are parts of a kernel. When it is compiled, a function becomes a part of those that call
it ("inlined") unless it is marked.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping
from types import FunctionType, MappingProxyType, ModuleType
from typing import Any, TypeVar

Function = TypeVar("Function", bound=Callable[..., Any])
Space = dict[str, Any]
NOTHING: Mapping[str, Any] = MappingProxyType({})


def called(function: Function) -> Function:
    """Mark a function that is not inlined."""
    return _mark(function, "called")


def given(function: Function) -> Function:
    """Mark a function that its namesake in another module of the kernel replaces."""
    return _mark(function, "given")


def entry(function: Function) -> Function:
    """Mark a function that Python calls, and that is kept on disk when it is compiled."""
    return _mark(function, "entry")


def _mark(function: Function, mark: str) -> Function:
    inspect.unwrap(function).kernel_mark = mark  # type: ignore[attr-defined]
    return function


def copy_modules(
    modules: Iterable[ModuleType], make: Callable[[FunctionType, str], Any], replaced: Mapping[str, Any] = NOTHING,
    joined: bool = False,
) -> dict[str, Space]:
    """Return the names of copies of modules, by the names of the modules.

    Args:
        modules: of a kernel.
        make: function with the names of its copy, and its mark → its replacement.
        replaced: replacements of functions by name, for which ``make`` is not called.
        joined: whether the copies share their names: functions are the last module's, all else is the first one's.
    """
    parts = tuple(modules)
    spaces = {part.__name__: dict(vars(part)) for part in parts}
    if joined:
        values = {name: x for part in reversed(parts) for name, x in vars(part).items() if not inspect.isfunction(x)}
        spaces = dict.fromkeys(spaces, values)
    copies, named, names = dict[Any, Any](), Space(), dict[Any, str]()
    for part in parts:
        space = spaces[part.__name__]
        for name, value in vars(part).items():
            plain: Any = inspect.unwrap(value) if inspect.isfunction(value) else None  # tests wrap them to check types
            if plain is None or plain.__module__ != part.__name__:
                continue
            mark = getattr(plain, "kernel_mark", "inlined")
            if mark == "given":
                names[plain] = name
                continue
            copy = replaced[name] if name in replaced else make(FunctionType(plain.__code__, space, name), mark)
            copies[plain] = named[name] = space[name] = copy
    copies |= {plain: named[name] for plain, name in names.items()}
    for space in spaces.values():
        for name, value in space.items():
            if inspect.isfunction(value) and (plain := inspect.unwrap(value)) in copies:
                space[name] = copies[plain]
    return spaces

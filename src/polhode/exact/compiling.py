"""The kernels compiled by Numba, which keeps them beside their files, or in the user's cache.

Copies of their modules are made whose functions are Numba's; the modules themselves stay as Python runs them.
"""

from __future__ import annotations

import inspect
import math
import sys
import zlib
from collections.abc import Callable, Iterable
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numpy as np
from numba import njit
from numba.core import event
from numba.core.types import float64, int64
from numba.extending import intrinsic

_TAKE: Any = njit  # whose types do not know all of its options
_FILES = [Path(__file__), *sorted(Path(__file__).parent.rglob("kernel*.py"))]
SOURCES = zlib.crc32(b"".join(path.read_bytes() for path in _FILES))


def announce(what: str, dispatcher: Any) -> Any:
    """Have a function of Numba's say on a terminal when it is being compiled, and return it."""

    class Listener(event.Listener):
        def on_start(self, event: Any) -> None:
            if event.data["dispatcher"] is dispatcher and sys.stderr.isatty():
                print(f"polhode: compiling its {what}, once for this installation …", file=sys.stderr, flush=True)

        def on_end(self, event: Any) -> None:
            pass

    event.register("numba:compile", Listener())
    return dispatcher


def compiled_modules(modules: Iterable[ModuleType]) -> list[dict[str, Any]]:
    """Return the names of each module, with functions that Numba compiles when they are first called.

    Args:
        modules: with functions that are marked as parts of a kernel, which call each other.
    """
    modules, made = list(modules), dict[Any, Any]()
    spaces: list[dict[str, Any]] = [dict(vars(module)) for module in modules]
    for module, space in zip(modules, spaces, strict=True):
        for name, value in vars(module).items():
            plain = inspect.unwrap(value) if callable(value) else value  # tests wrap functions to check annotations
            mark = getattr(plain, "kernel_mark", None)
            if mark is not None and plain.__module__ == module.__name__:
                made[plain] = OWN[name] if name in OWN else _compile(FunctionType(plain.__code__, space, name), mark)
    for space in spaces:
        for name, value in space.items():
            plain = inspect.unwrap(value) if isinstance(value, FunctionType) else None
            if plain in made:
                space[name] = made[plain]
    return spaces


def _compile(function: FunctionType, mark: str) -> Any:
    if mark != "entry":  # needs no way in from Python, which takes time to compile
        return _TAKE(error_model="numpy", forceinline=mark == "inlined", no_cpython_wrapper=True,
                     no_cfunc_wrapper=True)(function)  # fmt: skip
    # Numba looks at one file alone for changes, and keeps what it compiles by this name
    function.__qualname__ = f"{function.__name__}_{SOURCES:08x}"
    return announce("closed forms", _TAKE(error_model="numpy", nogil=True, cache=True)(function))


def is_on_disk(entry: Any) -> bool:
    """Return whether Numba has compiled a function before."""
    return any(Path(entry.stats.cache_path).glob(f"*{entry.__qualname__}-*.nbi"))


# ---------------------------------------------------------------------- what takes the place of Python's words


def _instruction(function: Callable[..., Any]) -> Any:
    return intrinsic(inspect.unwrap(function))


@_instruction
def _fused(context: Any, a: Any, b: Any, c: Any) -> Any:
    """Return a b + c, rounded once."""
    return float64(float64, float64, float64), lambda _, builder, __, values: builder.fma(*values)


@_instruction
def _bits_of(context: Any, x: Any) -> Any:
    cast = lambda made, builder, _, values: builder.bitcast(values[0], made.get_value_type(int64))  # noqa: E731
    return int64(float64), cast


@_instruction
def _of_bits(context: Any, n: Any) -> Any:
    cast = lambda made, builder, _, values: builder.bitcast(values[0], made.get_value_type(float64))  # noqa: E731
    return float64(int64), cast


def _two_product(a: Any, b: Any) -> Any:
    p = a * b
    return p, _fused(a, b, -p)


_inlined = _TAKE(error_model="numpy", forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
two_product = _inlined(inspect.unwrap(_two_product))
OWN: dict[str, Any] = {
    "two_product": two_product, "bits_of": _bits_of, "of_bits": _of_bits,
    "square_root": _inlined(lambda x: np.sqrt(x)), "exponential": _inlined(lambda x: math.exp(x)),
    "floor": _inlined(lambda x: np.floor(x)), "nearest": _inlined(lambda x: np.rint(x)),
    "room": _inlined(lambda count: np.zeros(count)), "places": _inlined(lambda count: np.empty(count, np.int64)),
    "flags": _inlined(lambda count: np.empty(count, np.bool_)),
}  # fmt: skip

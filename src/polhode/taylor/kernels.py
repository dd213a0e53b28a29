"""The kernel, as plain Python and compiled by Numba: the same lines, and the same bits.

Compiling takes five seconds, once for an installation, and loading what was compiled a third of one. Short runs are
over by then, and are left to Python.
"""

from __future__ import annotations

import inspect
import time
import zlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any, NamedTuple

from polhode.taylor import compiled_vectors, kernel, kernel_series, kernel_zeros, vectors

LOADED, COMPILED = 0.3, 2.0  # s of the processor that runs by Python take before the kernel is loaded, or compiled
MODULES: tuple[ModuleType, ...] = kernel_series, kernel_zeros, kernel
ENTRIES = ("advance", "values_at")
INLINED = ("combination", "nodes")
Function = Any  # of Numba's or of Python's own


class Kernel(NamedTuple):
    """Functions of ``kernel``, and the steps that one call takes at most, so that Ctrl-C is seen between two."""

    advance: Function
    values_at: Function
    stretch: int


class _Spent:
    """Time that this process has spent in runs by Python [s], and whether it has the compiled kernel."""

    seconds = 0.0
    compiled = False


def chosen_kernel() -> Kernel:
    """Return the compiled kernel if it is there or worth its while, else that of plain Python."""
    spent = _Spent.seconds
    wait = not _Spent.compiled and (spent < LOADED or (spent < COMPILED and not _is_on_disk()))
    if wait:
        return python_kernel()
    _Spent.compiled = True
    return compiled_kernel()


def _counted(function: Function) -> Function:
    def counted(*arguments: Any) -> Any:
        before = time.process_time()
        found = function(*arguments)
        _Spent.seconds += time.process_time() - before
        return found

    return counted


@cache
def python_kernel() -> Kernel:
    """Return the kernel as it is written."""
    space = _joined(lambda function, name: function, {})
    return Kernel(*(_counted(space[name]) for name in ENTRIES), stretch=20)


@cache
def compiled_kernel() -> Kernel:
    """Return the kernel as Numba compiles it when it is first called, or has it on the disk."""
    from polhode.exact.kernel_arithmetic import announced, njit

    sources = [Path(inspect.getfile(module)).read_bytes() for module in (*MODULES, compiled_vectors)]
    version = zlib.crc32(b"".join(sources))
    load, store, gather = compiled_vectors.vector_operations()
    operations = {"load": load, "store": store, "gather": gather}
    take: Any = njit  # whose types do not know all of its options

    def compiled(function: FunctionType, name: str) -> Any:
        if name in ENTRIES:
            # Numba looks at one file alone for changes, and keeps what it compiles by this name
            function.__qualname__ = f"{name}_{version:08x}"
            return announced("Taylor series", take(error_model="numpy", nogil=True, cache=True)(function))
        return take(error_model="numpy", nogil=True, forceinline=name in INLINED, no_cpython_wrapper=True,
                    no_cfunc_wrapper=True)(function)  # fmt: skip

    space = _joined(compiled, operations)
    return Kernel(*(space[name] for name in ENTRIES), stretch=200_000)


def use_compiled_kernel() -> None:
    """Take the compiled kernel from now on, however short the runs."""
    _Spent.compiled = True


@cache
def _is_on_disk() -> bool:
    """Whether Numba has compiled it before."""
    kept = [Path(entry.stats.cache_path).glob(f"*{entry.__qualname__}-*.nbi") for entry in compiled_kernel()[:2]]
    return all(any(found) for found in kept)


def _joined(made: Callable[[FunctionType, str], Any], operations: dict[str, Any]) -> dict[str, Any]:
    """Return the names of all modules, in which functions, made into what is wanted, call each other."""
    space: dict[str, Any] = {}
    for module in (vectors, *MODULES):
        space.update({name: value for name, value in vars(module).items() if not inspect.isfunction(value)})
    own = [(name, value) for module in (vectors, *MODULES) for name, value in vars(module).items()
           if inspect.isfunction(value) and value.__module__ == module.__name__]  # fmt: skip
    for name, value in own:
        plain = inspect.unwrap(value)  # tests wrap functions to check annotations
        space[name] = operations.get(name) or made(FunctionType(plain.__code__, space, name), name)
    return space

"""Functions that Numba compiles at their first call. Where there are no images it keeps them on disk, under seals."""

from __future__ import annotations

import pickle
import sys
from collections.abc import Callable
from pathlib import Path
from types import FunctionType
from typing import Any

from numba import njit, typeof
from numba.core import event
from numba.core.caching import IndexDataCacheFile

from polhode._base.compiled.waiting import LIMITS, alone
from polhode._base.seals import read_sealed, write_sealed

_TAKE: Any = njit  # whose types do not know all of its options


def compile_part(function: Callable[..., Any], inlined: bool = True) -> Any:
    """Return a function for others that Numba compiles; it has no way in from Python, which takes time to compile."""
    return _TAKE(error_model="numpy", forceinline=inlined, no_cpython_wrapper=True, no_cfunc_wrapper=True)(function)


def compile_later(function: FunctionType, mark: str, what: str, kept_name: str) -> Any:
    """Return a function of a kernel as Numba compiles it when it is first called.

    Args:
        function: with the names of its copy.
        mark: of ``copying``.
        what: words for what the kernel computes.
        kept_name: by which the kernel is kept on disk.
    """
    if mark != "entry":
        return compile_part(function, mark == "inlined")
    function.__qualname__ = f"{function.__name__}_{kept_name}"
    return CompiledFunction(what, function)


class CompiledFunction:
    """A function that Python calls and Numba compiles: one process does, and all others wait for it and load that.

    Workers of a sweep start together, and each would compile for seconds. On a terminal the compiling one says so.

    Args:
        what: words for what it computes.
        function: to be compiled.
    """

    def __init__(self, what: str, function: FunctionType) -> None:
        self.what, self.function = what, function
        self.dispatcher: Any = _TAKE(error_model="numpy", nogil=True, cache=True)(function)
        _seal_files(self.dispatcher)
        self._is_ready = False  # the dispatcher's own list takes longer to ask than a short run
        entry = self

        class Listener(event.Listener):
            def on_start(self, event: Any) -> None:
                entry._announce(event.data["dispatcher"])

            def on_end(self, event: Any) -> None:
                pass

        event.register("numba:compile", Listener())

    def __call__(self, *arguments: Any) -> Any:
        if not self._is_ready:
            with alone(self._place / f"{self.dispatcher.__qualname__}.lock", LIMITS.max_wait):
                self.dispatcher.compile(tuple(map(typeof, arguments)))
            self._is_ready = True
        return self.dispatcher(*arguments)

    @property
    def _place(self) -> Path:
        return Path(self.dispatcher.stats.cache_path)

    def is_on_disk(self) -> bool:
        """Return whether Numba has compiled it before."""
        return any(self._place.glob(f"*{self.dispatcher.__qualname__}-*.nbi"))

    def _announce(self, dispatcher: Any) -> None:
        if dispatcher is self.dispatcher and sys.stderr.isatty():
            print(f"polhode: compiling its {self.what}, once for this installation …", file=sys.stderr, flush=True)


class _SealedFiles(IndexDataCacheFile):
    """Numba's files of one function, which it would read without a checksum, and run."""

    def _load_index(self) -> dict[Any, str]:
        content = read_sealed(Path(self._index_path), LIMITS.max_bytes)
        if content is None:
            return {}
        version, stamp, names = pickle.loads(content)
        return names if (version, stamp) == (self._version, self._source_stamp) else {}

    def _save_index(self, overloads: dict[Any, str]) -> None:
        self._write(Path(self._index_path), (self._version, self._source_stamp, overloads))

    def _load_data(self, name: str) -> Any:
        content = read_sealed(Path(self._data_path(name)), LIMITS.max_bytes)
        if content is None:
            raise FileNotFoundError(name)  # so that Numba compiles again
        return pickle.loads(content)

    def _save_data(self, name: str, data: Any) -> None:
        self._write(Path(self._data_path(name)), data)

    def _write(self, path: Path, value: Any) -> None:
        write_sealed(path, self._dump(value))  # type: ignore[attr-defined]


def _seal_files(dispatcher: Any) -> None:
    """Have Numba keep a function under seals, or not at all where a release of Numba keeps it in another way."""
    cache = getattr(dispatcher, "_cache", None)
    files: Any = getattr(cache, "_cache_file", None)
    if cache is None:  # where NUMBA_DISABLE_JIT is set
        return
    if type(files) is not IndexDataCacheFile:
        cache.disable()
        return
    cache._cache_file = _SealedFiles(files._cache_path, Path(files._index_name).stem, files._source_stamp)

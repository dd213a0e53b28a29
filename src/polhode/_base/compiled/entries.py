"""Functions that Python calls and Numba compiles once, loaded from the disk without Numba where they are there."""

from __future__ import annotations

import os
import pickle
import struct
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from threading import Lock
from typing import Any

import numpy as np

from polhode._base.compiled.images import CannotLink, Image, load, processors
from polhode._base.compiled.waiting import LIMITS, alone
from polhode._base.seals import read_sealed, write_sealed

ENDING = ".kernel"
IN_ORDER, TO_BE_WRITTEN = 0x101, 0x400  # flags of arrays of NumPy: in the order of C and aligned
SHIPPED = Path(__file__).parent / "shipped"  # images for classes of processors, where a release has them


Run = tuple[Callable[[bytes], int], struct.Struct]


class Entry:
    """A function of arrays, numbers and tuples of these, without a result.

    Of processes that need it at once, as workers of a sweep do, one compiles, and all others wait for it and load that.

    Args:
        name: under which it is kept on disk, with the digest of all that is compiled into it.
        what: words for what it computes.
        module: file of its module: beside this one's compiled form it is kept, where that can be written.
        by_numba: returns it as a ``CompiledFunction``.
    """

    def __init__(self, name: str, what: str, module: Path, by_numba: Callable[[], Any]) -> None:
        self.name, self.what, self._by_numba = name, what, by_numba
        self._place = find_place(module)
        self._runs, self._lock = dict[str, Run](), Lock()
        self._numba: Any = None  # where no image can be made or run

    def __call__(self, *arguments: Any) -> None:
        kinds, words = list[str](), list[Any]()
        for argument in arguments:
            _flatten(argument, kinds, words)
        form = ",".join(kinds)
        run = self._runs.get(form) or self._prepare(form, kinds, arguments)
        if run is None:
            self._numba(*arguments)
        elif run[0](run[1].pack(*words)):
            raise MemoryError(f"no room for {self.what}")

    def is_on_disk(self) -> bool:
        """Return whether it has been compiled before, or came compiled."""
        return any(next(folder.glob(f"{self.name}_*_{processor}{ENDING}"), None) for folder, processor in self._homes())

    def _prepare(self, form: str, kinds: list[str], arguments: tuple[Any, ...]) -> Run | None:
        with self._lock:
            if form not in self._runs and self._numba is None:
                function = self._load(form)
                if function is None:
                    with alone(self._place / f"{self.name}.lock", LIMITS.max_wait):
                        function = self._load(form) or self._compile(form, arguments)
                if function is None:
                    self._numba = self._by_numba()
                else:
                    self._runs[form] = function, struct.Struct("".join("d" if kind == "d" else "q" for kind in kinds))
            return self._runs.get(form)

    def _homes(self) -> Iterator[tuple[Path, str]]:
        own, *classes = processors()
        yield self._place, own
        for level in classes:
            yield SHIPPED, level

    def _load(self, form: str) -> Callable[[bytes], int] | None:
        for folder, processor in self._homes():
            path = folder / self._file(form, processor)
            content = read_sealed(path, LIMITS.max_bytes, installed=folder is SHIPPED)
            if content is not None:
                with suppress(OSError, AttributeError):  # where no memory may be run, or libm lacks a function
                    return load(Image(*pickle.loads(content)))
        return None

    def _file(self, form: str, processor: str) -> str:
        return f"{self.name}_{sha256(form.encode()).hexdigest()[:8]}_{processor}{ENDING}"

    def _compile(self, form: str, arguments: tuple[Any, ...]) -> Callable[[bytes], int] | None:
        """Return the function, which is written to the disk, or None where only Numba can run it."""
        from polhode._base.compiled.objects import build_image  # which loads Numba

        if sys.stderr.isatty():
            print(f"polhode: compiling its {self.what}, once for this installation …", file=sys.stderr, flush=True)
        try:
            image = build_image(self._by_numba().function, arguments)
            with suppress(OSError):
                write_sealed(self._place / self._file(form, processors()[0]), pickle.dumps(tuple(image)))
            return load(image)
        except (CannotLink, OSError, AttributeError):
            return None


def find_place(module: Path) -> Path:
    """Return where what is compiled of a module is kept: as Numba does, or beside other things that polhode keeps."""
    if named := os.environ.get("NUMBA_CACHE_DIR"):
        return Path(named) / "polhode"
    beside = module.parent / "__pycache__"
    if os.access(beside if beside.exists() else beside.parent, os.W_OK):
        return beside
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "polhode" / "kernels"


def _flatten(value: Any, kinds: list[str], words: list[Any]) -> None:
    """Append the kinds of the arrays and numbers in a value, and a word for each: of an array where its record is."""
    if isinstance(value, np.ndarray):
        flags = value.flags.num
        if flags & IN_ORDER != IN_ORDER:
            raise TypeError("compiled functions take arrays that are aligned and in the order of C")
        kinds.append(f"{value.dtype.str}{value.ndim}{'' if flags & TO_BE_WRITTEN else 'r'}")
        words.append(id(value))
    elif isinstance(value, tuple):
        for part in value:
            _flatten(part, kinds, words)
    elif isinstance(value, float):
        kinds.append("d")
        words.append(value)
    else:
        kinds.append("q")
        words.append(int(value))

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
from weakref import WeakSet

import numpy as np

from polhode._base.compiled.images import CannotLink, Image, load, processors
from polhode._base.compiled.waiting import LIMITS, alone
from polhode._base.seals import drop_oldest, read_sealed, write_sealed
from polhode.errors import shown

ENDING = ".kernel"
IN_ORDER, TO_BE_WRITTEN = 0x101, 0x400  # flags of arrays of NumPy: in the order of C and aligned
SHIPPED = Path(__file__).parent / "shipped"  # images for classes of processors, where a release has them


NESTING = "(", ")"  # around the kinds of a tuple's parts
Run = tuple[Callable[[bytes], int], struct.Struct]
ENTRIES: WeakSet[Entry] = WeakSet()


class Entry:
    """A function of arrays, numbers and tuples of these, without a result.

    Of processes that need it at once, as workers of a sweep do, one compiles, and all others wait for it and load that,
    where filelock is installed.

    Args:
        name: under which it is kept on disk, with the digest of all that is compiled into it.
        what: words for what it computes.
        module: file of its module: beside this one's compiled form it is kept, where that can be written.
        otherwise: returns it as a ``CompiledFunction``, or as Python runs it where nothing can be compiled.
        compiles: whether Numba is there.
    """

    def __init__(
        self, name: str, what: str, module: Path, otherwise: Callable[[], Any], compiles: bool = True
    ) -> None:
        self.name, self.what, self._otherwise, self._compiles = name, what, otherwise, compiles
        self._place = find_place(module)
        self._runs, self._lock = dict[str, Run](), Lock()
        self._without: Any = None  # the function where no image can be made or run
        ENTRIES.add(self)

    def __call__(self, *arguments: Any) -> None:
        kinds, words = list[str](), list[Any]()
        for argument in arguments:
            _flatten(argument, kinds, words)
        form = ",".join(kinds)
        run = self._runs.get(form) or self._prepare(form, kinds, arguments)
        if run is None:
            self._without(*arguments)
        elif run[0](run[1].pack(*words)):
            raise MemoryError(f"no room for {self.what}")

    def is_on_disk(self) -> bool:
        """Return whether it has been compiled before, or came compiled; without Numba, whether that runs, too."""
        return any(self._compiles or _load(path) is not None for path in self._files())

    def _prepare(self, form: str, kinds: list[str], arguments: tuple[Any, ...]) -> Run | None:
        with self._lock:
            if form not in self._runs and self._without is None:
                function = self._load(form)
                if function is None and self._compiles:
                    with alone(self._place / f"{self.name}.lock", LIMITS.max_wait):
                        function = self._load(form) or self._compile(form, arguments)
                if function is None:
                    self._without = self._otherwise()
                else:
                    words = ("d" if kind == "d" else "q" for kind in kinds if kind not in NESTING)
                    self._runs[form] = function, struct.Struct("".join(words))
            return self._runs.get(form)

    def _homes(self) -> Iterator[tuple[Path, str]]:
        own, *classes = processors()
        yield self._place, own
        for level in classes:
            yield SHIPPED, level

    def _files(self) -> Iterator[Path]:
        """Yield what is on the disk for any form of arguments."""
        for folder, processor in self._homes():
            with suppress(OSError):  # where there is no such folder
                for path in folder.iterdir():  # as globbing takes ten times as long
                    if path.name.startswith(f"{self.name}_") and path.name.endswith(f"_{processor}{ENDING}"):
                        yield path

    def _load(self, form: str) -> Callable[[bytes], int] | None:
        for folder, processor in self._homes():
            if (function := _load(folder / self._file(form, processor))) is not None:
                return function
        return None

    def _file(self, form: str, processor: str) -> str:
        return f"{self.name}_{sha256(form.encode()).hexdigest()[:8]}_{processor}{ENDING}"

    def _compile(self, form: str, arguments: tuple[Any, ...]) -> Callable[[bytes], int] | None:
        """Return the function, which is written to the disk, or None where only Numba can run it."""
        from polhode._base.compiled.objects import build_image  # which loads Numba

        if sys.stderr.isatty():
            print(f"polhode: compiling its {self.what}, once for this installation …", file=sys.stderr, flush=True)
        try:
            image = build_image(self._otherwise().function, arguments)
            with suppress(OSError):
                write_sealed(self._place / self._file(form, processors()[0]), pickle.dumps(tuple(image)))
                function, _, _ = self.name.rpartition("_")  # without the digest
                drop_oldest(self._place.glob(f"{function}_*{ENDING}"), LIMITS.max_images)
            return load(image)
        except (CannotLink, OSError, AttributeError):
            return None


def _load(path: Path) -> Callable[[bytes], int] | None:
    """Return the function of a file that is whole and can run here; None for any other."""
    content = read_sealed(path, LIMITS.max_bytes, installed=path.parent == SHIPPED)
    if content is not None:
        with suppress(OSError, AttributeError):  # where no memory may be run, or libm lacks a function
            return load(Image(*pickle.loads(content)))
    return None


def _renew_locks() -> None:
    """Free all entries in a process that was forked, as the thread that had one is not in it."""
    for entry in ENTRIES:
        entry._lock = Lock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew_locks)


def find_place(module: Path) -> Path:
    """Return where what is compiled of a module is kept: as Numba does, or beside other things that polhode keeps.

    Without a home directory it is a place where there is nothing and nothing can be written.
    """
    if named := os.environ.get("NUMBA_CACHE_DIR"):
        return Path(named) / "polhode"
    beside = module.parent / "__pycache__"
    if os.access(beside if beside.exists() else beside.parent, os.W_OK):
        return beside
    try:
        return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "polhode" / "kernels"
    except RuntimeError:  # HOME is not set, and the user has no entry
        return Path(os.devnull) / "polhode"


def _flatten(value: Any, kinds: list[str], words: list[Any]) -> None:
    """Append the kinds of the arrays and numbers in a value, and a word for each: of an array where its record is."""
    if isinstance(value, np.ndarray):
        flags = value.flags.num
        if flags & IN_ORDER != IN_ORDER:
            raise TypeError(
                "a compiled function takes arrays that are aligned and in the order of C; got one of shape "
                f"{value.shape} with strides {value.strides}. Give it `np.ascontiguousarray` of that."
            )
        kinds.append(f"{value.dtype.str}{value.ndim}{'' if flags & TO_BE_WRITTEN else 'r'}")
        words.append(id(value))
    elif isinstance(value, tuple):
        kinds.append(NESTING[0])
        for part in value:
            _flatten(part, kinds, words)
        kinds.append(NESTING[1])
    elif isinstance(value, float):
        kinds.append("d")
        words.append(value)
    elif isinstance(value, int | np.integer | np.bool_):
        kinds.append("q")
        words.append(int(value))
    else:
        what = "a compiled function takes arrays, doubles, whole numbers and tuples of these"
        raise TypeError(f"{what}; got {shown(value)}.")

"""The kernels compiled by Numba, which keeps them beside their files, or in the user's cache.

Copies of their modules are made whose functions are Numba's; the modules themselves stay as Python runs them.
"""

from __future__ import annotations

import inspect
import math
import sys
import zlib
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numpy as np
from filelock import FileLock
from llvmlite.ir import Constant
from numba import njit, typeof
from numba.core import event
from numba.core.cgutils import unpack_tuple
from numba.core.types import UniTuple, float64, int64, none
from numba.extending import intrinsic
from numba.np.arrayobj import make_array

from polhode.exact._copies import copy_modules
from polhode.exact._kernel_arithmetic import BLOCK

_TAKE: Any = njit  # whose types do not know all of its options
LONGEST = 600.0  # s that another process may take to compile
_FILES = sorted(path for path in Path(__file__).parent.rglob("*.py") if path.name.startswith(("_formulas", "_kernel")))
SOURCES = zlib.crc32(b"".join(path.read_bytes() for path in (Path(__file__), *_FILES)))


class Entry:
    """A function of Numba's that Python calls, which one process compiles and all others wait for and load.

    Workers of a sweep start at the same time, and each would compile for seconds. On a terminal it says when it does.

    Args:
        what: words for what it computes.
        dispatcher: what ``njit`` returned, to be kept on disk.
    """

    def __init__(self, what: str, dispatcher: Any) -> None:
        self.what, self.dispatcher = what, dispatcher
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
            with self._alone():
                self.dispatcher.compile(tuple(map(typeof, arguments)))
            self._is_ready = True
        return self.dispatcher(*arguments)

    @contextmanager
    def _alone(self) -> Iterator[None]:
        lock = FileLock(self._place / f"{self.dispatcher.__qualname__}.lock", timeout=LONGEST)
        try:
            lock.acquire()
        except (OSError, NotImplementedError):  # read-only, without locks, or held for too long
            yield
            return
        try:
            yield
        finally:
            lock.release()

    @property
    def _place(self) -> Path:
        return Path(self.dispatcher.stats.cache_path)

    def is_on_disk(self) -> bool:
        """Return whether Numba has compiled it before."""
        return any(self._place.glob(f"*{self.dispatcher.__qualname__}-*.nbi"))

    def _announce(self, dispatcher: Any) -> None:
        if dispatcher is self.dispatcher and sys.stderr.isatty():
            print(f"polhode: compiling its {self.what}, once for this installation …", file=sys.stderr, flush=True)


def compiled_modules(modules: Iterable[ModuleType], motion: str) -> dict[str, dict[str, Any]]:
    """Return the names of modules, by theirs, with functions that Numba compiles when they are first called.

    Args:
        modules: with functions that are marked as parts of a kernel, which call each other.
        motion: word for the motion whose formulas they have.
    """
    return copy_modules(modules, OWN, partial(_compile, motion))


def _compile(motion: str, function: FunctionType, mark: str) -> Any:
    if mark != "entry":  # needs no way in from Python, which takes time to compile
        return _TAKE(error_model="numpy", forceinline=mark == "inlined", no_cpython_wrapper=True,
                     no_cfunc_wrapper=True)(function)  # fmt: skip
    # Numba looks at one file alone for changes, and keeps what it compiles by this name
    function.__qualname__ = f"{function.__name__}_{motion}_{SOURCES:08x}"
    return Entry("closed forms", _TAKE(error_model="numpy", nogil=True, cache=True)(function))


# ---------------------------------------------------------------------- what takes the place of Python's words


def _instruction(function: Callable[..., Any]) -> Any:
    return intrinsic(inspect.unwrap(function))


@_instruction
def _fused(context: Any, a: Any, b: Any, c: Any) -> Any:
    """Return a b + c, rounded once."""
    return float64(float64, float64, float64), lambda _, builder, __, values: builder.fma(*values)


@_instruction
def _bits_of(context: Any, x: Any) -> Any:
    cast = lambda target, builder, _, values: builder.bitcast(values[0], target.get_value_type(int64))  # noqa: E731
    return int64(float64), cast


@_instruction
def _of_bits(context: Any, n: Any) -> Any:
    cast = lambda target, builder, _, values: builder.bitcast(values[0], target.get_value_type(float64))  # noqa: E731
    return float64(int64), cast


def _two_product(a: Any, b: Any) -> Any:
    p = a * b
    return p, _fused(a, b, -p)


@intrinsic(prefer_literal=True)
def _record(context: Any, rows: Any, i: Any, count: Any) -> Any:
    numbers = rows.dtype, count.literal_value

    def read(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        places = _places(context, builder, rows, values, count.literal_value)
        return context.make_tuple(builder, signature.return_type, [builder.load(place) for place in places])

    return UniTuple(*numbers)(rows, i, count), read


@intrinsic
def _put_record(context: Any, rows: Any, i: Any, values: Any) -> Any:
    def write(context: Any, builder: Any, _: Any, operands: Any) -> Any:
        places = _places(context, builder, rows, operands, len(values))
        for place, value in zip(places, unpack_tuple(builder, operands[2]), strict=True):
            builder.store(value, place)
        return context.get_dummy_value()

    return none(rows, i, values), write


def _places(context: Any, builder: Any, rows: Any, values: Any, count: int) -> list[Any]:
    """Return pointers to numbers of an array that stand BLOCK apart."""
    data, first = make_array(rows)(context, builder, values[0]).data, values[1]
    steps = [builder.add(first, Constant(first.type, k * BLOCK)) for k in range(count)]
    return [builder.gep(data, [step], inbounds=True) for step in steps]


_inlined = _TAKE(error_model="numpy", forceinline=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)
two_product = _inlined(inspect.unwrap(_two_product))
OWN: dict[str, Any] = {
    "two_product": two_product, "bits_of": _bits_of, "of_bits": _of_bits,
    "record": _record, "put_record": _put_record,
    "square_root": _inlined(lambda x: np.sqrt(x)), "exponential": _inlined(lambda x: math.exp(x)),
    "floor": _inlined(lambda x: np.floor(x)), "nearest": _inlined(lambda x: np.rint(x)),
    "room": _inlined(lambda count: np.zeros(count)), "places": _inlined(lambda count: np.empty(count, np.int64)),
    "flags": _inlined(lambda count: np.empty(count, np.bool_)),
}  # fmt: skip

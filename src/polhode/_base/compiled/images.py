"""Images: a compiled function with all that it calls, as bytes that are mapped into memory and called.

Loading one takes a millisecond, where Numba or LLVM take a tenth of a second before they load anything. LLVM writes
object code for which a linker would have little to do: in the large model of code, as Numba has it on x86-64, each
address within the function and of the functions of libm is a whole number of eight bytes. So an image is the object's
sections side by side, with the places of these addresses. Other systems and processors have none.
"""

from __future__ import annotations

import ctypes
import mmap
import os
import platform
import sys
from collections.abc import Callable
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode._base.extras import is_there

LINES = ("vendor_id", "cpu family", "model", "flags")  # by which LLVM knows a processor
SETTINGS = "NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES", "NUMBA_OPT", "NUMBA_BOUNDSCHECK"  # which change its machine code
COMPILERS = "numba", "llvmlite"  # another version of which may make other code of the same source
LEVELS = {
    "x86-64-v4": {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"},
    "x86-64-v3": {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"},
}  # fmt: skip
"""Classes of processors and what they add to the one below, the best first, under their names for LLVM."""


class Image(NamedTuple):
    """Machine code and its addresses.

    Attributes:
        code: of all functions, with their constants.
        entry: where the one begins that is called.
        places: of addresses within the image, and ``targets`` these, from its beginning.
        outside: by the name of a function outside, the places of its address.
    """

    code: bytes
    entry: int
    places: tuple[int, ...]
    targets: tuple[int, ...]
    outside: dict[str, tuple[int, ...]]


class CannotLink(ValueError):
    """Object code that no image can be made of."""


@cache
def has_images() -> bool:
    """Return whether this process can run images."""
    head = 16  # bytes of an object, which are more with Py_TRACE_REFS and where there is no lock: see ``objects``
    is_this_python = sys.implementation.name == "cpython" and object.__basicsize__ == head
    if sys.platform != "linux" or platform.machine() != "x86_64" or not is_this_python or is_switched_off():
        return False
    try:
        return bool(read_processor())
    except OSError:  # as in a container without /proc
        return False


def is_switched_off() -> bool:
    """Return whether nothing compiled is to run, as Numba takes the setting."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0")


@cache
def processors() -> tuple[str, ...]:
    """Return names under which images are kept: this processor's and compiler's own, then classes, the best first."""
    read = read_processor()
    settings = [os.environ.get(name) for name in SETTINGS]
    facts = [read.get(key) for key in LINES], settings, [read_version(name) for name in COMPILERS]
    own = sha256(repr(facts).encode()).hexdigest()[:8]
    flags, needed, classes = set(read.get("flags", "").split()), set[str](), list[str]()
    for level in reversed(LEVELS):
        needed |= LEVELS[level]
        classes = [level, *classes] if needed <= flags else classes
    return own, *classes


def read_version(package: str) -> bytes | None:
    """Return the file in which a package has its version, in a tenth of the time that asking for the version takes."""
    spec = find_spec(package) if is_there(package) else None
    if spec is None or spec.origin is None:
        return None
    named = Path(spec.origin).with_name("_version.py")
    return (named if named.exists() else Path(spec.origin)).read_bytes()


def read_processor() -> dict[str, str]:
    """Return what Linux says of the first core."""
    with Path("/proc/cpuinfo").open("rb", buffering=0) as file:
        text = file.read(8192).decode("ascii", "replace")  # of the first few, as all are listed one after the other
    rows = (line.partition(":") for line in text.partition("\n\n")[0].splitlines())
    return {key.strip(): value.strip() for key, _, value in rows}


def load(image: Image) -> Callable[[bytes], int]:
    """Return the function of an image, which takes the address of its arguments.

    Raises:
        OSError: where the system allows no code but that of files.
    """
    memory = mmap.mmap(-1, len(image.code), mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS, mmap.PROT_READ | mmap.PROT_WRITE)
    memory[:] = image.code
    own, process = np.frombuffer(memory, np.uint8), ctypes.CDLL(None)
    base = own.ctypes.data
    _put(own, image.places, np.array(image.targets, np.int64) + base)
    for name, places in image.outside.items():
        address = ctypes.cast(getattr(process, name), ctypes.c_void_p).value
        _put(own, places, np.full(len(places), address, np.int64))
    process.mprotect.argtypes = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int
    if process.mprotect(base, len(image.code), mmap.PROT_READ | mmap.PROT_EXEC):
        raise OSError("memory cannot be made executable")
    function: Any = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_char_p)(base + image.entry)
    function.memory = own  # which goes with it
    return function


def _put(code: Any, places: tuple[int, ...], addresses: Any) -> None:
    if places:
        code[np.array(places)[:, None] + np.arange(8)] = addresses.view(np.uint8).reshape(-1, 8)

"""Restores gradual underflow in threads where it is switched off.

XLA's threads treat numbers below 2.2e-308 as zero, and so does NumPy when it is called back from them: the same closed
form would then give different answers inside and outside of a compiled function.
"""

from __future__ import annotations

import contextlib
import ctypes
from collections.abc import Iterator
from functools import cache
from typing import Any

ENVIRONMENT = 512  # bytes, more than any system's fenv_t


@contextlib.contextmanager
def gradual_underflow() -> Iterator[None]:
    """Compute with subnormal numbers within this context, as the thread does that called ``remember_environment``."""
    # flush-to-zero and denormals-are-zero are bits of the floating-point environment, which belongs to a thread
    usual = remember_environment()
    if usual is None:
        yield
        return
    library, normal = usual
    here = ctypes.create_string_buffer(ENVIRONMENT)
    library.fegetenv(here)
    library.fesetenv(normal)
    try:
        yield
    finally:
        library.fesetenv(here)


@cache
def remember_environment() -> tuple[Any, Any] | None:
    """Return the C library and this thread's floating-point environment when first called; None where C99 has none."""
    try:
        library = ctypes.CDLL(None)
        get, set_ = library.fegetenv, library.fesetenv
    except (AttributeError, OSError, TypeError):  # Windows, whose threads cannot be asked in this way
        return None
    get.argtypes = set_.argtypes = [ctypes.c_void_p]
    environment = ctypes.create_string_buffer(ENVIRONMENT)
    get(environment)
    return library, environment

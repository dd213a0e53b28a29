"""Compiled functions are kept in the user's cache folder, so that a command run again does not compile them again."""

from __future__ import annotations

import os
import platform
import warnings

LARGEST = 300_000_000  # bytes of all that is kept; what was not used for the longest time goes first


def keep_compiled() -> None:
    """Let JAX keep what it compiles, for the command line alone: importing the library changes no such setting.

    To be called before JAX is imported. Settings in the environment win. What cannot be kept or read is compiled again,
    and nothing is said.
    """
    # what equinox checks while it runs calls Python, and such functions cannot be kept; polhode checks beforehand
    os.environ.setdefault("EQX_ON_ERROR", "nan")
    os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "3")  # processors that read their own functions back with complaints
    warnings.filterwarnings("ignore", "Error (reading|writing) persistent compilation cache")
    if "JAX_COMPILATION_CACHE_DIR" in os.environ:
        return
    from platformdirs import user_cache_path

    # a home that several machines share: they may have different processors
    os.environ["JAX_COMPILATION_CACHE_DIR"] = str(user_cache_path("polhode") / "compiled" / platform.node())
    os.environ.setdefault("JAX_COMPILATION_CACHE_MAX_SIZE", str(LARGEST))
    os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS", "0")
    os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES", "-1")

"""Makes JAX compile quickly for a command, and keeps what it compiled in the user's cache folder."""

from __future__ import annotations

import os
import platform
import warnings

COMPILER = "XLA_FLAGS"
QUICKLY = "--xla_backend_optimization_level=1 --xla_cpu_parallel_codegen_split_count=1"  # the functions run as fast
ADDED = {"0.10.": " --xla_cpu_use_fusion_emitters=false", "0.11.": ""}  # by releases of jaxlib that were tried:
# one that does not know a flag ends the process
LARGEST = 300_000_000  # bytes of all that is kept; what was not used for the longest time goes first


def compile_quickly(flags: str = QUICKLY) -> None:
    """Switch off XLA's most expensive optimizations, which hardly pay where a function runs a few times.

    To be called before JAX is imported. Flags in the environment win.
    """
    from jaxlib.version import __version__  # without loading JAX

    added = [more for release, more in ADDED.items() if __version__.startswith(release)]
    if added:
        os.environ.setdefault(COMPILER, flags + added[0])


def keep_compiled() -> None:
    """Let commands keep what JAX compiles, pint's table of units, and reports; importing the library keeps nothing.

    To be called before JAX is imported. Settings in the environment win. What cannot be kept or read is made again, and
    nothing is said.
    """
    # what equinox checks while it runs calls Python, and such functions cannot be kept; polhode checks beforehand
    os.environ.setdefault("EQX_ON_ERROR", "nan")
    os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "3")  # processors that read their own functions back with complaints
    warnings.filterwarnings("ignore", "Error (reading|writing) persistent compilation cache")
    from platformdirs import user_cache_path

    for what in ("units", "reports"):
        os.environ.setdefault(f"POLHODE_{what.upper()}_CACHE", str(user_cache_path("polhode") / what))
    if "JAX_COMPILATION_CACHE_DIR" in os.environ:
        return
    # a home that several machines share: they may have different processors
    os.environ["JAX_COMPILATION_CACHE_DIR"] = str(user_cache_path("polhode") / "compiled" / platform.node())
    os.environ.setdefault("JAX_COMPILATION_CACHE_MAX_SIZE", str(LARGEST))
    os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS", "0")
    os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES", "-1")

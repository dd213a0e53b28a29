"""Makes JAX compile quickly for a command, and keeps what it compiled in the user's cache folder."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import warnings
import zlib
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

COMPILER = "XLA_FLAGS"
QUICKLY = ("--xla_backend_optimization_level=1", "--xla_cpu_parallel_codegen_split_count=1",
           "--xla_cpu_use_fusion_emitters=false")  # the functions run as fast
TRIAL = "import jax; jax.jit(lambda x: 2.0 * x)(1.5)"


class FlagLimits(NamedTuple):
    """Numbers beyond which flags are not tried or read."""

    trial_seconds: float = 120.0  # on a machine that is busy; a trial takes about one
    max_flag_bytes: int = 10_000  # of the file that keeps them


LIMITS = FlagLimits()


def compile_quickly(flags: tuple[str, ...] = QUICKLY) -> None:
    """Switch off XLA's most expensive optimizations, which hardly pay where a function runs a few times.

    To be called before JAX is imported. Flags in the environment win.
    """
    if COMPILER not in os.environ and (known := _known_flags(flags)):
        os.environ[COMPILER] = " ".join(known)


def _known_flags(flags: tuple[str, ...]) -> tuple[str, ...]:
    """Return those flags that the compiler knows; none where it cannot be kept which these are.

    One that it does not know ends its process, and releases differ: it is asked once, in a process of its own.
    """
    from jaxlib.version import __version__  # without loading JAX

    from polhode._base.seals import read_sealed, write_sealed

    folder = _cache_folder()
    if folder is None:
        return ()
    spec = find_spec("jaxlib")
    build = zlib.crc32(f"{spec and spec.origin} {flags}".encode())
    kept = folder / "flags" / f"{__version__}-{build:08x}"
    if lines := (read_sealed(kept, LIMITS.max_flag_bytes) or b"").decode().splitlines():
        return tuple(lines)
    try:
        write_sealed(kept, b"")  # whether it can be kept
        known = flags if _starts_with(flags) else tuple(flag for flag in flags if _starts_with((flag,)))
        write_sealed(kept, "\n".join(known).encode())
    except (OSError, subprocess.TimeoutExpired):
        return ()
    return known


def _starts_with(flags: tuple[str, ...]) -> bool:
    """Whether a process in which JAX compiles with these flags comes to its end."""
    environment = os.environ | {COMPILER: " ".join(flags), "JAX_PLATFORMS": "cpu"}
    done = subprocess.run([sys.executable, "-c", TRIAL], env=environment, capture_output=True, check=False,
                          timeout=LIMITS.trial_seconds)
    return done.returncode == 0


def keep_compiled() -> None:
    """Let commands keep what JAX compiles, pint's table of units, and reports; importing the library keeps nothing.

    To be called before JAX is imported. Settings in the environment win. Entries that cannot be kept or read are made
    again silently.
    """
    # what equinox checks while it runs calls Python, and such functions cannot be kept; polhode checks beforehand
    os.environ.setdefault("EQX_ON_ERROR", "nan")
    os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "3")  # processors that warn when they read their own functions back
    warnings.filterwarnings("ignore", "Error (reading|writing) persistent compilation cache")
    folder = _cache_folder()
    if folder is None:
        return
    for what in ("units", "reports"):
        os.environ.setdefault(f"POLHODE_{what.upper()}_CACHE", str(folder / what))
    if "JAX_COMPILATION_CACHE_DIR" in os.environ:  # a folder of the user's own, whose content JAX chooses
        return
    # a home that several machines share: they may have different processors
    os.environ.setdefault("POLHODE_COMPILED_CACHE", str(folder / "compiled" / platform.node()))
    os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS", "0")
    os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES", "-1")
    os.environ.setdefault("JAX_PERSISTENT_CACHE_ENABLE_XLA_CACHES", "none")  # which a compiler would write unsealed


def _cache_folder() -> Path | None:
    """Return the user's cache folder for polhode; None where there is no home directory."""
    from platformdirs import user_cache_path

    try:
        folder = user_cache_path("polhode")
    except RuntimeError:
        return None
    return None if folder.parts[0] == "~" else folder  # as older releases of platformdirs leave it

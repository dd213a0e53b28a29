"""What JAX compiles for a command, kept under a seal for the next one.

JAX reads back what it kept without a checksum of its own wherever it compresses by Zstandard, and runs it as machine
code. So it is given a store of ours in place of its folder; a JAX that takes none keeps nothing.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path
from typing import NamedTuple

from polhode._base.seals import drop_oldest, read_sealed, write_sealed

FOLDER = "POLHODE_COMPILED_CACHE"  # environment variable: the folder for programs that JAX compiles


class CacheLimits(NamedTuple):
    """Numbers beyond which the entries that were not used for the longest time are dropped."""

    max_bytes: int = 300_000_000  # of all that is kept
    max_entries: int = 100_000


LIMITS = CacheLimits()


class SealedPrograms:
    """The store that JAX asks for compiled programs, with the methods of JAX's ``CacheInterface``."""

    def __init__(self, folder: Path) -> None:
        self._path = folder

    def get(self, key: str) -> bytes | None:
        """Return the entry of a key; None for a missing or damaged one."""
        place = self._place(key)
        content = read_sealed(place, LIMITS.max_bytes)
        if content is not None:
            with contextlib.suppress(OSError):
                os.utime(place)
        return content

    def put(self, key: str, value: bytes) -> None:
        """Keep an entry, where there is room."""
        if len(value) <= LIMITS.max_bytes:
            write_sealed(self._place(key), value)
            drop_oldest(self._path.glob("*"), LIMITS.max_entries, LIMITS.max_bytes)

    def _place(self, key: str) -> Path:
        return self._path / f"{key}-cache"


def keep_programs() -> None:
    """Let JAX keep what it compiles where the environment says so; to be called before anything is compiled."""
    folder = os.environ.get(FOLDER)
    if not folder:
        return
    import jax

    from polhode._base.jax_inner import compilation_cache

    if not callable(getattr(compilation_cache, "get_file_cache", None)):
        return
    compilation_cache.get_file_cache = lambda path: (SealedPrograms(Path(path)), path)
    jax.config.update("jax_compilation_cache_dir", folder)

"""Everything on which the bits of a result depend besides its input: program, libraries, settings, other packages.

Numbers that are kept for later, in reports, pages or chunks of a sweep, are stored under its digest.
"""

from __future__ import annotations

import hashlib
import os
import platform
import sys
from collections.abc import Iterable
from functools import cache
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

from polhode._base.plugins import COMPUTED_BY, Plugin, digest_plugins

SETTINGS = ("XLA_FLAGS", "JAX_ENABLE_X64", "NUMBA_DISABLE_JIT", "NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES",
            "NPY_DISABLE_CPU_FEATURES", "OPENBLAS_CORETYPE")  # fmt: skip
"""Environment variables by which the same libraries compute other last bits."""
OURS = "polhode, Python, a library that it computes with, or a setting such as XLA_FLAGS"


def program_digest(plugins: Iterable[Plugin] = ()) -> str:
    """Return a SHA-256 that differs between programs whose numbers may differ.

    Sources count by content, so that installing the same version again changes nothing. Processors are not told apart.

    Args:
        plugins: what takes part of other packages.

    Raises:
        InvalidInput: where its code changed after this process had imported it.
    """
    return hashlib.sha256(repr(sorted(program_parts(plugins).items())).encode()).hexdigest()


def program_parts(plugins: Iterable[Plugin] = ()) -> dict[str, str]:
    """Return the digests of the parts of a program, by what they are in words; arguments as ``program_digest`` has."""
    others = {f"the {plugin.word} {plugin.name} of another package ({plugin.value})": digest
              for plugin, digest in digest_plugins(plugins).items()}
    return {OURS: _own_digest()} | others


def _own_digest() -> str:
    settings = [(name, os.environ.get(name)) for name in SETTINGS]
    system = platform.python_version(), sys.platform, platform.machine()
    return hashlib.sha256(repr((system, _versions(), settings, _sources())).encode()).hexdigest()


@cache
def _versions() -> list[tuple[str, str]]:
    return [(name, _version(name)) for name in COMPUTED_BY]


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return ""


@cache
def _sources() -> str:
    """Return a digest of the files of this package."""
    digest, spec = hashlib.sha256(), find_spec("polhode")
    assert spec is not None
    for top in map(Path, spec.submodule_search_locations or ()):
        for file in sorted(top.rglob("*")):
            if file.is_file() and file.parent.name != "__pycache__":
                content = file.read_bytes()
                digest.update(f"{file.relative_to(top).as_posix()} {len(content)}\n".encode())
                digest.update(content)
    return digest.hexdigest()

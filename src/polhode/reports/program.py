"""The program, libraries and settings on which every bit of a result depends, as a digest.

Numbers that are kept for later, in reports or in chunks of a sweep, are stored under this digest.
"""

from __future__ import annotations

import hashlib
import os
import platform
import sys
from functools import cache
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

# whose versions change numbers, or how a spec is read; a test of the house looks for others
COMPUTED_BY = ("numpy", "scipy", "array-api-compat", "numba", "llvmlite", "jax", "jaxlib", "equinox", "diffrax",
               "optimistix", "lineax", "pydantic", "pydantic-core", "pint", "trimesh", "ase", "xarray", "h5netcdf",
               "h5py", "zarr", "numcodecs")  # fmt: skip
SETTINGS = ("XLA_FLAGS", "NUMBA_DISABLE_JIT", "NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES", "NPY_DISABLE_CPU_FEATURES",
            "OPENBLAS_CORETYPE")  # fmt: skip
"""Environment variables by which the same libraries compute other last bits."""


def program_digest(*packages: str) -> str:
    """Return a SHA-256 that differs between programs whose numbers may differ.

    Sources count by content, so that installing the same version again changes nothing. Processors are not told apart.

    Args:
        packages: others whose code computes too, such as that of a kind of motion.
    """
    versions = [(name, _version(name)) for name in COMPUTED_BY]
    settings = [(name, os.environ.get(name)) for name in SETTINGS]
    sources = [(name, _sources(name)) for name in sorted({"polhode", *packages})]
    system = platform.python_version(), sys.platform, platform.machine()
    return hashlib.sha256(repr((system, versions, settings, sources)).encode()).hexdigest()


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return ""


@cache
def _sources(package: str) -> str:
    """Return a digest of the files of a package, or of a module of its own."""
    digest, spec = hashlib.sha256(), find_spec(package)
    if spec is None:
        return ""
    folders = [Path(place) for place in spec.submodule_search_locations or ()]
    files = [(file, file.relative_to(top)) for top in folders for file in sorted(top.rglob("*"))
             if file.is_file() and file.parent.name != "__pycache__"]  # fmt: skip
    if not folders and spec.origin is not None and Path(spec.origin).is_file():
        files = [(Path(spec.origin), Path(package))]
    for file, name in files:
        content = file.read_bytes()
        digest.update(f"{name.as_posix()} {len(content)}\n".encode())
        digest.update(content)
    return digest.hexdigest()

"""The table of units as pint reads it, kept in one sealed file for the next command.

Reading its definitions takes pint half a second. What it keeps of them in a folder are pickles without a checksum, in
which a lost bit may be a factor; so its folder is a temporary one, whose files come from, or go into, a file of ours.
pint names them by its own version, Python's, and the content of its definitions.
"""

from __future__ import annotations

import base64
import contextlib
import json
import sys
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.seals import read_sealed, write_sealed


class UnitCacheLimits(NamedTuple):
    """A number beyond which kept units are not read."""

    max_bytes: int = 10_000_000  # they are 300,000


LIMITS = UnitCacheLimits()


def _import_pint() -> Any:
    """Return pint, imported without dask: a quarter of its time, for arrays that no quantity of a spec is."""
    if "pint" not in sys.modules and "dask" not in sys.modules:
        sys.modules["dask"] = None  # type: ignore[assignment]  # Python's way to say that a module cannot be imported
        try:
            return import_module("pint")
        finally:
            del sys.modules["dask"]
    return import_module("pint")


def load_registry(folder: Path) -> Any:
    """Return pint's registry, from a kept file in a folder or from its definitions, which are then kept there.

    For processes of polhode's own, whose pint knows no arrays of dask.
    """
    pint = _import_pint()
    place = folder / f"pint-{pint.__version__}.units"
    kept = read_sealed(place, LIMITS.max_bytes)
    with tempfile.TemporaryDirectory(prefix="polhode-") as name:
        within = Path(name)
        for file, content in json.loads(kept or b"{}").items():
            (within / file).write_bytes(base64.b64decode(content))
        before = set(within.iterdir())
        registry = pint.UnitRegistry(cache_folder=within)
        registry.parse_units("m")  # it reads its definitions on first use
        if set(within.iterdir()) - before:
            packed = {path.name: base64.b64encode(path.read_bytes()).decode() for path in within.iterdir()}
            with contextlib.suppress(OSError):
                write_sealed(place, json.dumps(packed).encode())
    return registry

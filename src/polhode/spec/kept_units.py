"""The table of units as pint reads it, kept in one sealed file for the next command.

Reading its definitions takes pint half a second. What it keeps of them in a folder are pickles without a checksum, in
which a lost bit may be a factor; so its folder is a temporary one, whose files come from, or go into, a file of ours.
pint names them by its own version, Python's, and the content of its definitions.
"""

from __future__ import annotations

import base64
import contextlib
import json
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.seals import read_sealed, write_sealed


class UnitCacheLimits(NamedTuple):
    """A number beyond which kept units are not read."""

    max_bytes: int = 10_000_000  # they are 300,000


LIMITS = UnitCacheLimits()


def load_registry(folder: Path) -> Any:
    """Return pint's registry, from a kept file in a folder or from its definitions, which are then kept there."""
    import pint

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

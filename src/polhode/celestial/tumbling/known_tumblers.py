"""The table of known tumblers, which comes with the package."""

from __future__ import annotations

import difflib
import tomllib
from functools import cache
from pathlib import Path
from typing import NamedTuple

from polhode.errors import InvalidInput, shown


class KnownTumbler(NamedTuple):
    """A body whose two periods are published.

    Attributes:
        key: its name at the command line.
        name: with its number.
        precession: P_φ with unit, and its standard deviation where the source has one.
        rotation: P_ψ likewise.
        moments: I1 ≤ I2 ≤ I3 in any unit, with errors where the source has them; None where it has none.
        mode: "short-axis" or "long-axis", as the source says.
        source: where it is published.
    """

    key: str
    name: str
    precession: str
    rotation: str
    moments: tuple[str, str, str] | None
    mode: str
    source: str


@cache
def known_tumblers() -> dict[str, KnownTumbler]:
    """Return the known tumblers by key.

    Example:
        >>> known_tumblers()["krylov"].precession
        '67.27 h'
    """
    table = tomllib.loads((Path(__file__).parent / "tumblers.toml").read_text("utf-8"))
    return {key: KnownTumbler(key, row["name"], row["precession"], row["rotation"],
                              tuple(row["moments"]) if "moments" in row else None, row["mode"], row["source"])
            for key, row in table.items()}


def known_tumbler(key: str) -> KnownTumbler:
    """Return a known tumbler.

    Raises:
        InvalidInput: for a name that is not in the table.

    Example:
        >>> known_tumbler("Krylov").mode
        'short-axis'
    """
    known = known_tumblers()
    wanted = key.strip().lower().replace(" ", "-")
    if wanted not in known:
        near = difflib.get_close_matches(wanted, known, 1)
        meant = f"; did you mean {near[0]}?" if near else "."
        raise InvalidInput(f"no tumbler is called {shown(key)}{meant} Known are {', '.join(known)}; of others give "
                           "`precession`, `rotation` and `moments`.")
    return known[wanted]

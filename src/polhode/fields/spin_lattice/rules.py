"""Rules that the keys of spins on a lattice must satisfy together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from polhode.fields.spin_lattice.table import LIMITS
from polhode.spec.rules import Mistake


def find_mistakes(tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield lists whose lengths do not fit each other, and keys that exclude each other."""
    system = tables["system"]
    vectors, cells, basis = (system.get(key) for key in ("vectors", "cells", "basis"))
    count = len(vectors) if isinstance(vectors, list) else None
    if count and isinstance(cells, list) and len(cells) != count:
        yield ("system", "cells"), f"needs a number for each of the {count} vectors; got {len(cells)}"
    sites = len(basis) if isinstance(basis, list) and basis else 1
    spins = math.prod(cells) * sites if isinstance(cells, list) and all(type(n) is int and n > 0 for n in cells) else 0
    if spins > LIMITS.max_spins:
        yield ("system", "cells"), f"must make at most {LIMITS.max_spins:,} spins; got {spins:,}"
    bonds = system.get("bonds")
    for k, bond in enumerate(bonds if isinstance(bonds, list) else []):
        if isinstance(bond, dict):
            yield from _bond_rules(bond, ("system", "bonds", k), count, sites)
    directions = system.get("directions")
    if system.get("random") is True and (directions is not None or "disorder" in system):
        yield ("system", "random"), "goes without directions and disorder; leave out one or the other"
    if isinstance(directions, list) and len(directions) not in (1, sites):
        yield ("system", "directions"), f"needs one for all or one for each of {sites} sites; got {len(directions)}"
    if "temperature" in system and not system.get("damping"):
        yield ("system", "temperature"), "needs damping, like 0.1, by which the bath holds the spins"
    if "dipolar" in system and system.get("periodic", True) is True:
        yield ("system", "dipolar"), "needs periodic = false: the sum over an infinite lattice depends on its shape"


def _bond_rules(bond: dict[str, Any], where: tuple[str | int, ...], count: int | None, sites: int) -> Iterator[Mistake]:
    cell, ends = bond.get("cell"), bond.get("sites")
    if count and isinstance(cell, list) and len(cell) != count:
        yield (*where, "cell"), f"needs a whole number for each of the {count} vectors; got {len(cell)}"
    if isinstance(ends, list) and any(type(end) is int and end > sites for end in ends):
        yield (*where, "sites"), f"must be from 1 to {sites}, the sites of the basis; got {ends}"
    keys = [key for key in ("exchange", "chirality", "matrix") if key in bond]
    if not keys or ("matrix" in keys and len(keys) > 1):
        yield where, "needs exchange or chirality or both, or matrix alone"
    if isinstance(matrix := bond.get("matrix"), list) and len(matrix) != 3:
        yield (*where, "matrix"), f"needs three rows of three energies; got {len(matrix)}"

"""Molecules as rigid bodies of point masses."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from importlib.resources import files

import numpy as np

from polhode.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.bodies.points import from_points
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real

ATOMIC_MASS_UNIT = 1.66053906892e-27  # kg, CODATA 2022


@known_numbers_only
def from_atoms(
    symbols: Sequence[str], positions: Real[ArrayLike, "n 3"], masses: Real[ArrayLike, "n"] | None = None
) -> Body:
    """Return a molecule as a rigid body of point masses, which is where its rotational constants come from.

    Masses are standard atomic weights, averaged over isotopes; a spectroscopist gives the isotopes' masses instead.
    The rotational constants of an equilibrium geometry are not those of the vibrational ground state.

    Args:
        symbols: (n,) chemical symbols.
        positions: (n, 3) [m].
        masses: (n,) [kg], or None for the table's; multiples of ``ATOMIC_MASS_UNIT`` for isotopes.

    Raises:
        InvalidInput: for unknown symbols, atoms at one place, or arrays that do not match.
    """
    symbols = list(symbols)
    try:
        shape = np.shape(positions)
    except ValueError:
        raise InvalidInput("`positions` must be three numbers for each atom; got rows of different lengths.") from None
    if shape != (len(symbols), 3):
        raise InvalidInput(f"`symbols` (n,) and `positions` (n, 3) must match; got {len(symbols)} and {shape}.")
    distinct, first = np.unique(np.asarray(positions, dtype=float), axis=0, return_index=True)
    if len(distinct) < len(symbols):
        twice = min(set(range(len(symbols))) - set(first.tolist()))
        raise InvalidInput(f"atoms must be apart; atom {twice + 1} ({symbols[twice]}) is where another one is.")
    return from_points(atomic_masses(symbols) if masses is None else masses, positions)


def atomic_masses(symbols: Sequence[str]) -> Float64[Array, "n"]:
    """Return standard atomic weights [kg] of chemical symbols; the mass number's stands in for elements without one.

    Raises:
        InvalidInput: for what is not a chemical element.

    Source: Meija et al., Pure Appl. Chem. 88 (2016) 265, as in ASE's tables.
    """
    table = _atomic_weights()
    unknown = [symbol for symbol in symbols if symbol not in table]
    if unknown:
        raise InvalidInput(
            f"`symbols` must be chemical elements; got {shown(unknown[0])}. "
            "Give `masses` for other atoms."
        )
    return np.array([table[symbol] for symbol in symbols]) * ATOMIC_MASS_UNIT


def is_element(symbol: str) -> bool:
    """Return whether a word is a chemical symbol."""
    return symbol in _atomic_weights()


@functools.cache
def _atomic_weights() -> dict[str, float]:
    lines = files("polhode.bodies").joinpath("atomic_weights.csv").read_text("ascii").splitlines()[1:]
    return {symbol: float(weight) for symbol, weight in (line.split(",") for line in lines)}

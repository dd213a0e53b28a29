"""Molecules as rigid bodies of point masses."""

from __future__ import annotations

import functools
import re
from collections.abc import Sequence
from importlib.resources import files

import numpy as np

from polhode._base import check
from polhode.bodies import _points as points
from polhode.bodies._digits import judge_moments, last_digit, unsure_moments
from polhode.bodies._inertia import MassProperties, principal_axes
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real

ATOMIC_MASS_UNIT = 1.66053906892e-27  # kg, CODATA 2022
ANGSTROM = 1e-10  # m
HYDROGENS = {"D": 2.01410177812, "T": 3.0160492779}  # u, of isotopes with symbols of their own: NIST, as below


def mass_properties(
    symbols: Sequence[str], positions: Real[ArrayLike, "n 3"], masses: Real[ArrayLike, "n"] | None = None
) -> MassProperties:
    """Return mass, centre and inertia of a molecule; see ``Body.from_atoms``, which documents the arguments."""
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
    properties = points.mass_properties(atomic_masses(symbols) if masses is None else masses, positions)
    return _round_to_digits(properties, positions)


def _round_to_digits(properties: MassProperties, positions: Array) -> MassProperties:
    """Return moments that are equal or zero where the digits of the positions do not distinguish them."""
    moments, axes = principal_axes(properties.inertia)
    rounded, _ = judge_moments(moments, unsure_moments(moments, properties.mass, last_digit(positions, ANGSTROM)))
    if (rounded == moments).all():
        return properties
    return properties._replace(inertia=axes @ np.diag(rounded) @ axes.T)


def atomic_masses(symbols: Sequence[str]) -> Float64[Array, "n"]:
    """Return standard atomic weights [kg] of chemical symbols; the mass number for elements without one.

    Raises:
        InvalidInput: for a word that is no chemical element.

    Source: Meija et al., Pure Appl. Chem. 88 (2016) 265, as in ASE's tables.
    """
    return _look_up(symbols, _atomic_weights())


def isotopic_masses(symbols: Sequence[str]) -> Float64[Array, "n"]:
    """Return the masses [kg] of the most common isotopes of chemical symbols, which a spectrum mostly shows.

    Raises:
        InvalidInput: for a word that is no chemical element.

    Source: Coursey et al., *Atomic Weights and Isotopic Compositions* 4.1 (NIST, 2015), as in ASE's tables.
    """
    return _look_up(symbols, _isotope_masses())


def _look_up(symbols: Sequence[str], table: dict[str, float]) -> Float64[Array, "n"]:
    unknown = [symbol for symbol in symbols if symbol not in table]
    if unknown:
        check.refuse("symbols", "chemical elements", unknown[0],
                     f"{explain_symbol(str(unknown[0]))}Any names will do where you give `masses`.")
    return np.array([table[symbol] for symbol in symbols]) * ATOMIC_MASS_UNIT


def is_element(symbol: str) -> bool:
    """Return whether a word is a chemical symbol."""
    return symbol in _atomic_weights()


def explain_symbol(word: str) -> str:
    """Return a guess at the meaning of a word that is no chemical symbol, with the remedy; empty without a guess.

    >>> explain_symbol("8")
    '8 is the atomic number of O: write the symbol. '
    >>> explain_symbol("C12")
    'Write C for an atom with a label, or C with its mass for an isotope. '
    >>> explain_symbol("HW1")
    'Write H for an atom with a label, or H with its mass for an isotope. '
    """
    name = word.strip("'\"").capitalize()
    symbols = list(_atomic_weights())
    if (isotope := name.rstrip("0123456789")) in HYDROGENS:
        return f"{isotope} is hydrogen of {HYDROGENS[isotope]} u: write H, with this mass. "
    if name.isdecimal() and 1 <= int(name) <= len(symbols):
        return f"{name} is the atomic number of {symbols[int(name) - 1]}: write the symbol. "
    # the longest symbol that it may begin with; HW1, a hydrogen of water, begins with no longer one
    for pattern in (r"(\d*)[-_]?([A-Za-z]{1,2})[-_]?(\d*)[A-Za-z'*+-]*", r"(\d*)([A-Za-z])[A-Za-z]?\d+[A-Za-z'*+-]*"):
        match = re.fullmatch(pattern, word.strip("'\""))
        if match and is_element(element := match[2].capitalize()):
            if match[1]:
                return f"Write {element}, with its mass for an isotope. "
            return f"Write {element} for an atom with a label, or {element} with its mass for an isotope. "
    return ""


@functools.cache
def _atomic_weights() -> dict[str, float]:
    return _table("atomic_weights.csv")


@functools.cache
def _isotope_masses() -> dict[str, float]:
    return _table("isotope_masses.csv")


def _table(name: str) -> dict[str, float]:
    lines = files("polhode.bodies").joinpath(name).read_text("ascii").splitlines()[1:]
    return {symbol: float(mass) for symbol, mass in (line.split(",") for line in lines)}

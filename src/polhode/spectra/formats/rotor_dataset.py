"""Levels and lines of molecules as labelled arrays with units, and as NetCDF files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode._base.extras import needing
from polhode.errors import InvalidInput
from polhode.formats.dataset import write_variables
from polhode.spectra import Levels, Lines, Rotor

if TYPE_CHECKING:
    import xarray

Named = dict[str, Any]
NUMBERS = ["J", "Ka", "Kc"]
OF_LEVELS = {
    "J": ("1", "angular momentum quantum number"),
    "Ka": ("1", "quantum number K_a of the prolate limit"),
    "Kc": ("1", "quantum number K_c of the oblate limit"),
    "energy": ("Hz", "energy over Planck's constant"),
    "weight": ("1", "statistical weight of nuclear spins, without 2J + 1"),
}
OF_LINES = {
    "frequency": ("Hz", "frequency of the line"),
    "strength": ("C2 m2", "line strength, the sum over directions of dipole matrix elements squared"),
    "lower_energy": ("Hz", "energy of the lower level over Planck's constant"),
    "weight": ("1", "statistical weight of nuclear spins, without 2J + 1"),
    "intensity": ("m2 Hz", "integrated absorption cross section"),
    "einstein": ("s-1", "Einstein coefficient of spontaneous emission"),
}


def spectrum_dataset(
    levels: Levels | None = None, lines: Lines | None = None, attributes: dict[str, Any] | None = None
) -> xarray.Dataset:
    """Return levels, lines or both as an xarray Dataset, whose variables carry units.

    Levels have the dimension ``level``; lines have ``line``, and ``quantum_number`` (J, Ka, Kc) of their two levels.
    Variables of lines begin with ``line_``.

    Args:
        levels: of ``Rotor.levels``.
        lines: of ``Rotor.lines``.
        attributes: global attributes to add, such as the temperature.

    Raises:
        InvalidInput: without both.

    >>> import polhode as ph
    >>> dataset = spectrum_dataset(ph.spectra.Rotor((27e9, 14e9, 9e9)).levels(1))
    >>> dataset.energy.units, dataset.energy.values.tolist()
    ('Hz', [0.0, 23000000000.0, 36000000000.0, 41000000000.0])
    """
    with needing("Datasets need"):
        import xarray as xr

    return xr.Dataset(*_describe(levels, lines, attributes))


def write_spectrum(
    path: str | Path, levels: Levels | None = None, lines: Lines | None = None,
    attributes: dict[str, Any] | None = None,
) -> Path:
    """Write levels, lines or both as NetCDF, as ``spectrum_dataset`` has them; the file appears whole or not at all.

    Args:
        path: the file.
        levels: of ``Rotor.levels``.
        lines: of ``Rotor.lines``.
        attributes: global attributes to add, such as the temperature.

    Raises:
        InvalidInput: without both, or if the file cannot be written there.
    """
    return write_variables(path, *_describe(levels, lines, attributes))


def _describe(
    levels: Levels | None, lines: Lines | None, attributes: dict[str, Any] | None
) -> tuple[Named, Named, Named]:
    """Return variables and coordinates, each (dimensions, values, attributes), and global attributes."""
    if levels is None and lines is None:
        raise InvalidInput("a dataset of a spectrum needs `levels` or `lines`; got neither. Give one.")
    variables: Named = {}
    coordinates: Named = {}
    if levels is not None:
        for name, (unit, meaning) in OF_LEVELS.items():
            variables[name] = ("level", np.asarray(getattr(levels, name)), {"units": unit, "long_name": meaning})
        note = {"long_name": "species of the group D2 of half turns"}
        variables["symmetry"] = ("level", np.array(levels.symmetry, dtype=str), note)
    if lines is not None:
        coordinates["quantum_number"] = ("quantum_number", NUMBERS, {})
        for name in ("upper", "lower"):
            note = {"units": "1", "long_name": f"quantum numbers of the {name} level"}
            variables[f"line_{name}"] = (("line", "quantum_number"), np.asarray(getattr(lines, name)), note)
        for name, (unit, meaning) in OF_LINES.items():
            note = {"units": unit, "long_name": meaning}
            variables[f"line_{name}"] = ("line", np.asarray(getattr(lines, name)), note)
    return variables, coordinates, {"Conventions": "CF-1.11", "source": "polhode", **(attributes or {})}


def rotor_attributes(rotor: Rotor, name: str, temperature: float | None = None) -> dict[str, Any]:
    """Return a molecule's attributes for a dataset: constants and dipole in SI units, and the form of distortion.

    >>> import polhode as ph
    >>> rotor_attributes(ph.spectra.Rotor((27e9, 14e9, 9e9)), "molecule")["title"]
    'molecule'
    """
    attributes: dict[str, Any] = {"title": name, "rotational_constants_hertz": np.array(rotor.constants)}
    if rotor.dipole.any():
        attributes["dipole_coulomb_metre"] = rotor.dipole
    if temperature is not None:
        attributes["temperature_kelvin"] = temperature
    if rotor.reduction is not None and rotor.representation is not None:
        attributes |= {"reduction": rotor.reduction.value, "representation": rotor.representation.name}
        attributes |= {f"distortion_{name}_hertz": value for name, value in rotor.distortion.items()}
    return attributes

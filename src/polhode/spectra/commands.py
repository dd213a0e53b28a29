"""The commands ``levels`` and ``lines``."""

from __future__ import annotations

from polhode.cli.commands.application import AsJson
from polhode.spectra import options as spectrum


def levels(
    file: spectrum.MoleculeFile, json: AsJson = False, j_max: spectrum.LargestJ = None,
    out: spectrum.SpectrumFile = None,
) -> None:
    """Print a molecule's rotational levels."""
    from polhode.spectra.command import run_levels

    run_levels(file, j_max, json, out)


def lines(
    file: spectrum.MoleculeFile, json: AsJson = False, j_max: spectrum.LargestJ = None,
    temperature: spectrum.Temperature = None, lowest: spectrum.Lowest = None, highest: spectrum.Highest = None,
    min_intensity: spectrum.SmallestIntensity = None, most: spectrum.Strongest = 50, dipole: spectrum.Dipole = None,
    out: spectrum.SpectrumFile = None,
) -> None:
    """Print a molecule's rotational lines by frequency, with intensities."""
    from polhode.spectra.command import LineOptions, run_lines

    run_lines(file, LineOptions(j_max, temperature, lowest, highest, min_intensity, most, dipole), json, out)

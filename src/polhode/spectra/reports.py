"""Levels and lines of molecules in words: labels, frequencies, tables."""

from __future__ import annotations

import math

import numpy as np

from polhode.reports.answer import Table
from polhode.spectra._strengths import Lines
from polhode.spectra.rotor import Levels

WAVE_NUMBER = 29979245800.0  # Hz of 1 cm⁻¹
AREA = 1e-12  # m² Hz of 1 nm² MHz
PREFIXES = ((1e12, "THz"), (1e9, "GHz"), (1e6, "MHz"), (1e3, "kHz"))


def label(J: int, Ka: int, Kc: int) -> str:
    """Return a level's name.

    >>> label(3, 1, 2), label(12, 10, 3)
    ('3_1,2', '12_10,3')
    """
    return f"{J}_{Ka},{Kc}"


def frequency(value: float, digits: int = 9) -> str:
    """Return a frequency [Hz] in words, in a fitting unit; the frequencies of spectra in MHz.

    >>> frequency(835840.288e6), frequency(3.2e3), frequency(0.0)
    ('835.840288 GHz', '3.2 kHz', '0 Hz')
    """
    unit, name = next(((unit, name) for unit, name in PREFIXES if abs(value) >= unit), (1.0, "Hz"))
    return f"{value / unit:.{digits}g} {name}"


def wave_number(value: float, digits: int = 8) -> str:
    """Return E/h [Hz] as a wave number.

    >>> wave_number(29979245800.0)
    '1 cm⁻¹'
    """
    return f"{value / WAVE_NUMBER:.{digits}g} cm⁻¹"


def level_table(levels: Levels, last_j: int, shown_j: int) -> Table:
    """Return levels by J, then energy.

    Args:
        levels: some.
        last_j: the largest J of the table.
        shown_j: of its text.
    """
    arrays = (levels.J, levels.Ka, levels.Kc, levels.energy, levels.weight)
    columns = zip(*(array.tolist() for array in arrays), levels.symmetry, strict=True)
    rows = [
        {"J": J, "Ka": Ka, "Kc": Kc, "energy": energy, "wave_number": 100.0 * energy / WAVE_NUMBER,
         "symmetry": symmetry, "weight": weight}
        for J, Ka, Kc, energy, weight, symmetry in columns if J <= last_j
    ]
    more = f", J up to {shown_j}" if shown_j < last_j else ""
    return Table("levels", f"Levels{more}", {
        "level": lambda row: label(row["J"], row["Ka"], row["Kc"]),
        "cm⁻¹": lambda row: f"{row['wave_number'] / 100.0:.6f}",
        "MHz": lambda row: f"{row['energy'] / 1e6:.4f}",
        "species": lambda row: row["symmetry"],
        "g_ns": lambda row: f"{row['weight']:g}",
    }, rows, {"energy": "Hz, E/h", "wave_number": "1/m, E/hc",
              "symmetry": "species of the group of half turns about a, b, c",
              "weight": "of nuclear spins, without 2J + 1"}, shown=lambda row: row["J"] <= shown_j)


def line_table(lines: Lines, title: str) -> Table:
    """Return absorption lines, as they come; intensities are integrated cross sections."""
    rows = []
    columns = zip(*(array.tolist() for array in lines), strict=True)
    for upper, lower, nu, strength, energy, weight, intensity, einstein in columns:
        size = intensity / AREA
        rows.append({
            "upper": upper, "lower": lower, "frequency": nu, "wave_number": 100.0 * nu / WAVE_NUMBER,
            "intensity": intensity, "lg_intensity": math.log10(size) if size > 0.0 else -math.inf,
            "lower_energy": energy, "strength": strength, "weight": weight, "einstein": einstein,
        })
    return Table("lines", title, {
        "line": lambda row: f"{label(*row['upper'])} – {label(*row['lower'])}",
        "MHz": lambda row: f"{row['frequency'] / 1e6:.4f}",
        "cm⁻¹": lambda row: f"{row['wave_number'] / 100.0:.5f}",
        "lg I": lambda row: f"{row['lg_intensity']:.4f}" if np.isfinite(row["lg_intensity"]) else "–",
        "E″ cm⁻¹": lambda row: f"{row['lower_energy'] / WAVE_NUMBER:.4f}",
        "A": lambda row: f"{row['einstein']:.4g} /s",
        "g_ns": lambda row: f"{row['weight']:g}",
    }, rows, {
        "upper": "J, K_a, K_c", "lower": "J, K_a, K_c", "frequency": "Hz", "wave_number": "1/m",
        "intensity": "m² Hz, integrated cross section", "lg_intensity": "of the intensity in nm² MHz, as in catalogues",
        "lower_energy": "Hz, E/h", "strength": "C² m², line strength times dipole squared, without nuclear spins",
        "weight": "of nuclear spins, without 2J + 1", "einstein": "1/s, of spontaneous emission",
    })

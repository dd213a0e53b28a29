"""``polhode levels FILE`` and ``polhode lines FILE``: the spectrum of a molecule."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from polhode.cli.destinations import check_spares
from polhode.cli.publish import publish
from polhode.errors import InvalidInput, shown
from polhode.spectra.study import levels, spectrum_within


class LineOptions(NamedTuple):
    """Options of ``polhode lines``, as they are given; see there."""

    j_max: int | None
    temperature: str | None
    lowest: str | None
    highest: str | None
    min_intensity: float | None
    most: int
    dipole: str | None


def run_levels(path: Path, j_max: int | None, json: bool, out: Path | None = None) -> None:
    """Print the levels of a molecule."""
    if out is not None:
        check_spares(out, path)
    publish(levels(path, j_max=j_max), json, out)


def run_lines(path: Path, options: LineOptions, json: bool, out: Path | None = None) -> None:
    """Print the strongest lines of a molecule within bounds, by frequency."""
    if out is not None:
        check_spares(out, path)
    dipole = None if options.dipole is None else _dipole(options.dipole)
    bounds = {"lowest": options.lowest, "highest": options.highest}
    weakest = 0.0 if options.min_intensity is None else options.min_intensity
    report = spectrum_within(path, options.j_max, options.temperature, bounds, weakest, options.most, dipole)
    publish(report, json, out)


def _dipole(text: str) -> list[float]:
    """Return three numbers of a text with commas between."""
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        values = []
    if len(values) != 3:
        why = f"must be three numbers in debye with commas, like 0,1.857,0; got {shown(text)}"
        raise InvalidInput(f"--dipole {why}.")
    return values

"""A molecule's constants from measured lines, and the report on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.kinds.reading import read_spec_or_molecule
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain
from polhode.spectra._derivatives import AXES, get_constant, once_each
from polhode.spectra._measured import MeasuredLines
from polhode.spectra.fitting import RotorFit, fit_rotor
from polhode.spectra.formats.spfit import read_lin
from polhode.spectra.reports import label
from polhode.spectra.rotor import Rotor
from polhode.spectra.spec_rotors import rotor_of_spec
from polhode.studies.naming import warnings_as_notes

MEGA = 1e6  # Hz


class LineFitLimits(NamedTuple):
    """What decides which remarks are made.

    Attributes:
        close_correlation: of two constants that are reported as hardly separated.
    """

    close_correlation: float = 0.95


LIMITS = LineFitLimits()
NOT_NOISE = "residuals are not noise: no constant has a known error"


@dataclass(frozen=True)
class LineFitReport(StudyReport):
    """The report on a molecule's constants from measured lines.

    Attributes:
        name: of the molecule.
        start: the rotor that the fit started from.
        measured: the lines.
        fit: the numbers.
        asked: names of the constants to fit; None for all that change a line.
        warned: warnings of the readers and the fit.
    """

    kind: ClassVar[str] = "line-fit"
    data_file: ClassVar[str] = "fit.par"
    data_endings: ClassVar[tuple[str, ...]] = ".par", ".var"
    name: str
    start: Rotor
    measured: MeasuredLines
    fit: RotorFit
    asked: Sequence[str] | None
    warned: Sequence[str]

    @property
    def determined(self) -> bool:
        return self.fit.determined

    @property
    def summary(self) -> str:
        fit = self.fit
        if not self.determined:
            return (f"The lines are not those of this molecule within their errors: residuals are {fit.rms:.3g} times "
                    "as large. Labels, errors or missing constants are wrong. The constants of the best fit have no "
                    "known errors.")
        return (f"{len(fit.names)} constants from {len(fit.residual)} observations, which they meet to {fit.rms:.3g} "
                "of their errors.")

    @property
    def answers(self) -> list[Group | Table]:
        fit, measured = self.fit, self.measured
        return [_quality(fit, measured), _constants(fit, self.start), _worst(fit, measured)]

    @property
    def notes(self) -> list[str]:
        start, fit, asked = self.start, self.fit, self.asked
        notes = [*self.warned, *_together(start, fit, asked), *_list_fixed(start, fit, asked), *_remarks(fit)]
        if self.determined and not fit.noise.is_noise:
            notes.append(f"residuals are {fit.rms:.2g} times the lines' errors, more than chance leaves. Errors of the "
                         f"constants are enlarged by {fit.enlarged:.2g}, which is right if those of the lines are too "
                         "small alike, and not if a label or the model is wrong.")
        return notes

    def _write_data(self, path: Path) -> Path:
        """Write the constants as a ``.par`` file, or with their correlations as ``.var``.

        Where residuals are not noise, the title says so, no correlations are written, and errors are those of SPFIT's
        free constants.
        """
        from polhode.spectra.formats.spfit_constants import constant_table, write_par

        fit = self.fit
        sigma = dict(zip(fit.names, fit.sigma.tolist(), strict=True))
        title, correlation = (self.name, fit.correlation) if self.determined else (f"{NOT_NOISE}; {self.name}", None)
        write_par(constant_table(fit.rotor, sigma, title, correlation), path)
        return path


def fit_lines(path: Path, lines: Path, free: Sequence[str] | None = None) -> LineFitReport:
    """Return the report on a molecule's constants.

    Args:
        path: of a spec or of atoms, whose constants the fit starts from.
        lines: file of measured lines, .lin.
        free: names of the constants to fit; None for those of the spec that lines depend on.

    Raises:
        InvalidInput: with the file's name, for one that cannot be read or fitted.
        NotConverged: where the fit does not converge.
    """
    with warnings_as_notes(path) as notes:
        spec = read_spec_or_molecule(path)
        start = rotor_of_spec(spec).rotor
    with warnings_as_notes(lines) as more:
        measured = read_lin(lines).measured()
    with warnings_as_notes(path) as others:
        names = None if free is None else [name.strip() for name in free]
        if names is not None and not all(names):
            got = shown(",".join(names))
            raise InvalidInput(f"`free` must be names of constants, like A,B,C,D_J; got {got}.")
        fit = fit_rotor(start, measured, names)
    return LineFitReport(spec.name, start, measured, fit, names, [*notes, *more, *others])


def _together(start: Rotor, fit: RotorFit, asked: Sequence[str] | None) -> list[str]:
    """Return which equal constants were fitted as one."""
    first = next((name for name in fit.names if name in start.equal), None)
    others = [name for name in start.equal if name != first and (asked is None or name in asked)]
    if first is None or not others:
        return []
    both = f"{first} and {' and '.join(others)}"
    return [f"{both} are equal at the start and fitted as one, {first}; to fit each, start from values that differ."]


def _list_fixed(start: Rotor, fit: RotorFit, asked: Sequence[str] | None) -> list[str]:
    """Return a note on constants that were kept as given, as no line depends on them."""
    if asked is not None:
        return []
    left = [name for name in once_each(start, [*AXES, *start.distortion]) if name not in fit.names]
    if not left:
        return []
    kept, them = ("is", "it") if len(left) == 1 else ("are", "them")
    return [f"{', '.join(left)} {kept} kept as the spec says: no line changes with {them}."]


def _quality(fit: RotorFit, measured: MeasuredLines) -> Group:
    count = len(fit.residual)
    freedom = count - len(fit.names)
    rms = float(np.sqrt(np.mean(fit.residual**2)))
    return Group("Fit", [
        Answer("lines", len(measured.frequency), "", "lines"),
        Answer("observations", count, "", "observations", "blends are one each"),
        Answer("degrees_of_freedom", freedom, "", "degrees of freedom"),
        Answer("rms", fit.rms, "", "residuals, of their errors", "root mean square", f"{fit.rms:.6g}"),
        Answer("correlation", fit.correlation if fit.determined else None),
        Answer("rms_frequency", rms, "Hz", "residuals", "root mean square", f"{rms / MEGA:.6g} MHz"),
    ])


def _constants(fit: RotorFit, start: Rotor) -> Table:
    determined = fit.determined
    columns = zip(fit.names, fit.values.tolist(), fit.sigma.tolist(), strict=True)
    rows = [{"constant": name, "value": value, "standard_error": sigma if determined else None,
             "start": get_constant(start, name)} for name, value, sigma in columns]
    return Table("constants", "Constants", {
        "constant": lambda row: row["constant"],
        "MHz": lambda row: (uncertain(row["value"] / MEGA, row["standard_error"] / MEGA, digits=2) if determined
                            else f"{row['value'] / MEGA:.6g}, error not known"),
        "change": lambda row: f"{(row['value'] - row['start']) / MEGA:+.4g} MHz",
    }, rows, {"value": "Hz", "standard_error": "Hz", "start": "Hz"}, key="constant")


def _worst(fit: RotorFit, measured: MeasuredLines) -> Table:
    first = [int(np.flatnonzero(fit.observation == k)[0]) for k in range(len(fit.residual))]
    rows: list[dict[str, Any]] = []
    listed = 8
    for k in fit.worst(listed).tolist():
        line = first[k]
        rows.append({
            "upper": measured.upper[line].tolist(), "lower": measured.lower[line].tolist(),
            "frequency": float(measured.frequency[line]), "residual": float(fit.residual[k]),
            "standardized": float(fit.standardized[k]), "leverage": float(fit.leverage[k]),
        })
    return Table("worst", "Observations that fit worst", {
        "line": lambda row: f"{label(*row['upper'])} – {label(*row['lower'])}",
        "MHz": lambda row: f"{row['frequency'] / MEGA:.4f}",
        "observed − calculated": lambda row: f"{row['residual'] / MEGA:+.4f} MHz",
        "of its spread": lambda row: f"{row['standardized']:+.2f}" if np.isfinite(row["standardized"]) else "–",
        "leverage": lambda row: f"{row['leverage']:.3f}",
    }, rows, {"upper": "J, K_a, K_c", "lower": "J, K_a, K_c", "frequency": "Hz", "residual": "Hz"})


def _remarks(fit: RotorFit) -> list[str]:
    """Return notes on strongly correlated constants, and on lines that alone determine a constant."""
    notes = []
    pairs = np.argwhere(np.triu(np.abs(fit.correlation), 1) > LIMITS.close_correlation)
    if len(pairs):
        one, other = pairs[np.argmax([abs(fit.correlation[i, j]) for i, j in pairs])].tolist()
        more = f", and of {len(pairs) - 1} other pairs" if len(pairs) > 1 else ""
        size = fit.correlation[one, other]
        notes.append(f"errors of {fit.names[one]} and {fit.names[other]} go together, correlation {size:.3f}{more}.")
    alone = int((fit.leverage > 1.0 - 1e-6).sum())
    if alone:
        notes.append(f"{alone} observations determine something alone: their residuals are zero whatever was measured.")
    return notes

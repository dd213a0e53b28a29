"""The branch of ``polhode.fit`` for molecules: a spec or a file of atoms, and measured lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from polhode.errors import InvalidInput
from polhode.studies.fit_request import FitBranch, FitRequest
from polhode.studies.naming import name_arguments

if TYPE_CHECKING:
    from polhode.spectra.line_fit import LineFitReport

LINES = ".lin"
STARTS = (".toml", ".xyz", ".extxyz", ".pdb", ".mol", ".sdf")
"""Files that a fit to measured lines can start from; none of them is a log."""


def _knows(request: FitRequest) -> bool:
    first, last = (file.suffix.lower() for file in (request.files[0], request.files[-1]))
    return not request.pendulum and (first in STARTS or last == LINES)


def _fit(request: FitRequest) -> LineFitReport:
    files = request.files
    if len(files) != 2:
        raise InvalidInput(f"{files[0]}: a molecule is fitted to one file of lines; got {len(files) - 1}. Write "
                           f"polhode fit SPEC LINES{LINES}; for a pendulum's periods give "
                           f"`pendulum`.")
    if wrong := request.options.with_columns:
        raise InvalidInput(f"{name_arguments(wrong)} is for gyro logs, and {files[0]} is a molecule. Leave it out.")
    from polhode.spectra.line_fit import fit_lines

    return fit_lines(files[0], files[1], request.free)


FIT = FitBranch(_knows, _fit)

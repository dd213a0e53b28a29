"""``polhode fit FILE…``: a molecule's constants from measured lines, or the inertia of a thrown body from gyro logs."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import typer

from polhode.cli.columns import ColumnOptions
from polhode.cli.fit_scale import ScaleOptions, scale_of
from polhode.cli.fit_throw import ThrowOptions, named, run_fit_throw
from polhode.errors import InvalidInput

NOT_TOLD = 3  # exit code, where a report says that the logs do not tell the inertia
LINES = ".lin"
STARTS = (".toml", ".xyz", ".extxyz", ".pdb", ".mol", ".sdf")
"""Files that a fit to measured lines can start from; none of them is a log."""


class FitFiles(NamedTuple):
    """What a fit reads and writes."""

    files: list[Path]
    free: str | None
    out: Path | None
    json: bool


def run_fit(given: FitFiles, throw: ThrowOptions, scale: ScaleOptions, columns: ColumnOptions) -> None:
    """Fit what the files are of: a molecule where the first is a spec or atoms, a thrown body otherwise.

    Raises:
        typer.Exit: with code 3 where the report says that the inertia is not determined.
    """
    files = given.files
    if files[0].suffix.lower() in STARTS or files[-1].suffix.lower() == LINES:
        if len(files) != 2:
            raise InvalidInput(f"{files[0]}: a molecule is fitted to one file of lines; got {len(files) - 1}. Write "
                               f"polhode fit SPEC LINES{LINES}.")  # fmt: skip
        if wrong := [*named(throw), *named(scale), *(f"--{name.replace('_', '-')}" for name in columns.words)]:
            raise InvalidInput(f"{', '.join(wrong)} is for gyro logs, and {files[0]} is a molecule. Leave it out.")
        from polhode.cli.fit_rotor import run_fit_rotor

        run_fit_rotor(files[0], files[1], given.free, given.out, given.json)
        return
    if given.free is not None:
        raise InvalidInput("--free names constants of a molecule, and gyro logs are given. Leave it out.")
    if not run_fit_throw(files, throw, scale_of(scale), scale.weighted, columns, given.out, given.json):
        raise typer.Exit(NOT_TOLD)

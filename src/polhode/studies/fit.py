"""``polhode.fit``: the inertia of a body from logs, or a molecule's constants from measured lines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from polhode.errors import InvalidInput, shown
from polhode.formats.paths import as_path
from polhode.reports.report import with_inputs
from polhode.studies.naming import name_arguments
from polhode.studies.tables import take_columns
from polhode.studies.throws import Progress, ThrowOptions, fit_logs

if TYPE_CHECKING:
    from polhode.studies.attitude_report import AttitudeReport
    from polhode.studies.line_fit import LineFitReport
    from polhode.studies.pendulum_report import PendulumReport
    from polhode.studies.throw_report import ThrowReport

LINES = ".lin"
STARTS = (".toml", ".xyz", ".extxyz", ".pdb", ".mol", ".sdf")
"""Files that a fit to measured lines can start from; none of them is a log."""


def fit(
    *files: Path | str, free: Sequence[str] | None = None, windows: Sequence[tuple[float, float]] = (),
    drag: bool | None = None, torque: bool | None = None, rotor: bool | None = None, gain: bool | None = None,
    clip: str | float | None = None, moment: str | None = None, mass: str | None = None,
    added_weight: str | None = None, weighted: Sequence[Path | str] = (), columns: Mapping[str, Any] | None = None,
    pendulum: bool = False,
) -> ThrowReport | AttitudeReport | LineFitReport | PendulumReport:  # fmt: skip
    """Fit the model that the files determine, and return the report.

    Gyro logs of throws of one body, and a log of its attitude, tell its ratios of inertia; a spec or a file of atoms
    with measured lines (.lin) the constants of a molecule; a file of a pendulum's periods the moments of a body.

    Args:
        files: gyro logs; or one log of attitudes; or a spec or atoms, and lines.
        free: of a molecule, the constants that are fitted, like ("A", "B", "D_J"); those that lines depend on if left
            out.
        windows: of logs, (start, end) of free flights [s] in place of those that are found.
        drag, rotor: of gyro logs, whether there is drag, and a wheel in the body; None to decide by a criterion.
        torque: of attitudes, whether there is a constant torque in the body; None to decide by a criterion.
        gain: of gyro logs, whether gains of the axes are fitted; they are unless this is False.
        clip: the gyro's limit [rad/s], or a text like "2000 deg/s".
        moment: one that is known, like "I3 = 1.2e-4 kg m^2".
        mass, added_weight, weighted: the body's mass, like "150 g"; a weight on it, like "20 g at 0, 70, 0 mm"; and
            logs of throws with it.
        columns: of a table of another program, words of a mapping by name, like {"time": "t", "gyro": "gx,gy,gz"}.
        pendulum: whether the file has periods of a pendulum on which the body hung.

    Raises:
        InvalidInput: for files that cannot be read or fitted, and for arguments that are not for them.
        NotConverged: where a fit finds no end.

    >>> import polhode as ph
    >>> report = ph.fit("examples/phone_throw.csv")  # doctest: +SKIP
    >>> report.summary  # doctest: +SKIP
    """
    texts = {"moment": moment, "mass": mass, "added_weight": added_weight}
    if wrong := [name for name, text in texts.items() if text is not None and not isinstance(text, str)]:
        raise InvalidInput(f"`{wrong[0]}` must be a text like \"150 g\"; got {shown(texts[wrong[0]])}.")
    switches = {"drag": drag, "torque": torque, "rotor": rotor, "gain": gain}
    if wrong := [name for name, value in switches.items() if value not in (None, True, False)]:
        raise InvalidInput(f"`{wrong[0]}` must be True, False or None; got {shown(switches[wrong[0]])}.")
    lists = {"windows": windows, "weighted": weighted, **({} if free is None else {"free": free})}
    if wrong := [name for name, some in lists.items() if isinstance(some, str) or not isinstance(some, Sequence)]:
        raise InvalidInput(f"`{wrong[0]}` must be a list; got {shown(lists[wrong[0]])}.")
    table = take_columns(columns, True)
    options = ThrowOptions(windows, drag, torque, rotor, gain, clip, moment, mass, added_weight,
                           [as_path("weighted", path) for path in weighted], table)  # fmt: skip
    paths = [as_path("files", path) for path in files]
    return with_inputs(lambda: fit_files(paths, free, options, pendulum=pendulum))


def fit_files(
    files: Sequence[Path], free: Sequence[str] | None, options: ThrowOptions, progress: Progress | None = None,
    pendulum: bool = False,
) -> ThrowReport | AttitudeReport | LineFitReport | PendulumReport:  # fmt: skip
    """Return the report of ``fit``."""
    if not files:
        raise InvalidInput("`files` is empty. Name a log, or a spec and its measured lines.")
    if pendulum:
        wrong = [*options.given, *(["free"] if free is not None else [])]
        wrong += ["columns"] if options.table is not None or options.unit is not None else []
        if wrong or len(files) > 1:
            what = f"{name_arguments(wrong)} cannot go with it" if wrong else f"got {len(files)} files"
            raise InvalidInput(f"`pendulum` takes one file of periods alone; {what}. Leave out the rest.")
        from polhode.studies.pendulum import fit_periods

        return fit_periods(files[0])
    if files[0].suffix.lower() in STARTS or files[-1].suffix.lower() == LINES:
        if len(files) != 2:
            raise InvalidInput(f"{files[0]}: a molecule is fitted to one file of lines; got {len(files) - 1}. Write "
                               f"polhode fit SPEC LINES{LINES}; for a pendulum's periods give "
                               f"`pendulum`.")  # fmt: skip
        wrong = options.given + (["columns"] if options.table is not None or options.unit is not None else [])
        if wrong:
            raise InvalidInput(f"{name_arguments(wrong)} is for gyro logs, and {files[0]} is a molecule. Leave it out.")
        from polhode.studies.line_fit import fit_lines

        return fit_lines(files[0], files[1], free)
    if free is not None:
        raise InvalidInput("`free` names constants of a molecule, and gyro logs are given. Leave it out.")
    return fit_logs(files, options, progress)

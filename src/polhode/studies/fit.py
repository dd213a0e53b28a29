"""``polhode.fit``: the inertia of a body from logs, or a molecule's constants from measured lines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from polhode._base.extras import needing
from polhode.errors import InvalidInput, shown
from polhode.formats.paths import as_path
from polhode.reports.report import with_inputs
from polhode.studies.fit_request import FitOptions, FitRequest, Progress, fit_request
from polhode.studies.tables import take_columns

if TYPE_CHECKING:
    from polhode.measuring.attitudes.report import AttitudeReport
    from polhode.measuring.pendulum.report import PendulumReport
    from polhode.measuring.throws.report import ThrowReport
    from polhode.spectra.line_fit import LineFitReport


def fit(
    *files: Path | str, free: Sequence[str] | None = None, windows: Sequence[tuple[float, float]] = (),
    drag: bool | None = None, torque: bool | None = None, rotor: bool | None = None, gain: bool | None = None,
    clip: str | float | None = None, moment: str | None = None, mass: str | None = None,
    added_weight: str | None = None, weighted: Sequence[Path | str] = (), columns: Mapping[str, Any] | None = None,
    pendulum: bool = False,
) -> ThrowReport | AttitudeReport | LineFitReport | PendulumReport:
    """Fit the model that the files determine, and return the report.

    Gyro logs of throws of one body, and a log of its attitude, tell its ratios of inertia; a spec or a file of atoms
    with measured lines (.lin) the constants of a molecule; a file of a pendulum's periods the moments of a body.

    Args:
        files: gyro logs; or one log of attitudes; or a spec or atoms, and lines.
        free: of a molecule, the constants that are fitted, like ("A", "B", "D_J"); those that lines depend on if left
            out.
        windows: of logs, (start, end) of free flights [s] in place of the detected ones.
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
    options = FitOptions(windows, drag, torque, rotor, gain, clip, moment, mass, added_weight,
                         [as_path("weighted", path) for path in weighted], table)
    paths = [as_path("files", path) for path in files]
    return with_inputs(lambda: fit_files(paths, free, options, pendulum=pendulum))


def fit_files(
    files: Sequence[Path], free: Sequence[str] | None, options: FitOptions, progress: Progress | None = None,
    pendulum: bool = False,
) -> ThrowReport | AttitudeReport | LineFitReport | PendulumReport:
    """Return the report of ``fit``."""
    if not files:
        raise InvalidInput("`files` is empty. Name a log, or a spec and its measured lines.")
    # one of these, or that of another package
    with needing("Fits need"):  # branches import what fits their files
        report: Any = fit_request(FitRequest(files, free, options, progress, pendulum))
    return report

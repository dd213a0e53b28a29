"""The report on a body's inertia from the periods of a pendulum."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from polhode.estimation._estimate import Estimate
from polhode.measuring.answers import in_words, values
from polhode.measuring.pendulum.fitting import PendulumFit
from polhode.measuring.pendulum.swings import Measurements
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain, write_count


class NoteThresholds(NamedTuple):
    """Numbers that decide which notes a reader gets.

    Attributes:
        min_probability: of a misfit by errors alone; a less probable one is mentioned.
        max_errors: standard errors, by which moments may be unphysical without a word.
        max_tilt: rad, up to which axes are perpendicular.
    """

    min_probability: float = 0.01
    max_errors: float = 2.0
    max_tilt: float = 1e-6


LIMITS = NoteThresholds()


@dataclass(frozen=True)
class PendulumReport(StudyReport):
    """The report on moments of inertia from a pendulum.

    Attributes:
        measured: the content of the file.
        fit: the numbers.
    """

    kind: ClassVar[str] = "pendulum-fit"
    measured: Measurements
    fit: PendulumFit

    @property
    def name(self) -> str:
        return self.measured.name

    @property
    def probability(self) -> float | None:
        """Of a misfit as large as this by errors alone; None where nothing is left to check."""
        return self.fit.test.probability if self.fit.freedom else None

    @property
    def determined(self) -> bool:
        return self.fit.test.is_noise

    @property
    def summary(self) -> str:
        fit, count = self.fit, write_count(len(self.measured.swings), "swing")
        if not self.determined:
            best = in_words(fit.combined if fit.principal is None else fit.principal)
            what = "moment" if fit.principal is None else "principal moments"
            return (f"{count} do not fit one body within their errors: χ² is {fit.misfit:.3g}, where {fit.freedom} is "
                    f"expected. A length, an axis, a count of turns or an error is wrong. The best fit, {what} {best} "
                    "kg m², has no known error.")
        if fit.principal is not None:
            return f"{count}: the principal moments are {_words(fit.principal)} kg m²."
        said = ", ".join(f"{uncertain(value, error)} kg m² about {_axis(axis)}" for axis, value, error in self._each())
        return f"{count}: the moment of inertia is {said}."

    @property
    def answers(self) -> list[Group | Table]:
        return [self._moments(), self._tensor(), self._quality(), self._swings()]

    @property
    def notes(self) -> list[str]:
        fit, measured = self.fit, self.measured
        air = "the air that the body carries along, and its lift, are part of these moments; they matter if it is"
        notes = [f"{air} large and light."]
        if measured.exact:
            notes.append(f"given without errors and taken as exact: {', '.join(measured.exact)}.")
        if any(swing.amplitude == 0.0 for swing in measured.swings):
            notes.append("a swing without amplitude is taken as small; 10° make the period 0.19 % longer, and the "
                         "moment 0.38 % too large if they are not given.")
        if self.determined and self.probability is not None and self.probability < LIMITS.min_probability:
            notes.append(f"the swings do not fit one body within their errors: χ² is {fit.misfit:.3g}, where "
                         f"{fit.freedom} is expected. Look for a wrong length, axis or count of turns; the errors are "
                         "then too small.")
        if fit.unphysical > 0.0 and fit.principal is not None and self.determined:
            error = math.sqrt(float(np.array([-1.0, -1.0, 1.0]) @ fit.principal.covariance @ (-1.0, -1.0, 1.0)))
            far = "far more than" if fit.unphysical > LIMITS.max_errors * error else "within"
            notes.append(f"no body has this tensor: its largest moment exceeds the sum of the others by "
                         f"{fit.unphysical:.2g} kg m², {far} the error of {error:.2g}.")
        notes += self._three_axes()
        if fit.inertia is None and len(fit.axes) > 1:
            notes.append("a tensor needs six independent axes, like x, y, z, [1, 1, 0], [1, 0, 1], [0, 1, 1]; there "
                         f"are {len(fit.axes)}.")
        return notes

    def _three_axes(self) -> list[str]:
        """Return a note where the moments about three perpendicular axes are those of no body."""
        axes, combined = self.fit.axes, self.fit.combined
        if not self.determined or self.fit.inertia is not None or len(axes) != 3:
            return []
        if np.abs(axes @ axes.T - np.eye(3)).max() > LIMITS.max_tilt:
            return []
        k = int(np.argmax(combined.value))
        sign = np.where(np.arange(3) == k, 1.0, -1.0)
        excess, error = float(sign @ combined.value), math.sqrt(float(sign @ combined.covariance @ sign))
        if excess <= LIMITS.max_errors * error:
            return []
        rule = "about perpendicular axes none may exceed the sum of the others"
        return [f"no body has these moments: {rule}, and one does by {excess:.2g} ± {error:.1g} kg m²."]

    def _each(self) -> list[tuple[Any, float, float]]:
        one = self.fit.combined
        return list(zip(self.fit.axes, one.value.tolist(), one.standard_error.tolist(), strict=True))

    def _moments(self) -> Table:
        intervals = self.fit.combined.interval()
        known = self.determined
        rows = [{"axis": axis.tolist(), "moment": value, "standard_error": error if known else None,
                 "interval": ends.tolist() if known else None}
                for (axis, value, error), ends in zip(self._each(), intervals, strict=True)]
        unknown = float("nan")
        columns = {
            "axis": lambda row: _axis(row["axis"]),
            "moment": lambda row: f"{uncertain(row['moment'], row['standard_error'] or unknown, '', 2)} kg m²",
            "95 %": lambda row: "not known" if row["interval"] is None else "{:.6g} to {:.6g}".format(*row["interval"]),
        }
        units = {"moment": "kg m²", "standard_error": "kg m²", "interval": "kg m²", "axis": "given axes"}
        return Table("moments", "Moments of inertia about the centre of mass", columns, rows, units)

    def _tensor(self) -> Group:
        fit = self.fit
        inertia, principal, center = fit.inertia, fit.principal, fit.center
        axes = fit.principal_axes
        named = [Answer("", None, "", f"axis {k + 1}", "", None if axes is None else
                        ", ".join(f"{x:+.4f}" for x in axes[:, k])) for k in range(3)]
        return Group("Tensor and centre of mass", [
            Answer("inertia", None if inertia is None else values(inertia), "kg m²", "Jxx, Jyy, Jzz, Jxy, Jxz, Jyz",
                   "given axes", None if inertia is None else _words(inertia)),
            Answer("principal_moments", None if principal is None else values(principal), "kg m²", "I1, I2, I3", "",
                   None if principal is None else _words(principal)),
            *named,
            Answer("axes", None if axes is None else axes.tolist(), "", "", "principal axes by columns"),
            Answer("unphysical", fit.unphysical, "kg m²"),
            Answer("center", None if center is None else values(center), "m", "centre of mass", "on the pivots' scale",
                   None if center is None else f"{_words(center)} m on the pivots' scale"),
        ])

    def _quality(self) -> Group:
        fit, probability = self.fit, self.probability
        words = "nothing is left to check" if probability is None else (
            f"{fit.misfit:.4g}, {fit.freedom} expected; probability {probability:.2g}")
        return Group("Fit", [
            Answer("misfit", fit.misfit if fit.freedom else None, "", "misfit χ²", "", words),
            Answer("freedom", fit.freedom), Answer("probability", probability),
        ])

    def _swings(self) -> Table:
        fit, measured = self.fit, self.measured
        errors = fit.moments.standard_error
        rows = [{
            "pendulum": measured.kinds[k], "axis": list(swing.axis), "period": swing.period.value,
            "period_error": swing.period.error, "timings": measured.timings[k], "amplitude": swing.amplitude,
            "moment": float(fit.moments.value[k]), "standard_error": float(errors[k]),
        } for k, swing in enumerate(measured.swings)]
        columns = {
            "pendulum": lambda row: row["pendulum"],
            "axis": lambda row: _axis(row["axis"]),
            "period": lambda row: f"{uncertain(row['period'], row['period_error'], '', 2)} s",
            "timings": lambda row: str(row["timings"]),
            "amplitude": lambda row: f"{math.degrees(row['amplitude']):.4g}°",
            "moment": lambda row: f"{uncertain(row['moment'], row['standard_error'], '', 2)} kg m²",
        }
        units = {"period": "s", "period_error": "s", "amplitude": "rad", "moment": "kg m²", "standard_error": "kg m²"}
        return Table("swings", "Swings", columns, rows, units)


def _words(estimate: Estimate) -> str:
    return ", ".join(uncertain(value, error, "", 2)
                     for value, error in zip(estimate.value, estimate.standard_error, strict=True))


def _axis(axis: Any) -> str:
    """Return an axis in words.

    >>> _axis([0.0, 0.0, 1.0]), _axis([0.6, 0.0, 0.8])
    ('z', '(0.6, 0, 0.8)')
    """
    where = np.flatnonzero(axis)
    if len(where) == 1:
        return ("−" if axis[where[0]] < 0 else "") + "xyz"[where[0]]
    return "({})".format(", ".join(f"{x:.4g}" for x in axis))

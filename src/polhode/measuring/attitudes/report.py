"""The report on a fit of attitudes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from polhode.estimation._estimate import Estimate
from polhode.measuring.answers import (
    about_axes,
    about_inertia,
    about_misfit,
    about_moments,
    describe_turning,
    each,
    in_words,
    sentence,
    tell_misfit,
    values,
)
from polhode.measuring.attitudes.attitude_fit import AttitudeFit
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.report import StudyReport
from polhode.reports.wording import uncertain

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class AttitudeReport(StudyReport):
    """The report on a body's inertia from a log of its attitude.

    Attributes:
        name: of the log.
        fit: the numbers.
        moments: I1, I2, I3 [kg m²]; None where only their ratios are known.
    """

    kind: ClassVar[str] = "attitude-fit"
    data_file: ClassVar[str] = "fit.nc"
    data_endings: ClassVar[tuple[str, ...]] = (".nc",)
    name: str
    fit: AttitudeFit
    moments: Estimate | None

    @property
    def determined(self) -> bool:
        return self.fit.degenerate is None and self.fit.misfit is None

    @property
    def summary(self) -> str:
        fit = self.fit
        if fit.degenerate is not None or fit.ratios is None:
            return f"The inertia is not determined. {sentence(fit.degenerate or '')}"
        if fit.misfit is not None:
            return tell_misfit(fit, "rad")
        said = ", ".join(f"{name} = {uncertain(value, error)}" for name, value, error in each(fit.ratios))
        turning = describe_turning(fit.motion, fit.times, fit.equal)
        return f"{said}; {turning}, residuals {fit.rms:.2g} rad rms."

    @property
    def answers(self) -> list[Group | Table]:
        fit = self.fit
        span = [float(fit.times[0]), float(fit.times[-1])]
        noise = (fit.sigma, fit.rate_sigma) if fit.misfit is None else (None, None)
        return [about_inertia(fit), *about_moments(self.moments), about_axes(fit), self._torque(), Group("Fit", [
            Answer("rms", fit.rms, "rad", "residuals", "root mean square", f"{fit.rms:.3g} rad rms"),
            Answer("sigma", noise[0], "rad", "noise of an attitude", "about each axis; null where it is not noise",
                   None if noise[0] is None else f"{noise[0]:.3g} rad"),
            Answer("rate_sigma", noise[1], "rad/s", "noise of a rate", "along each axis",
                   None if noise[1] is None else f"{noise[1]:.3g} rad/s"),
            Answer("bias", None if fit.bias is None else values(fit.bias), "rad/s", "bias of the rates",
                   "along the device's x, y, z; null where no rates were given",
                   None if fit.bias is None else f"{in_words(fit.bias)} rad/s"),
            about_misfit(fit.misfit),
            Answer("samples", len(fit.times), "", "samples used"),
            Answer("window", span, "s", "times", "", f"{span[0]:.6g} to {span[1]:.6g} s"),
            Answer("regime", fit.regime, "", "regime"),
        ])]  # fmt: skip

    def _torque(self) -> Group:
        """Return the constant torque, in N m too where a moment is known, and how the criterion decided."""
        fit, moments = self.fit, self.moments
        both = {"free", "torque"} <= fit.aicc.keys()
        better = fit.aicc["free"] - fit.aicc["torque"] if both else 0.0
        said = f"AICc {'prefers' if better > 0 else 'speaks against'} a torque by {abs(better):.3g}" if both else None
        known = fit.degenerate is None
        torque, absolute = fit.torque, None
        if torque is not None and moments is not None:
            largest, error = float(moments.value[2]), float(moments.standard_error[2])
            size = np.hypot(torque.standard_error * largest, torque.value * error)
            absolute = Estimate(("Nx", "Ny", "Nz"), torque.value * largest, np.diag(size**2), torque.degrees_of_freedom)
        if said and fit.misfit is not None:
            said += "; neither motion explains the log"
        return Group("Torque", [
            Answer("torque", None if torque is None else values(torque), "rad/s²", "N/I3 along x, y, z",
                   "constant in the body, over the largest moment; null where there is none",
                   f"{in_words(torque)} rad/s²" if torque is not None else "none" if known else "not determined"),
            Answer("torque_absolute", None if absolute is None else values(absolute), "N m",
                   "N along x, y, z", "", None if absolute is None else f"{in_words(absolute)} N m"),
            Answer("aicc", fit.aicc, "", "criterion" if both else "", "", said),
        ])

    @property
    def notes(self) -> list[str]:
        fit = self.fit
        if fit.degenerate is not None:
            return []
        if fit.misfit is not None:
            advice = ("look at the residuals by `draw`. Torques that turn with the orbit or a field, as of the gravity "
                      "gradient or a dipole, are not tried; a part of the log in which they matter less may be free. "
                      "Filtered attitudes have residuals that are alike too: thin them out.")
            return [advice]
        equal = f"{fit.equal} within their errors: the axes between them are not determined."
        return [equal] if fit.equal else []

    def figures(self) -> Mapping[str, Callable[[], Figure | None]]:
        from polhode.measuring.throws.figures import attitude_figures

        return attitude_figures(self.fit)

    def _write_data(self, path: Path) -> Path:
        from polhode.measuring.throws.dataset import write_attitude_fit

        return write_attitude_fit(self.fit, self.name, path)

"""All figures of a report at once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from polhode.figures import style
from polhode.figures.axis_locus import draw_axis_locus
from polhode.figures.components import draw_components
from polhode.figures.damped_body import draw_damped_motion, draw_damped_sphere
from polhode.figures.gyrostat import draw_gyrostat_motion, draw_gyrostat_sphere
from polhode.figures.herpolhode import draw_herpolhode
from polhode.figures.momentum_sphere import draw_momentum_sphere
from polhode.figures.top_motion import draw_top_motion
from polhode.report.base import AbstractReport
from polhode.report.damped_body import DampedBodyReport
from polhode.report.free_body import FreeBodyReport
from polhode.report.gyrostat import GyrostatReport
from polhode.report.tops import LagrangeTopReport, TopReport

FIGURES: dict[type, dict[str, Callable[[Any], Figure | None]]] = {
    FreeBodyReport: {
        "momentum_sphere": draw_momentum_sphere,
        "components": draw_components,
        "herpolhode": draw_herpolhode,
    },
    TopReport: {"axis_locus": draw_axis_locus, "motion": draw_top_motion},
    LagrangeTopReport: {"axis_locus": draw_axis_locus, "motion": draw_top_motion},
    GyrostatReport: {"momentum_sphere": draw_gyrostat_sphere, "motion": draw_gyrostat_motion},
    DampedBodyReport: {"momentum_sphere": draw_damped_sphere, "motion": draw_damped_motion},
}


def draw_all(report: AbstractReport, folder: Path, ending: str = "png") -> list[Path]:
    """Write every figure that the report has into an existing folder and return their paths."""
    figures = {name: make(report) for name, make in FIGURES[type(report)].items()}
    return [
        style.save(figure, folder / f"{name}.{ending}") for name, figure in figures.items() if figure is not None
    ]

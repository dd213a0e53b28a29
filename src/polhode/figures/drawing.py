"""All figures of a report at once."""

from __future__ import annotations

from pathlib import Path

from polhode.figures import style
from polhode.figures.components import draw_components
from polhode.figures.herpolhode import draw_herpolhode
from polhode.figures.momentum_sphere import draw_momentum_sphere
from polhode.report import Report


def draw_all(report: Report, folder: Path, ending: str = "png") -> list[Path]:
    """Write every figure that the report has into an existing folder and return their paths."""
    makers = {
        "momentum_sphere": draw_momentum_sphere,
        "components": draw_components,
        "herpolhode": draw_herpolhode,
    }
    figures = {name: make(report) for name, make in makers.items()}
    return [
        style.save(figure, folder / f"{name}.{ending}") for name, figure in figures.items() if figure is not None
    ]

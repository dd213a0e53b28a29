"""All figures of a report at once."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from matplotlib.figure import Figure

from polhode.errors import InvalidInput, shown
from polhode.figures import style
from polhode.report.base import AbstractReport

TOP_FIGURES = {
    "spinning_top": ("spinning_top", "draw_spinning_top"),
    "axis_locus": ("axis_locus", "draw_axis_locus"),
    "motion": ("top_motion", "draw_top_motion"),
}
# by the report's kind: file name → module and function, imported only when drawn
FIGURES: dict[str, dict[str, tuple[str, str]]] = {
    "free-body": {
        "momentum_sphere": ("momentum_sphere", "draw_momentum_sphere"),
        "inertia_ellipsoid": ("inertia_ellipsoid", "draw_inertia_ellipsoid"),
        "components": ("components", "draw_components"),
        "herpolhode": ("herpolhode", "draw_herpolhode"),
    },
    "heavy-top": TOP_FIGURES,
    "lagrange-top": TOP_FIGURES,
    "gyrostat": {
        "momentum_sphere": ("gyrostat", "draw_gyrostat_sphere"),
        "motion": ("gyrostat", "draw_gyrostat_motion"),
    },
    "damped-body": {
        "momentum_sphere": ("damped_body", "draw_damped_sphere"),
        "motion": ("damped_body", "draw_damped_motion"),
    },
    "spin-orbit": {"section": ("spin_section", "draw_spin_section"), "motion": ("spin_history", "draw_spin_history")},
    "euler-disk": {
        "rolling_disk": ("rolling_disk", "draw_rolling_disk"),
        "tilt": ("disk_end", "draw_disk_end"),
        "contact_path": ("contact_path", "draw_contact_path"),
    },
}


def draw_figure(report: AbstractReport, name: str) -> Figure | None:
    """Return one figure of a report, None where there is nothing to see.

    Args:
        report: what is drawn.
        name: as its file is called, such as ``"inertia_ellipsoid"``.

    Raises:
        InvalidInput: for names that reports of this kind have no figure of.
    """
    known = FIGURES[report.kind]
    if name not in known:
        raise InvalidInput(
            f"`name` must be of {', '.join(known)} for a report of kind {report.kind}; "
            f"got {shown(name)}."
        )
    module, draw = known[name]
    return getattr(import_module(f"polhode.figures.{module}"), draw)(report)


def draw_all(report: AbstractReport, folder: Path, *forms: str) -> list[Path]:
    """Write every figure that the report has into an existing folder and return their paths.

    Args:
        report: what is drawn.
        folder: where to.
        forms: png, svg, pdf, each figure in all of them; png if none is named.
    """
    written = []
    for name in FIGURES[report.kind]:
        figure = draw_figure(report, name)
        if figure is not None:
            written += [style.save(figure, folder / f"{name}.{form}") for form in forms or ("png",)]
    return written

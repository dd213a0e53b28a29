"""All figures of a report at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from polhode.figures import style


def draw_all(
    report: Any, figures: Mapping[str, Callable[[Any], Figure | None]], folder: Path, *forms: str
) -> list[Path]:
    """Write every figure of a report into an existing folder and return their paths.

    Args:
        report: what is drawn.
        figures: what draws each figure, by the name of its file; a figure may be None where there is nothing to see.
        folder: where to.
        forms: png, svg, pdf, each figure in all of them; png if none is named.
    """
    written = []
    for name, draw in figures.items():
        figure = draw(report)
        if figure is not None:
            written += [style.save(figure, folder / f"{name}.{form}") for form in forms or ("png",)]
    return written

"""Figures that wings and other packages add to the reports of kinds that are there, by ``polhode.figures``.

An entry point is named KIND.FIGURE, like ``free-body.spin_rate``, so that none is imported before it is drawn: what is
added to which kind, and the names of its files, are known by then. It is a function from the report to a figure.
"""

from __future__ import annotations

import re
import warnings
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from polhode._base.plugins import FAILURES, find_entry_points, load_entry_point
from polhode._base.plugins.wings import wing_points
from polhode.errors import InvalidInput, one_line, shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.kinds.base import AbstractKind, Figures

GROUP = "polhode.figures"
FILE_NAME = re.compile(r"(?!(con|prn|aux|nul)$)[a-z]+(_[a-z0-9]+)*")  # a file on every system, Windows and macOS too
_RULE = ("is ignored, as its name must be KIND.FIGURE, where FIGURE is words in small letters joined by _, like "
         "gyrostat.spin_rate. Rename or remove it.")


def figures_of(kind: AbstractKind) -> Figures:
    """Return the functions that draw the figures of a report: the kind's own, and those that are added to it.

    One of another package that fails is left out, with a warning: the report loses nothing else.
    """
    own = kind.figures()
    return {**own, **{name: partial(_draw, point) for name, point in added_figures(kind.name, tuple(own)).items()}}


@cache
def added_figures(kind: str, own: tuple[str, ...]) -> dict[str, Any]:
    """Return the entry points of the figures that are added to a kind, by name; none is imported.

    Args:
        kind: its name.
        own: the names of its own figures, which win.
    """
    others = find_entry_points(GROUP, {*wing_points(GROUP), *(f"{kind}.{name}" for name in own)})
    added = {}
    for name, point in (wing_points(GROUP) | others).items():
        whose, _, figure = name.partition(".")
        if whose == kind and FILE_NAME.fullmatch(figure):
            added[figure] = point
        elif whose == kind:
            _warn(point, _RULE)
    return added


def check_kinds_of_figures(kinds: list[str]) -> None:
    """Warn of figures of other packages for kinds that are not there: of a misspelt one nobody would ask.

    Args:
        kinds: the names of all kinds.
    """
    for name, point in find_entry_points(GROUP, ()).items():
        whose, dot, _ = name.partition(".")
        if not dot:
            _warn(point, _RULE)
        elif whose not in kinds:
            _warn(point, f"is ignored, as there is no kind {shown(whose)}; there are {', '.join(kinds)}. Rename or "
                         "remove it.")


def _draw(point: Any, report: Any) -> Figure | None:
    """Return what a function that is added draws; None where one of another package fails, with a warning."""
    if point.name in wing_points(GROUP):
        return point.load()(report)
    from matplotlib.figure import Figure

    try:
        draw = load_entry_point(point)
    except InvalidInput as error:
        warnings.warn(f"{error} Its figure is left out.", stacklevel=2)
        return None
    try:
        figure = draw(report)
        if figure is None:
            return None
        if isinstance(figure, Figure):
            figure.draw_without_rendering()  # some mistakes, like those in formulas, show only as it is saved
            return figure
        what = f"it must return a figure of Matplotlib or None; got {shown(figure)}"
    except FAILURES as error:
        what = f"it fails ({type(error).__name__}: {one_line(str(error))})"
    _warn(point, f"is left out: {what}. Update or remove it.")
    return None


def _warn(point: Any, what: str) -> None:
    warnings.warn(f"the figure {point.name} of another package, {point.value}, {what}", stacklevel=3)

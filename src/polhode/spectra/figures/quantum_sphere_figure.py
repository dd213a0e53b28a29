"""The momentum sphere with the polhodes that correspond to a molecule's levels."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from polhode.analysis.polhodes import separatrix
from polhode.figures import style
from polhode.figures.energy_levels import draw_legend, label_axes
from polhode.figures.sphere import draw_curve, draw_disk, view_frame
from polhode.spectra.figures.level_curves import (
    ROUND_A,
    ROUND_C,
    VIEW,
    curve_width,
    level_curves,
    rotor_moments,
    side_colour,
)
from polhode.spectra.rotor import Rotor

AXES = ("$a$", "$b$", "$c$")


def quantum_sphere(rotor: Rotor, J: int, *, axes: Any = None) -> Figure:
    """Return the sphere |L| = J + ½ with a pair of polhodes for each of the 2J + 1 levels, far side dimmed.

    Next polhodes of one side have an area of 2π/(J + ½) between them, a quantum, on the unit sphere; levels that
    tunnelling pairs lie on almost equal polhodes.

    Args:
        rotor: a rigid asymmetric rotor; distortion is left out.
        J: of the levels.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for a symmetric molecule.

    >>> from polhode.spectra import Rotor
    >>> quantum_sphere(Rotor((27.0, 14.0, 9.0)), 3).axes[0].get_title()
    'Levels of J = 3 as polhodes'
    """
    curves = level_curves(rotor, J)
    figure, (axes,) = style.axes_for(axes)
    frame = view_frame(VIEW)
    draw_disk(axes)
    for level in curves:
        draw_curve(axes, frame, level.unit, side_colour(level.above), curve_width(J))
    for curve in separatrix(rotor_moments(rotor)):
        draw_curve(axes, frame, curve, style.VERMILION, 1.0)
    label_axes(axes, frame, AXES)
    lines = [("round $a$", ROUND_A, 1.2), ("round $c$", ROUND_C, 1.2), ("separatrix", style.VERMILION, 0.9)]
    draw_legend(axes, lines, ())
    axes.set_title(f"Levels of J = {J} as polhodes", fontsize=style.FONT, color=style.DARK)
    return figure

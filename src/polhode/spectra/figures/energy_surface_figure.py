"""The rotational energy surface of a molecule: how its energy depends on where L points in it.

Source: Harter & Patterson, J. Chem. Phys. 80 (1984) 4241.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from polhode.analysis.polhodes import separatrix
from polhode.bodies._turned import ball
from polhode.bodies.surface import Surface
from polhode.figures import style
from polhode.figures.scene import Scene
from polhode.figures.sphere import view_frame
from polhode.spectra.figures.level_curves import (
    ROUND_A,
    ROUND_C,
    VIEW,
    curve_width,
    level_curves,
    rotor_moments,
    side_colour,
)
from polhode.spectra.figures.quantum_sphere_figure import AXES
from polhode.spectra.rotor import Rotor
from polhode.types import Array

BODY = "#dfe6ec"


def energy_surface(rotor: Rotor, J: int, *, axes: Any = None) -> Figure:
    """Return the surface whose radius along each direction of L is the energy, with the levels of one J as contours.

    Args:
        rotor: a rigid asymmetric rotor; distortion is left out.
        J: of the levels, |L| = J + ½.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for a symmetric molecule.

    >>> from polhode.spectra import Rotor
    >>> energy_surface(Rotor((27.0, 14.0, 9.0)), 3).axes[0].get_title()
    'Rotational energy surface, levels of J = 3'
    """
    curves = level_curves(rotor, J)
    scale = np.array(rotor.constants) / rotor.constants[0]
    fineness = 96
    unit, faces = ball(fineness)
    vertices = unit * _radius(unit, scale)[:, None]
    frame = view_frame(VIEW)
    right, up = np.abs(vertices @ frame[:2].T).max(axis=0)
    right, up = np.maximum((right, up), np.abs(frame[:2] * (scale + 0.22)).max(axis=-1))
    border = 0.12  # of the largest radius, to the window's edge
    window = (-right - border, right + border, -up - border, up + border)
    figure, (axes,) = style.axes_for(axes, height=style.choose_height(window, 0.7))
    scene = Scene(axes, frame, window)
    scene.solid(Surface(vertices, faces), BODY, ambient=0.7)
    scene.finish(order=0.0)
    width = curve_width(J)
    for level in curves:
        scene.line(level.unit * _radius(level.unit, scale)[:, None], side_colour(level.above), width)
    for curve in separatrix(rotor_moments(rotor)):
        scene.line(curve * scale[1], style.VERMILION, 1.0)
    for k, name in enumerate(AXES):
        end = np.eye(3)[k]
        scene.line(np.linspace(scale[k] * end, (scale[k] + 0.12) * end, 20), style.DARK, 0.7)
        x, y, _ = scene.project((scale[k] + 0.2) * end)
        scene.axes.text(x, y, name, fontsize=style.FONT + 1, ha="center", va="center", color=style.DARK, zorder=6)
    lines = (("round $a$", ROUND_A, 1.2), ("round $c$", ROUND_C, 1.2), ("saddle", style.VERMILION, 0.9))
    handles = [axes.plot([], [], color=colour, lw=width, label=label)[0] for label, colour, width in lines]
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=3, frameon=False,
                fontsize=style.FONT - 1, handlelength=1.6, columnspacing=1.2)
    axes.set_title(f"Rotational energy surface, levels of J = {J}", fontsize=style.FONT, color=style.DARK)
    return figure


def _radius(unit: Array, scale: Array) -> Array:
    return unit**2 @ scale

"""The levels of a molecule in columns of K_a, and the saddle that divides them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from polhode.figures import style
from polhode.spectra._level_polhodes import find_above
from polhode.spectra.figures.level_curves import CROWDED, ROUND_A, ROUND_C, side_colour
from polhode.spectra.reports import WAVE_NUMBER
from polhode.spectra.rotor import Rotor, find_fallen
from polhode.types import Array


def level_diagram(rotor: Rotor, j_max: int, *, axes: Any = None) -> Figure:
    """Return the levels with J up to ``j_max`` over K_a, each with its J; K_c = J − K_a is left in a column.

    The saddle of each J lies on the dashed curve: left above it L goes round the c axis, right below it round a.
    Levels that the nuclear spins leave empty are dotted.

    Args:
        rotor: any; whether a level is above the saddle is judged without distortion.
        j_max: the largest J.
        axes: matplotlib axes to draw on; a new figure without them.

    Raises:
        InvalidInput: for a J that is not a whole number from 0 to 10,000.

    >>> from polhode.spectra import Rotor
    >>> level_diagram(Rotor((27.0e9, 14.0e9, 9.0e9)), 3).axes[0].get_xlabel()
    '$K_a$'
    """
    levels = rotor.levels(j_max)
    most_columns = 12
    energy, columns = levels.energy / WAVE_NUMBER, min(int(levels.Ka.max()), most_columns)
    holds = ~find_fallen(levels.J, energy)  # distortion beyond its range lets levels fall below the ground state
    top = float(energy[holds & ((levels.Ka == columns) | (columns == levels.Ka.max()))].max(initial=0.0))
    if axes is None:
        figure = style.new_figure(4.8, 4.4)
        axes = figure.subplots()
    else:
        figure, (axes,) = style.axes_for(axes)
    top = top or 1.0
    above = _above(rotor, j_max)
    left = levels.Kc == levels.J - levels.Ka
    half = 0.33  # of a column's width: the ticks of its two ladders
    start = levels.Ka + np.where(left & (levels.Ka > 0), -half, np.where(levels.Ka > 0, 0.04, -0.5 * half))
    end = start + half - 0.04
    shown = (levels.Ka <= columns) & (energy <= 1.02 * top) & holds
    for side in (False, True):
        for empty in (False, True):
            own = shown & (above == side) & ((levels.weight == 0.0) == empty)
            pieces = [[(x0, y), (x1, y)] for x0, x1, y in zip(start[own], end[own], energy[own], strict=True)]
            form = ":" if empty else "-"
            drawn = LineCollection(pieces, colors=side_colour(side), linewidths=1.1, linestyles=form)
            axes.add_collection(drawn, autolim=False)
    # a pair that lies together has its J once, on the left, which comes next
    paired = 0.01  # of the height: two levels that lie together
    pair = ~left & ((j_max > CROWDED) | (np.abs(np.append(energy[1:], np.inf) - energy) < paired * top))
    _name(axes, levels.J, shown & ~pair, left | (levels.Ka == 0), start, end, energy, top)
    axes.set_xlim(-0.75, columns + 0.75)
    axes.set_ylim(-0.02 * top, 1.04 * top)
    _draw_saddle(axes, rotor, columns, top)
    axes.set_xticks(range(columns + 1))
    axes.set_xlabel("$K_a$")
    axes.set_ylabel("energy  [cm$^{-1}$]")
    style.tidy(axes)
    return figure


def _above(rotor: Rotor, j_max: int) -> Array:
    """Return whether the levels with J up to ``j_max`` go round the a axis, as far as their polhodes say so."""
    A, B, C = rotor.constants
    count = j_max + 1 if rotor.is_linear else (j_max + 1) ** 2
    above = np.full(count, B - C < A - B)  # circles round the axis of symmetry; of a linear molecule round none
    polhodes = find_above(rotor.constants, j_max)
    if polhodes is not None:
        above[1:] = polhodes
    return above


def _name(
    axes: Any, J: Array, named: Array, left: Array, start: Array, end: Array, energy: Array, top: float
) -> None:
    """Write the J of each level that is to be named beside it, where the one below leaves room."""
    last: dict[tuple[float, bool], float] = {}
    apart = 0.028  # of the height: labels nearer to each other are left out
    for k in np.flatnonzero(named)[np.argsort(energy[named])]:
        column = (float(start[k]), bool(left[k]))
        if energy[k] - last.get(column, -math.inf) < apart * top:
            continue
        last[column] = float(energy[k])
        x, side = (start[k] - 0.03, "right") if left[k] else (end[k] + 0.03, "left")
        axes.text(x, energy[k], f"{J[k]}", fontsize=style.FONT - 3, ha=side, va="center", color=style.GREY,
                  clip_on=True)


def _draw_saddle(axes: Any, rotor: Rotor, columns: int, top: float) -> None:
    """Draw E = B (K_a/f)², f the share of a hemisphere that lies round c: a J's saddle is at K_a = f (J + ½)."""
    A, B, C = rotor.constants
    if not (math.isfinite(A) and A > B > C > 0.0):
        return
    share = 2.0 / math.pi * math.atan2(math.sqrt(B - C), math.sqrt(A - B))  # of a lune between the separatrix's planes
    K = np.linspace(0.0, min(columns + 0.75, share * math.sqrt(1.04 * top * WAVE_NUMBER / B)), 200)
    line = axes.plot(K, B * (K / share) ** 2 / WAVE_NUMBER, color=style.VERMILION, lw=0.9, ls="--", label="saddle")[0]
    handles = [axes.plot([], [], color=colour, lw=1.2, label=label)[0]
               for label, colour in (("round $c$", ROUND_C), ("round $a$", ROUND_A))]
    axes.legend(handles=[handles[0], line, handles[1]], loc="lower right", fontsize=style.FONT - 1, frameon=False,
                handlelength=1.8)

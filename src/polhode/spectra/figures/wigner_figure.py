"""Wigner functions of a molecule's levels, and of a quantum body that turns over about its middle axis."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from polhode.errors import InvalidInput
from polhode.figures import style
from polhode.spectra._operators import Representation, rigid_terms
from polhode.spectra._strengths import compute_states
from polhode.spectra.figures.level_curves import find_polhodes
from polhode.spectra.racket import Racket
from polhode.spectra.rotor import Rotor
from polhode.spectra.symbols import sum_harmonics, symbol_coefficients
from polhode.types import Array, Float64


class WignerLimits(NamedTuple):
    """Limits of the pictures.

    Attributes:
        max_j: work grows as its cube, and waves become finer than what is drawn.
    """

    max_j: int = 60


LIMITS = WignerLimits()
MIDDLE_IS_Z = Representation.IIr  # x, y, z = c, a, b
COLOURS = "RdBu_r"


def level_wigner(rotor: Rotor, J: int, *, axes: Any = None) -> Figure:
    """Return Wigner functions of six levels of one J, from the lowest through the saddle to the highest.

    Each is the hemisphere about b in an equal area map, c to the right and a up; the other is its image under a half
    turn. The line is where the classical energy is the level's, its polhode. Ripples inside it are interference.

    Args:
        rotor: a rigid asymmetric rotor; distortion is left out.
        J: of the levels, from 1 to 60.
        axes: matplotlib axes to draw on, six; new ones without them.

    Raises:
        InvalidInput: for a symmetric molecule, or a larger J.

    >>> from polhode.spectra import Rotor
    >>> len(level_wigner(Rotor((27.0, 14.0, 9.0)), 1).axes)
    3
    """
    check_drawable(J)
    levels = find_polhodes(rotor, J)
    chosen = _choose_levels(levels.above)
    if axes is None:
        figure = style.new_figure(6.0, 4.4 if len(chosen) > 3 else 2.4)
        panels = list(np.atleast_1d(figure.subplots(math.ceil(len(chosen) / 3), 3)).flat)
    else:
        figure, panels = style.axes_for(axes, rows=len(chosen))
    states = compute_states(rigid_terms(rotor.constants, MIDDLE_IS_Z), J, MIDDLE_IS_Z)
    for panel, k in zip(panels, chosen, strict=False):
        state = states.vectors[::-1, k]  # their K ascends, m of a spin descends
        values = wigner_on_side(state, 1.0, J)
        _draw(panel, values, 1.0, float(np.abs(values).max()))
        _draw_energy(panel, rotor, float(levels.energy[k]) / (J + 0.5) ** 2)
        name = f"${J}_{{{levels.Ka[k]},{levels.Kc[k]}}}$"
        panel.set_title(name, fontsize=style.FONT, color=style.DARK, pad=3.0)
    for panel in panels[len(chosen) :]:
        panel.set_axis_off()
    return figure


def racket_wigner(racket: Racket, *, axes: Any = None) -> Figure:
    """Return the Wigner function of a body that turns over, at five times, on both hemispheres about its middle axis.

    Times are the start, those of half and of the first reversal, and as far beyond. Each hemisphere is drawn from
    outside in an equal-area map: about +b above, with c to the right, about −b below, with c to the left; a is up.

    Args:
        racket: with J up to 60.
        axes: matplotlib axes to draw on, ten; new ones without them.

    Raises:
        InvalidInput: for a larger J.
    """
    check_drawable(racket.J)
    times = choose_times(racket)
    sides = (1.0, -1.0)  # of +b and of −b
    if axes is None:
        figure = style.new_figure(7.2, 3.3)
        panels = list(figure.subplots(len(sides), len(times)).flat)
    else:
        figure, panels = style.axes_for(axes, rows=len(sides) * len(times))
    power = style.power_of_ten(times)
    for k, (time, state) in enumerate(zip(times, racket.states(times), strict=True)):
        both = [wigner_on_side(state, side, racket.J) for side in sides]
        largest = float(np.abs(both).max())  # one scale for both sides of a time, which keeps faint ones faint
        for row, (side, values) in enumerate(zip(sides, both, strict=True)):
            panel = panels[row * len(times) + k]
            _draw(panel, values, side, largest)
            if row == 0:
                title = f"{time / 10.0**power:.3g} {style.factor(power)}s" if time else "0 s"
                panel.set_title(title, fontsize=style.FONT - 1, color=style.DARK, pad=3.0)
            if k == 0:
                panel.text(-1.75, 0.0, "$+b$" if side > 0.0 else "$-b$", fontsize=style.FONT, ha="right", va="center")
    return figure


def choose_times(racket: Racket) -> Float64[Array, "time"]:
    """Return five times (5,) [s] from the start to twice the first reversal."""
    first = racket.first_reversal
    end = (math.log(racket.J) + 2.3) / racket.rate if first is None else first.time
    return end * np.array([0.0, 0.5, 0.75, 1.0, 2.0])


def check_drawable(J: int) -> None:
    """Refuse a J whose waves are too fine.

    Raises:
        InvalidInput: with the largest allowed.
    """
    if J > LIMITS.max_j:
        raise InvalidInput(f"`J` must be at most {LIMITS.max_j} for a Wigner function's picture; got {J}.")


def wigner_on_side(state: Array, side: float, J: int) -> Float64[Array, "n m"]:
    """Return the Wigner function on a hemisphere about ±z; polar angles from ±z by rows, azimuths by columns."""
    polar, azimuth = _grid(J)
    colatitude = polar if side > 0.0 else math.pi - polar
    values = sum_harmonics(symbol_coefficients(np.outer(state, state.conj())), colatitude[:, None], azimuth[None, :])
    return np.real(values)


def _grid(J: int) -> tuple[Array, Array]:
    per_wave = 8  # points, of waves of which 2J go round
    count = max(48, per_wave * J // 2)
    return np.linspace(0.0, 0.5 * math.pi, count), np.linspace(0.0, 2.0 * math.pi, 4 * count + 1)


def _choose_levels(above: Array) -> list[int]:
    """Return the levels that are shown: the ends of both sides, and those half way."""
    count, below = len(above), int((~above).sum())
    wanted = (0, below // 2, below - 1, below, (below + count) // 2, count - 1)
    most_panels = 6
    return sorted({min(max(k, 0), count - 1) for k in wanted})[:most_panels]


def _draw(panel: Any, values: Array, side: float, largest: float) -> None:
    edge = math.sqrt(2.0)  # of the map of a hemisphere
    picture = panel.imshow(_on_pixels(values, side), cmap=COLOURS, vmin=-largest, vmax=largest, origin="lower",
                           extent=(-edge, edge, -edge, edge))
    around = np.linspace(0.0, 2.0 * math.pi, 200)
    border, = panel.plot(edge * np.cos(around), edge * np.sin(around), color=style.GREY, lw=0.6)
    picture.set_clip_path(border.get_path(), panel.transData)
    panel.text(side * 1.5, 0.0, "$c$", fontsize=style.FONT - 2, ha="left" if side > 0.0 else "right", va="center")
    panel.text(0.0, 1.5, "$a$", fontsize=style.FONT - 2, ha="center", va="bottom")
    panel.set_aspect("equal")
    panel.set_xlim(-1.72, 1.72)
    panel.set_ylim(-1.6, 1.72)
    panel.set_axis_off()


def _on_pixels(values: Array, side: float) -> Float64[Array, "pixels pixels"]:
    """Return values of `wigner_on_side` at the pixels of an equal-area map, rows from below.

    They are interpolated linearly, as matplotlib does within triangles, of which it would draw a hundred thousand.
    Beyond the hemisphere's edge they are those at the edge.
    """
    pixels = 360  # across the map, more than are printed
    across = math.sqrt(2.0) * (np.arange(pixels) + 0.5 - 0.5 * pixels) / (0.5 * pixels)
    x, y = side * across[None, :], across[:, None]
    rows, columns = values.shape[0] - 1, values.shape[1] - 1
    polar = 2.0 * np.arcsin(np.minimum(0.5 * np.hypot(x, y), math.sqrt(0.5)))
    row, column = (polar * (rows / (0.5 * math.pi)),
                   np.remainder(np.arctan2(y, x), 2.0 * math.pi) * (columns / (2.0 * math.pi)))
    i, k = np.minimum(row.astype(int), rows - 1), np.minimum(column.astype(int), columns - 1)
    u, v = row - i, column - k
    inner, outer = (values[n, k] * (1.0 - v) + values[n, k + 1] * v for n in (i, i + 1))
    return inner * (1.0 - u) + outer * u


def _draw_energy(panel: Any, rotor: Rotor, height: float) -> None:
    """Draw the contour A n_a² + B n_b² + C n_c² = energy."""
    A, B, C = rotor.constants
    polar, azimuth = np.linspace(0.0, 0.5 * math.pi, 120), np.linspace(0.0, 2.0 * math.pi, 361)
    sine, cosine, out = np.sin(polar)[:, None], np.cos(polar)[:, None], 2.0 * np.sin(0.5 * polar)[:, None]
    surface = sine**2 * (A * np.sin(azimuth) ** 2 + C * np.cos(azimuth) ** 2) + B * cosine**2
    if surface.min() < height < surface.max():
        panel.contour(out * np.cos(azimuth), out * np.sin(azimuth), surface, [height], colors=style.DARK,
                      linewidths=0.8)

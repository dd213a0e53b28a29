"""The page of a molecule: levels of one J as polhodes, Wigner functions, and the flip of a quantum body."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from scipy import constants

from polhode.bodies.surface import Surface
from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.kinds.panel import KindPanel
from polhode.motion._trajectory import Trajectory
from polhode.reports.wording import in_its_unit
from polhode.spectra._level_polhodes import LevelPolhodes, level_directions
from polhode.spectra._operators import Representation, rigid_terms
from polhode.spectra._strengths import States, compute_states
from polhode.spectra.quantum_rotor.answers import QuantumRotorReport, is_split
from polhode.spectra.racket import Racket
from polhode.spectra.reports import WAVE_NUMBER, frequency, label, wave_number
from polhode.spectra.rotor import PLANCK_OVER_8_PI_SQUARED
from polhode.spectra.symbols import pole_values
from polhode.types import Array, Float64
from polhode.viewer.encoding import pack
from polhode.viewer.panels import PageContent, body_panels
from polhode.viewer.samples import Samples

MIDDLE_IS_Z = Representation.IIr  # x, y, z = c, a, b


class QuantumPageLimits(NamedTuple):
    """Limits of the page's computations.

    Attributes:
        max_j: of Wigner functions: there the page's script takes a second for its tables, and waves are fine.
    """

    max_j: int = 60


LIMITS = QuantumPageLimits()


class Shown(NamedTuple):
    """What a page starts with.

    Attributes:
        level: by its place in the ladder of energy; None of a coherent state.
        direction: (3,) of L along a, b, c.
    """

    level: int | None
    direction: Float64[Array, "3"]


def _check(report: QuantumRotorReport) -> None:
    A = report.rotor.constants[0]
    why = (
        "a linear molecule has no motion about its axis" if not math.isfinite(A)
        else "of a spherical top every L rests in the body" if report.rotor.equal == "ABC"
        else "with `j` = 0 there is no L" if report.J == 0 else None
    )
    if why is not None:
        raise InvalidInput(
            f"there is nothing to show on a page: {why}. Ask for levels and figures by `polhode report`."
        )


def _start(report: QuantumRotorReport) -> Shown:
    """Return the flip, or the level next above the saddle, or the middle one of a symmetric molecule."""
    if report.racket is not None and report.J <= LIMITS.max_j:
        return Shown(None, report.racket.direction)
    directions, above = _polhodes(report)
    level = int(np.argmax(above)) if above.any() and not above.all() else report.J
    return Shown(level, directions[level])


def _polhodes(report: QuantumRotorReport) -> tuple[Float64[Array, "n 3"], Array]:
    """Return a point of each level's polhode (2J+1, 3), and whether that goes round the a axis."""
    A, B, C = report.rotor.constants
    if report.polhodes is not None:
        return level_directions((A, B, C), report.J, report.polhodes.semiclassical), report.polhodes.above
    levels = _states(report)
    prolate = report.rotor.equal == "BC" or B - C < A - B
    along = (levels.Ka if prolate else levels.Kc) / (report.J + 0.5)
    beside, rest = np.sqrt(1.0 - along**2), np.zeros(len(along))
    components = (along, rest, beside) if prolate else (beside, rest, along)
    return np.stack(components, axis=-1), np.full(len(along), prolate)


def _states(report: QuantumRotorReport) -> States:
    """Return the levels of the rigid rotor, with states of a spin whose x, y, z are c, a, b, from K = −J up."""
    return compute_states(rigid_terms(report.rotor.constants, MIDDLE_IS_Z), report.J, MIDDLE_IS_Z)


def _moments(report: QuantumRotorReport) -> Float64[Array, "3"]:
    return PLANCK_OVER_8_PI_SQUARED / np.array(report.rotor.constants)


def _size(J: int) -> float:
    """Return |L| [kg m²/s]."""
    return constants.hbar * (J + 0.5)


def _span(report: QuantumRotorReport, motion: FreeMotion) -> float:
    """Return the length of the page's first window [s]: some periods, or two flips where those are longer."""
    period = None if motion.period is None else float(motion.period)
    if period is None or not math.isfinite(period):
        speed = float(np.linalg.norm(motion.momentum_at_epoch / motion.moments))
        period = 8.0 * math.pi / speed
        if report.racket is not None:
            period = (2.0 * math.log(report.J) + 8.0) / report.racket.rate
    return 2.2 * period


def _model(report: QuantumRotorReport, directions: Float64[Array, "n 3"]) -> dict[str, Any]:
    """Return the input of the page's script for the classical body and the spin."""
    level, direction = _start(report)
    states = _states(report)
    names = [label(report.J, Ka, Kc) for Ka, Kc in zip(states.Ka.tolist(), states.Kc.tolist(), strict=True)]
    levels = [
        {"name": name, "start": start, "said": said}
        for name, start, said in zip(names, directions.tolist(), _describe_levels(report, states), strict=True)
    ]
    spin = {} if report.J > LIMITS.max_j else {
        "vectors": pack(states.vectors[::-1]), "energies": states.energy.tolist(),
        "kernel": pole_values(report.J).tolist(),
    }
    return {
        "solver": "QuantumRotor", "J": report.J, "constants": list(report.rotor.constants),
        "moments": _moments(report).tolist(), "momentumSize": _size(report.J), "attitude": [1.0, 0.0, 0.0, 0.0],
        "epoch": 0.0, "level": level, "direction": direction.tolist(), "levels": levels,
        "said": [] if report.racket is None else _of_flip(report.racket), "largestJ": LIMITS.max_j, **spin,
    }  # fmt: skip


def _describe_levels(report: QuantumRotorReport, states: States) -> list[list[list[str]]]:
    """Return pairs of a name and a value for each level."""
    polhodes = report.polhodes
    if polhodes is None:
        return [[["energy E/hc", wave_number(energy)]] for energy in states.energy.tolist()]
    return [_of_level(polhodes, k) for k in range(len(polhodes.energy))]


def _of_level(polhodes: LevelPolhodes, k: int) -> list[list[str]]:
    above, step, classical = bool(polhodes.above[k]), float(polhodes.step[k]), float(polhodes.classical_step[k])
    said = [
        ["energy E/hc, rigid rotor", wave_number(float(polhodes.energy[k]))],
        ["as a quantised polhode", wave_number(float(polhodes.semiclassical[k]))],
        ["L goes round", "the a axis, above the saddle" if above else "the c axis, below the saddle"],
    ]
    if math.isfinite(step) and math.isfinite(classical):
        said.append(["step to the next of its ladder", frequency(step, 6)])
        said.append(["turns of L a second, half way there", frequency(classical, 6)])
    if is_split(float(polhodes.splitting[k]), classical):
        said.append(["tunnelling splits the pair by", frequency(float(polhodes.splitting[k]), 6)])
    return said


def _of_flip(racket: Racket) -> list[list[Any]]:
    """Return pairs of a name and a value about the flip."""
    half, first, revival = racket.half_time, racket.first_reversal, racket.revival_time
    said: list[list[Any]] = [] if half is None else [["⟨L_b⟩ falls to J/2 after", in_its_unit(half)]]
    if first is not None:
        values = {"time": in_its_unit(first.time), "value": f"{first.along:.4f}"}
        said.append(["first reversal", ["{time}, to ⟨L_b⟩ = {value} J", values]])
    return said if revival is None else [*said, ["revival T_rev", in_its_unit(revival)]]


class QuantumRotorPanel(KindPanel):
    """Levels of one J as polhodes, their Wigner functions, and the flip of a quantum body."""

    def shown(self, report: QuantumRotorReport) -> Trajectory:
        """Return the classical motion that the page starts with: of the flip that the spec asks for, or of a level.

        Raises:
            InvalidInput: for J = 0, and for molecules without a motion on a sphere: linear and spherical ones.
        """
        _check(report)
        size, moments = _size(report.J), _moments(report)
        motion = FreeMotion(moments, momentum=size * _start(report).direction)
        span = _span(report, motion)
        trajectory = motion.sample(np.linspace(0.0, span, 800))
        return trajectory if report.frame is None else replace(trajectory, frame=report.frame)

    def content(self, report: QuantumRotorReport, samples: Samples, surface: Surface | None) -> PageContent:
        """Return the body, the sphere of the levels' polhodes and, up to J = 60, the Wigner function."""
        directions, above = _polhodes(report)
        families = [
            {"starts": directions[chosen].tolist(), "axis": axis,
             "legend": ["levels round {axis}", {"axis": "abc"[axis]}]}
            for chosen, axis in ((above, 0), (~above, 2)) if chosen.any()
        ]
        axes = ["a", "b", "c"]
        sphere = {
            "type": "sphere", "title": ["Levels of J = {J} as polhodes", {"J": report.J}], "families": families,
            "axes": axes, "words": "drag the point to another level, or L", "legend": "",
        }  # fmt: skip
        panels = [*(panel | {"axes": axes} for panel in body_panels(samples, _moments(report), surface)), sphere]
        if report.J <= LIMITS.max_j:
            panels.append({"type": "wigner"})
        panels[0] |= {"azimuth": 0.89, "elevation": 0.51}  # a, b and c are all visible, and the saddle at b
        units = {"energy": [constants.h * WAVE_NUMBER, "cm⁻¹"], "momentum": [constants.hbar, "ħ"]}
        words = {"axes": axes, "units": units}
        return PageContent(panels, model=_model(report, directions), solved=True, words=words)


PANEL = QuantumRotorPanel()

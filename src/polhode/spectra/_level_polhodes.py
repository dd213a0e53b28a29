"""The levels of one J next to the classical motion on their polhodes.

Levels J_{K, J−K} and J_{K, J−K+1} are two ladders. Along each, next levels lie 2π/T apart in the middle between them:
classical L goes round its polhode at the quantum frequency. Only at the saddle, where T is infinite, do
levels stay apart.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from polhode.spectra._orbits import orbit
from polhode.spectra.rotor import Rotor, equal_constants
from polhode.spectra.semiclassics import LIMITS, are_above, doublet_splitting, quantise, without_casimir
from polhode.types import Array, Bool, Float64, Integer


class LevelPolhodes(NamedTuple):
    """Levels of a J of a rigid asymmetric rotor, ascending; each (2J+1,), energies as E/h in the unit of the constants.

    Attributes:
        Ka, Kc: quantum numbers.
        energy: exact.
        semiclassical: by quantised polhodes.
        above: whether the polhode goes round the a axis, above the saddle, and not round the c axis.
        step: to the next level of its ladder; NaN for the last.
        classical_step: 2π/T of the polhode at the energy between them, NaN where there is none.
        splitting: of the pair that tunnelling splits, from the barrier.
        saddle: B (J + ½)² less d/4, where levels share d J(J + 1), ().
    """

    Ka: Integer[Array, "n"]
    Kc: Integer[Array, "n"]
    energy: Float64[Array, "n"]
    semiclassical: Float64[Array, "n"]
    above: Bool[Array, "n"]
    step: Float64[Array, "n"]
    classical_step: Float64[Array, "n"]
    splitting: Float64[Array, "n"]
    saddle: float


def level_directions(
    constants: tuple[float, float, float], J: int, energy: Float64[Array, "n"]
) -> Float64[Array, "n 3"]:
    """Return where polhodes cross the plane of a and c (n, 3), unit vectors along a, b, c.

    Args:
        constants: A > B > C.
        J: whose |L| is J + ½.
        energy: (n,) E/h of quantised polhodes, as exact ones of nearly symmetric molecules may lie below C |L|².
    """
    (A, _, C), d = without_casimir(constants)
    # u = E/G² = A sin²χ + C cos²χ in the plane of a and c
    square = np.clip((A - (energy - d * J * (J + 1.0)) / (J + 0.5) ** 2) / (A - C), 0.0, 1.0)  # cos² of the angle to c
    return np.stack([np.sqrt(1.0 - square), np.zeros(len(square)), np.sqrt(square)], axis=-1)


def _have_polhodes(constants: tuple[float, float, float]) -> bool:
    A, _, C = constants
    return math.isfinite(A) and C > 0.0 and not equal_constants(constants)


def find_above(constants: tuple[float, float, float], j_max: int) -> Bool[Array, "levels"] | None:
    """Return ``above`` of the levels with J from 1 to ``j_max``, J by J; None of a symmetric or linear molecule.

    Args:
        constants: A ≥ B ≥ C, in any unit of energy.
        j_max: a whole number.
    """
    return are_above(without_casimir(constants)[0], j_max) if _have_polhodes(constants) else None


def level_polhodes(constants: tuple[float, float, float], J: int) -> LevelPolhodes | None:
    """Return the levels of one J with their polhodes; None of a symmetric or linear molecule, or J = 0.

    A multiple of |L|² taken out of H leaves the polhodes alone, and shifts all levels by that multiple of J(J + 1).

    Args:
        constants: A ≥ B ≥ C, in any unit of energy.
        J: a whole number.
    """
    if not _have_polhodes(constants) or J == 0:
        return None
    G, (rest, d) = J + 0.5, without_casimir(constants)
    shared = d * J * (J + 1.0)
    exact = Rotor(rest).levels_of(J)
    energies, _, _ = quantise(rest, J, 2 if J >= LIMITS.min_second_order_j else 1)
    step = np.full(2 * J + 1, np.nan)
    step[:-2] = exact.energy[2:] - exact.energy[:-2]  # the ladders alternate
    between = exact.energy[:-2] + 0.5 * step[:-2]
    classical = np.full(2 * J + 1, np.nan)
    off = (between != rest[1] * G * G) & (between > rest[2] * G * G) & (between < rest[0] * G * G)
    classical[:-2][off] = 2.0 * math.pi / orbit(rest, G, between[off]).period
    return LevelPolhodes(
        exact.Ka, exact.Kc, exact.energy + shared, energies + shared, energies > rest[1] * G * G, step, classical,
        doublet_splitting(rest, J, energies), rest[1] * G * G + shared,
    )

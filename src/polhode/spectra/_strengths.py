"""Dipole lines of a rotor: frequencies, strengths, intensities, Einstein coefficients.

S_g = (2J+1) |Σ a_K a'_{K+q} w_q ⟨J K 1 q|J' K+q⟩|², summed over all upper states 2J + 1. Source: Gordy & Cook,
*Microwave Molecular Spectra*, ch. 2 and 7; Pickett et al., J. Quant. Spectrosc. Radiat. Transfer 60 (1998) 883 for
intensities.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from scipy import constants

from polhode.spectra import _wang as wang
from polhode.spectra._operators import Representation, Term
from polhode.types import Array, Float64, Integer

DEBYE = 1e-21 / constants.c  # C m
# of an integrated cross section [m² Hz] and of an Einstein coefficient [1/s], with S μ² in (C m)²
# ∫σ dν = 8π³/(3hc) · 1/(4πε₀) · ν S μ² w e^{−E″/kT} (1 − e^{−hν/kT})/Q, and A = 64π⁴ν³/(3hc³) · 1/(4πε₀) · S
# μ²/(2J′ + 1)
INTENSITY = 2.0 * math.pi**2 / (3.0 * constants.epsilon_0 * constants.h * constants.c)
EINSTEIN = 16.0 * math.pi**3 / (3.0 * constants.epsilon_0 * constants.h * constants.c**3)
RULES = {"a": (0, 1), "b": (1, 1), "c": (1, 0)}
"""Change of K_a and K_c, even or odd, in lines of each component of the dipole."""
ROUNDING = 16.0 * float(np.finfo(float).eps)  # of amplitudes and of energies


class Lines(NamedTuple):
    """Absorption lines, by frequency; each array (n,).

    Attributes:
        upper, lower: (n, 3) J, K_a, K_c.
        frequency: [Hz].
        strength: Σ_g S_g μ_g² [C² m²].
        lower_energy: E″/h [Hz].
        weight: statistical weight of the nuclear spins.
        intensity: integrated cross section [m² Hz] at the temperature; nm² MHz times 1e-12. NaN without temperature.
        einstein: A of spontaneous emission [1/s].
    """

    upper: Integer[Array, "n 3"]
    lower: Integer[Array, "n 3"]
    frequency: Float64[Array, "n"]
    strength: Float64[Array, "n"]
    lower_energy: Float64[Array, "n"]
    weight: Float64[Array, "n"]
    intensity: Float64[Array, "n"]
    einstein: Float64[Array, "n"]


class States(NamedTuple):
    """A J's levels with states in |J, K⟩, K from −J to J along the first axis: (2J+1, 2J+1)."""

    Ka: Integer[Array, "n"]
    Kc: Integer[Array, "n"]
    energy: Float64[Array, "n"]
    vectors: Float64[Array, "n n"]


def compute_states(terms: list[tuple[float, Term]], J: int, representation: Representation) -> States:
    """Return levels and states of one J, by label."""
    parts = []
    for block in wang.blocks(J):
        values, states = wang.eigenvectors(wang.band(terms, J, block))
        labels = wang.labels(J, block, representation)
        whole, K = np.zeros((2 * J + 1, len(values))), block.K.astype(int)
        for k, row in zip(K, states, strict=True):
            if k:
                whole[J + k], whole[J - k] = math.sqrt(0.5) * row, block.sign * math.sqrt(0.5) * row
            else:
                whole[J] = row
        parts.append((*labels, values, whole))
    Ka, Kc, energy, vectors = (np.concatenate(column, axis=-1) for column in zip(*parts, strict=True))
    order = np.lexsort((-Kc, Ka))
    return States(Ka[order], Kc[order], energy[order], vectors[:, order])


def strengths(
    low: States, high: States, dipole: Float64[Array, "3"], representation: Representation
) -> Float64[Array, "n m"]:
    """Return Σ_g S_g μ_g² (n, m) from each state of one J to each of J or J + 1."""
    J, above = (len(low.Ka) - 1) // 2, (len(high.Ka) - 1) // 2
    K = np.arange(-J, J + 1)
    total = np.zeros((len(low.Ka), len(high.Ka)))
    for axis, component in zip("abc", dipole, strict=True):
        if not component:
            continue
        moment = np.zeros_like(total)
        for q, weight in _components("xyz"[representation.value.index(axis)]):
            inside = np.abs(K + q) <= above
            # ⟨upper|Φ_q|lower⟩ = Σ_K a_K a′_{K+q} ⟨J K 1 q|J′ K+q⟩, but for factors of J that the strength takes in
            raised = high.vectors[(K + q)[inside] + above]
            moment += weight * (low.vectors[inside] * clebsch_gordan(J, K[inside], q, above)[:, None]).T @ raised
        odd_a, odd_c = RULES[axis]
        allowed = ((low.Ka[:, None] - high.Ka) % 2 == odd_a) & ((low.Kc[:, None] - high.Kc) % 2 == odd_c)
        total += np.where(allowed, (2 * J + 1) * (component * moment) ** 2, 0.0)
    return total


def _components(axis: str) -> list[tuple[int, float]]:
    """Return the spherical components q of a direction cosine, and their weights, without a common phase."""
    # direction cosines as spherical components: x = (Φ₋₁ − Φ₊₁)/√2, y = i(Φ₋₁ + Φ₊₁)/√2, z = Φ₀
    half = math.sqrt(0.5)
    return {"z": [(0, 1.0)], "x": [(-1, half), (1, -half)], "y": [(-1, half), (1, half)]}[axis]


def clebsch_gordan(J: int, K: Integer[Array, "k"], q: int, above: int) -> Float64[Array, "k"]:
    """Return ⟨J K 1 q | J' K+q⟩ for J' = J or J + 1: Varshalovich, Moskalev & Khersonskii, table 8.2."""
    K = K.astype(float)
    if above == J + 1:
        if q == 0:
            return np.sqrt((J - K + 1) * (J + K + 1) / ((2 * J + 1) * (J + 1)))
        return np.sqrt((J + q * K + 1) * (J + q * K + 2) / ((2 * J + 1) * (2 * J + 2)))
    if J == 0:
        return np.zeros_like(K)
    if q == 0:
        return K / math.sqrt(J * (J + 1.0))
    return -q * np.sqrt((J - q * K) * (J + q * K + 1) / (2.0 * J * (J + 1)))


def lines_between(
    low: States, high: States, dipole: Float64[Array, "3"], representation: Representation
) -> tuple[Integer[Array, "n 3"], Integer[Array, "n 3"], Float64[Array, "n"], Float64[Array, "n"], Float64[Array, "n"]]:
    """Return upper and lower labels, frequencies, strengths and lower energies of all lines between two J."""
    J, above = (len(low.Ka) - 1) // 2, (len(high.Ka) - 1) // 2
    strength = strengths(low, high, dipole, representation)
    if J == above:
        strength = np.triu(strength)  # each pair once
    # rounding: for symmetric tops forbidden strengths and equal energies do not come out as exactly zero
    allowed = strength > (2 * J + 1) * (ROUNDING**2 * np.dot(dipole, dipole))
    apart = np.abs(high.energy - low.energy[:, None]) > ROUNDING * np.abs(high.energy).max()
    i, k = np.nonzero(allowed & apart)
    one = np.column_stack([np.full(len(i), J), low.Ka[i], low.Kc[i]])
    other = np.column_stack([np.full(len(k), above), high.Ka[k], high.Kc[k]])
    difference = high.energy[k] - low.energy[i]
    up = (difference >= 0.0)[:, None]
    upper, lower = np.where(up, other, one), np.where(up, one, other)
    return upper, lower, np.abs(difference), strength[i, k], np.minimum(low.energy[i], high.energy[k])

"""Coefficients of real functions on the sphere, where f_{l,−m} = (−1)^m f̄_lm: checked, random, by degree, on maps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.special import sph_harm_y

from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Complex128, Float64, Real


def checked_coefficients(n: int, coefficients: Any, name: str = "coefficients") -> Complex128[np.ndarray, "n n"]:
    """Return f_lm (N, N), l by rows, from (l, m) → f_lm or from such an array.

    Raises:
        InvalidInput: for degrees and orders outside, f_l0 that are not real, or values that are not finite.
    """
    if isinstance(coefficients, dict):
        table = np.zeros((n, n), complex)
        for place, value in coefficients.items():
            pair = isinstance(place, tuple) and len(place) == 2
            if not (pair and 1 <= place[0] < n and 0 <= place[1] <= place[0]):
                raise InvalidInput(f"`{name}` must be by (l, m) with 1 ≤ l < {n} and 0 ≤ m ≤ l; got {shown(place)}.")
            table[place] = value
    else:
        table = np.array(coefficients, complex)
    if table.shape != (n, n) or not np.isfinite(table).all():
        raise InvalidInput(f"`{name}` must be finite, of shape ({n}, {n}); got shape {table.shape}.")
    if np.imag(table[:, 0]).any() or table[0].any():
        raise InvalidInput(f"`{name}` must be real for m = 0, and none for l = 0: the function has no mean.")
    return table


def checked_energies(n: int, spectrum: Real[ArrayLike, "degrees"], name: str = "spectrum") -> np.ndarray:
    """Return energies by degree (k,) k ≤ N.

    Raises:
        InvalidInput: for energies that are negative or not finite, or too many of them.
    """
    wanted = np.asarray(spectrum, float)
    if wanted.ndim != 1 or len(wanted) > n or not (np.isfinite(wanted).all() and (wanted >= 0).all()):
        raise InvalidInput(f"`{name}` must be at most {n} energies, not negative; got {shown(spectrum)}.")
    return wanted


def random_coefficients(
    n: int, energies: np.ndarray, weights: np.ndarray, rng: np.random.Generator
) -> Complex128[np.ndarray, "n n"]:
    """Return f_lm (N, N) of random phases with ½ w_l Σ_m |f_lm|² as given by degree, l = 0 left out."""
    table = np.zeros((n, n), complex)
    for degree in range(1, len(energies)):
        row = rng.normal(size=degree + 1) + 1j * rng.normal(size=degree + 1) * (np.arange(degree + 1) > 0)
        # f_{l,−m} = (−1)^m f̄_lm doubles every order m > 0 in Σ_m |f_lm|²
        energy = 0.5 * weights[degree] * (row[0].real ** 2 + 2.0 * np.sum(np.abs(row[1:]) ** 2))
        table[degree, : degree + 1] = row * math.sqrt(energies[degree] / energy)
    return table


def inverse_squares(n: int) -> Float64[np.ndarray, "n"]:
    """Return 1/(l(l+1)) for l = 0, …, N − 1, and 0 for l = 0: the weights of vorticity in the kinetic energy."""
    degree = np.arange(n)
    return 1.0 / np.where(degree > 0, degree * (degree + 1.0), np.inf)


def on_map(
    coefficients: Complex128[Array, "*batch n n"], colatitude: Real[ArrayLike, "rows"],
    azimuth: Real[ArrayLike, "columns"],
) -> Float64[np.ndarray, "*batch rows columns"]:
    """Return functions (…, rows, columns) at colatitudes and azimuths [rad]."""
    f = np.asarray(coefficients)
    theta, phi = np.asarray(colatitude, float), np.asarray(azimuth, float)
    n = f.shape[-1]
    degree = np.arange(n)
    total = np.zeros((*f.shape[:-2], len(theta), len(phi)))
    for m in range(n):
        # Σ_m f_lm Y_lm = f_l0 Y_l0 + 2 Re Σ_{m>0} f_lm Y_lm, the sum over l first
        along = f[..., m:, m] @ sph_harm_y(degree[m:, None], m, theta[None, :], 0.0)
        waves = along[..., None] * np.exp(1j * m * phi)
        total += (1.0 if m == 0 else 2.0) * waves.real
    return total

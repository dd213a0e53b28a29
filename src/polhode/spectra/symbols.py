"""Functions on the sphere that represent operators on a spin: Weyl's (Wigner's), Q and P.

Source: Stratonovich, Sov. Phys. JETP 4 (1957) 891; Várilly & Gracia-Bondía, Ann. Phys. 190 (1989) 107; Varshalovich,
Moskalev & Khersonskii, *Quantum Theory of Angular Momentum* (1988), §2.4, for the tensors.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.special import gammaln, sph_harm_y_all

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput
from polhode.special._spherical_tensors import spherical_tensor
from polhode.spectra.spin import unit_vectors
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

KINDS = {"q": -1.0, "weyl": 0.0, "p": 1.0}


@known_numbers_only
def symbol_coefficients(operator: Real[ArrayLike, "n n"], kind: str = "weyl") -> Complex128[Array, "n orders"]:
    """Return the coefficients of spherical harmonics Y_kq (2s+1, 4s+1) of an operator's symbol, column 2s + q.

    Args:
        operator: (2s+1, 2s+1), rows and columns from m = s down.
        kind: "weyl" for Weyl's symbol, on states Wigner's function; "q" for the expectation in coherent states; "p" for
            the weight of coherent states, which grows without bound with k.

    Raises:
        InvalidInput: for a matrix that is not square or not finite, or another kind.
    """
    require_doubles(operator=operator)
    A = np.asarray(operator, complex)
    if A.ndim != 2 or A.shape[0] != A.shape[1] or not A.size or not np.isfinite(A).all():
        raise InvalidInput(f"`operator` must be a finite square matrix (2s+1, 2s+1); got shape {A.shape}.")
    check.one_of("kind", kind, KINDS)
    n = len(A)
    s = 0.5 * (n - 1)
    k = np.arange(n)
    size = math.sqrt(4.0 * math.pi / n) * np.exp(-KINDS[kind] * _log_weights(n, k))
    coefficients = np.zeros((n, 2 * n - 1), complex)
    for q in range(n):
        rows = spherical_tensor(s, q)
        # tr A T†, of T_kq and of T_{k,−q} = (−1)^q T_kq†
        coefficients[q:, n - 1 + q] = rows @ np.diagonal(A, q)
        coefficients[q:, n - 1 - q] = (-1.0) ** q * (rows @ np.diagonal(A, -q))
    return size[:, None] * coefficients


def pole_values(s: float) -> Float64[Array, "n"]:
    """Return the Wigner functions (2s+1,) of |m⟩, m = s, s − 1, …, at the pole: the kernel there is diagonal.

    Args:
        s: of the spin.
    """
    rows = spherical_tensor(s, 0)
    return np.sqrt((2.0 * np.arange(len(rows)) + 1.0) / len(rows)) @ rows


def _log_weights(n: int, k: Array) -> Array:
    """Return ln C_k, C_k = (2s)! √((2s+1)/((2s−k)! (2s+k+1)!))."""
    # C_k = √((2s+1)/(2k+1)) ⟨s|T_k0|s⟩, by which the expectation of T_kq in coherent states falls short of its Weyl
    # symbol (Várilly & Gracia-Bondía 1989)
    return gammaln(n) + 0.5 * (math.log(n) - gammaln(n - k) - gammaln(n + k + 1.0))


@known_numbers_only
def symbol(
    operator: Real[ArrayLike, "n n"], directions: Real[ArrayLike, "*batch 3"], kind: str = "weyl"
) -> Complex128[Array, "*batch"]:
    """Return an operator's symbol at directions (…): Weyl's of a state is its Wigner function; 1 is the symbol of 1.

    (2s+1)/4π ∫ W_A W_B = tr AB, and likewise ∫ Q_A P_B. Work grows as s³ and with the directions as s².

    Args:
        operator: (2s+1, 2s+1), rows and columns from m = s down.
        directions: (…, 3), normalised here.
        kind: "weyl", "q" or "p", as for ``symbol_coefficients``.

    Raises:
        InvalidInput: for a matrix that is not square or not finite, directions that are zero, or another kind.

    >>> from polhode.spectra import spin_matrices
    >>> round(float(symbol(spin_matrices(1.5)[2], (0.0, 0.0, 1.0), "q").real), 12)
    1.5
    """
    require_doubles(directions=directions)
    n = unit_vectors("directions", directions)
    coefficients = symbol_coefficients(operator, kind)
    theta, phi = np.arctan2(np.hypot(n[..., 0], n[..., 1]), n[..., 2]), np.arctan2(n[..., 1], n[..., 0])
    return sum_harmonics(coefficients, theta, phi)


def sum_harmonics(coefficients: Array, colatitude: Array, azimuth: Array) -> Complex128[Array, "..."]:
    """Return Σ c_kq Y_kq at angles that broadcast, those of a grid as (n, 1) and (1, m), which is quickest.

    Args:
        coefficients: of ``symbol_coefficients``.
        colatitude, azimuth: [rad].
    """
    count = len(coefficients)
    orders = np.concatenate([np.arange(count), np.arange(1 - count, 0)])  # as SciPy lists them
    harmonics = sph_harm_y_all(count - 1, count - 1, colatitude, 0.0)
    along = np.einsum("kq,kq...->...q", coefficients[:, count - 1 + orders], harmonics)
    around = np.exp(1j * np.multiply.outer(azimuth, orders))
    if along.ndim == 3 and along.shape[1] == around.shape[0] == 1:
        return along[:, 0] @ around[0].T
    return (along * around).sum(axis=-1)

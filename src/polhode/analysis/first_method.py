"""Lyapunov's first method: stability by the exponents of the linearised flow."""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.analysis._reasons import Exponents, LeafIsPoint
from polhode.analysis.energy_casimir import Stability
from polhode.types import ArrayLike, Real


@known_numbers_only
def first_method(
    linearization: Real[ArrayLike, "n n"], basis: Real[ArrayLike, "n k"] | None = None, tolerance: float = 1e-12
) -> Stability:
    """Return the verdict on an equilibrium from the derivative of any vector field there.

    Exponents with negative real parts throughout prove stability, asymptotic on the given directions; one with a
    positive real part disproves it. Between the two the derivative alone decides nothing.

    Args:
        linearization: (n, n) [1/s].
        basis: (n, k) orthonormal directions that the flow keeps, as those within a leaf; all if left out.
        tolerance: relative error of the entries.

    Source: Lyapunov 1892; Khalil, *Nonlinear Systems*, theorem 4.7.
    """
    A = np.asarray(linearization, dtype=float)
    basis = np.eye(len(A)) if basis is None else np.asarray(basis)
    inner = basis.T @ A @ basis
    if not inner.size:
        return Stability("stable", 0.0, None, None, LeafIsPoint(), np.zeros(0, complex))
    from scipy.linalg import eig

    eigensystem: Any = eig(inner, left=True, right=True)
    spectrum, left, right = eigensystem
    alignment = np.abs(np.einsum("ik,ik->k", left.conj(), right))
    unsure = tolerance * np.abs(inner).max() / np.maximum(alignment, np.finfo(float).tiny)
    k = int(np.argmax(spectrum.real))
    rate = float(spectrum[k].real)
    reason = Exponents(rate, float(unsure[k]), bool((spectrum.real < -unsure).all()))
    if rate > unsure[k]:
        mode = right[:, k] * np.exp(-1j * np.angle(right[np.argmax(np.abs(right[:, k])), k]))
        direction = basis @ mode.real
        return Stability("unstable", rate, "exponential", direction / np.linalg.norm(direction), reason, spectrum)
    if reason.all_negative:
        return Stability("stable", rate, None, None, reason, spectrum)
    return Stability("undecided", 0.0, None, None, reason, spectrum)

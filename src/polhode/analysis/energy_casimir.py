"""Stability of an equilibrium of a Lie–Poisson system, by the energy–Casimir method and by the spectrum.

An equilibrium is a critical point of H + Σ λ_k C_k. If the second variation of that function is definite on the
tangent space of the leaf (the common level of the Casimirs), the function itself confines every motion that starts
near: that is the certificate. If the linearised flow on the leaf has an exponent with positive real part, its mode
shows how neighbours leave. Between the two the matrices alone decide nothing, and that is said.

Source: Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1; Marsden & Ratiu, *Introduction to Mechanics and
Symmetry*, §1.7 and §15.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from polhode.errors import InvalidInput

Array = Any
EQUILIBRIUM_TOLERANCE = 1e-8  # what may be left of dH + Σ λ dC, relative to dH


@dataclass(frozen=True)
class Stability:
    """A verdict with its certificate.

    Attributes:
        verdict: "stable", "unstable" or "undecided".
        rate: largest real part of an exponent of the linearised flow on the leaf [1/s].
        growth: "exponential", "linear", or None for a verdict that is not "unstable".
        direction: (n,) unit direction in which neighbours leave, or None.
        certificate: the function that proves stability, the growth that disproves it, or why neither is known.
        spectrum: exponents of the linearised flow on the leaf [1/s], complex.
    """

    verdict: str
    rate: float
    growth: str | None
    direction: Array | None
    certificate: str
    spectrum: Array


def energy_casimir(
    linearization: Array,
    energy_gradient: Array,
    energy_hessian: Array,
    casimir_gradients: Array,
    casimir_hessians: Array,
    casimir_names: Sequence[str] = (),
    on_equilibria: bool = False,
    tolerance: float = 1e-10,
) -> Stability:
    """Return the verdict on an equilibrium from the matrices there; one scale of state, energy and time throughout.

    Args:
        linearization: (n, n) derivative of the vector field [1/s].
        energy_gradient: (n,) dH.
        energy_hessian: (n, n) D²H.
        casimir_gradients: (k, n) dC_k; other conserved quantities may stand among them if their gradients depend on
            the Casimirs' here, and the freedom this leaves is used.
        casimir_hessians: (k, n, n) D²C_k.
        casimir_names: what to call the Casimirs in the certificate; C1, C2, … if empty.
        on_equilibria: whether every null direction of the second variation on the leaf is known to be tangent to a
            family of equilibria on it. Then a shear along it moves neighbours away at a steady rate.
        tolerance: what counts as zero, relative to the largest entry of the matrix in question. Zero for matrices
            whose entries are exact to their last digit.

    Raises:
        InvalidInput: for shapes that do not match, values that are not finite, or a point that is no equilibrium.
    """
    A, g, H = (np.asarray(x, dtype=float) for x in (linearization, energy_gradient, energy_hessian))
    n = g.size
    dC = np.asarray(casimir_gradients, dtype=float).reshape(-1, n)
    ddC = np.asarray(casimir_hessians, dtype=float).reshape(-1, n, n)
    _check(A, g, H, dC, ddC)
    names = list(casimir_names) or [f"C{k + 1}" for k in range(len(dC))]
    leaf = _null_space(dC, n)
    on_leaf = leaf.T @ H @ leaf, np.einsum("ia,kij,jb->kab", leaf, ddC, leaf)
    multipliers = _multipliers(g, dC, *on_leaf)
    second = on_leaf[0] + np.einsum("k,kij->ij", multipliers, on_leaf[1])
    flow = leaf.T @ A @ leaf
    found: Any = np.linalg.eig(flow) if leaf.shape[1] else (np.zeros(0, complex), np.zeros((0, 0)))
    spectrum, modes = found
    function = _function(multipliers, names)
    curvatures = np.linalg.eigvalsh(second) if leaf.shape[1] else np.zeros(0)
    zero = tolerance * np.abs(second).max(initial=0.0)
    positive, negative = int((curvatures > zero).sum()), int((curvatures < -zero).sum())
    rate = float(spectrum.real.max(initial=0.0))
    noise = tolerance * np.abs(flow).max(initial=0.0)

    if max(positive, negative) == curvatures.size:
        sign = "positive" if positive or not curvatures.size else "negative"
        shown = ", ".join(f"{x:.6g}" for x in curvatures)
        text = f"{function} has a {sign} definite second variation on the leaf (curvatures {shown})"
        return Stability("stable", 0.0, None, None, text, spectrum)
    if rate > max(noise, 0.0):
        k = int(np.argmax(spectrum.real))
        way = _unit(leaf @ modes[:, k].real)
        text = f"the linearised flow on the leaf grows as exp({rate:.6g} t) along ({_shown(way)})"
        return Stability("unstable", rate, "exponential", way, text, spectrum)
    if on_equilibria and not (positive and negative):
        return _on_equilibria(leaf, flow, noise, function, spectrum)
    why = (
        f"the second variation of {function} on the leaf is "
        + ("indefinite" if positive and negative else "degenerate")
        + " while no exponent has a positive real part; higher orders decide"
    )
    return Stability("undecided", 0.0, None, None, why, spectrum)


def _on_equilibria(leaf: Array, flow: Array, noise: float, function: str, spectrum: Array) -> Stability:
    """Judge a semidefinite second variation whose null directions are tangent to equilibria."""
    if np.abs(flow).max(initial=0.0) <= noise:
        text = f"every neighbour on the leaf is an equilibrium, as {function} is constant there"
        return Stability("stable", 0.0, None, None, text, spectrum)
    left, shear, _ = np.linalg.svd(flow)
    way = _unit(leaf @ left[:, 0])
    text = f"neighbours leave at a steady rate along ({_shown(way)}), {shear[0]:.6g}/s times their distance"
    return Stability("unstable", 0.0, "linear", way, text, spectrum)


def _check(A: Array, g: Array, H: Array, dC: Array, ddC: Array) -> None:
    n = g.size
    if g.ndim != 1 or A.shape != (n, n) or H.shape != (n, n) or len(dC) != len(ddC):
        raise InvalidInput(
            f"shapes must match: dH (n,), D²H (n, n), linearisation (n, n), one gradient and Hessian a Casimir; "
            f"got {g.shape}, {H.shape}, {A.shape}, {len(dC)} and {len(ddC)}."
        )
    if not all(np.isfinite(x).all() for x in (A, g, H, dC, ddC)):
        raise InvalidInput("the matrices at the equilibrium must be finite; got NaN or an infinity.")


def _multipliers(g: Array, dC: Array, energy: Array, casimirs: Array) -> Array:
    """Return λ with dH + Σ λ dC = 0; where several do, the one whose second variation is the most definite."""
    if not len(dC):
        multipliers, rest, free = np.zeros(0), g, np.zeros((0, 0))
    else:
        multipliers = np.linalg.lstsq(dC.T, -g, rcond=1e-12)[0]
        rest = g + dC.T @ multipliers
        free = _null_space(dC.T, len(dC))
    if np.linalg.norm(rest) > EQUILIBRIUM_TOLERANCE * np.linalg.norm(g):
        raise InvalidInput(
            "the point is not an equilibrium: dH is not a combination of the dC there, "
            f"{np.linalg.norm(rest):.3g} of {np.linalg.norm(g):.3g} is left. Solve for the equilibrium first."
        )
    if not free.size or not energy.size:
        return multipliers
    return _most_definite(multipliers, free, energy, casimirs)


def _most_definite(multipliers: Array, free: Array, energy: Array, casimirs: Array) -> Array:
    """Search the freedom for a definite second variation; its least eigenvalue is a concave function of the freedom."""
    from scipy.optimize import minimize

    base = energy + np.einsum("k,kij->ij", multipliers, casimirs)
    ways = np.einsum("km,kij->mij", free, casimirs)
    size = np.abs(base).max() / (np.abs(ways).max() or 1.0)
    best, found = 0.0, multipliers
    for sign in (1.0, -1.0):

        def worst(z: Array, sign: float = sign) -> float:
            return -float(np.linalg.eigvalsh(sign * (base + size * np.einsum("m,mij->ij", z, ways)))[0])

        options = {"xatol": 1e-13, "fatol": 1e-15 * np.abs(base).max(), "maxiter": 2000 * free.shape[1]}
        run = minimize(worst, np.zeros(free.shape[1]), method="Nelder-Mead", options=options)
        if -run.fun > best:
            best, found = -run.fun, multipliers + size * free @ run.x
    return found


def _null_space(dC: Array, n: int) -> Array:
    """Return an orthonormal basis (n, d) of the leaf's tangent space; coordinate vectors where the leaf allows."""
    if not len(dC):
        return np.eye(n)
    used = np.abs(dC).max(axis=0) > 0
    free = np.eye(n)[:, ~used]
    _, sizes, rows = np.linalg.svd(dC[:, used])
    rank = int((sizes > 1e-12 * sizes.max(initial=0.0)).sum())
    rest = np.zeros((n, int(used.sum()) - rank))
    rest[used] = rows[rank:].T
    return np.hstack([free, rest])


def _function(multipliers: Array, names: list[str]) -> str:
    terms = zip(multipliers, names, strict=True)
    return "H" + "".join(f" {'+' if m >= 0 else '−'} {abs(m):.6g} {name}" for m, name in terms)


def _unit(vector: Array) -> Array:
    largest = vector[np.argmax(np.abs(vector))]
    return vector / (np.linalg.norm(vector) * (np.sign(largest) or 1.0)) + 0.0


def _shown(vector: Array) -> str:
    return ", ".join(f"{x:.4g}" for x in vector)

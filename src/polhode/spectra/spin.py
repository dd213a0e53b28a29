"""Spin matrices, coherent states and their evolution.

Index 0 is m = +s. ħ = 1; S obeys the plus bracket's commutators [S_x, S_y] = i S_z, those of a spin. The angular
momentum along a body's own axes obeys the minus bracket's, [L_x, L_y] = −i L_z, as its Poisson bracket does: it is −S
or the complex conjugate of S. Even Hamiltonians have equal levels in either.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput, shown
from polhode.special._spherical_tensors import magnetic_numbers
from polhode.types import Array, ArrayLike, Complex128, Float64, Real


class SpinLimits(NamedTuple):
    """Limits of dense matrices.

    Attributes:
        max_spin: its matrices take 3 GB.
    """

    max_spin: float = 4000.0


LIMITS = SpinLimits()


@known_numbers_only
def spin_matrices(s: float) -> Complex128[Array, "3 n n"]:
    """Return S_x, S_y, S_z (3, 2s+1, 2s+1) of a spin, [S_x, S_y] = i S_z, rows and columns from m = s down to −s.

    Args:
        s: 0, 1/2, 1, …

    Raises:
        InvalidInput: for a spin that is not half a whole number, or too large.

    >>> x, y, z = spin_matrices(1)
    >>> bool(np.allclose(x @ y - y @ x, 1j * z)), np.diag(z).real.tolist()
    (True, [1.0, 0.0, -1.0])
    """
    m = magnetic_numbers(s)
    if s > LIMITS.max_spin:
        raise InvalidInput(f"`s` must be at most {LIMITS.max_spin:g} for dense matrices; got {shown(s)}.")
    # S_x = ½(S₊ + S₋), S_y = −½i(S₊ − S₋)
    up = np.diag(raising_elements(s, m[1:]), 1)
    return np.array([0.5 * (up + up.T), -0.5j * (up - up.T), np.diag(m)])


def raising_elements(s: float, m: Float64[Array, "k"]) -> Float64[Array, "k"]:
    """Return ⟨m+1|S₊|m⟩ = √((s−m)(s+m+1)), the product form, which does not cancel."""
    return np.sqrt((s - m) * (s + m + 1.0))


@known_numbers_only
def coherent_state(s: float, direction: Real[ArrayLike, "*batch 3"]) -> Complex128[Array, "*batch n"]:
    """Return e^{−iφS_z} e^{−iθS_y} |s, s⟩ (…, 2s+1): the state that points along a direction, ⟨S⟩ = s n.

    Args:
        s: 0, 1/2, 1, …
        direction: (…, 3), normalised here.

    Raises:
        InvalidInput: for an invalid spin, or directions that are zero or not finite.

    >>> state = coherent_state(2, (1.0, 0.0, 0.0))
    >>> np.einsum("i,kij,j->k", state.conj(), spin_matrices(2), state).real.round(12).tolist()
    [2.0, 0.0, 0.0]

    Source: Perelomov, *Generalized Coherent States*, §4.3.
    """
    require_doubles(direction=direction)
    m = magnetic_numbers(s)
    n = unit_vectors("direction", direction)
    # cos²(θ/2) and sin²(θ/2), the smaller one from sin θ: 1 − cos θ would cancel
    smaller = 0.5 * (n[..., 0] ** 2 + n[..., 1] ** 2) / (1.0 + np.abs(n[..., 2]))
    up, down = (np.where(n[..., 2] < 0.0, *pair) for pair in ((smaller, 1.0 - smaller), (1.0 - smaller, smaller)))
    # |⟨m|n⟩|² = C(2s, s+m) cos^(2(s+m))(θ/2) sin^(2(s−m))(θ/2): the binomial distribution of s + m
    size = np.sqrt(_binomial(round(2.0 * s), up, down))[..., ::-1]
    return size * np.exp(-1j * m * np.arctan2(n[..., 1], n[..., 0])[..., None])


def _binomial(
    n: int, share: Float64[Array, "*batch"], other: Float64[Array, "*batch"]
) -> Float64[Array, "*batch {n}+1"]:
    """Return the probabilities of 0, 1, …, n successes, each with probability ``share``, 1 − share being ``other``.

    They are products of ratios of next ones from the most likely one on, and then made to sum to one. SciPy's package
    of distributions takes longer to import than a report's figures to draw.
    """
    count, share, other = np.arange(1, n + 1), np.asarray(share)[..., None], np.asarray(other)[..., None]
    likeliest = np.minimum(np.floor((n + 1) * share), n)
    with np.errstate(divide="ignore"):
        ratios = (n - count + 1.0) / count * share / other  # of `count` successes to one less
        after, before = np.where(count > likeliest, ratios, 1.0), np.where(count > likeliest, 1.0, 1.0 / ratios)
    one = np.ones_like(share)
    rising = np.concatenate([one, np.cumprod(after, axis=-1)], axis=-1)
    falling = np.concatenate([np.cumprod(before[..., ::-1], axis=-1)[..., ::-1], one], axis=-1)
    return rising * falling / (rising * falling).sum(axis=-1, keepdims=True)


def unit_vectors(name: str, vectors: Any) -> Float64[Array, "*batch 3"]:
    """Return vectors (…, 3) at unit length.

    Raises:
        InvalidInput: for another shape, zero, or values that are not finite.
    """
    values = check.array(name, vectors, ("…", 3))
    largest = np.abs(values).max(axis=-1, keepdims=True)
    if not (largest > 0.0).all():
        raise InvalidInput(f"`{name}` must not be zero; got {shown(vectors)}.")
    values = values / largest
    return values / np.linalg.norm(values, axis=-1, keepdims=True)


@known_numbers_only
def orbit_radius(s: float, convention: str = "count") -> float:
    """Return the radius |L|/ħ of the sphere that represents a spin.

    Args:
        s: 0, 1/2, 1, …
        convention: "count": s + ½, whose area 2π(2s + 1) has room for the 2s + 1 states; "prequantum": s, the orbit
            that carries a line bundle, of 2s quanta; "casimir": √(s(s+1)), the root of the Casimir.

    Raises:
        InvalidInput: for an invalid spin, or another convention.

    Source: Kirillov, *Lectures on the Orbit Method*, ch. 1 and 5; Woodhouse, *Geometric Quantization*, ch. 10.
    """
    magnetic_numbers(s)
    radii = {"count": s + 0.5, "prequantum": float(s), "casimir": math.sqrt(s * (s + 1.0))}
    return radii[check.one_of("convention", convention, radii)]


@known_numbers_only
def evolve(
    hamiltonian: Real[ArrayLike, "n n"], state: Real[ArrayLike, "n"], times: Real[ArrayLike, "time"]
) -> Complex128[Array, "time n"]:
    """Return e^{−iHt} ψ at times (T, n), ħ = 1, exactly at any time by the eigenvectors of H.

    Args:
        hamiltonian: (n, n), Hermitian [rad/s].
        state: (n,) at time zero.
        times: (T,) [s].

    Raises:
        InvalidInput: for shapes that do not match, a matrix that is not Hermitian, or values that are not finite.
    """
    require_doubles(hamiltonian=hamiltonian, state=state, times=times)
    H, psi, t = np.asarray(hamiltonian, complex), np.asarray(state, complex), np.asarray(times, float)
    if H.ndim != 2 or H.shape != (psi.size, psi.size) or psi.ndim != 1 or t.ndim != 1:
        raise InvalidInput(
            f"`hamiltonian` (n, n), `state` (n,) and `times` (T,) must match; got {H.shape}, {psi.shape} and {t.shape}."
        )
    if not (np.isfinite(H).all() and np.isfinite(psi).all() and np.isfinite(t).all()):
        raise InvalidInput("`hamiltonian`, `state` and `times` must be finite; got NaN or an infinity.")
    off = np.abs(H - H.conj().T).max(initial=0.0)
    if off > 1e-12 * np.abs(H).max(initial=0.0):
        raise InvalidInput(f"`hamiltonian` must be Hermitian; it differs from its conjugate transpose by {off:.3g}.")
    energies, vectors = np.linalg.eigh(H)
    return np.exp(-1j * np.multiply.outer(t, energies)) * (vectors.conj().T @ psi) @ vectors.T

"""Coadjoint orbits: dimension, tangent space, and the Kirillov–Kostant–Souriau form.

The orbit through μ is the set of all Ad*_g μ, on which every Casimir is constant: on so(3)* the sphere of one |L|. Its
tangent vectors at μ are ad*_x μ, and its symplectic form is
ω(ad*_x μ, ad*_y μ) = sign · ⟨μ, [x, y]⟩, so that ω(X_F, X_G) = {F, G} for either sign. Source: Marsden & Ratiu,
*Introduction to Mechanics and Symmetry*, §14.2–14.4.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.errors import InvalidInput, shown
from polhode.poisson.brackets import as_points, poisson_tensor
from polhode.types import Array, ArrayLike, Float64, Integer, Real


class OrbitLimits(NamedTuple):
    """What decides the dimension of an orbit."""

    relative_rank: float = 1e-10  # singular values of the Poisson tensor below it, relative to the largest, vanish


LIMITS = OrbitLimits()


@known_numbers_only
def orbit_dimension(algebra: AbstractLieAlgebra, mu: ArrayLike) -> Integer[Array, "..."] | int:
    """Return the dimension (…) of the orbit through μ: the rank of the Poisson tensor, always even."""
    sizes = np.linalg.svd(np.asarray(poisson_tensor(algebra, mu)), compute_uv=False)
    largest = np.maximum(sizes[..., :1], np.finfo(float).tiny)
    dimension = np.sum(sizes > LIMITS.relative_rank * largest, axis=-1)
    return int(dimension) if dimension.ndim == 0 else dimension


@known_numbers_only
def orbit_tangent(algebra: AbstractLieAlgebra, mu: ArrayLike) -> Float64[Array, "d {algebra.dim}"]:
    """Return an orthonormal basis (d, dim) of the tangent space at one μ, in the coordinates ⟨·, e_i⟩."""
    mu = _one_point(algebra, mu)
    _, sizes, rows = np.linalg.svd(np.asarray(poisson_tensor(algebra, mu)))
    return rows[: int((sizes > LIMITS.relative_rank * max(sizes[0], np.finfo(float).tiny)).sum())]


def kks_form(
    algebra: AbstractLieAlgebra, mu: ArrayLike, x: ArrayLike, y: ArrayLike, sign: int = -1
) -> Float64[Array, "..."]:
    """Return ω(ad*_x μ, ad*_y μ) = sign · ⟨μ, [x, y]⟩ (…) for elements x, y that generate the two tangent vectors."""
    if sign not in (-1, 1):
        raise InvalidInput(f"`sign` must be −1 or +1; got {shown(sign)}.")
    require_doubles(x=x, y=y)
    return sign * algebra.pairing(as_points(algebra, mu), algebra.bracket(jnp.asarray(x), jnp.asarray(y)))


@known_numbers_only
def kks_matrix(algebra: AbstractLieAlgebra, mu: ArrayLike, sign: int = -1) -> Float64[Array, "d d"]:
    """Return ω(t_a, t_b) (d, d) in the basis of ``orbit_tangent`` at one μ."""
    tangent = orbit_tangent(algebra, mu)
    # ad*_x μ = Σ_i x_i c_ijk μ_k: the coordinates of the tangent vector that x moves μ by
    flow = np.asarray(poisson_tensor(algebra, _one_point(algebra, mu), sign=1))
    # x_a with ad*_{x_a} μ = t_a; what lstsq leaves open lies in the stabiliser of μ, on which ω does not depend
    elements = np.linalg.lstsq(flow.T, tangent.T, rcond=None)[0]
    return sign * elements.T @ flow @ elements


@known_numbers_only
def restricted_bracket(algebra: AbstractLieAlgebra, mu: ArrayLike, sign: int = -1) -> Float64[Array, "d d"]:
    """Return {t_a, t_b} (d, d): the bracket on the orbit, of coordinates along ``orbit_tangent`` at one μ.

    It is the inverse of −ω there, so that ω(X_F, X_G) = {F, G}.
    """
    tangent = orbit_tangent(algebra, mu)
    return tangent @ np.asarray(poisson_tensor(algebra, _one_point(algebra, mu), sign)) @ tangent.T


@known_numbers_only
def symplectic_area(momenta: Real[ArrayLike, "n 3"], sign: int = -1) -> float:
    """Return ∫ω over the part of an SO(3) orbit to the left of a closed curve (n, 3) on it: sign · area/|L|.

    The curve is closed by its first point; its pieces are taken as arcs of great circles, for which the sum of the
    signed triangles with a corner at the first point is exact. The area is modulo the whole sphere, in (−2π, 2π] |L|.
    """
    require_doubles(momenta=momenta)
    points = np.asarray(momenta, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 3 or not np.isfinite(points).all():
        raise InvalidInput(f"`momenta` must be at least three finite points (n, 3); got shape {points.shape}.")
    norms = np.linalg.norm(points, axis=1)
    if not norms.min() > 0 or np.ptp(norms) > 1e-6 * norms.max():
        raise InvalidInput("`momenta` must lie on one sphere about the origin, not at it. Check |L| along the curve.")
    unit = points / norms[:, None]
    # tan(Ω/2) = a·(b × c)/(1 + a·b + b·c + c·a) for the solid angle Ω of a spherical triangle: van Oosterom & Strackee,
    # IEEE Trans. Biomed. Eng. 30 (1983) 125
    a, b, c = unit[0], unit, np.roll(unit, -1, axis=0)
    volume = np.einsum("i,ni->n", a, np.cross(b, c))
    angle = 2.0 * np.arctan2(volume, 1.0 + b @ a + c @ a + np.einsum("ni,ni->n", b, c))
    solid = math.remainder(float(angle.sum()), 4.0 * math.pi)
    return sign * float(norms.mean()) * solid


@known_numbers_only
def liouville_volume(algebra: AbstractLieAlgebra, mu: ArrayLike) -> float:
    """Return the symplectic volume of the orbit through one μ: 4π|L| on SO(3)."""
    if not isinstance(algebra, SO3):
        raise InvalidInput(f"the volume of orbits is known for SO3; got {algebra.name}.")
    return 4.0 * math.pi * float(jnp.linalg.norm(_one_point(algebra, mu)))


def _one_point(algebra: AbstractLieAlgebra, mu: Array) -> Array:
    mu = as_points(algebra, mu)
    if mu.shape != algebra.element_shape:
        raise InvalidInput(f"one point {algebra.element_shape} is needed; got shape {mu.shape}. Loop over points.")
    return mu

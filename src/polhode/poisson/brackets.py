"""The Lie–Poisson bracket of functions on the dual, by automatic differentiation.

{F, G}(μ) = sign · ⟨μ, [dF, dG]⟩; minus (left-invariant) is the default, for which Ḟ = {F, H} and μ̇ = ad*_{dH} μ.
The differential dF is the element of the algebra with δF = ⟨δμ, dF⟩, and ⟨ad*_x μ, y⟩ = ⟨μ, [x, y]⟩. Functions take one
point and give a real scalar; results take points (…, *element_shape).
Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §13.1.
"""

from __future__ import annotations

from collections.abc import Callable

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import in_jax_numpy, is_traced, require_doubles
from polhode._base.arrays.traced_checks import check_function
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Double, Float64

Function = Callable[[Array], Array]


def bracket(algebra: AbstractLieAlgebra, F: Function, G: Function, sign: int = -1) -> Function:
    """Return {F, G} as a function of points.

    Raises:
        InvalidInput: for a sign other than ±1; when called, for functions that are not real scalars, wrong shapes, or
            points with NaN.

    >>> from polhode.algebra import SO3
    >>> L3 = bracket(SO3(), lambda L: L[0], lambda L: L[1])
    >>> float(L3(jnp.array([1.0, 2.0, 5.0])))
    -5.0
    """
    dF, dG, sign = differential(algebra, F), differential(algebra, G), _check_sign(sign)

    def value(mu: ArrayLike) -> Float64[Array, "..."]:
        mu = as_points(algebra, mu)
        return sign * algebra.pairing(mu, algebra.bracket(dF(mu), dG(mu)))

    return value


def hamiltonian_field(algebra: AbstractLieAlgebra, H: Function, sign: int = -1) -> Function:
    """Return X_H: μ̇ = −sign · ad*_{dH} μ, as a function of points."""
    dH, sign = differential(algebra, H), _check_sign(sign)

    def field(mu: ArrayLike) -> Double[Array, "..."]:
        mu = as_points(algebra, mu)
        # Ḟ = sign ⟨μ, [dF, dH]⟩ = −sign ⟨μ, [dH, dF]⟩ = −sign ⟨ad*_{dH} μ, dF⟩ for every F
        return -sign * algebra.coadjoint(dH(mu), mu)

    return field


def time_derivative(algebra: AbstractLieAlgebra, F: Function, H: Function, sign: int = -1) -> Function:
    """Return Ḟ = {F, H} along the motion of H."""
    return bracket(algebra, F, H, sign)


def differential(algebra: AbstractLieAlgebra, F: Function) -> Function:
    """Return dF, an element of the algebra at each point, by reverse-mode differentiation."""

    def scalar(mu: Array) -> Array:
        value = jnp.asarray(F(mu))
        if value.shape or jnp.issubdtype(value.dtype, jnp.complexfloating):
            kind = "complex" if jnp.issubdtype(value.dtype, jnp.complexfloating) else "real"
            raise InvalidInput(
                f"a function on the dual must give one real number at one point; got shape {value.shape}, {kind}. "
                "Write it for a single point; batches are taken care of."
            )
        return value.astype(jnp.float64)

    gradient = jax.grad(scalar)
    looked_at: list[bool] = []

    def at(mu: Array) -> Array:
        depth = jnp.ndim(mu) - len(algebra.element_shape)
        if not looked_at:
            with in_jax_numpy("functions on the dual"):
                check_function("a function on the dual", scalar, jax.ShapeDtypeStruct(algebra.element_shape, mu.dtype))
            looked_at.append(True)
        function = gradient
        for _ in range(depth):
            function = jax.vmap(function)
        with in_jax_numpy("functions on the dual"):
            return algebra.from_gradient(function(mu))

    return at


def poisson_tensor(
    algebra: AbstractLieAlgebra, mu: ArrayLike, sign: int = -1
) -> Float64[Array, "... {algebra.dim} {algebra.dim}"]:
    """Return π_ij = {x_i, x_j} = sign · ⟨ad*_{e_i} μ, e_j⟩ (…, dim, dim) in the coordinates ⟨μ, e_i⟩."""
    mu, depth = as_points(algebra, mu), len(algebra.element_shape)
    basis = algebra.from_vector(jnp.eye(algebra.dim))
    # dx_i = e_i, so that {x_i, x_j} = sign ⟨μ, [e_i, e_j]⟩; Ḟ = (∂F)ᵀ π ∂H
    rows = algebra.coadjoint(basis, jnp.expand_dims(mu, mu.ndim - depth))
    return _check_sign(sign) * algebra.to_dual_vector(rows)


def as_points(algebra: AbstractLieAlgebra, mu: ArrayLike) -> Double[Array, "..."]:
    """Return points as JAX arrays of the algebra's type and shape.

    Raises:
        InvalidInput: for wrong shapes or known values that are not finite.
    """
    require_doubles(point=mu)
    try:
        mu = jnp.asarray(mu, dtype=algebra.dtype)
    except (TypeError, ValueError):
        raise InvalidInput(f"a point of the dual of {algebra.name} must be numbers; got {shown(mu)}.") from None
    algebra.batch_shape(mu)
    if not (is_traced(mu) or np.isfinite(np.asarray(mu)).all()):
        raise InvalidInput(f"a point of the dual of {algebra.name} must be finite; got NaN or an infinity.")
    return mu


def _check_sign(sign: int) -> int:
    if sign not in (-1, 1):
        raise InvalidInput(f"`sign` must be −1 (left-invariant) or +1 (right-invariant); got {shown(sign)}.")
    return sign

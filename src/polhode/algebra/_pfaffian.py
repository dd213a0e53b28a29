"""The Pfaffian of antisymmetric matrices, a Casimir of so(2m)."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.types import Array, Float64


def pfaffian(matrix: Float64[Array, "*batch n n"]) -> Float64[Array, "*batch"]:
    """Return the Pfaffian of antisymmetric matrices (…, 2m, 2m), a polynomial of their entries, without division.

    With J = diag(ε, ε, …), ε = [[0, 1], [−1, 0]], p(λ) = Pf(A + λJ) is a polynomial that begins with λᵐ. Where B is A
    without its first two rows, r and s are these from the third column on, and a = A₀₁, Schur's complement gives
    p_A = p_B (λ + a + r (B + λJ)⁻¹ s), and (B + λJ)⁻¹ = −Σ_k (JB)ᵏ J / λᵏ⁺¹. This takes n⁴ operations where an
    expansion along a row takes (n − 1)!!.

    Source: Rote, Division-Free Algorithms for the Determinant and the Pfaffian, LNCS 2122 (2001) 119.
    """
    n = matrix.shape[-1]
    one = jnp.ones((*matrix.shape[:-2], 1))
    coefficients = one
    for at in range(n - 2, -1, -2):
        row, other = matrix[..., at, at + 2 :], matrix[..., at + 1, at + 2 :]
        powers, turned = [-_times_blocks(other[..., None])], _times_blocks(matrix[..., at + 2 :, at + 2 :])
        for _ in range((n - at) // 2 - 2):
            powers.append(turned @ powers[-1])
        factors = jnp.concatenate([one, matrix[..., at, at + 1, None]], axis=-1)
        if at + 2 < n:
            vectors = jnp.concatenate(powers, axis=-1)
            factors = jnp.concatenate([factors, jnp.sum(row[..., None] * vectors, axis=-2)], axis=-1)
        coefficients = _begin_product(coefficients, factors)
    return coefficients[..., -1]


def _begin_product(one: Float64[Array, "*batch m"], other: Float64[Array, "*batch k"]) -> Float64[Array, "*batch k"]:
    """Return the first k coefficients of a product of polynomials, of which the first has fewer."""
    m, k = one.shape[-1], other.shape[-1]
    terms = one[..., :, None] * other[..., None, :]
    # in rows that are longer by one, each begins one place later: sums of columns are those of equal degree
    longer = jnp.concatenate([terms, jnp.zeros((*terms.shape[:-1], m))], axis=-1)
    flat = longer.reshape(*longer.shape[:-2], m * (k + m))[..., : m * (k + m - 1)]
    return jnp.sum(flat.reshape(*flat.shape[:-1], m, k + m - 1), axis=-2)[..., :k]


def _times_blocks(rows: Float64[Array, "*batch n columns"]) -> Float64[Array, "*batch n columns"]:
    """Return J B."""
    pairs = rows.reshape(*rows.shape[:-2], rows.shape[-2] // 2, 2, rows.shape[-1])
    return jnp.stack([pairs[..., 1, :], -pairs[..., 0, :]], axis=-2).reshape(rows.shape)

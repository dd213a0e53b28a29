"""The Pfaffian of antisymmetric matrices, a Casimir of so(2m)."""

from __future__ import annotations

import functools

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
    coefficients = [jnp.ones(matrix.shape[:-2])]
    for at in range(n - 2, -1, -2):
        rest, other = matrix[..., at + 2 :, at + 2 :], matrix[..., at + 1, at + 2 :]
        factors, vector = [jnp.ones(matrix.shape[:-2]), matrix[..., at, at + 1]], -_times_blocks(other)
        for power in range((n - at) // 2 - 1):
            if power:
                vector = _times_blocks(jnp.einsum("...ij,...j->...i", rest, vector))
            factors.append(jnp.sum(matrix[..., at, at + 2 :] * vector, axis=-1))
        coefficients = [
            functools.reduce(lambda x, y: x + y, [factors[d - k] * c for k, c in enumerate(coefficients[: d + 1])])
            for d in range(len(coefficients) + 1)
        ]
    return coefficients[-1]


def _times_blocks(vector: Float64[Array, "*batch n"]) -> Float64[Array, "*batch n"]:
    """Return J v."""
    pairs = vector.reshape(*vector.shape[:-1], -1, 2)
    return jnp.stack([pairs[..., 1], -pairs[..., 0]], axis=-1).reshape(vector.shape)

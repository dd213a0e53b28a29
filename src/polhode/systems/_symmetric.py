"""Products and solutions with symmetric inertias, (3, 3) or the diagonal (3,) of one."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.types import Array, Float64

Vectors = list[Array]


def times(inertia: Float64[Array, "..."], vector: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
    """Return the product of a symmetric inertia (3, 3), or the diagonal (3,) of one, and vectors (…, 3)."""
    return inertia * vector if inertia.ndim == 1 else vector @ inertia


def solve(inertia: Float64[Array, "..."], vector: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
    """Solve I x = b for x by Cramer's rule, I symmetric (3, 3) or its diagonal (3,), b (…, 3)."""
    if inertia.ndim == 1:
        return vector / inertia
    size = jnp.max(jnp.abs(inertia))  # so that products of three neither overflow nor vanish
    a, b, c = inertia / size
    # I⁻¹ = adj I/det I: its columns are cross products of the rows, and det I = a·(b × c)
    adjugate = jnp.stack([jnp.cross(b, c), jnp.cross(c, a), jnp.cross(a, b)])
    return (vector @ adjugate) / jnp.dot(a, adjugate[0]) / size


def solve_symmetric(matrix: list[Vectors], right: Vectors) -> Vectors:
    """Solve A x = b by L D Lᵀ, A symmetric and positive, its entries and those of b arrays (…).

    It is written out in sums, products and quotients, which Taylor series have recurrences of.
    """
    size = len(right)
    lower: list[Vectors] = []
    pivots: Vectors = []
    x: Vectors = []
    for i in range(size):
        scaled: Vectors = []  # L_ik D_k
        for k in range(i):
            scaled.append(matrix[i][k] - sum((scaled[n] * lower[k][n] for n in range(k)), 0.0))
        lower.append([value / pivot for value, pivot in zip(scaled, pivots, strict=True)])
        pivots.append(matrix[i][i] - sum((a * b for a, b in zip(scaled, lower[i], strict=True)), 0.0))
        x.append(right[i] - sum((a * b for a, b in zip(lower[i], x, strict=True)), 0.0))
    solution = [value / pivot for value, pivot in zip(x, pivots, strict=True)]
    for i in range(size - 1, -1, -1):
        solution[i] = solution[i] - sum((lower[k][i] * solution[k] for k in range(i + 1, size)), 0.0)
    return solution

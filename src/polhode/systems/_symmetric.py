"""Products and solutions with symmetric inertias, (3, 3) or the diagonal (3,) of one."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.types import Array, Float64


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

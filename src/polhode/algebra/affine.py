"""The affine algebra of the line, the smallest that is not commutative."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.algebra.base import AbstractLieAlgebra
from polhode.types import Array, Float64


class AffineLine(AbstractLieAlgebra):
    """Dilations and shifts of the line: [e1, e2] = e2, ad*_(a,b) (α, β) = (−βb, βa).

    The half-planes β ≠ 0 are orbits, open ones, so that there is no Casimir.
    """

    @property
    def dim(self) -> int:
        return 2

    def bracket(self, x: Float64[Array, "*#batch 2"], y: Float64[Array, "*#batch 2"]) -> Float64[Array, "*batch 2"]:
        value = x[..., 0] * y[..., 1] - x[..., 1] * y[..., 0]
        return jnp.stack([jnp.zeros_like(value), value], axis=-1)

    def coadjoint(self, x: Float64[Array, "*#batch 2"], mu: Float64[Array, "*#batch 2"]) -> Float64[Array, "*batch 2"]:
        return jnp.stack(jnp.broadcast_arrays(-mu[..., 1] * x[..., 1], mu[..., 1] * x[..., 0]), axis=-1)

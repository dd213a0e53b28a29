"""The Heisenberg algebra: canonical pairs and the centre."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp

from polhode._base import check
from polhode.algebra.base import AbstractLieAlgebra, Operand, Vector
from polhode.types import Array, Float64


class Heisenberg(AbstractLieAlgebra):
    """Elements (q, p, z) (…, 2n+1): [(q, p, z), (q', p', z')] = (0, 0, q·p' − p·q').

    ad*_(q,p,z) (α, β, γ) = (−γp, γq, 0). Casimir γ: its levels are the symplectic spaces of n canonical pairs.
    """

    n: int = eqx.field(static=True, default=1)

    def __check_init__(self) -> None:
        check.whole("n", self.n, 1, what="canonical pairs")

    @property
    def dim(self) -> int:
        return 2 * self.n + 1

    @property
    def name(self) -> str:
        return f"Heisenberg({self.n})"

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return ("γ",)

    def bracket(self, x: Operand, y: Operand) -> Vector:
        n = self.n
        value = jnp.sum(x[..., :n] * y[..., n : 2 * n] - x[..., n : 2 * n] * y[..., :n], axis=-1, keepdims=True)
        return jnp.concatenate([jnp.zeros((*value.shape[:-1], 2 * n)), value], axis=-1)

    def coadjoint(self, x: Operand, mu: Operand) -> Vector:
        n, level = self.n, mu[..., -1:]
        parts = jnp.broadcast_arrays(-level * x[..., n : 2 * n], level * x[..., :n])
        return jnp.concatenate([*parts, jnp.zeros((*parts[0].shape[:-1], 1))], axis=-1)

    def casimirs(self, mu: Vector) -> Float64[Array, "*batch k"]:
        return jnp.asarray(mu)[..., -1:]

    def exp_change(self, x: Operand, mu: Operand) -> Vector:
        return self.coadjoint(x, mu)  # ad*² = 0

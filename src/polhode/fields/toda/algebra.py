"""Lower bidiagonal matrices, a quotient of the Borel subalgebra: the algebra of the Toda lattice."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp

from polhode._base import check
from polhode.algebra.base import AbstractLieAlgebra, Operand, Vector
from polhode.types import Array, Float64


class Bidiagonal(AbstractLieAlgebra):
    """Elements (β_1, …, β_n, α_1, …, α_{n−1}) (…, 2n−1): β on the diagonal, α below it, nothing further.

    [B_i, A_i] = −A_i, [B_{i+1}, A_i] = A_i, all else commutes: lower triangular matrices modulo those that vanish on
    the diagonal and next to it. ad*_(β,α) (b, a) = (a_iα_i − a_{i−1}α_{i−1}, a_i(β_{i+1} − β_i)). Casimir Σb.
    It is solvable and not unimodular.

    Args:
        n: order of the matrices, at least 2.

    Source: Adler, Invent. Math. 50 (1979) 219; Kostant, Adv. Math. 34 (1979) 195.

    >>> Bidiagonal(2).bracket(jnp.array([0.0, 1.0, 0.0]), jnp.array([0.0, 0.0, 1.0])).tolist()
    [0.0, 0.0, 1.0]
    """

    n: int = eqx.field(static=True)

    def __check_init__(self) -> None:
        check.whole("n", self.n, 2, remedy="It is the order of the matrices.")

    @property
    def dim(self) -> int:
        return 2 * self.n - 1

    @property
    def name(self) -> str:
        return f"Bidiagonal({self.n})"

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return ("Σb",)

    def bracket(self, x: Operand, y: Operand) -> Vector:
        n = self.n
        # of matrices, the entry below the diagonal of xy − yx
        value = jnp.diff(x[..., :n]) * y[..., n:] - jnp.diff(y[..., :n]) * x[..., n:]
        return jnp.concatenate([jnp.zeros((*value.shape[:-1], n)), value], axis=-1)

    def coadjoint(self, x: Operand, mu: Operand) -> Vector:
        n = self.n
        return jnp.concatenate([_difference(mu[..., n:] * x[..., n:]), mu[..., n:] * jnp.diff(x[..., :n])], axis=-1)

    def casimirs(self, mu: Vector) -> Float64[Array, "*batch k"]:
        return jnp.sum(jnp.asarray(mu)[..., : self.n], axis=-1, keepdims=True)

    def rate(self, x: Vector) -> Float64[Array, "*batch"]:
        sizes = jnp.abs(jnp.diff(jnp.asarray(x)[..., : self.n]))  # eigenvalues of ad_x
        # the derivative of `max` asks which entry equals it, of which XLA may compute the last bit anew: then none does
        return jnp.take_along_axis(sizes, jnp.argmax(sizes, axis=-1, keepdims=True), axis=-1)[..., 0]

    def exp_change(self, x: Operand, mu: Operand) -> Vector:
        # a grows at the rate β_{i+1} − β_i, and b receives the integral of aα
        n, growth = self.n, jnp.diff(x[..., : self.n])
        off = mu[..., n:] * x[..., n:] * _mean_growth(growth)
        return jnp.concatenate([_difference(off), mu[..., n:] * jnp.expm1(growth)], axis=-1)


def _difference(off: Array) -> Array:
    """Return c_i − c_{i−1} (…, n) of c (…, n−1), without a sum of them."""
    none = jnp.zeros((*off.shape[:-1], 1))
    return jnp.concatenate([off, none], axis=-1) - jnp.concatenate([none, off], axis=-1)


def _mean_growth(growth: Array) -> Array:
    """Return (e^g − 1)/g, regular at zero."""
    small = jnp.abs(growth) < 1e-5
    safe = jnp.where(small, 1.0, growth)
    # ∫₀¹ e^{gs} ds; the next term of the series is g³/24
    return jnp.where(small, 1.0 + 0.5 * growth * (1.0 + growth / 3.0), jnp.expm1(safe) / safe)

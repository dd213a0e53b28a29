"""Many copies of one algebra, along a batch axis."""

from __future__ import annotations

from typing import Any

import equinox as eqx
import jax.numpy as jnp

from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Double, Float64


class Power(AbstractLieAlgebra):
    """The direct sum of ``count`` copies of ``algebra``; elements (…, count, *element_shape), as for spins."""

    algebra: AbstractLieAlgebra
    count: int = eqx.field(static=True)

    def __check_init__(self) -> None:
        if not isinstance(self.count, int) or self.count < 1:
            raise InvalidInput(f"`count` must be a whole number of copies, at least 1; got {shown(self.count)}.")

    @property
    def dim(self) -> int:
        return self.count * self.algebra.dim

    @property
    def element_shape(self) -> tuple[int, ...]:
        return (self.count, *self.algebra.element_shape)

    @property
    def dtype(self) -> Any:
        return self.algebra.dtype

    @property
    def name(self) -> str:
        return f"{self.algebra.name}^{self.count}"

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"{name} of {k}" for k in range(self.count) for name in self.algebra.casimir_names)

    def bracket(self, x: Double[Array, "..."], y: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.bracket(x, y)

    def coadjoint(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.coadjoint(x, mu)

    def pairing(self, mu: Double[Array, "..."], x: Double[Array, "..."]) -> Float64[Array, "..."]:
        return jnp.sum(self.algebra.pairing(mu, x), axis=-1)

    def casimirs(self, mu: Double[Array, "..."]) -> Float64[Array, "... k"]:
        return self._flat(self.algebra.casimirs(mu))

    def named_casimirs(self, mu: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        batch = self.batch_shape(mu)
        return {name: values.reshape(*batch, -1) for name, values in self.algebra.named_casimirs(mu).items()}

    def to_vector(self, x: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        return self._flat(self.algebra.to_vector(x))

    def from_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        return self.algebra.from_vector(self._split(vector))

    def to_dual_vector(self, mu: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        return self._flat(self.algebra.to_dual_vector(mu))

    def from_dual_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        return self.algebra.from_dual_vector(self._split(vector))

    def from_gradient(self, gradient: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.from_gradient(gradient)

    def rate(self, x: Double[Array, "..."]) -> Float64[Array, "..."]:
        return jnp.max(self.algebra.rate(x), axis=-1)

    def exp(self, x: Double[Array, "..."]) -> Any:
        return self.algebra.exp(x)

    def compose(self, g: Any, h: Any) -> Any:
        return self.algebra.compose(g, h)

    def coadjoint_action(self, g: Any, mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.coadjoint_action(g, mu)

    def cayley(self, x: Double[Array, "..."]) -> Any:
        return self.algebra.cayley(x)

    def exp_change(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.exp_change(x, mu)

    def cayley_change(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.cayley_change(x, mu)

    def _flat(self, values: Array) -> Array:
        return values.reshape(*values.shape[:-2], -1)

    def _split(self, vector: Array) -> Array:
        vector = jnp.asarray(vector)
        return vector.reshape(*vector.shape[:-1], self.count, self.algebra.dim)

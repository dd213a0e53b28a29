"""Many copies of one algebra, along batch axes."""

from __future__ import annotations

import math
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import is_traced
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Double, Float64, Real


class Power(AbstractLieAlgebra):
    """The direct sum of copies of ``algebra``, as for spins.

    ``count`` is their number, or the shape of an array of them: elements are ``(…, *shape, *element_shape)``. Values
    for each copy are listed along one axis, in the order of that array.

    With ``weights`` w_k the pairing is Σ w_k ⟨μ_k, x_k⟩, so that {F, G} = Σ ⟨μ_k, [∂F/∂μ_k, ∂G/∂μ_k]⟩ / w_k: a vortex
    of strength Γ is then a unit vector of weight Γ, a particle of mass m a velocity and a place of weight m.

    Args:
        algebra: of which there are copies.
        count: their number, or the shape of an array of them.
        weights: of that shape, finite and not zero; by default one each.

    >>> from polhode.algebra import SO3
    >>> Power(SO3(), (4, 2)).element_shape, Power(SO3(), (4, 2)).copies
    ((4, 2, 3), 8)
    >>> float(Power(SO3(), 2, (1.0, -3.0)).pairing(jnp.ones((2, 3)), jnp.ones((2, 3))))
    -6.0
    """

    algebra: AbstractLieAlgebra
    count: int | tuple[int, ...] = eqx.field(static=True)
    weights: Float64[Array, "*shape"] | None

    def __init__(
        self,
        algebra: AbstractLieAlgebra,
        count: int | tuple[int, ...],
        weights: Real[ArrayLike, "*shape"] | None = None,
    ) -> None:
        self.algebra, self.count = algebra, count
        self.weights = None if weights is None else jnp.asarray(weights, dtype=float)

    def __check_init__(self) -> None:
        if not self.shape or not all(isinstance(n, int) and n >= 1 for n in self.shape):
            check.refuse("count", "a whole number of copies, at least 1, or a tuple of such numbers", self.count)
        if self.weights is None:
            return
        if self.weights.shape != self.shape:
            raise InvalidInput(f"`weights` must be {self.shape}, one for each copy; got {self.weights.shape}.")
        if not is_traced(self.weights) and not bool(jnp.all(jnp.isfinite(self.weights) & (self.weights != 0))):
            raise InvalidInput(f"`weights` must be finite and not zero; got {shown(np.asarray(self.weights))}.")

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the array of copies."""
        return self.count if isinstance(self.count, tuple) else (self.count,)

    @property
    def copies(self) -> int:
        """How many copies there are."""
        return math.prod(self.shape)

    @property
    def is_of_spins(self) -> bool:
        return self.algebra.is_of_spins

    @property
    def dim(self) -> int:
        return self.copies * self.algebra.dim

    @property
    def element_shape(self) -> tuple[int, ...]:
        return (*self.shape, *self.algebra.element_shape)

    @property
    def dtype(self) -> Any:
        return self.algebra.dtype

    @property
    def name(self) -> str:
        return f"{self.algebra.name}^{'×'.join(map(str, self.shape))}"

    @property
    def element_rule(self) -> str:
        return self.algebra.element_rule

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"{name} of {k}" for k in range(self.copies) for name in self.algebra.casimir_names)

    def bracket(self, x: Double[Array, "..."], y: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.bracket(x, y)

    def coadjoint(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.coadjoint(x, mu)

    def pairing(self, mu: Double[Array, "..."], x: Double[Array, "..."]) -> Float64[Array, "..."]:
        paired = self.algebra.pairing(mu, x)
        return jnp.sum(paired if self.weights is None else self.weights * paired, axis=self._axes)

    def casimirs(self, mu: Double[Array, "..."]) -> Float64[Array, "... k"]:
        return self._flat(self.algebra.casimirs(mu))

    def named_casimirs(self, mu: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        batch = self.batch_shape(mu)
        return {name: values.reshape(*batch, -1) for name, values in self.algebra.named_casimirs(mu).items()}

    @property
    def casimirs_of_copies(self) -> tuple[str, ...]:
        one = self.algebra
        if not one.casimirs_of_copies:
            return one.casimir_names
        return tuple(jax.eval_shape(one.named_casimirs, jax.ShapeDtypeStruct(one.element_shape, one.dtype)))

    def to_vector(self, x: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        return self._flat(self.algebra.to_vector(x))

    def from_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        return self.algebra.from_vector(self._split(vector))

    def to_dual_vector(self, mu: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        values = self.algebra.to_dual_vector(mu)
        # ⟨μ, e_i⟩ with the weights of the pairing
        return self._flat(values if self.weights is None else values * self.weights[..., None])

    def from_dual_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        values = self._split(vector)
        return self.algebra.from_dual_vector(values if self.weights is None else values / self.weights[..., None])

    def project(self, matrix: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.project(matrix)

    def from_gradient(self, gradient: Double[Array, "..."]) -> Double[Array, "..."]:
        element = self.algebra.from_gradient(gradient)
        if self.weights is None:
            return element
        # δF = Σ ∂F/∂μ_k · δμ_k = Σ w_k ⟨δμ_k, x_k⟩
        return element / self.weights.reshape(*self.shape, *(1,) * len(self.algebra.element_shape))

    def rate(self, x: Double[Array, "..."]) -> Float64[Array, "..."]:
        return jnp.max(self.algebra.rate(x), axis=self._axes)

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

    @property
    def _axes(self) -> tuple[int, ...]:
        return tuple(range(-len(self.shape), 0))

    def _flat(self, values: Array) -> Array:
        batch = values.shape[: values.ndim - len(self.shape) - 1]
        return values.reshape(*batch, self.copies * values.shape[-1])

    def _split(self, vector: Array) -> Array:
        vector = jnp.asarray(vector)
        return vector.reshape(*vector.shape[:-1], *self.shape, self.algebra.dim)

"""An algebra extended by the dual numbers: the algebra acting on a commuting copy of itself, and its dual."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp

from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput
from polhode.types import Array, Double, Float64


class DualNumbers(AbstractLieAlgebra):
    """g ⋉ g* for an algebra g with an invariant pairing: g over numbers a + d b with d² = 0.

    Elements (…, 2, *element_shape) are x = x₀ + d x₁, with [x, y] = [x₀, y₀] + d([x₀, y₁] + [x₁, y₀]); points of the
    dual are Z = Θ + d W, with ⟨Z, x⟩ = ⟨W, x₀⟩ + ⟨Θ, x₁⟩, so that ad*_x Z = ad*_{x₀} Θ + d(ad*_{x₀} W + ad*_{x₁} Θ).
    Every formula of g holds with such numbers put in, and its part with d is its derivative: so it is computed.
    Casimirs are those of g at Θ and, called "d" of them, their derivatives along W, for su(N) tr Θ^k and k tr WΘ^(k−1).
    Group elements are pairs (g, ġ).

    Args:
        algebra: g. For algebras without an invariant pairing this is their tangent algebra, g ⋉ g.

    >>> from polhode.algebra import SE3, SO3
    >>> bool((DualNumbers(SO3()).structure_constants() == SE3().structure_constants()).all())
    True

    Source: Takiff, Trans. Amer. Math. Soc. 160 (1971) 249; Modin & Roop, IMA J. Numer. Anal. (2025), arXiv
    2311.16045.
    """

    algebra: AbstractLieAlgebra

    @property
    def dim(self) -> int:
        return 2 * self.algebra.dim

    @property
    def element_shape(self) -> tuple[int, ...]:
        return (2, *self.algebra.element_shape)

    @property
    def dtype(self) -> Any:
        return self.algebra.dtype

    @property
    def name(self) -> str:
        return f"DualNumbers({self.algebra.name})"

    @property
    def element_rule(self) -> str:
        return self.algebra.element_rule

    @property
    def casimir_names(self) -> tuple[str, ...]:
        names = self.algebra.casimir_names
        return (*names, *(f"d {name}" for name in names))

    def casimirs(self, mu: Double[Array, "..."]) -> Float64[Array, "... k"]:
        return jnp.concatenate(jax.jvp(self.algebra.casimirs, *self._pairs(mu)), axis=-1)

    # ------------------------------------------------------------------ the algebra and its dual

    def bracket(self, x: Double[Array, "..."], y: Double[Array, "..."]) -> Double[Array, "..."]:
        return self._lift(self.algebra.bracket, x, y)

    def coadjoint(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self._lift(self.algebra.coadjoint, x, mu)

    def pairing(self, mu: Double[Array, "..."], x: Double[Array, "..."]) -> Float64[Array, "..."]:
        (theta, w), (first, second) = self._split(mu), self._split(x)
        return self.algebra.pairing(w, first) + self.algebra.pairing(theta, second)

    def to_vector(self, x: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        return jnp.concatenate([self.algebra.to_vector(part) for part in self._split(x)], axis=-1)

    def from_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        return self._join(*(self.algebra.from_vector(half) for half in jnp.split(jnp.asarray(vector), 2, axis=-1)))

    def to_dual_vector(self, mu: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        # ⟨Z, x⟩ = ⟨W, x₀⟩ + ⟨Θ, x₁⟩: coordinates along x₀ are those of W
        return jnp.concatenate([self.algebra.to_dual_vector(part) for part in self._split(mu)[::-1]], axis=-1)

    def from_dual_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        w, theta = (self.algebra.from_dual_vector(half) for half in jnp.split(jnp.asarray(vector), 2, axis=-1))
        return self._join(theta, w)

    def project(self, matrix: Double[Array, "..."]) -> Double[Array, "..."]:
        return self.algebra.project(matrix)  # which is linear: that of each part

    def from_gradient(self, gradient: Double[Array, "..."]) -> Double[Array, "..."]:
        # dF/dΘ pairs with x₁, dF/dW with x₀
        by_theta, by_w = self._split(gradient)
        return self._join(self.algebra.from_gradient(by_w), self.algebra.from_gradient(by_theta))

    def rate(self, x: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return the larger rate of x₀ and x₁: the spectral radius of ad is that of x₀, while x₁ shears as fast."""
        return jnp.maximum(*(self.algebra.rate(part) for part in self._split(x)))

    # ------------------------------------------------------------------ the group

    def exp(self, x: Double[Array, "..."]) -> Any:
        return jax.jvp(self.algebra.exp, *self._pairs(x))

    def compose(self, g: Any, h: Any) -> Any:
        return jax.jvp(self.algebra.compose, (g[0], h[0]), (g[1], h[1]))

    def coadjoint_action(self, g: Any, mu: Double[Array, "..."]) -> Double[Array, "..."]:
        theta, w = self._split(mu)
        return self._join(*jax.jvp(self.algebra.coadjoint_action, (g[0], theta), (g[1], w)))

    def cayley(self, x: Double[Array, "..."]) -> Any:
        return jax.jvp(self.algebra.cayley, *self._pairs(x))

    def exp_change(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self._lift(self.algebra.exp_change, x, mu)

    def cayley_change(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        return self._lift(self.algebra.cayley_change, x, mu)

    # ------------------------------------------------------------------ of matrices, by products

    def odd_part(self, matrix: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return the part of pairs of matrices (…, 2, n, n) in the algebra, but for the trace."""
        return self._lift(self._of_matrices("odd_part"), matrix)

    def cayley_middle(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return Z̃ with μ = (1 − x†/2) Z̃ (1 + x†/2) over the dual numbers."""
        return self._lift(self._of_matrices("cayley_middle"), x, mu)

    def cayley_terms(
        self, x: Double[Array, "..."], mu: Double[Array, "..."]
    ) -> tuple[Double[Array, "..."], Double[Array, "..."], Double[Array, "..."]]:
        """Return y μ, [y, μ] and y μ y over the dual numbers with y = x†/2, by six products of matrices."""
        values, changes = jax.jvp(self._of_matrices("cayley_terms"), *self._pairs(x, mu))
        one, two, three = (self._join(*both) for both in zip(values, changes, strict=True))
        return one, two, three

    def _of_matrices(self, name: str) -> Callable[..., Any]:
        if not hasattr(self.algebra, name):
            raise InvalidInput(f"{self.name} has no products: elements of {self.algebra.name} are not matrices.")
        return getattr(self.algebra, name)

    # ------------------------------------------------------------------ pairs

    @property
    def _axis(self) -> int:
        return -len(self.algebra.element_shape) - 1

    def _split(self, value: Double[Array, "..."]) -> tuple[Array, Array]:
        value = jnp.asarray(value, self.dtype)
        return jnp.take(value, 0, axis=self._axis), jnp.take(value, 1, axis=self._axis)

    def _join(self, value: Array, change: Array) -> Array:
        return jnp.stack([value, change], axis=self._axis)

    def _pairs(self, *values: Double[Array, "..."]) -> tuple[list[Array], list[Array]]:
        parts = [self._split(value) for value in values]
        return [part[0] for part in parts], [part[1] for part in parts]

    def _lift(self, function: Callable[..., Array], *values: Double[Array, "..."]) -> Array:
        """Return f(a + d b) = f(a) + d f'(a) b."""
        return self._join(*jax.jvp(function, *self._pairs(*values)))

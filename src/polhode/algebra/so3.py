"""so(3): vectors with the cross product, quaternions as group elements."""

from __future__ import annotations

import jax.numpy as jnp

from polhode import rotation
from polhode.algebra.base import AbstractLieAlgebra
from polhode.motion._layout import MOMENTUM, StatePart
from polhode.types import Array, Float64


def half_angle_factors(x: Float64[Array, "*batch 3"]) -> tuple[Float64[Array, "*batch 1"], Float64[Array, "*batch 1"]]:
    """Return 2 sin(θ/2)/θ and cos(θ/2), (…, 1), θ = |x|, regular at zero."""
    square = jnp.sum(x * x, axis=-1, keepdims=True)
    # the next terms are θ⁴/1920 and θ⁴/384, below 1e-18
    small = square < 1e-8
    angle = jnp.sqrt(jnp.where(small, 1.0, square))
    sine = jnp.where(small, 1.0 - square / 24.0, 2.0 * jnp.sin(0.5 * angle) / angle)
    return sine, jnp.where(small, 1.0 - square / 8.0, jnp.cos(0.5 * angle))


class SO3(AbstractLieAlgebra):
    """Rotations of space: [x, y] = x × y, ad*_x μ = μ × x, pairing μ · x. Basis: the axes.

    Group elements are unit quaternions wxyz; Ad*_g μ = R(g)ᵀ μ. Casimir |μ|².

    >>> SO3().bracket(jnp.array([1.0, 0, 0]), jnp.array([0.0, 1, 0])).tolist()
    [0.0, 0.0, 1.0]
    """

    @property
    def body_parts(self) -> tuple[StatePart, ...]:
        return (MOMENTUM,)

    @property
    def is_of_spins(self) -> bool:
        return True

    @property
    def dim(self) -> int:
        return 3

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return ("|L|²",)

    def bracket(self, x: Float64[Array, "*#batch 3"], y: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        return jnp.cross(x, y)

    def coadjoint(self, x: Float64[Array, "*#batch 3"], mu: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        return jnp.cross(mu, x)

    def casimirs(self, mu: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch k"]:
        return jnp.sum(jnp.asarray(mu) ** 2, axis=-1, keepdims=True)

    def rate(self, x: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        return scaled_norm(x)

    def exp(self, x: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 4"]:
        s, c = half_angle_factors(jnp.asarray(x))
        return jnp.concatenate([c, 0.5 * s * x], axis=-1)

    def compose(self, g: Float64[Array, "*#batch 4"], h: Float64[Array, "*#batch 4"]) -> Float64[Array, "*batch 4"]:
        return rotation.multiply(g, h)

    def coadjoint_action(
        self, g: Float64[Array, "*#batch 4"], mu: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        return rotation.rotate(rotation.conjugate(g), mu)

    def cayley(self, x: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 4"]:
        x = jnp.asarray(x)
        # the quaternion (1, x/2) at unit length: a turn with tan(θ/2) = |x|/2
        w = 1.0 / jnp.sqrt(1.0 + 0.25 * jnp.sum(x * x, axis=-1, keepdims=True))
        return jnp.concatenate([w, 0.5 * w * x], axis=-1)

    def exp_change(self, x: Float64[Array, "*#batch 3"], mu: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        s, c = half_angle_factors(x)
        # (sin θ/θ) μ × x + ((1 − cos θ)/θ²)(μ × x) × x, by half angles: sin θ = 2 sin(θ/2) cos(θ/2), 1 − cos θ = 2
        # sin²(θ/2)
        once = jnp.cross(mu, x)
        return s * (c * once + 0.5 * s * jnp.cross(once, x))

    def cayley_change(
        self, x: Float64[Array, "*#batch 3"], mu: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        # tan(θ/2) = |x|/2: sin θ/|x| and (1 − cos θ)/|x|² are 1 and ½ over 1 + |x|²/4
        once = jnp.cross(mu, x)
        return (once + 0.5 * jnp.cross(once, x)) / (1.0 + 0.25 * jnp.sum(x * x, axis=-1, keepdims=True))


def scaled_norm(x: Float64[Array, "*batch n"]) -> Float64[Array, "*batch"]:
    """Return |x| (…) of vectors whose squares may be beyond the largest or smallest number."""
    x = jnp.asarray(x)
    largest = jnp.max(jnp.abs(x), axis=-1, keepdims=True)
    size = jnp.where(largest > 0, largest, 1.0)
    return size[..., 0] * jnp.linalg.norm(x / size, axis=-1)

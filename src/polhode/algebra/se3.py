"""se(3): rotations and translations; its dual has the states of the heavy top and of a body in an ideal fluid."""

from __future__ import annotations

from collections.abc import Callable

import jax.numpy as jnp

from polhode import rotation
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3, scaled_norm
from polhode.motion._layout import LINEAR, MOMENTUM, StatePart
from polhode.types import Array, Float64


class SE3(AbstractLieAlgebra):
    """Rigid motions, angular part first: [(a, b), (c, d)] = (a × c, a × d + b × c).

    ad*_(a,b) (Π, P) = (Π × a + P × b, P × a), pairing Π · a + P · b. Group elements (…, 7) are a unit quaternion wxyz
    and the translation behind it: r → R r + d. Casimirs |P|² and Π · P. Generic orbits have dimension 4.
    """

    @property
    def body_parts(self) -> tuple[StatePart, ...]:
        return (MOMENTUM, LINEAR)

    @property
    def dim(self) -> int:
        return 6

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return ("|P|²", "Π·P")

    def bracket(self, x: Float64[Array, "*#batch 6"], y: Float64[Array, "*#batch 6"]) -> Float64[Array, "*batch 6"]:
        (a, b), (c, d) = _parts(x), _parts(y)
        return jnp.concatenate([jnp.cross(a, c), jnp.cross(a, d) + jnp.cross(b, c)], axis=-1)

    def coadjoint(self, x: Float64[Array, "*#batch 6"], mu: Float64[Array, "*#batch 6"]) -> Float64[Array, "*batch 6"]:
        (a, b), (angular, linear) = _parts(x), _parts(mu)
        return jnp.concatenate([jnp.cross(angular, a) + jnp.cross(linear, b), jnp.cross(linear, a)], axis=-1)

    def casimirs(self, mu: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch k"]:
        angular, linear = _parts(mu)
        return jnp.stack([jnp.sum(linear * linear, axis=-1), jnp.sum(angular * linear, axis=-1)], axis=-1)

    def rate(self, x: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch"]:
        return scaled_norm(x[..., :3])

    def exp(self, x: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch 7"]:
        a, b = _parts(x)
        square = jnp.sum(a * a, axis=-1, keepdims=True)
        small = square < 0.01
        angle = jnp.sqrt(jnp.where(small, 1.0, square))
        # (1 − cos θ)/θ² and (θ − sin θ)/θ³, by series where they cancel
        first = 0.5 - square / 24 * (1 - square / 30 * (1 - square / 56 * (1 - square / 90)))
        second = 1 / 6 - square / 120 * (1 - square / 42 * (1 - square / 72 * (1 - square / 110)))
        first = jnp.where(small, first, 2.0 * (jnp.sin(0.5 * angle) / angle) ** 2)
        second = jnp.where(small, second, (angle - jnp.sin(angle)) / angle**3)
        # ∫₀¹ exp(s â) b ds
        once = jnp.cross(a, b)
        return jnp.concatenate([SO3().exp(a), b + first * once + second * jnp.cross(a, once)], axis=-1)

    def compose(self, g: Float64[Array, "*#batch 7"], h: Float64[Array, "*#batch 7"]) -> Float64[Array, "*batch 7"]:
        turn = rotation.multiply(g[..., :4], h[..., :4])
        return jnp.concatenate([turn, g[..., 4:] + rotation.rotate(g[..., :4], h[..., 4:])], axis=-1)

    def coadjoint_action(
        self, g: Float64[Array, "*#batch 7"], mu: Float64[Array, "*#batch 6"]
    ) -> Float64[Array, "*batch 6"]:
        # ⟨Ad*_g (Π, P), (a, b)⟩ = Π·Ra + P·(Rb + d × Ra): Π becomes Rᵀ(Π + P × d), P becomes RᵀP
        back = rotation.conjugate(g[..., :4])
        angular, linear = _parts(mu)
        angular = angular + jnp.cross(linear, g[..., 4:])
        return jnp.concatenate([rotation.rotate(back, angular), rotation.rotate(back, linear)], axis=-1)

    def cayley(self, x: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch 7"]:
        a, b = _parts(x)
        # (1 − â/2)⁻¹ b
        half = 0.5 * a
        square = jnp.sum(half * half, axis=-1, keepdims=True)
        shift = (b + jnp.cross(half, b) + half * jnp.sum(half * b, axis=-1, keepdims=True)) / (1.0 + square)
        return jnp.concatenate([SO3().cayley(a), shift], axis=-1)

    def exp_change(self, x: Float64[Array, "*#batch 6"], mu: Float64[Array, "*#batch 6"]) -> Float64[Array, "*batch 6"]:
        return self._change(SO3().exp_change, self.exp(x)[..., 4:], x, mu)

    def cayley_change(
        self, x: Float64[Array, "*#batch 6"], mu: Float64[Array, "*#batch 6"]
    ) -> Float64[Array, "*batch 6"]:
        return self._change(SO3().cayley_change, self.cayley(x)[..., 4:], x, mu)

    def _change(self, change: Callable[[Array, Array], Array], shift: Array, x: Array, mu: Array) -> Array:
        turn, (angular, linear) = x[..., :3], _parts(mu)
        # Rᵀ(Π + P × d) − Π = (Rᵀ − 1)(Π + P × d) + P × d: no large terms cancel
        arm = jnp.cross(linear, shift)
        return jnp.concatenate([change(turn, angular + arm) + arm, change(turn, linear)], axis=-1)


def _parts(x: Array) -> tuple[Array, Array]:
    x = jnp.asarray(x)
    return x[..., :3], x[..., 3:]

"""se(2): motions of the plane; its dual has the states of a planar body, and of the pendulum."""

from __future__ import annotations

import jax.numpy as jnp

from polhode.algebra.base import AbstractLieAlgebra
from polhode.types import Array, Float64


class SE2(AbstractLieAlgebra):
    """Motions of the plane, the turn first: [(a, b), (c, d)] = (0, a J d − c J b), J a quarter turn to the left.

    ad*_(a,b) (Π, P) = (−P·Jb, −a JP), pairing Πa + P·b. Group elements (…, 4) are cosine and sine of the
    turn and the translation behind them: r → R r + d. Casimir |P|²: orbits are cylinders about the Π axis, as the phase
    space of a pendulum. Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §14.6.
    """

    @property
    def dim(self) -> int:
        return 3

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return ("|P|²",)

    def bracket(self, x: Float64[Array, "*#batch 3"], y: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        (a, b1, b2), (c, d1, d2) = _parts(x), _parts(y)
        return _stack(jnp.zeros_like(a * c), -a * d2 + c * b2, a * d1 - c * b1)

    def coadjoint(self, x: Float64[Array, "*#batch 3"], mu: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        (a, b1, b2), (_, p1, p2) = _parts(x), _parts(mu)
        return _stack(p1 * b2 - p2 * b1, a * p2, -a * p1)

    def casimirs(self, mu: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch k"]:
        _, p1, p2 = _parts(mu)
        return (p1 * p1 + p2 * p2)[..., None]

    def rate(self, x: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        return jnp.abs(jnp.asarray(x)[..., 0])

    def exp(self, x: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 4"]:
        a, b1, b2 = _parts(x)
        half = 0.5 * a
        # sin a / a and (1 − cos a)/a, without cancellation and with their limits at a = 0
        near = jnp.abs(half) < 1e-4
        share = jnp.where(near, 1.0 - half * half / 6.0, jnp.sin(half) / jnp.where(near, 1.0, half))
        s, c = share * jnp.cos(half), share * jnp.sin(half)
        # d = ∫₀¹ R(sa) b ds = (sin a/a) b + ((1 − cos a)/a) J b
        return _stack(jnp.cos(a), jnp.sin(a), s * b1 - c * b2, c * b1 + s * b2)

    def cayley(self, x: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 4"]:
        a, b1, b2 = _parts(x)
        half = 0.5 * a
        # (1 − aJ/2)⁻¹ = (1 + aJ/2)/(1 + a²/4), as J² = −1: cos and sin are (1 − h²)/(1 + h²) and 2h/(1 + h²), h = a/2
        scale = 1.0 / (1.0 + half * half)
        return _stack((1.0 - half * half) * scale, a * scale, (b1 - half * b2) * scale, (b2 + half * b1) * scale)

    def compose(self, g: Float64[Array, "*#batch 4"], h: Float64[Array, "*#batch 4"]) -> Float64[Array, "*batch 4"]:
        (c, s, d1, d2), (cosine, sine, b1, b2) = _parts(g), _parts(h)
        return _stack(c * cosine - s * sine, s * cosine + c * sine, d1 + c * b1 - s * b2, d2 + s * b1 + c * b2)

    def coadjoint_action(
        self, g: Float64[Array, "*#batch 4"], mu: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        (c, s, d1, d2), (angular, p1, p2) = _parts(g), _parts(mu)
        # ⟨Ad*_g (Π, P), (a, b)⟩ = Πa + P·(Rb − a J d): Π becomes Π − P·Jd, P becomes RᵀP
        return _stack(angular + p1 * d2 - p2 * d1, c * p1 + s * p2, c * p2 - s * p1)

    def exp_change(self, x: Float64[Array, "*#batch 3"], mu: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        half = 0.5 * jnp.asarray(x)[..., 0]
        s, c = jnp.sin(half), jnp.cos(half)
        # cos a − 1 = −2 sin² ½a
        return _coadjoint_change(-2.0 * s * s, 2.0 * s * c, self.exp(x), mu)

    def cayley_change(
        self, x: Float64[Array, "*#batch 3"], mu: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch 3"]:
        half = 0.5 * jnp.asarray(x)[..., 0]
        scale = 2.0 * half / (1.0 + half * half)
        # cos − 1 = −2h²/(1 + h²) and sin = 2h/(1 + h²), h = a/2
        return _coadjoint_change(-half * scale, scale, self.cayley(x), mu)


def _coadjoint_change(less: Array, sine: Array, g: Array, mu: Array) -> Array:
    """Return Ad*_g μ − μ from cos − 1 and sin of the turn, without cancellation."""
    (_, _, d1, d2), (_, p1, p2) = _parts(g), _parts(mu)
    return _stack(p1 * d2 - p2 * d1, less * p1 + sine * p2, less * p2 - sine * p1)


def _parts(x: Array) -> tuple[Array, ...]:
    x = jnp.asarray(x)
    return tuple(x[..., k] for k in range(x.shape[-1]))


def _stack(*parts: Array) -> Array:
    return jnp.stack(jnp.broadcast_arrays(*parts), axis=-1)

"""The spherical midpoint method for spins."""

from __future__ import annotations

from typing import Any, ClassVar

import equinox as eqx
import jax.numpy as jnp

from polhode.algebra.so3 import scaled_norm
from polhode.errors import InvalidInput
from polhode.integrators._composition import DEFAULT_ORDER, compose, stages
from polhode.integrators._fixed_point import fixed_point
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Double, Float64


class SphericalMidpoint(AbstractOrbitSolver):
    """w₁ − w₀ = h X(|w₀| (w₀ + w₁)/|w₀ + w₁|) on products of spheres, composed to order 2, 4, 6 or 8; implicit.

    Args:
        system: on SO3 or a Power of it, without attitude.
        step_size: largest step [s].
        order: 2, 4, 6 or 8.

    Source: McLachlan, Modin & Verdier, Phys. Rev. E 89 (2014) 061301.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    keeps: ClassVar[str] = "the length of every spin, the Poisson structure; time reversal; linear symmetries' momenta"
    own_order: int = eqx.field(static=True)

    def __init__(self, system: AbstractLiePoissonSystem, step_size: Scalar, order: int = DEFAULT_ORDER) -> None:
        algebra = system.algebra
        if not algebra.is_of_spins:
            raise InvalidInput(f"`SphericalMidpoint` needs SO3 or a Power of it; got {algebra.name}. Take LieMidpoint.")
        stages(order)
        self.system, self.step_size, self.own_order = system, step_size, order

    def order(self, terms: Any) -> int:
        return self.own_order

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        attitude, point = self.system.parts(state)
        if attitude is not None:
            raise InvalidInput("`SphericalMidpoint` moves momenta only, not an attitude; take LieMidpoint.")
        return compose(self._stage, self.own_order, t, h, point, self.beside_jumps(t, h))

    def _stage(self, t: Array, h: Array, point: Array) -> Change:
        half_way = t + 0.5 * h
        length = scaled_norm(point)[..., None]

        def improve(change: Array) -> Array:
            middle = point + 0.5 * change
            size = scaled_norm(middle)[..., None]
            middle = middle * (length / jnp.where(size > 0, size, 1.0))
            return h * self.system.algebra.coadjoint(self.system.generator(half_way, middle), middle)

        start = improve(jnp.zeros_like(point))
        # the size of the change's terms, which do not vanish where the change does
        scale = jnp.abs(h) * jnp.max(jnp.abs(self.system.generator(half_way, point))) * jnp.max(length)
        solution = fixed_point(improve, start, scale)
        return Change(*solution)

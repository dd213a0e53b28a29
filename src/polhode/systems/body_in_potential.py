"""A body with a fixed point in a potential that depends on how a direction in space lies in the body."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import jax
import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.algebra._closures import take_apart
from polhode.algebra._functions import check_scalar
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.se3 import SE3
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, components
from polhode.systems.free_rigid_body import axis_flows, checked_moments
from polhode.types import Array, ArrayLike, Float64, Real

Potential = Callable[[Float64[Array, "3"]], Float64[Array, ""]]


class BodyInPotential(AbstractLiePoissonSystem):
    """H = ½ Π·I⁻¹Π + V(Γ) on se(3)*: Π̇ = Π × Ω + Γ × ∇V, Γ̇ = Γ × Ω.

    Γ is a direction fixed in space, along the body's axes. State (Π, Γ) (…, 6), or with the attitude (…, 10).
    Flows: rotation about each axis, and the potential, which kicks Π.

    Args:
        moments: (3,) principal moments about the fixed point [kg m²].
        potential: V [J] of one Γ (3,), differentiable by JAX.

    Raises:
        InvalidInput: for moments that are not positive, or a potential that is not a real scalar.

    Source: Celledoni, Fassò, Säfström & Zanna, SIAM J. Sci. Comput. 30 (2008) 2084.
    """

    title: ClassVar[str] = "Body in a potential"
    has_vertical: ClassVar[bool] = True
    algebra: AbstractLieAlgebra
    moments: Float64[Array, "3"]
    potential: Potential

    @known_numbers_only
    def __init__(self, moments: Real[ArrayLike, "3"], potential: Potential) -> None:
        check_scalar("potential", potential, (3,), jnp.float64)
        self.algebra, self.moments = SE3(), checked_moments(moments)
        self.potential = take_apart(potential, jax.ShapeDtypeStruct((3,), jnp.float64))

    def energy(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch"]:
        angular = point[..., :3]
        kinetic = 0.5 * jnp.sum(angular * angular / self.moments, axis=-1)
        return kinetic + self._over_batch(self.potential)(point[..., 3:])

    def velocity(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch 6"]:
        force = self._over_batch(jax.grad(self.potential))(point[..., 3:])
        return jnp.concatenate([point[..., :3] / self.moments, force], axis=-1)

    @property
    def flows(self) -> dict[str, Flow]:
        return {"potential": self._kick} | axis_flows(self.moments, vectors=2)

    def _kick(self, time: Array, state: Components) -> Components:
        # under V(Γ) alone Γ̇ = Γ × 0 = 0, so that Π̇ = Γ × ∇V(Γ) is constant: the kick is exact
        direction = jnp.stack(state[-3:], axis=-1)
        kick = time * jnp.cross(direction, self._over_batch(jax.grad(self.potential))(direction))
        still = jnp.zeros_like(state[0])
        return (*[still] * (len(state) - 6), *components(kick), still, still, still)

    def _over_batch(self, function: Callable[[Array], Array]) -> Callable[[Array], Array]:
        def values(direction: Array) -> Array:
            batched = function
            for _ in range(jnp.ndim(direction) - 1):
                batched = jax.vmap(batched)
            return batched(direction)

        return values

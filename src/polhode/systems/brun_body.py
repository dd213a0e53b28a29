"""A body with a fixed point in a central field, to second order: Brun's problem."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.se3 import SE3
from polhode.systems._checks import checked_number
from polhode.systems._top_integrals import Integral
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow
from polhode.systems.free_rigid_body import axis_flows, checked_moments
from polhode.types import Array, ArrayLike, Float64, Real


class BrunBody(AbstractLiePoissonSystem):
    """H = ½ Π·I⁻¹Π + ½ ε Γ·IΓ on se(3)*: Π̇ = Π × Ω + ε Γ × IΓ, Γ̇ = Γ × Ω.

    Not a heavy top: the potential is quadratic in Γ, as of a body pinned at its centre of mass in a far mass's field,
    ε = 3GM/R³ with Γ towards the mass. Integrable, with Clebsch's integral ½|Π|² − ½ ε det I Γ·I⁻¹Γ. State (Π, Γ)
    (…, 6), or with the attitude (…, 10). Flows: rotation about each axis, and the field, which kicks Π.

    Args:
        moments: (3,) principal moments about the fixed point [kg m²].
        strength: ε [1/s²], of either sign.

    Raises:
        InvalidInput: for moments that are not positive, or a strength that is not finite.

    Source: de Brun 1893; Clebsch, Math. Ann. 3 (1871) 238; Bogoyavlenskii, Math. USSR Izv. 25 (1985) 207.
    """

    title: ClassVar[str] = "Brun's body"
    has_vertical: ClassVar[bool] = True
    algebra: AbstractLieAlgebra
    moments: Float64[Array, "3"]
    strength: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, moments: Real[ArrayLike, "3"], strength: float) -> None:
        self.algebra, self.moments = SE3(), checked_moments(moments)
        self.strength = checked_number("strength", strength, unit="1/s²")

    def energy(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch"]:
        angular, up = point[..., :3], point[..., 3:]
        return 0.5 * jnp.sum(angular**2 / self.moments + self.strength * self.moments * up**2, axis=-1)

    def velocity(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch 6"]:
        angular, up = point[..., :3], point[..., 3:]
        return jnp.concatenate([angular / self.moments, self.strength * self.moments * up], axis=-1)

    @property
    def extra_invariants(self) -> dict[str, Integral]:
        moments = self.moments
        # det I / I_k without the quotient
        # d/dt ½|Π|² = ε Π·(Γ × IΓ), and d/dt of the other term is ε det I (I⁻¹Γ)·(Γ × Ω): equal, by det I
        # (I⁻¹a × I⁻¹b) = I (a × b) with a = Γ, b = IΓ
        cofactors = jnp.stack([moments[1] * moments[2], moments[2] * moments[0], moments[0] * moments[1]])

        def clebsch(point: Array) -> Array:
            return 0.5 * jnp.sum(point[..., :3] ** 2 - self.strength * cofactors * point[..., 3:] ** 2, axis=-1)

        return {"Clebsch's integral": clebsch}

    @property
    def flows(self) -> dict[str, Flow]:
        return {"field": self._kick} | axis_flows(self.moments, vectors=2)

    def _kick(self, time: Array, state: Components) -> Components:
        # Γ stays in the field alone: Π grows by t ε Γ × IΓ
        x, y, z = state[-3:]
        a, b, c = (time * self.strength * self.moments[k] for k in range(3))
        still = jnp.zeros_like(x)
        return (*[still] * (len(state) - 6), (c - b) * y * z, (a - c) * z * x, (b - a) * x * y, still, still, still)

"""Energy lost inside a body that keeps its angular momentum: double-bracket dissipation."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.so3 import SO3
from polhode.systems._checks import checked_number
from polhode.systems.base import AbstractLiePoissonSystem, Balance
from polhode.systems.free_rigid_body import checked_moments
from polhode.types import Array, ArrayLike, Float64, Real


class DoubleBracket(AbstractLiePoissonSystem):
    """Π̇ = Π × Ω + α Π × (Π × Ω): |Π|² is kept exactly, the energy falls by Ė = −α |Π × Ω|².

    A coadjoint motion with ξ = Ω + α Π × Ω, which also moves the attitude, so that the momentum stays in space, as with
    losses inside the body. Every motion but those from the other axes ends in rotation about the axis of largest
    inertia: the major-axis rule, Explorer 1's lesson. State Π (…, 3), or with the attitude (…, 7).

    Args:
        moments: (3,) principal moments [kg m²], positive.
        rate: α [s/(kg m²)], not negative.

    Raises:
        InvalidInput: for moments that are not positive, or a rate that is negative or not finite.

    Source: Brockett, Linear Algebra Appl. 146 (1991) 79; Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175
    (1996) 1; Thomson & Reiter, J. Astronaut. Sci. 7 (1960) 29 for Explorer 1.
    """

    kind: ClassVar[str] = "damped-body"
    algebra: AbstractLieAlgebra
    moments: Float64[Array, "3"]
    rate: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, moments: Real[ArrayLike, "3"], rate: float) -> None:
        self.algebra, self.moments = SO3(), checked_moments(moments)
        self.rate = checked_number("rate", rate, least=0.0, unit="s/(kg m²)")

    def energy(self, point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(point * point / self.moments, axis=-1)

    def velocity(self, point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
        return point / self.moments

    def generator(self, t: Real[ArrayLike, "..."], point: Float64[Array, "*batch 3"]) -> Float64[Array, "*batch 3"]:
        velocity = self.velocity(point)
        return velocity + self.rate * jnp.cross(point, velocity)

    @property
    def conserves_energy(self) -> bool:
        return False

    def balances(self, t: Real[ArrayLike, "..."], state: Float64[Array, "..."]) -> dict[str, Balance]:
        point = self.parts(state).point
        # Ė = Ω·Π̇ = α Ω·(Π × (Π × Ω)) = −α |Π × Ω|²
        lost = self.rate * jnp.sum(jnp.cross(point, self.velocity(point)) ** 2, axis=-1)
        return {"energy": Balance(self.energy(point), -lost)}

"""A pendulum in a body that swings in every direction, as of fuel that sloshes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

import equinox as eqx
import jax.numpy as jnp

from polhode._base.arrays import known_numbers_only
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Argument, Attitude, Time, Velocity
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart, Coordinates
from polhode.systems._checks import checked_direction, checked_number, checked_vector
from polhode.types import Array, ArrayLike, Float64, Real


class SphericalPendulum(AbstractMovingPart):
    """A point mass on a rod about a pivot, in any direction: slosh as a pendulum.

    Its coordinates are q = n − n₀ along the body's axes, with n₀ the direction of the arm at rest and n a vector along
    it now. No angles are used, so that it may swing over the top, and round and round. The length |n| has no effect: it
    stays as it was at the start, as does the part of the canonical momentum along n, which is zero. The rate that
    ``pack`` takes is ω (3,), its angular velocity against the body. On it act a spring, whose energy is k (1 − cos θ)
    at the angle θ from rest, and the couple −c ω.

    Args:
        pivot: (3,) [m, body axes].
        arm: (3,) from the pivot to the mass at rest [m, body axes].
        mass: m [kg], positive.
        stiffness: k [N m/rad], not negative.
        damping: c [N m s], not negative.

    Raises:
        InvalidInput: for values out of range, an arm without length, a body without mass.

    Source: Dodge, *The New "Dynamic Behavior of Liquids in Moving Containers"* (2000), ch. 3; Abramson (ed.), *The
    Dynamic Behavior of Liquids in Moving Containers*, NASA SP-106 (1966), ch. 6.
    """

    name: ClassVar[str] = "pendulum"
    arguments: ClassVar[dict[str, Argument]] = {
        "pivot": Argument("m", (3,)),
        "arm": Argument("m", (3,)),
        "mass": Argument("kg"),
        "stiffness": Argument("N*m/rad"),
        "damping": Argument("N*m*s"),
    }
    start_arguments: ClassVar[dict[str, Argument]] = {
        "toward": Argument("", (3,)),
        "angular_velocity": Argument("rad/s", (3,)),
    }

    pivot: Float64[Array, "3"]
    arm: Float64[Array, "3"]
    mass: Float64[Array, ""]
    stiffness: Float64[Array, ""]
    damping: Float64[Array, ""]
    is_lossless: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, pivot: Real[ArrayLike, "3"], arm: Real[ArrayLike, "3"], mass: float, stiffness: float = 0.0,
        damping: float = 0.0,
    ) -> None:
        self.pivot, self.arm = checked_vector("pivot", pivot), checked_vector("arm", arm)
        checked_direction("arm", arm)
        self.mass = checked_number("mass", mass, 0.0, unit="kg")
        self.stiffness = checked_number("stiffness", stiffness, least=0.0, unit="N m/rad")
        self.damping = checked_number("damping", damping, least=0.0, unit="N m s")
        self.is_lossless = not float(self.damping)

    @property
    def along(self) -> Float64[Array, "3"]:
        """n₀, the direction of the arm at rest."""
        return self.arm / _norm(self.arm)

    def start_of(self, values: Mapping[str, Any]) -> tuple[Any, Any]:
        toward = values.get("toward")
        place = None if toward is None else checked_direction("toward", toward) - self.along
        return values.get("angular_velocity"), place

    @property
    def coordinates(self) -> tuple[StatePart, ...]:
        return (StatePart("deflection", 3, "1", "deflection of a pendulum's direction from rest", "given"),)

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def conserves_energy(self) -> bool:
        return self.is_lossless

    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        toward = self.along + q
        return self.pivot + self._length * toward / _norm(toward)[..., None]

    def gauge(self, q: Coordinates) -> Float64[Array, "*batch"]:
        # with it the mass matrix of q is m l² at |n| = 1, and nowhere singular
        return jnp.sqrt(self.mass) * self._length * _norm(self.along + q)

    def coordinate_rates(
        self, q: Float64[Array, "*#batch {self.count}"], rate: Float64[Array, "*#batch 3"]
    ) -> Float64[Array, "*batch {self.count}"]:
        return jnp.cross(rate, self.along + q)

    def potential(self, q: Coordinates) -> Float64[Array, "*batch"]:
        # 1 − cos θ = (|q|² − (|n| − 1)²)/(2 |n|), with |n|² − 1 = 2 n₀·q + |q|²: without differences near rest
        size, square = _norm(self.along + q), jnp.sum(q**2, axis=-1)
        longer = (2.0 * jnp.sum(self.along * q, axis=-1) + square) / (size + 1.0)
        return 0.5 * self.stiffness * (square - longer**2) / size

    def applied(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.count}"]:
        toward = self.along + own[..., :3]
        square = jnp.sum(toward**2, axis=-1)[..., None]
        across = rate - toward * jnp.sum(toward * rate, axis=-1)[..., None] / square
        return -self.damping * across / square

    @property
    def _length(self) -> Array:
        return _norm(self.arm)


def _norm(vector: Array) -> Array:
    return jnp.sqrt(jnp.sum(vector**2, axis=-1))

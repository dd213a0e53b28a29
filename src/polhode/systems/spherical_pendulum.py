"""A pendulum in a body that swings in every direction, as of fuel that sloshes."""

from __future__ import annotations

from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.systems._checks import checked_direction, checked_number, checked_vector
from polhode.systems.attachments import Argument, Attitude, Time, Velocity
from polhode.systems.moving_parts import AbstractMovingPart, Coordinates
from polhode.types import Array, ArrayLike, Float64, Real

ACROSS = 1e-9  # of a length, by which a direction must lie across another


class SphericalPendulum(AbstractMovingPart):
    """A point mass on a rod about a pivot, in any direction: slosh as a pendulum.

    Its coordinates are (u, v) = 2 tan(θ/2) (cos φ, sin φ), θ its angle from rest and φ the direction in which it leans:
    for small angles the angles themselves, and regular everywhere but at rest turned round. On it act a spring, whose
    energy is k (1 − cos θ), and −c ω of its angular velocity ω against the body.

    Args:
        pivot: (3,) [m, body axes].
        arm: (3,) from the pivot to the mass at rest [m, body axes].
        mass: m [kg], positive.
        stiffness: k [N m/rad], not negative.
        damping: c [N m s], not negative.
        leaning: (3,) a direction across the arm, of u; by default one of the body's axes made perpendicular to it.

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
        "leaning": Argument("", (3,)),
    }

    pivot: Float64[Array, "3"]
    arm: Float64[Array, "3"]
    across: Float64[Array, "2 3"]
    mass: Float64[Array, ""]
    stiffness: Float64[Array, ""]
    damping: Float64[Array, ""]
    is_lossless: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, pivot: Real[ArrayLike, "3"], arm: Real[ArrayLike, "3"], mass: float, stiffness: float = 0.0,
        damping: float = 0.0, leaning: Real[ArrayLike, "3"] | None = None,
    ) -> None:  # fmt: skip
        self.pivot, self.arm = checked_vector("pivot", pivot), checked_vector("arm", arm)
        along = np.asarray(checked_direction("arm", arm))
        wanted = np.eye(3)[np.argmin(np.abs(along))] if leaning is None else checked_direction("leaning", leaning)
        across = np.asarray(wanted) - along * np.dot(along, np.asarray(wanted))
        if not np.linalg.norm(across) > ACROSS:
            raise InvalidInput(f"`leaning` must lie across the arm {shown(arm)}; got {shown(leaning)}.")
        first = across / np.linalg.norm(across)
        self.across = np.linalg.norm(np.asarray(self.arm)) * jnp.asarray([first, np.cross(along, first)])
        self.mass = checked_number("mass", mass, 0.0, unit="kg")
        self.stiffness = checked_number("stiffness", stiffness, least=0.0, unit="N m/rad")
        self.damping = checked_number("damping", damping, least=0.0, unit="N m s")
        self.is_lossless = not float(self.damping)

    @property
    def coordinates(self) -> tuple[StatePart, ...]:
        return (StatePart("lean", 2, "1", "lean 2 tan(θ/2) of a pendulum"),)

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def conserves_energy(self) -> bool:
        return self.is_lossless

    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        quarter = 0.25 * jnp.sum(q**2, axis=-1)[..., None]  # tan²(θ/2)
        leaned = jnp.sum(q[..., :, None] * self.across, axis=-2)
        return self.pivot + ((1.0 - quarter) * self.arm + leaned) / (1.0 + quarter)

    def potential(self, q: Coordinates) -> Float64[Array, "*batch"]:
        quarter = 0.25 * jnp.sum(q**2, axis=-1)
        # 1 − cos θ = 2 tan²(θ/2)/(1 + tan²(θ/2))
        return 2.0 * self.stiffness * quarter / (1.0 + quarter)

    def applied(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.count}"]:  # fmt: skip
        # the map from (u, v) to directions is conformal, |ω| = |(u̇, v̇)|/(1 + tan²(θ/2))
        quarter = 0.25 * jnp.sum(own[..., :2] ** 2, axis=-1)[..., None]
        return -self.damping * rate / (1.0 + quarter) ** 2

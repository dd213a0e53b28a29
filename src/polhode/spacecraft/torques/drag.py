"""Drag of a flow about a body that turns."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.spacecraft.systems.attachments import Argument, Attitude, Own, Time, Velocity
from polhode.spacecraft.torques.base import AbstractTorque
from polhode.systems._checks import checked_number
from polhode.types import Array, ArrayLike, Float64, Real


class LinearDrag(AbstractTorque):
    """τ = −c Ω, the drag of a slow flow.

    Args:
        coefficient: c [N m s], one for all axes or one for each (3,), not negative.
    """

    name: ClassVar[str] = "linear-drag"
    arguments: ClassVar[dict[str, Argument]] = {"coefficient": Argument("N*m*s", many=True)}

    coefficient: Float64[Array, "*components"]

    @known_numbers_only
    def __init__(self, coefficient: Real[ArrayLike, "*components"]) -> None:
        shape, rule = (3,) if np.ndim(coefficient) else (), "one or three finite numbers, not negative"
        remedy = "Drag takes energy: give its size without a sign."
        values = check.array("coefficient", coefficient, shape, "N m s", least=0, rule=rule, remedy=remedy)
        self.coefficient = jnp.asarray(values)

    @property
    def names_all_jumps(self) -> bool:
        return True

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        return -self.coefficient * angular_velocity


class QuadraticDrag(AbstractTorque):
    """τ = −k |Ω| Ω, the drag of a fast flow.

    Args:
        coefficient: k [N m s²], not negative.
    """

    name: ClassVar[str] = "quadratic-drag"
    arguments: ClassVar[dict[str, Argument]] = {"coefficient": Argument("N*m*s^2")}

    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, coefficient: float) -> None:
        self.coefficient = checked_number("coefficient", coefficient, least=0.0, unit="N m s²")

    @property
    def names_all_jumps(self) -> bool:
        return True

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        return -self.coefficient * jnp.linalg.norm(angular_velocity, axis=-1, keepdims=True) * angular_velocity

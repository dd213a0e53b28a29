"""A torque of another package: the magnetic coils of a spacecraft that stop its tumbling by the B-dot law."""

from __future__ import annotations

from typing import Any, ClassVar

import jax.numpy as jnp

import polhode as ph
from polhode.spacecraft import AbstractTorque, Argument


class BDotCoils(AbstractTorque):
    """Torque m × B of coils whose moment is m = −k dB/dt, B being measured along the body.

    A field that is constant in space changes along the body by dB/dt = B × Ω, so that the torque is k (Ω × B) × B.

    Source: Stickler & Alfriend, J. Spacecraft and Rockets 13 (1976) 282.
    """

    arguments: ClassVar[dict[str, Argument]] = {"gain": Argument("A*m^2*s/T"), "field": Argument("T", (3,))}

    gain: float  # k [A m² s/T]
    field: tuple[float, float, float]  # B, constant in space [T]

    @property
    def needs_attitude(self) -> bool:
        return True

    def torque(self, t: Any, attitude: Any, angular_velocity: Any, actuator: Any = None) -> Any:
        field = ph.rotation.rotate(ph.rotation.conjugate(attitude), jnp.asarray(self.field))
        return self.gain * jnp.cross(jnp.cross(angular_velocity, field), field)

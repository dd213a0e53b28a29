"""The equations of motion of a spherical pendulum."""

from __future__ import annotations

from typing import Any, ClassVar

import jax.numpy as jnp

from polhode.motion import Quantity, StateLayout, StatePart
from polhode.systems import AbstractSystem

Array = Any
NAMES = (("x", "m"), ("y", "m"), ("z", "m"), ("v_x", "m s-1"), ("v_y", "m s-1"), ("v_z", "m s-1"))
LAYOUT = StateLayout(tuple(StatePart(name, 1, unit, f"{name} of the mass, from the pivot") for name, unit in NAMES))


class SphericalPendulum(AbstractSystem):
    """r̈ = −g e_z + (g z − |v|²) r/l², for |r| = l; state (r, v) (…, 6)."""

    title: ClassVar[str] = "Spherical pendulum"
    kind: ClassVar[str] = "spherical-pendulum"
    has_vertical: ClassVar[bool] = True
    length: Array
    gravity: Array

    def vector_field(self, t: Array, state: Array) -> Array:
        place, velocity = state[..., :3], state[..., 3:]
        pull = (self.gravity * state[..., 2:3] - jnp.sum(velocity**2, axis=-1, keepdims=True)) / self.length**2
        weight = jnp.array([0.0, 0.0, -1.0]) * self.gravity
        return jnp.concatenate([velocity, weight + pull * place], axis=-1)

    def invariants(self, state: Array) -> dict[str, Array]:
        x, y, z, u, v, w = (state[..., k] for k in range(6))
        return {
            "energy_per_mass": 0.5 * (u**2 + v**2 + w**2) + self.gravity * z,
            "vertical_momentum_per_mass": x * v - y * u,
        }

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {
            "energy_per_mass": Quantity("m2 s-2", "energy per mass"),
            "vertical_momentum_per_mass": Quantity("m2 s-1", "angular momentum about the vertical, per mass"),
        }

    def layout(self, state: Array) -> StateLayout:
        return LAYOUT

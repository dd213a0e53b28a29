"""An exact motion of another package: a spinning charged ball in a uniform magnetic field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

import polhode as ph
from polhode.motion import AbstractMotion, Quantity

UP = np.array([0.0, 0.0, 1.0])  # the field's direction in space


@dataclass(frozen=True, eq=False, init=False)
class ChargedBall(AbstractMotion):
    """A ball whose magnetic moment γL is turned by the field B along space z: dL/dt = γ L × B, Ω = L/I.

    L goes round the field at the Larmor rate w = −γB. Seen in a frame that turns with it, the ball turns steadily, so
    that R(t) = exp(t w ẑ) exp(t (Ω − w ẑ)) R(0), with Ω at the epoch, in space.

    Args:
        moment: (…) I about any axis [kg m²].
        larmor_rate: (…) w [rad/s].
        momentum, attitude, epoch, axes: as of ``FreeMotion``.

    Source: Goldstein, Poole & Safko, *Classical Mechanics*, §5.9.
    """

    title: ClassVar[str] = "Charged ball"
    has_vertical: ClassVar[bool] = True
    body_numbers: ClassVar[tuple[str, ...]] = ("larmor_rate",)
    larmor_rate: Any

    def __init__(self, moment, *, larmor_rate, momentum, attitude=None, epoch=0.0, axes=None):
        moments = np.asarray(moment)[..., None] * np.ones(3)
        super().__init__(moments, {"larmor_rate": larmor_rate}, momentum, attitude, epoch, None, axes)

    def closed_form(self, elapsed, rest):
        attitude, momentum = self.principal_start
        in_space = ph.rotation.rotate(attitude, momentum)
        larmor = self.larmor_rate[..., None] * UP
        turned = ph.rotation.from_rotation_vector(elapsed[..., None] * (in_space / self.moments - larmor))
        within = ph.rotation.multiply(turned, attitude)  # body → the frame that goes round with L
        around = ph.rotation.from_rotation_vector(elapsed[..., None] * larmor)
        return ph.rotation.multiply(around, within), ph.rotation.rotate(ph.rotation.conjugate(within), in_space)

    @property
    def fastest_rate(self):
        _, momentum = self.principal_start
        return abs(momentum / self.moments).sum(axis=-1) + abs(self.larmor_rate)

    @property
    def cycle(self):
        return 2.0 * np.pi / max(float(self.fastest_rate), 1e-3)

    @property
    def quantities(self):
        return {
            "energy": Quantity("J", "energy of rotation"),
            "momentum_along_the_field": Quantity("kg m2 s-1", "angular momentum along the field"),
        }

    def conserved_along(self, attitude, momentum, angular_velocity):
        return {
            "energy": 0.5 * (momentum * angular_velocity).sum(axis=-1),
            "momentum_along_the_field": ph.rotation.rotate(attitude, momentum)[..., 2],
        }

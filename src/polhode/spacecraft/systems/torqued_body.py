"""A rigid body under torques alone, without mounts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems.mounts import AbstractMounted
from polhode.spacecraft.systems.rigid_body import AbstractRigidBody
from polhode.spacecraft.torques import AbstractTorque, checked_torques
from polhode.systems.free_rigid_body import checked_moments
from polhode.types import Array, ArrayLike, Float64, Real


class TorquedBody(AbstractRigidBody):
    """L̇ = L × Ω + Σ τ along principal axes, dR/dt = R hat(Ω): a ``RigidBody`` without mounts.

    State L (…, 3) where no torque asks for the attitude, or attitude and L (…, 7). Nothing is conserved in general; the
    kinetic energy changes by the torques' power τ·Ω, |L|² by 2 τ·L, and on a circular orbit the Jacobi integral by the
    power of all torques but gravity's in the orbit's frame. ``simulate`` reports the residuals of these balances.

    Args:
        moments: (3,) principal moments [kg m²], positive.
        torques: any number of them.

    Raises:
        InvalidInput: for moments that are not positive, anything but a torque, or a gravity gradient on other moments.

    >>> from polhode.spacecraft.torques import LinearDrag
    >>> body = TorquedBody((1.0, 2.0, 3.0), [LinearDrag(0.5)])
    >>> body.vector_field(0.0, body.pack(momentum=(0.0, 0.0, 3.0))).tolist()
    [0.0, 0.0, -0.5]
    """

    title: ClassVar[str] = "Body under torques"
    moments: Float64[Array, "3"]
    mounts: tuple[AbstractMounted, ...]
    torques: tuple[AbstractTorque, ...]
    structure: None

    @known_numbers_only
    def __init__(self, moments: Real[ArrayLike, "3"], torques: Sequence[AbstractTorque]) -> None:
        self.moments, self.mounts, self.structure = checked_moments(moments), (), None
        frame = BodyFrame(np.asarray(self.moments), np.eye(3), np.zeros(3), None)
        self.torques = checked_torques(torques, frame)

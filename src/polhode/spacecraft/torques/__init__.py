"""Torques on a body, in its axes: one file for each family of them."""

from polhode.spacecraft.torques.base import AbstractTorque, checked_torques, in_body, torque_of
from polhode.spacecraft.torques.drag import LinearDrag, QuadraticDrag
from polhode.spacecraft.torques.gravity import GravityGradient
from polhode.spacecraft.torques.lagged import LaggedTorque

__all__ = [
    "AbstractTorque", "GravityGradient", "LaggedTorque", "LinearDrag", "QuadraticDrag", "checked_torques",
    "in_body", "torque_of",
]  # fmt: skip

"""Motions, exact or sampled: the data that other rooms make and use."""

from polhode.motion.base import AbstractMotion
from polhode.motion.frame import BodyFrame
from polhode.motion.layout import Quantity, StateLayout, StatePart
from polhode.motion.outcome import Ending, Ends, Outcome, Status
from polhode.motion.trajectory import Trajectory

__all__ = [
    "AbstractMotion",
    "BodyFrame",
    "Ending",
    "Ends",
    "Outcome",
    "Quantity",
    "StateLayout",
    "StatePart",
    "Status",
    "Trajectory",
]


def __dir__() -> list[str]:
    return __all__

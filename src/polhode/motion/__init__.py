"""Motions, exact or sampled: the data that other rooms make and use."""

from polhode.motion._layout import ATTITUDE, MOMENTUM, Quantity, StateLayout, StatePart
from polhode.motion._outcome import Ending, Ends, Outcome, Status
from polhode.motion._plan import MotionPlan, Stepping
from polhode.motion._trajectory import Trajectory
from polhode.motion.base import AbstractMotion
from polhode.motion.frame import BodyFrame

__all__ = [
    "ATTITUDE",
    "MOMENTUM",
    "AbstractMotion",
    "BodyFrame",
    "Ending",
    "Ends",
    "MotionPlan",
    "Outcome",
    "Quantity",
    "StateLayout",
    "StatePart",
    "Status",
    "Stepping",
    "Trajectory",
]


def __dir__() -> list[str]:
    return __all__

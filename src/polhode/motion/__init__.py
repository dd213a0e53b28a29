"""Motions, exact or sampled: the data type between systems and everything that uses their motion."""

from polhode.motion.base import AbstractMotion
from polhode.motion.layout import Quantity, StateLayout, StatePart
from polhode.motion.outcome import Ending, Ends, Outcome, Status
from polhode.motion.trajectory import Trajectory

__all__ = [
    "AbstractMotion",
    "Ending",
    "Ends",
    "Outcome",
    "Quantity",
    "StateLayout",
    "StatePart",
    "Status",
    "Trajectory",
]

"""What a motion is, exact or sampled: the currency between what moves and what is made of it."""

from polhode.motion.base import AbstractMotion
from polhode.motion.layout import Quantity, StateLayout, StatePart
from polhode.motion.outcome import Ending, Outcome
from polhode.motion.trajectory import Trajectory

__all__ = ["AbstractMotion", "Ending", "Outcome", "Quantity", "StateLayout", "StatePart", "Trajectory"]

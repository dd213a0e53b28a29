"""The names from other rooms that authors of kinds need, gathered for ``polhode.kinds``."""

from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.reports.about import about_body, accuracy, from_motion
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport, SystemReport
from polhode.spec.fields import (
    Acceleration,
    Angle,
    Direction,
    Duration,
    Flag,
    Lean,
    Length,
    Mass,
    Moment,
    Plain,
    Rate,
    one_of,
    quantity,
)
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

__all__ = [
    "STANDARD_GRAVITY", "WITHOUT_MOTION", "Acceleration", "Angle", "Answer", "Direction", "Duration", "Flag", "Group",
    "Lean", "Length", "Mass", "Mistake", "Moment", "MotionReport", "Plain", "Rate", "SystemReport", "SystemTable",
    "Table", "about_body", "accuracy", "from_motion", "one_of", "quantity",
]  # fmt: skip

"""What the author of a kind needs from other packages of polhode, exported by ``polhode.kinds``."""

from polhode.reports.about import about_body, accuracy
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport, SystemReport
from polhode.spec.fields import Angle, Direction, Duration, Flag, Length, Mass, Moment, Plain, Rate, one_of, quantity
from polhode.spec.models import SystemTable

__all__ = [
    "Angle", "Answer", "Direction", "Duration", "Flag", "Group", "Length", "Mass", "Moment", "MotionReport", "Plain",
    "Rate", "SystemReport", "SystemTable", "Table", "about_body", "accuracy", "one_of", "quantity",
]  # fmt: skip

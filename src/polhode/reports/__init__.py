"""From answers to text and JSON: what a report is, and the words that all of them share."""

from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport, SystemReport
from polhode.reports.report import Report, StudyReport

__all__ = ["Answer", "Group", "MotionReport", "Report", "StudyReport", "SystemReport", "Table"]


def __dir__() -> list[str]:
    return __all__

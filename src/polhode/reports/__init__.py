"""Reports: how answers become text and JSON, and the wording that all reports share."""

from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import MotionReport, SystemReport
from polhode.reports.report import Report, StudyReport

__all__ = ["Answer", "Group", "MotionReport", "Report", "StudyReport", "SystemReport", "Table"]


def __dir__() -> list[str]:
    return __all__

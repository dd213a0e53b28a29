"""From answers to text and JSON: what a report is, and the words that all of them share."""

from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import AbstractMotionReport, AbstractReport

__all__ = ["AbstractMotionReport", "AbstractReport", "Answer", "Group", "Table"]

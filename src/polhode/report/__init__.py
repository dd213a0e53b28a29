"""The plain answers about a body, a top, a disk: what command, page and sweep all use."""

from polhode.report.base import AbstractReport, Listing, Section
from polhode.report.free_body import FreeBodyReport, body_json, free_body_report

__all__ = ["AbstractReport", "FreeBodyReport", "Listing", "Section", "body_json", "free_body_report"]

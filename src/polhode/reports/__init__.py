"""From answers to text and JSON: what a report is, and the words that all of them share."""

from polhode.reports.base import AbstractReport, Listing, Section

__all__ = ["AbstractReport", "Listing", "Section"]

"""The figures of a heavy top, which are those of any top."""

from polhode.figures.top import FIGURES, OVERVIEW

__all__ = ["FIGURES", "OVERVIEW"]

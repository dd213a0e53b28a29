"""The figures of a Lagrange top, which are those of any top."""

from polhode.figures.top import FIGURES

__all__ = ["FIGURES"]

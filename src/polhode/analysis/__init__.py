"""Answers about motions and systems: verdicts with certificates, periods, precession, how motions differ and end."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

"""Checks of the laws that algebras and systems must obey, and hard motions by which to judge an engine."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

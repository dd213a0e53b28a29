"""Certificates of stability as exact data: the search, and checks."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

"""Reads and writes motions and bodies, in polhode's own file formats and in those of other tools."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

"""Reads and writes motions and bodies, in polhode's own file formats and in those of other tools."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

"""Figures for papers and reports, all in one style: matplotlib figures, saved by ``save``."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

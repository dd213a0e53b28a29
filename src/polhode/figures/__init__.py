"""Figures for papers and reports, all in one style: matplotlib figures, saved by ``save``."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

"""How does this thing rotate? Exact rigid-body motion and what it means."""

from polhode._base.extras import attach_stub

__version__ = "0.2.0"

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

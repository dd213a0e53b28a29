"""Special functions in double and double-double precision: elliptic integrals and functions, theta functions."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

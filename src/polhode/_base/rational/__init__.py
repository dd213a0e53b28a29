"""Exact arithmetic with fractions: the rational values of doubles, polynomials, linear algebra."""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

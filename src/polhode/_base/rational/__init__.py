"""Exact arithmetic with fractions: the rational values of doubles, polynomials, linear algebra."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

"""Poisson geometry on the dual of a Lie algebra: brackets, orbits with their form, reduction and reconstruction."""

import polhode.algebra  # noqa: F401  # which switches JAX to 64 bits
from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

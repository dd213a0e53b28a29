"""Poisson geometry on the dual of a Lie algebra: brackets, orbits with their form, reduction and reconstruction."""

import lazy_loader

import polhode.algebra  # noqa: F401  # which switches JAX to 64 bits

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

"""Lie algebras, their duals and the actions of their groups. Importing this room switches JAX to 64 bits."""

from polhode._base.extras import attach_stub
from polhode.algebra._precision import enable_double_precision

enable_double_precision()

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

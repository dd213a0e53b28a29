"""Systems that move: Hamiltonians on the duals of Lie algebras, bodies under torques, spins on orbits."""

import polhode.algebra  # noqa: F401  # which switches JAX to 64 bits
from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

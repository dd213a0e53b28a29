"""Fields and many bodies: what moves when the algebra is not that of a single rotation.

It answers how spins on a lattice precess, relax and make waves, how point vortices move in a plane or on a sphere, how
an ideal fluid and a conducting one move on a sphere, how a plasma's waves grow or are damped, and how a Toda chain
moves. Sources: Krech, Bunker and Landau (1998) for spins, Kidambi and Newton (1998) for vortices, Zeitlin (2004), Modin
and Viviani (2020) for fluids, Evstatiev and Shadwick (2013) for plasmas, Flaschka (1974) for the chain. From the core
it takes ``algebra``, ``systems``, ``integrators``, ``solving`` and verdicts on stability (``analysis``).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

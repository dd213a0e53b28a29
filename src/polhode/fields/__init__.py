"""Fields and many bodies: what moves when the algebra is not that of a single rotation.

It answers how spins on a lattice precess, relax and make waves, how point vortices, an ideal fluid and a conducting one
move on a sphere, how a plasma's waves grow or are damped, and how a Toda chain scatters. The fluids are those of
Zeitlin (2004) with the integrators of Modin and Viviani (2020), plasmas are particles in some Fourier modes of their
field as Evstatiev and Shadwick (2013) have them. From the core it takes algebras, systems, integrators and stability.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

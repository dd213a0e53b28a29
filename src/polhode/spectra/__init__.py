"""Quantum rotors: spins and molecules, the quantised orbits of so(3)*.

It answers at which energies a molecule rotates and which lines it has, fits its constants to measured lines, and shows
the flip of a racket as a wave packet. Hamiltonians are Watson's (1977), spherical tensors those of Varshalovich et al.
(1988), files those of Pickett's SPFIT and SPCAT (1991). From the core it takes moments, polhodes and exact motions.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

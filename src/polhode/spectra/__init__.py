"""Quantum rotors: spins and molecules, the quantised orbits of so(3)*.

It answers at which energies a molecule rotates and which lines it has, fits its constants to measured lines, and shows
the flip of a racket as a wave packet. Sources: Watson (1977) on reduced operators, Varshalovich, Moskalev and
Khersonskii (1988) on spherical tensors, Pickett (1991) on the files of SPFIT and SPCAT. From the core it takes moments
(``bodies``), polhodes (``analysis``) and free bodies (``exact``).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

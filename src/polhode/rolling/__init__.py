"""A disk that rolls on a table: Euler's disk, from its wobble to the sudden end.

It answers how fast a coin rolls steadily and whether that is stable, how its path bends, and how its motion ends under
each of six ways of losing energy. The mechanics are those of Appell (1900) and O'Reilly (1996), the losses those of
Moffatt (2000), Bildsten (2002) and Leine (2009) beside the classical couple. From the core it takes ``integrators`` and
``simulation``, Legendre functions (``special``) and verdicts on steady motions (``analysis``).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

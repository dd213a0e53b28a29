"""Spacecraft: rigid bodies with wheels, gyroscopes, moving parts, torques and control, and files of their attitude.

It answers how a satellite turns under what is mounted in it and what acts on it, when dissipation makes its spin flat,
and how two attitude histories differ. Sources: Hughes (1986), Wertz (1978), the CCSDS books 504.0 and 505.0, and NAIF's
documents on SPICE. From the core it takes ``bodies``, trajectories (``motion``), the Kepler orbit and the double
bracket (``systems``), ``simulation`` and verdicts on stability (``analysis``).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

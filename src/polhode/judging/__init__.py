"""Is another engine right: tables of hard motions, and verdicts on an engine's states of them.

It answers of which order a physics engine's method is, how its energy and momentum drift, and which known mistake
explains its errors, from its states in a file or from its step in Python. Judged are free bodies; the tables have
Lagrange tops too, exact to rounding. Sources: Richardson (1927) and Roache (1994) on observed orders. From the core it
takes closed forms (``exact``) and ``rotation``; from the application reports and a figure.
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

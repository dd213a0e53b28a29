"""How bodies in the sky rotate: asteroids that tumble, moons in resonance, the Earth's wobble.

It answers in which mode an asteroid tumbles and what its light curve shows, which spin–orbit resonances hold a moon and
where their chaos begins, and the period and quality of the Chandler wobble. Sources: Samarasinha and A'Hearn (1991),
Wisdom, Peale and Mignard (1984), Wilson and Vicente (1990). From the core it takes free bodies (``exact``), the Kepler
orbit (``systems``), ``simulation``, and estimates with their noise (``estimation``).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

"""The Lagrange top in closed form.

``motion`` has the public class. The steps are those of the free body: ``reduction`` forms the invariants exactly,
``roots`` finds the turning points, ``frequencies`` and ``preparation`` make the constants, ``series`` evaluates, and
``geometry`` has the numbers that describe the motion. ``evaluation`` runs them, by the modules ``kernel…`` for NumPy.
The derivative is in ``tangent``, from ``flow`` (less than a nutation), ``periods`` (whole nutations) and ``standing``
(tops whose axis stays vertical).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

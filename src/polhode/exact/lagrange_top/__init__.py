"""The Lagrange top in closed form.

``motion`` has the public class. All else is formulas over words: ``formulas_reduction`` forms the invariants exactly,
``formulas_roots`` finds the turning points, ``formulas_rates``, ``formulas_integrals`` and ``formulas_setup`` make the
constants, ``formulas`` evaluates. ``preparation`` runs them for arrays, the modules ``kernel…`` for one top or
many by Python and Numba; ``geometry`` has the numbers that describe the motion.
The derivative is in ``tangent``, from ``flow`` (less than a nutation), ``periods`` (whole nutations) and ``standing``
(tops whose axis stays vertical).
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)

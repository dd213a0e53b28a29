"""The free rigid body in closed form.

``motion`` has the public class. Set-up is done once a body, evaluation once a time, in these steps:

1. ``formulas_reduction`` sorts the axes, maps long-axis motion onto short-axis motion by reversing their order, and
   forms the invariants A, B, C, P, Q and S in double-double, S exactly.
2. ``formulas_rates`` gets the rates of the polhode and of the frame from one arithmetic–geometric mean.
3. ``formulas_setup`` finds the arguments of the theta functions by Landen's transformation, and the series'
   coefficients.
4. ``formulas`` evaluates: phases reduced to a fraction of a turn, two short series, one 4×4 matrix.
5. ``geometry`` has periods, precession and the other numbers that describe the motion.

``evaluation`` runs them, for arrays by ``preparation``. For NumPy it calls the modules ``kernel…``, which do the same
steps for one body and one time: as plain Python for little work, compiled by Numba for much. For JAX set-up and
evaluation are one operation, whose Jacobian comes from ``derivative``, ``tangent`` and ``tangent_kernel``; on the CPU
it calls the kernels.
"""

from polhode.exact.free_body.motion import FreeMotion

__all__ = ["FreeMotion"]

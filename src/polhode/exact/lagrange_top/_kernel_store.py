"""How the kernels store a block of tops: records of the formulas, in rows of BLOCK numbers."""

from __future__ import annotations

from polhode.exact._kernel_arithmetic import BLOCK, Pair
from polhode.exact._kernel_records import rows_of
from polhode.exact.lagrange_top._formulas import Four
from polhode.exact.lagrange_top._formulas_integrals import Integrals
from polhode.exact.lagrange_top._formulas_rates import Frequencies, Starts
from polhode.exact.lagrange_top._formulas_reduction import Reduction, Scaled
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.exact.lagrange_top._formulas_setup import Arguments, Timing

# what reduction and turning points find, kept when the tops are sorted by the form that they take. AGAIN is the mean of
# the second sum's run, whose last digits may be others
TOP, POINTS, BEGUN, MEAN, AGAIN, ALPHA, BETA, EXPONENT, RATES, INTEGRALS, AT, TAILS, TIMING, ROWS = rows_of(
    Reduction, TurningPoints, Starts, Pair, Pair, Pair, Pair, tuple[float], Frequencies, Integrals, Arguments, Four,
    Timing,
)
KEPT = BEGUN // BLOCK
# beside what is kept, before the tops are sorted. SPARE is below zero where too much cancels; UP says whether the upper
# root stands apart, 0 or 1, and is below zero for a top that is left to NumPy
_, _, SCALED, SPARE, UP, ROOT, SLOPE, ALL = rows_of(
    Reduction, TurningPoints, Scaled, tuple[float], tuple[float], Pair, Pair
)
V_ALPHA, V_BETA, W_ALPHA, W_BETA, X0 = range(INTEGRALS, INTEGRALS + 5 * BLOCK, BLOCK)

"""How the kernels store a block of tops: records of the formulas, in rows of BLOCK numbers."""

from __future__ import annotations

from polhode.exact._kernel_arithmetic import BLOCK, Pair
from polhode.exact._kernel_records import rows_of
from polhode.exact.lagrange_top._formulas import Four
from polhode.exact.lagrange_top._formulas_integrals import Integrals
from polhode.exact.lagrange_top._formulas_rates import Frequencies, Starts
from polhode.exact.lagrange_top._formulas_roots import Reduction, TurningPoints
from polhode.exact.lagrange_top._formulas_setup import Arguments, Timing

# what reduction and turning points find, kept when the tops are sorted by the form that they take. AGAIN is the mean of
# the second sum's run, whose last digits may be others
TOP, POINTS, BEGUN, MEAN, AGAIN, ALPHA, BETA, EXPONENT, RATES, INTEGRALS, AT, TAILS, TIMING, ROWS = rows_of(
    Reduction, TurningPoints, Starts, Pair, Pair, Pair, Pair, tuple[float], Frequencies, Integrals, Arguments, Four,
    Timing,
)
KEPT = BEGUN // BLOCK
# the fields of ``Reduction``, single ones and pairs
I1, I3, L1, L2, L3, E0, E1, E2, E3, REVERSED, LIFT, SIZE, RATE = range(TOP, TOP + 13 * BLOCK, BLOCK)
NORM, G, S0, T0, U0, P, C, C_PLUS, TWIST, F, D, W2, LEAN = range(TOP + 13 * BLOCK, POINTS, 2 * BLOCK)
# those of ``TurningPoints``
LOWER, UPPER, GAP, S1, S2, T1, T2, A, B, Y, Z_MINUS, Z_PLUS = range(POINTS, BEGUN, 2 * BLOCK)
V_ALPHA, V_BETA, W_ALPHA, W_BETA, X0 = range(INTEGRALS, INTEGRALS + 5 * BLOCK, BLOCK)
# UP says first whether too much cancels (below zero), then whether a top is NumPy's (above), then whether its upper
# root stands apart (0 or 1; below zero it is NumPy's). NOME is the size of what is taken from F
UP, NOME = BEGUN, BEGUN + BLOCK

"""How the kernels store a block of tops: rows of BLOCK numbers, two adjacent rows for a double-double number."""

from __future__ import annotations

from polhode.exact._kernel_arithmetic import (
    BLOCK,
)

# what reduction and turning points find, kept when the tops are sorted by the form that they take. The first are
# single, the second in pairs. UP says first whether too much cancels (below zero), then whether a top is NumPy's
# (above), then whether its upper root stands apart (0 or 1; below zero it is NumPy's)
(I1, I3, L1, L2, L3, E0, E1, E2, E3, SIDE, SIZE, RATE, UP, NOME) = range(0, 14 * BLOCK, BLOCK)
(NORM, G, S0, T0, U0, P, C, C_PLUS, TWIST, F, D, W2, LOWER, UPPER, GAP, S1, S2, T1, T2, A, B, Y, Z_MINUS,
 Z_PLUS) = range(14 * BLOCK, 62 * BLOCK, 2 * BLOCK)
KEPT = 62
# of what is found afterwards
(HALF_ROOT, MEAN, SUM, NUTATION, ALPHA, BETA, X0) = range(62 * BLOCK, 76 * BLOCK, 2 * BLOCK)
(V_ALPHA, V_BETA, W_ALPHA, W_BETA, Y_ALPHA, Y_BETA, R_ALPHA, R_BETA, THETA3, LINEAR_A, LINEAR_B, TURN,
 SIGN_A, SIGN_B) = range(76 * BLOCK, 90 * BLOCK, BLOCK)
ROWS = 90

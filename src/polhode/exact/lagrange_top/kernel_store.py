"""Where the kernels keep a block of tops: rows of BLOCK numbers, a double-double number in two rows that follow."""

from __future__ import annotations

from polhode.exact.kernel_arithmetic import BLOCK

# what reduction, turning points and frequencies find, kept when the tops are sorted by the form that they take;
# numbers in pairs of rows have a gap behind them
(I1, I3, L1, L2, L3, E0, E1, E2, E3, SIDE, SIZE, RATE, UP, NOME, PARAMETER) = range(0, 15 * BLOCK, BLOCK)
(NORM, G, S0, T0, U0, P, C, C_PLUS, TWIST, F, D, W2, LOWER, UPPER, GAP, S1, S2, T1, T2, A, B, Y, Z_MINUS,
 Z_PLUS) = range(15 * BLOCK, 63 * BLOCK, 2 * BLOCK)  # fmt: skip
KEPT = 63
# of what is found afterwards
(HALF_ROOT, MEAN, SUM, NUTATION, ALPHA, BETA, X0) = range(63 * BLOCK, 77 * BLOCK, 2 * BLOCK)
(V_ALPHA, V_BETA, W_ALPHA, W_BETA, Y_ALPHA, Y_BETA, R_ALPHA, R_BETA, THETA3, LINEAR_A, LINEAR_B, TURN,
 SIGN_A, SIGN_B) = range(77 * BLOCK, 91 * BLOCK, BLOCK)  # fmt: skip
ROWS = 91

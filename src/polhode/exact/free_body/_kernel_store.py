"""Where the kernels keep a block of bodies: rows of BLOCK numbers, a double-double number in two rows that follow."""

from __future__ import annotations

from polhode.exact._kernel_arithmetic import BLOCK

# what is formed before the bodies are sorted by the form that they take, the first single, the second in pairs
I1, I2, I3, L1, L2, L3, FIRST, SECOND, THIRD, PARITY, SIZE, RATE = range(0, 12 * BLOCK, BLOCK)
A, B, C, P, Q, GG, S = range(12 * BLOCK, 26 * BLOCK, 2 * BLOCK)
KEPT = 26
# of what is found afterwards; LONG is −1 after the mirror, LEAD what the third-kind sum is multiplied by
X1, X3, LONG, HALF, UP, ACROSS, E0, E1, E2, E3 = range(26 * BLOCK, 36 * BLOCK, BLOCK)
LEAD, V, G, FAST, MEAN, SUM = range(36 * BLOCK, 48 * BLOCK, 2 * BLOCK)
ROWS = 48

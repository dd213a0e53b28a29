"""The blocks of the rotational Hamiltonian in Wang's basis |K±⟩ = (|K⟩ ± |−K⟩)/√2, and their levels.

H keeps the parity of K and the sign, so that a J falls into four blocks E± (K even) and O± (K odd) of about J/2 rows,
tridiagonal for a rigid rotor and in the A reduction, banded in the S reduction. Source: Wang, Phys. Rev. 34 (1929) 243.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg import eig_banded, eigh_tridiagonal

from polhode.spectra._operators import Representation, Term, matrix_elements
from polhode.types import Array, Float64, Integer


class Block(NamedTuple):
    """One of a J's four blocks: the parity of K, the sign, and its values of K, (k,)."""

    odd: int
    sign: int
    K: Float64[Array, "k"]


def blocks(J: int) -> Iterator[Block]:
    """Yield E+, E−, O+, O− of a whole J, those that are not empty."""
    for odd in (0, 1):
        for sign in (1, -1):
            first = 1 if odd else (0 if sign > 0 else 2)
            K = np.arange(first, J + 1, 2, dtype=float)
            if len(K):
                yield Block(odd, sign, K)


def band(terms: list[tuple[float, Term]], J: int, block: Block) -> Float64[Array, "bands k"]:
    """Return the block's lower bands, row n those n places below the diagonal, as ``eig_banded`` takes them."""
    width = max([term.of_ladder for _, term in terms] + [1])
    K, count = block.K, len(block.K)
    rows = np.zeros((width + 1, count))
    for n in range(min(width, count - 1) + 1):
        rows[n, : count - n] = matrix_elements(terms, J, K[: count - n], n)
    # ⟨K'|H|−K⟩ with K + K' = 2n joins the two signs near K = 0; |0⟩ is one state, not two
    for n in range(1, width + 1):
        # ⟨K′±|H|K±⟩ = ⟨K′|H|K⟩ ± ⟨K′|H|−K⟩ for K, K′ > 0
        crossing = matrix_elements(terms, J, -K, n)
        for column, k in enumerate(K):
            row = round((2 * n - k - K[0]) / 2)
            if k > 0 and column <= row < count and K[row] > 0:
                rows[row - column, column] += block.sign * crossing[column]
    if K[0] == 0.0:
        # ⟨K′+|H|0⟩ = √2 ⟨K′|H|0⟩
        rows[1:, 0] *= np.sqrt(2.0)
    return rows


def energies(rows: Float64[Array, "bands k"]) -> Float64[Array, "k"]:
    """Return a block's levels, ascending."""
    if rows.shape[1] == 1:
        return rows[0].copy()
    values: Any
    if not rows[2:].any():
        values = eigh_tridiagonal(rows[0], rows[1, :-1], eigvals_only=True)
    else:
        values = eig_banded(rows[: rows.shape[1]], lower=True, eigvals_only=True)
    return values


def eigenvectors(rows: Float64[Array, "bands k"]) -> tuple[Float64[Array, "k"], Float64[Array, "k k"]]:
    """Return a block's levels, ascending, and their states by columns."""
    if rows.shape[1] == 1:
        return rows[0].copy(), np.ones((1, 1))
    eigensystem: Any
    if not rows[2:].any():
        eigensystem = eigh_tridiagonal(rows[0], rows[1, :-1])
    else:
        eigensystem = eig_banded(rows[: rows.shape[1]], lower=True)
    return eigensystem


def labels(J: int, block: Block, representation: Representation) -> tuple[Integer[Array, "k"], Integer[Array, "k"]]:
    """Return K_a and K_c of a block's levels, lowest first, for A ≥ B ≥ C.

    Level i of all of a J has K_a = ⌊(i+1)/2⌋ and K_c = J − ⌊i/2⌋. A half turn about a multiplies its state by
    (−1)^K_a, one about c by (−1)^K_c, and |K±⟩ by (−1)^K about z, ±(−1)^J about x, ±(−1)^(J+K) about y: this
    gives the levels of the block in any representation.
    """
    about_x = (1 - block.sign) // 2 + J
    parity = dict(zip(representation.value, (about_x, about_x + block.odd, block.odd), strict=True))
    order = np.arange(2 * J + 1)
    Ka, Kc = (order + 1) // 2, J - order // 2
    own = ((Ka - parity["a"]) % 2 == 0) & ((Kc - parity["c"]) % 2 == 0)
    return Ka[own], Kc[own]

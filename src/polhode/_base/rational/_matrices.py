"""Linear algebra over the rationals that python-flint's matrices lack: null spaces, squares, signatures, Routh's count.

A basis is a matrix whose rows are its vectors.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_poly

from polhode._base.rational.numbers import nearest_double
from polhode.types import Float64

Rows = Sequence[Sequence[fmpq]]
Squares = tuple[tuple[fmpq, tuple[fmpq, ...]], ...]
"""Pairs of d > 0 and ℓ (n,), of Σ d (ℓ·x)²."""


def matrix(rows: Rows, columns: int) -> fmpq_mat:
    """Return rows, of which there may be none, as a matrix."""
    return fmpq_mat(len(rows), columns, [x for row in rows for x in row])


def identity(n: int) -> fmpq_mat:
    """Return the identity (n, n)."""
    return fmpq_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])


def combine(weights: Iterable[fmpq], matrices: Sequence[fmpq_mat]) -> fmpq_mat:
    """Return Σ w M."""
    zero = fmpq_mat(matrices[0].nrows(), matrices[0].ncols())
    return sum((w * m for w, m in zip(weights, matrices, strict=True)), zero)


def as_floats(a: fmpq_mat) -> Float64[np.ndarray, "rows columns"]:
    """Return a matrix in doubles, with infinities beyond the largest."""
    return np.array([nearest_double(x) for x in a.entries()]).reshape(a.nrows(), a.ncols())


def reduce_rows(a: fmpq_mat) -> tuple[list[list[fmpq]], list[int]]:
    """Return the nonzero rows of the reduced echelon form, and the column of each one's pivot."""
    echelon, rank = a.rref()
    rows = echelon.tolist()[:rank]
    return rows, [next(k for k, x in enumerate(row) if x) for row in rows]


def null_space(a: fmpq_mat) -> fmpq_mat:
    """Return a basis of the null space; each vector has a one where the others have zeros, in the free columns."""
    rows, pivots = reduce_rows(a)
    free = [k for k in range(a.ncols()) if k not in pivots]
    basis = fmpq_mat(len(free), a.ncols())
    for i, k in enumerate(free):
        basis[i, k] = 1
        for row, pivot in zip(rows, pivots, strict=True):
            basis[i, pivot] = -row[k]
    return basis


def solve_near(extended: fmpq_mat, near: Sequence[fmpq]) -> list[fmpq] | None:
    """Return the x with A x = b whose free components are those of ``near``; None if there is no solution.

    Args:
        extended: (A | b).
        near: (n,) as x.
    """
    n = len(near)
    rows, pivots = reduce_rows(extended)
    if n in pivots:
        return None
    x = list(near)
    for row, pivot in zip(rows, pivots, strict=True):
        x[pivot] = row[n] - sum(row[k] * near[k] for k in range(n) if k not in pivots)
    return x


def split_into_squares(a: fmpq_mat) -> Squares | None:
    """Return d > 0 and rows ℓ with xᵀAx = Σ d (ℓ·x)²; None where A is not positive semidefinite.

    Lagrange's reduction, completing one square after the other.
    """
    left, squares = a, []
    for k in range(a.nrows()):
        row = fmpq_mat([left.tolist()[k]])
        pivot = left[k, k]
        if pivot < 0 or (not pivot and row):
            return None
        if pivot:
            row = row / pivot
            squares.append((pivot, tuple(row.entries())))
            left = left - row.transpose() * row * pivot
    return tuple(squares)


def signature(a: fmpq_mat) -> tuple[int, int, int]:
    """Return how many eigenvalues of a symmetric matrix are positive, zero and negative.

    All roots of its characteristic polynomial are real, and of such as many are positive as its coefficients have
    changes of sign [Descartes].
    """
    coefficients = a.charpoly().coeffs()
    zero = next(k for k, c in enumerate(coefficients) if c)
    positive = count_changes(coefficients)
    return positive, zero, a.nrows() - zero - positive


def count_changes(values: Iterable[fmpq]) -> int:
    """Return how often the sign changes along a row, zeros left out."""
    return sum(a * b < 0 for a, b in pairwise(x for x in values if x))


def count_roots_beyond(polynomial: fmpq_poly, line: fmpq) -> int | None:
    """Return how many roots have a real part greater than ``line``, none of them on it; None where Routh's array ends.

    Source: Gantmacher, *The Theory of Matrices* II, ch. XV §3 (Routh's theorem: as many as the first column has changes
    of sign).
    """
    shifted = polynomial(fmpq_poly([line, 1])).coeffs()[::-1]
    one, two = shifted[0::2], shifted[1::2]
    column = [one[0]]
    for _ in range(len(shifted) - 1):
        if not two or not two[0]:
            return None
        column.append(two[0])
        padded = [*two, fmpq(0)]
        one, two = two, [one[k + 1] - one[0] / two[0] * padded[k + 1] for k in range(len(one) - 1)]
    return count_changes(column)

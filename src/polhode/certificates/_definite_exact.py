"""Weights that make a sum of symmetric matrices definite, decided by exact signs where two matrices take part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

import numpy as np

from polhode._base.rational._matrices import Rows, combine, determinant, reduce_rows, signature
from polhode._base.rational._univariate import derivative, squarefree


def is_definite(matrix: Sequence[Sequence[Fraction]]) -> bool:
    """Whether all eigenvalues have one sign; so it is of a matrix without rows."""
    positive, zero, negative = signature(matrix)
    return not zero and not (positive and negative)


def definite_in_pencil(one: Rows, two: Rows) -> tuple[Fraction, Fraction] | None:
    """Return a, b with a·one + b·two definite; None exactly where there are none.

    Along one + s·two the signature changes at roots of the determinant alone, and between two neighbouring roots is a
    root of the derivative of the polynomial that has each of them once.
    """
    if is_definite(two):
        return Fraction(0), Fraction(1)
    for s in _places(one, two):
        if is_definite(combine((1, one), (s, two))):
            return Fraction(1), s
    return None


def _places(one: Rows, two: Rows) -> Iterator[Fraction]:
    """Yield a place between any two neighbouring roots of det(one + s·two), and some beyond all."""
    beyond = 2  # times a bound of all roots: nothing changes its sign there
    yield Fraction(0)
    polynomial = squarefree(_determinant_along(one, two))
    if len(polynomial) < 2:
        return
    roots = sorted(_real_roots(derivative(polynomial)))
    size = max(abs(c / polynomial[0]) for c in polynomial) + 1  # Cauchy's bound of all roots
    yield from (-beyond * size, *roots, *((a + b) / 2 for a, b in pairwise(roots)), beyond * size)


def _determinant_along(one: Rows, two: Rows) -> list[Fraction]:
    """Return the coefficients of det(one + s·two), highest power first, from its values at 0, 1, …, n."""
    n = len(one)
    powers = [[Fraction(s) ** k for k in range(n, -1, -1)] for s in range(n + 1)]
    rows = [[*row, determinant(combine((1, one), (s, two)))] for s, row in enumerate(powers)]
    reduced, pivots = reduce_rows(rows, n + 1)
    coefficients = [Fraction(0)] * (n + 1)
    for row, pivot in zip(reduced, pivots, strict=True):
        coefficients[pivot] = row[-1]
    start = next((k for k, c in enumerate(coefficients) if c), n)
    return coefficients[start:]


def _real_roots(polynomial: Sequence[Fraction]) -> list[Fraction]:
    """Return the real roots to a double's accuracy, which is enough to lie between two others."""
    if len(polynomial) == 2:
        return [-polynomial[1] / polynomial[0]]
    # of order one, so that coefficients far from it do not overflow
    roots = np.roots([float(c / polynomial[0]) for c in polynomial]) if len(polynomial) > 2 else np.zeros(0)
    return [Fraction(float(x.real)) for x in np.asarray(roots, complex) if abs(x.imag) <= 1e-6 * (1.0 + abs(x))]

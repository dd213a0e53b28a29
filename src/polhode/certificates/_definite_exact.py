"""Weights that make a sum of symmetric matrices definite, decided by exact signs where two matrices take part."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_poly

from polhode._base.rational._matrices import signature
from polhode._base.rational._univariate import squarefree
from polhode._base.rational.numbers import as_fmpq


def is_definite(matrix: fmpq_mat) -> bool:
    """Whether all eigenvalues have one sign; so it is of a matrix without rows."""
    positive, zero, negative = signature(matrix)
    return not zero and not (positive and negative)


def definite_in_pencil(one: fmpq_mat, two: fmpq_mat) -> tuple[fmpq, fmpq] | None:
    """Return a, b with a·one + b·two definite; None exactly where there are none.

    Along one + s·two the signature changes at roots of the determinant alone, and between two neighbouring roots is a
    root of the derivative of the polynomial that has each of them once.
    """
    if is_definite(two):
        return fmpq(0), fmpq(1)
    for s in _places(one, two):
        if is_definite(one + s * two):
            return fmpq(1), s
    return None


def _places(one: fmpq_mat, two: fmpq_mat) -> Iterator[fmpq]:
    """Yield a place between any two neighbouring roots of det(one + s·two), and some beyond all."""
    beyond = 2  # times a bound of all roots: nothing changes its sign there
    yield fmpq(0)
    polynomial = squarefree(_determinant_along(one, two))
    if polynomial.degree() < 1:
        return
    roots = sorted(_real_roots(polynomial.derivative()))
    size = max(map(abs, polynomial.coeffs())) / abs(polynomial.leading_coefficient()) + 1  # Cauchy's bound of all roots
    yield from (-beyond * size, *roots, *((a + b) / 2 for a, b in pairwise(roots)), beyond * size)


def _determinant_along(one: fmpq_mat, two: fmpq_mat) -> fmpq_poly:
    """Return det(one + s·two) from its values at 0, 1, …, n."""
    places = range(one.nrows() + 1)
    powers = fmpq_mat(len(places), len(places), [s**k for s in places for k in places])
    values = fmpq_mat(len(places), 1, [(one + s * two).det() for s in places])
    return fmpq_poly(powers.solve(values).entries())


def _real_roots(polynomial: fmpq_poly) -> list[fmpq]:
    """Return the real roots to a double's accuracy, which is enough to lie between two others."""
    monic = (polynomial / polynomial.leading_coefficient()).coeffs()[::-1]
    if len(monic) == 2:
        return [-monic[1]]
    # of order one, so that coefficients far from it do not overflow
    roots = np.roots([float(c) for c in monic]) if len(monic) > 2 else np.zeros(0)
    return [as_fmpq(float(x.real)) for x in np.asarray(roots, complex) if abs(x.imag) <= 1e-6 * (1.0 + abs(x))]

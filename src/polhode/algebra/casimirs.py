"""Polynomial Casimirs of an algebra, by exact linear algebra.

The Lie–Poisson bracket is linear in μ, so Casimirs split by degree: those of degree d are the null space of
P ↦ ({x_i, P})_i on homogeneous polynomials, a matrix of rationals. It is enough that P commutes with generators of the
algebra, by Jacobi's identity.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.extras import needing
from polhode._base.rational._sparse import REMEDY, choose_independent, null_space, rows_of, whole_multiple
from polhode._base.rational._terms import exponents_of, multiply_together
from polhode._base.rational.numbers import EXACT, as_fraction, read_number
from polhode.algebra._polynomial import Polynomial
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput

RationalBrackets = list[list[dict[int, Fraction]]]


class CasimirLimits(NamedTuple):
    """Numbers that decide which constants are rational, and which degrees are affordable."""

    max_denominator: int = 10_000  # of a simple fraction that a rounded constant is taken for
    constant_rounding: float = 1e-13  # relative: what computing a constant in doubles leaves
    max_monomials: int = 20_000  # writing down the equations takes a minute then


LIMITS = CasimirLimits()


def polynomial_casimirs(algebra: AbstractLieAlgebra, degree: int, read_as: str = EXACT) -> list[Polynomial]:
    """Return independent generators of the polynomial Casimirs up to a degree, lowest degree first.

    No constants, no products of others: in each degree a complement of the span of products of the generators
    before. Empty if there is none, as for the affine line. The equations fall apart into blocks without a common
    unknown, sixteen of them on su(4); a block of more than 5e9 rows × columns² is refused.

    Args:
        algebra: with structure constants that satisfy Jacobi's identity exactly, as the numbers that they are: any
            doubles or Fractions, or doubles next to simple fractions, as 1/3 of su(4).
        degree: the highest degree looked at, at least 1.
        read_as: "exact" for doubles as the binary fractions that they are, "decimal" for the shortest decimals that
            round to them. Which invariants there are depends on it: x1 x2³ is one of [e3, e1] = e1, [e3, e2] = −c e2
            for c = 1/3 alone, and the double 1/3 is another number.

    Raises:
        InvalidInput: for a degree below 1, constants that are rounded and no simple fractions, a problem too large, or
            if python-flint, of the extra `jax`, is missing.

    Source: Abellanas & Martínez Alonso, J. Math. Phys. 16 (1975) 1580.
    """
    degree = check.whole("degree", degree, 1)
    check_monomials(degree, math.comb(algebra.dim + degree - 1, degree), algebra.dim)
    independent = invariant_polynomials(rational_brackets(algebra, read_as), degree)
    return [Polynomial(np.array(p.monoms(), int), list(map(as_fraction, p.coeffs()))) for p in independent]


def check_monomials(degree: int, count: int, dim: int) -> None:
    """Refuse a degree that has too many monomials for exact linear algebra.

    Raises:
        InvalidInput: naming it.
    """
    if count > LIMITS.max_monomials:
        raise InvalidInput(f"`degree` {degree} in {dim} variables has {count} monomials, more than "
                           f"{LIMITS.max_monomials}. {REMEDY}")


def invariant_polynomials(brackets: RationalBrackets, degree: int) -> list[Any]:
    """Return the result of ``polynomial_casimirs`` as python-flint's, from the result of ``rational_brackets``.

    Raises:
        InvalidInput: for a problem too large, or a missing python-flint.
    """
    with needing("Exact Casimirs and integrals need"):
        from polhode._base.rational._polynomials import poisson_tensor

        tensor = poisson_tensor(brackets, 1)
    moves = [tensor[g] for g in _generators(brackets)]
    independent: list[Any] = []
    for d in range(1, degree + 1):
        invariants = _invariants(moves, d)
        if invariants:
            products = [p for p in multiply_together(independent, d) if sum(p.monoms()[0]) == d]
            independent += choose_independent(invariants, products)
    return [whole_multiple(p) for p in independent]


def rational_brackets(algebra: AbstractLieAlgebra, read_as: str = EXACT) -> RationalBrackets:
    """Return [e_i, e_j] as {k: c_ijk} with fractions that satisfy Jacobi's identity exactly.

    Fractions that the algebra was given are taken as they are, doubles as ``read_as`` says. Where Jacobi's identity
    then holds up to rounding only, as 1/3 is no double, the doubles are rounded from other numbers: simple fractions
    near them are taken, where these satisfy it.

    Args:
        algebra: whose constants they are.
        read_as: "exact" or "decimal", how doubles are read.

    Raises:
        InvalidInput: for constants that satisfy the identity in neither way, and for another reading.
    """
    given = algebra.structure_constants() if algebra.fractions is None else algebra.fractions
    table = _map_table(given, lambda x: read_number(x, read_as, "structure constants"))
    if _is_algebra(table):
        return table
    table = _map_table(given, lambda x: Fraction(float(x)).limit_denominator(LIMITS.max_denominator))
    # with the same zeros, but what is a rounding error of zero
    rounding = LIMITS.constant_rounding
    near = all(abs(float(vector.get(k, 0)) - x) <= rounding * abs(x) or abs(x) <= rounding
               for row, rows in zip(table, given, strict=True) for vector, values in zip(row, rows, strict=True)
               for k, x in enumerate(map(float, values)))
    if near and _is_algebra(table):
        return table
    raise InvalidInput(
        "structure constants must satisfy Jacobi's identity exactly for exact algebra; these do up to rounding only. "
        "Give them as Fractions, or scale the basis so that they are doubles or simple fractions."
    )


def _map_table(table: Any, read: Callable[[Any], Fraction]) -> RationalBrackets:
    return [[{k: value for k, x in enumerate(vector) if x and (value := read(x))} for vector in row] for row in table]


def _is_algebra(table: RationalBrackets) -> bool:
    """Return whether structure constants are antisymmetric and satisfy Jacobi's identity, exactly."""
    size = range(len(table))

    def bracket(i: int, vector: dict[int, Fraction], total: dict[int, Fraction]) -> None:
        for j, x in vector.items():
            for k, c in table[i][j].items():
                total[k] += x * c

    for i in size:
        for j in size[i:]:
            if table[i][j] != {k: -c for k, c in table[j][i].items()}:
                return False
    for i in size:
        for j in size[i + 1:]:
            for k in size[j + 1:]:
                total: dict[int, Fraction] = defaultdict(Fraction)
                bracket(i, table[j][k], total)
                bracket(j, table[k][i], total)
                bracket(k, table[i][j], total)
                if any(total.values()):
                    return False
    return True


def _generators(brackets: RationalBrackets) -> list[int]:
    """Return indices of basis elements whose nested brackets span the algebra, few of them."""
    dim = len(brackets)
    dense = np.zeros((dim, dim, dim))
    for i, row in enumerate(brackets):
        for j, vector in enumerate(row):
            for k, value in vector.items():
                dense[i, j, k] = float(value)
    chosen: list[int] = []
    span = np.zeros((0, dim))
    for i in range(dim):
        unit = np.eye(dim)[i]
        if len(span) and np.linalg.matrix_rank(np.vstack([span, unit])) == len(span):
            continue
        chosen.append(i)
        span = np.vstack([span, unit])
        while True:
            # brackets of all pairs in the span
            products = np.tensordot(span, np.tensordot(span, dense, (1, 1)), (1, 1)).reshape(-1, dim)
            _, sizes, rows = np.linalg.svd(np.vstack([span, products]), full_matrices=False)
            rank = int((sizes > 1e-9 * sizes[0]).sum())
            if rank == len(span):
                break
            span = rows[:rank]
    return chosen


def _invariants(moves: list[Any], degree: int) -> list[Any]:
    """Return a basis of the polynomials of one degree that commute with the generators, whose fields are given."""
    from polhode._base.rational._polynomials import context, rate

    dim = len(moves[0])
    space, indices = context(dim), combinations_with_replacement(range(dim), degree)
    monomials = [space.from_dict({exponents_of(m, dim): 1}) for m in indices]
    distinct = {tuple(row.items()) for move in moves for row in rows_of([rate(m, move) for m in monomials])}
    matrix = [dict(row) for row in sorted(distinct, key=len)]
    return [sum((c * monomials[k] for k, c in vector.items()), space.constant(0))
            for vector in null_space(matrix, len(monomials))]  # fmt: skip

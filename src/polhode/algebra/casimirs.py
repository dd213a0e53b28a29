"""Polynomial Casimirs of an algebra, found by exact linear algebra.

The Lie–Poisson bracket is linear in μ, so Casimirs split by degree: those of degree d are the null space of
P ↦ ({x_i, P})_i on homogeneous polynomials, a matrix of rationals. It is enough that P commutes with generators of the
algebra, by Jacobi's identity.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations_with_replacement

import numpy as np

from polhode.algebra._polynomial import Polynomial
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, not_installed, shown

Terms = dict[tuple[int, ...], Fraction]
LARGEST_DENOMINATOR = 10_000
MOST_MONOMIALS = 20_000  # writing down the equations takes a minute then
MOST_WORK = 5e9  # rows × columns² of one block of equations: some six seconds of exact elimination, without a break
REMEDY = "Lower the degree; `stability` takes Casimirs that are known otherwise by `casimirs=`."


def polynomial_casimirs(algebra: AbstractLieAlgebra, degree: int) -> list[Polynomial]:
    """Return independent generators of the polynomial Casimirs up to a degree, lowest degree first.

    No constants, no products of others: in each degree a complement of the span of products of the generators found
    before. Empty if there is none, as for the affine line. The equations fall apart into blocks without a common
    unknown, sixteen of them on su(4); a block of more than 5e9 rows × columns² is refused.

    Args:
        algebra: with rational structure constants.
        degree: the highest degree looked at, at least 1.

    Raises:
        InvalidInput: for a degree below 1, constants that are not simple fractions, a problem too large, or if
            python-flint, the extra `symbolic`, is missing.

    Source: Abellanas & Martínez Alonso, J. Math. Phys. 16 (1975) 1580.
    """
    is_degree = isinstance(degree, int) and degree > 0
    check_degree(degree, math.comb(algebra.dim + degree - 1, degree) if is_degree else 0, algebra.dim)
    independent = invariant_terms(rational_brackets(algebra), degree)
    return [Polynomial(np.array(list(terms)).reshape(-1, algebra.dim), list(terms.values())) for terms in independent]


def check_degree(degree: int, count: int, dim: int) -> None:
    """Refuse a degree that is none, or has too many monomials for exact linear algebra.

    Raises:
        InvalidInput: naming it.
    """
    if not isinstance(degree, int) or degree < 1:
        raise InvalidInput(f"`degree` must be a whole number, at least 1; got {shown(degree)}.")
    if count > MOST_MONOMIALS:
        raise InvalidInput(f"`degree` {degree} in {dim} variables has {count} monomials, more than "
                           f"{MOST_MONOMIALS}. {REMEDY}")  # fmt: skip


def invariant_terms(brackets: list[list[dict[int, Fraction]]], degree: int) -> list[Terms]:
    """Return what ``polynomial_casimirs`` finds as {exponents: coefficient}, of what ``rational_brackets`` gives.

    Raises:
        InvalidInput: for a problem too large, or a missing python-flint.
    """
    generators = _generators(brackets)
    independent: list[Terms] = []
    for d in range(1, degree + 1):
        invariants = _invariants(brackets, generators, d)
        if invariants:
            independent += new_terms(invariants, _products(independent, d))
    return [whole_terms(terms) for terms in independent]


def rational_brackets(algebra: AbstractLieAlgebra) -> list[list[dict[int, Fraction]]]:
    """Return [e_i, e_j] as {k: c_ijk} with exact fractions.

    Raises:
        InvalidInput: for constants that are not simple fractions.
    """
    c = algebra.structure_constants()
    table = []
    for row in c:
        table.append([])
        for vector in row:
            exact = {int(k): Fraction(float(vector[k])).limit_denominator(LARGEST_DENOMINATOR)
                     for k in np.flatnonzero(np.abs(vector) > 1e-14)}  # fmt: skip
            wrong = [float(vector[k]) for k, f in exact.items() if abs(float(f) - vector[k]) > 1e-13 * abs(vector[k])]
            if wrong:
                raise InvalidInput(
                    f"structure constants must be rational for exact Casimirs; got {shown(wrong[0])}. "
                    "Scale the basis so that they are."
                )
            table[-1].append(exact)
    return table


def _generators(brackets: list[list[dict[int, Fraction]]]) -> list[int]:
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


def _invariants(brackets: list[list[dict[int, Fraction]]], generators: list[int], degree: int) -> list[Terms]:
    """Return a basis of the polynomials of one degree that commute with the generators."""
    dim = len(brackets)
    monomials = [_exponents(m, dim) for m in combinations_with_replacement(range(dim), degree)]
    place = {m: n for n, m in enumerate(monomials)}
    # {x_g, Π x_i^{e_i}} = Σ_j e_j x^{e − 1_j} Σ_k c_gj^k x_k, by Leibniz
    rows: dict[tuple[int, int], dict[int, Fraction]] = defaultdict(lambda: defaultdict(Fraction))
    for column, monomial in enumerate(monomials):
        for g in generators:
            for j in np.flatnonzero(monomial):
                lowered = list(monomial)
                lowered[j] -= 1
                for k, value in brackets[g][int(j)].items():
                    raised = list(lowered)
                    raised[k] += 1
                    rows[g, place[tuple(raised)]][column] += monomial[int(j)] * value
    distinct = {tuple(sorted((c, v) for c, v in row.items() if v)) for row in rows.values()} - {()}
    matrix = [dict(row) for row in sorted(distinct, key=len)]
    return [{monomials[c]: v for c, v in vector.items()} for vector in null_space(matrix, len(monomials))]


def null_space(rows: list[dict[int, Fraction]], columns: int) -> list[dict[int, Fraction]]:
    """Return the null space of a sparse rational matrix, reduced: each vector has a column of its own."""
    pivots, reduced = _reduce_rows(rows, columns)
    free = [c for c in range(columns) if c not in set(pivots)]
    vectors = []
    for c in free:
        # one free unknown is 1 and the others are 0; the reduced rows give the pivots
        vector = {c: Fraction(1)}
        for pivot, row in zip(pivots, reduced, strict=True):
            if c in row:
                vector[pivot] = -row[c]
        vectors.append(vector)
    return vectors


def _reduce_rows(rows: list[dict[int, Fraction]], columns: int) -> tuple[list[int], list[dict[int, Fraction]]]:
    """Return pivots and rows of the reduced echelon form, block by block.

    Raises:
        InvalidInput: for a block too large, before any is reduced, or without python-flint.
    """
    if not rows:
        return [], []
    try:
        from flint import fmpq, fmpq_mat
    except ImportError:
        raise not_installed("exact Casimirs", "python-flint", "symbolic") from None
    pairs: list[tuple[int, dict[int, Fraction]]] = []
    for block, unknowns in _blocks(rows, columns):
        matrix = fmpq_mat(len(block), len(unknowns))
        place = {c: n for n, c in enumerate(unknowns)}
        for i, row in enumerate(block):
            for c, value in row.items():
                matrix[i, place[c]] = fmpq(value.numerator, value.denominator)
        echelon, rank = matrix.rref()
        for i in range(rank):
            row = {c: Fraction(int(v.p), int(v.q)) for n, c in enumerate(unknowns) if (v := echelon[i, n]) != 0}
            pairs.append((min(row), row))
    pairs.sort(key=lambda pair: pair[0])
    return [pivot for pivot, _ in pairs], [row for _, row in pairs]


def _blocks(rows: list[dict[int, Fraction]], columns: int) -> Iterator[tuple[list[dict[int, Fraction]], list[int]]]:
    """Return the rows that share unknowns with each other, and these unknowns in order.

    Exact elimination goes with the cube of its size, so that blocks take a hundredth of the whole; and between two of
    them a signal gets through.
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    pairs = np.array([(n, c) for n, row in enumerate(rows) for c in row])
    size = len(rows) + columns
    links = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1] + len(rows))), shape=(size, size))
    _, labels = connected_components(links, directed=False)
    together: dict[int, tuple[list[dict[int, Fraction]], list[int]]] = defaultdict(lambda: ([], []))
    for row, label in zip(rows, labels, strict=False):
        together[label][0].append(row)
    for column, label in enumerate(labels[len(rows) :]):
        together[label][1].append(column)
    blocks = [(block, unknowns) for block, unknowns in together.values() if block]
    largest = max(blocks, key=lambda pair: len(pair[0]) * len(pair[1]) ** 2)
    equations, unknown = len(largest[0]), len(largest[1])
    if equations * unknown**2 > MOST_WORK:
        raise InvalidInput(
            f"exact Casimirs would take {equations} equations for {unknown} unknowns at once, and at most "
            f"{MOST_WORK:.0e} rows × columns² are solved here, which is some seconds. {REMEDY}"
        )
    yield from blocks


def _products(polynomials: list[Terms], degree: int) -> list[Terms]:
    """Return all products of given polynomials that have the degree."""
    degrees = [sum(next(iter(terms))) for terms in polynomials]

    def extend(start: int, left: int) -> list[Terms]:
        results: list[Terms] = []
        for n in range(start, len(polynomials)):
            if degrees[n] == left:
                results.append(polynomials[n])
            elif degrees[n] < left:
                results += [_multiply(polynomials[n], rest) for rest in extend(n, left - degrees[n])]
        return results

    return extend(0, degree)


def new_terms(invariants: list[Terms], products: list[Terms]) -> list[Terms]:
    """Return those invariants that are needed in addition to the products to span all."""
    monomials = sorted({m for terms in (*invariants, *products) for m in terms}, reverse=True)
    place = {m: n for n, m in enumerate(monomials)}
    columns = [{place[m]: v for m, v in terms.items()} for terms in (*products, *sorted(invariants, key=len))]
    transposed: dict[int, dict[int, Fraction]] = defaultdict(dict)
    for c, column in enumerate(columns):
        for row, value in column.items():
            transposed[row][c] = value
    pivots, _ = _reduce_rows(list(transposed.values()), len(columns))
    return [{monomials[r]: v for r, v in columns[c].items()} for c in pivots if c >= len(products)]


def _multiply(a: Terms, b: Terms) -> Terms:
    product: Terms = defaultdict(Fraction)
    for m, x in a.items():
        for n, y in b.items():
            product[tuple(i + j for i, j in zip(m, n, strict=True))] += x * y
    return {m: v for m, v in product.items() if v}


def whole_terms(terms: Terms) -> Terms:
    """Return a polynomial's multiple with coprime whole coefficients, sorted, the first one positive."""
    order = sorted(terms, reverse=True)
    denominator = math.lcm(*(v.denominator for v in terms.values()))
    divisor = math.gcd(*(int(v * denominator) for v in terms.values()))
    factor = Fraction(denominator, divisor) * (1 if terms[order[0]] > 0 else -1)
    return {m: terms[m] * factor for m in order}


def _exponents(indices: tuple[int, ...], dim: int) -> tuple[int, ...]:
    counts = [0] * dim
    for i in indices:
        counts[i] += 1
    return tuple(counts)

"""Null spaces of sparse rational matrices, and of polynomials those that are independent, by python-flint."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from polhode.errors import InvalidInput

REMEDY = "Lower the degree; `stability` takes Casimirs that are known otherwise by `casimirs=`."
Rational = Any
"""A rational of python-flint."""
SparseRow = dict[int, Rational]


class SolvingLimits(NamedTuple):
    """A number beyond which equations are refused."""

    max_work: float = 5e9  # rows × columns² of one block: some six seconds of exact elimination, without a break


LIMITS = SolvingLimits()


def null_space(rows: list[SparseRow], columns: int) -> list[SparseRow]:
    """Return the null space of a sparse rational matrix, reduced: each vector has a column of its own.

    Raises:
        InvalidInput: for a block too large, before any is reduced.
    """
    vectors = {c: {c: 1} for c in range(columns)}
    pivots = _reduce_rows(rows, columns)
    for pivot, _ in pivots:
        del vectors[pivot]
    for pivot, row in pivots:
        # one free unknown is 1 and the others are 0; the reduced rows give the pivots
        for c, value in row.items():
            if c != pivot:
                vectors[c][pivot] = -value
    return list(vectors.values())


def _reduce_rows(rows: list[SparseRow], columns: int) -> list[tuple[int, SparseRow]]:
    """Return pivots and rows of the reduced echelon form, which is found block by block."""
    if not rows:
        return []
    pairs: list[tuple[int, SparseRow]] = []
    for block, unknowns in _blocks(rows, columns):
        echelon, rank = dense(block, unknowns).rref()
        for i in range(rank):
            row = {c: v for n, c in enumerate(unknowns) if (v := echelon[i, n])}
            pairs.append((min(row), row))
    return sorted(pairs)


def dense(rows: Sequence[SparseRow], columns: Sequence[int]) -> Any:
    """Return a matrix of python-flint, with the columns that are listed."""
    from flint import fmpq_mat

    matrix = fmpq_mat(len(rows), len(columns))
    place = {c: n for n, c in enumerate(columns)}
    for i, row in enumerate(rows):
        for c, value in row.items():
            matrix[i, place[c]] = value
    return matrix


def _blocks(rows: list[SparseRow], columns: int) -> list[tuple[list[SparseRow], list[int]]]:
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
    together: dict[int, tuple[list[SparseRow], list[int]]] = defaultdict(lambda: ([], []))
    for row, label in zip(rows, labels, strict=False):
        together[label][0].append(row)
    for column, label in enumerate(labels[len(rows) :]):
        together[label][1].append(column)
    blocks = [(block, unknowns) for block, unknowns in together.values() if block]
    largest = max(blocks, key=lambda pair: len(pair[0]) * len(pair[1]) ** 2)
    equations, unknown = len(largest[0]), len(largest[1])
    if equations * unknown**2 > LIMITS.max_work:
        raise InvalidInput(
            f"exact linear algebra would take {equations} equations for {unknown} unknowns at once, and at most "
            f"{LIMITS.max_work:.0e} rows × columns² are solved here, which is some seconds. {REMEDY}"
        )
    return blocks


def rows_of(polynomials: Sequence[Any]) -> list[SparseRow]:
    """Return the matrix whose columns are polynomials and whose rows are monomials, which any of them has."""
    rows: dict[tuple[Any, ...], SparseRow] = defaultdict(dict)
    for column, p in enumerate(polynomials):
        for m, c in p.terms():
            rows[m][column] = c
    return list(rows.values())


def choose_independent(invariants: list[Any], products: list[Any]) -> list[Any]:
    """Return those invariants that are needed in addition to the products to span all."""
    columns = [*products, *sorted(invariants, key=len)]
    return [columns[c] for c, _ in _reduce_rows(rows_of(columns), len(columns)) if c >= len(products)]


def whole_multiple(p: Any) -> Any:
    """Return a polynomial's multiple with coprime whole coefficients, that of the highest power of x_1 positive."""
    from flint import fmpq, fmpq_poly

    row = fmpq_poly(p.coeffs())
    factor = fmpq(row.denom(), row.numer().content())
    return p * (factor if p[max(p.monoms())] > 0 else -factor)

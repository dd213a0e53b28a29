"""Null spaces of sparse rational matrices, and of polynomials those that are independent, by python-flint."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from polhode._base.extras import needing
from polhode._base.rational._terms import Terms
from polhode.errors import InvalidInput

REMEDY = "Lower the degree; `stability` takes Casimirs that are known otherwise by `casimirs=`."


class SolvingLimits(NamedTuple):
    """A number beyond which equations are refused."""

    max_work: float = 5e9  # rows × columns² of one block: some six seconds of exact elimination, without a break


LIMITS = SolvingLimits()


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
    with needing("Exact Casimirs and integrals need"):
        from flint import fmpq, fmpq_mat
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
    if equations * unknown**2 > LIMITS.max_work:
        raise InvalidInput(
            f"exact linear algebra would take {equations} equations for {unknown} unknowns at once, and at most "
            f"{LIMITS.max_work:.0e} rows × columns² are solved here, which is some seconds. {REMEDY}"
        )
    yield from blocks


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

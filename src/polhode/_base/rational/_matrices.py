"""Linear algebra over the rationals: null spaces, solutions, squares, characteristic polynomials, Routh's count."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

Rows = list[list[Fraction]]


def reduce_rows(rows: Sequence[Sequence[Fraction]], columns: int) -> tuple[Rows, list[int]]:
    """Return the nonzero rows of the reduced echelon form, and the column of each one's pivot.

    Pivots are taken from the first ``columns`` columns only; columns behind these are carried along.
    """
    left = [list(row) for row in rows if any(row)]
    reduced: Rows = []
    pivots: list[int] = []
    for column in range(columns):
        place = next((k for k, row in enumerate(left) if row[column]), None)
        if place is None:
            continue
        pivot = left.pop(place)
        pivot = [x / pivot[column] for x in pivot]
        left = [_eliminate(row, pivot, column) for row in left]
        reduced = [_eliminate(row, pivot, column) for row in reduced]
        reduced.append(pivot)
        pivots.append(column)
    return reduced, pivots


def _eliminate(row: list[Fraction], pivot: list[Fraction], column: int) -> list[Fraction]:
    factor = row[column]
    return [x - factor * y if y else x for x, y in zip(row, pivot, strict=True)] if factor else row


def null_space(rows: Sequence[Sequence[Fraction]], columns: int) -> Rows:
    """Return a basis of the null space; each vector has a one where the others have zeros, in the free columns."""
    reduced, pivots = reduce_rows(rows, columns)
    basis = []
    for free in (k for k in range(columns) if k not in pivots):
        vector = [Fraction(int(k == free)) for k in range(columns)]
        for row, pivot in zip(reduced, pivots, strict=True):
            vector[pivot] = -row[free]
        basis.append(vector)
    return basis


def solve_near(rows: Sequence[Sequence[Fraction]], right: Sequence[Fraction], near: Sequence[Fraction]) -> (
    list[Fraction] | None
):
    """Return the x with rows · x = right whose free components are those of ``near``; None if there is no solution."""
    columns = len(near)
    outside = [b for row, b in zip(rows, right, strict=True) if not any(row)]
    extended = [[*row, b] for row, b in zip(rows, right, strict=True)]
    reduced, pivots = reduce_rows(extended, columns)
    rest = [row for row, b in zip(extended, right, strict=True) if any(row)]
    if any(outside) or len(reduce_rows(rest, columns + 1)[1]) > len(pivots):
        return None
    x = list(near)
    for row, pivot in zip(reduced, pivots, strict=True):
        others = sum((row[k] * near[k] for k in range(columns) if k not in pivots), Fraction(0))
        x[pivot] = row[columns] - others
    return x


def split_into_squares(matrix: Sequence[Sequence[Fraction]]) -> list[tuple[Fraction, list[Fraction]]] | None:
    """Return d > 0 and rows ℓ with xᵀMx = Σ d (ℓ·x)²; None where M is not positive semidefinite.

    Lagrange's reduction, completing one square after the other.
    """
    left = [list(row) for row in matrix]
    squares = []
    for k in range(len(left)):
        pivot = left[k][k]
        if pivot < 0 or (not pivot and any(left[k])):
            return None
        if not pivot:
            continue
        row = [x / pivot for x in left[k]]
        squares.append((pivot, row))
        left = [[x - pivot * row[i] * row[j] for j, x in enumerate(line)] for i, line in enumerate(left)]
    return squares


def transpose(a: Sequence[Sequence[Fraction]]) -> Rows:
    """Return the transpose."""
    return [list(column) for column in zip(*a, strict=True)]


def multiply(a: Sequence[Sequence[Fraction]], b: Sequence[Sequence[Fraction]]) -> Rows:
    """Return a b."""
    columns = transpose(b)
    return [[sum((x * y for x, y in zip(row, column, strict=True) if x and y), Fraction(0)) for column in columns]
            for row in a]


def combine(*terms: tuple[Fraction | int, Sequence[Sequence[Fraction]]]) -> Rows:
    """Return Σ c M."""
    n, m = len(terms[0][1]), len(terms[0][1][0])
    return [[sum((Fraction(c) * a[i][j] for c, a in terms), Fraction(0)) for j in range(m)] for i in range(n)]


def identity(n: int) -> Rows:
    """Return the identity (n, n)."""
    return [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]


def characteristic_polynomial(matrix: Sequence[Sequence[Fraction]]) -> list[Fraction]:
    """Return the coefficients of det(λ − A), highest power first [Faddeev and Leverrier]."""
    n = len(matrix)
    coefficients, power = [Fraction(1)], identity(n)
    for k in range(1, n + 1):
        power = multiply(matrix, power)
        coefficients.append(-sum((power[i][i] for i in range(n)), Fraction(0)) / k)
        power = combine((1, power), (coefficients[-1], identity(n)))
    return coefficients


def count_roots_beyond(polynomial: Sequence[Fraction], line: Fraction) -> int | None:
    """Return how many roots have a real part greater than ``line``, none of them on it; None where Routh's array ends.

    Args:
        polynomial: coefficients, highest power first.
        line: the real part.

    Source: Gantmacher, *The Theory of Matrices* II, ch. XV §3 (Routh's theorem: as many as the first column has changes
    of sign).
    """
    shifted = shift_origin(polynomial, line)
    one, two = shifted[0::2], shifted[1::2]
    column = [one[0]]
    for _ in range(len(shifted) - 1):
        if not two or not two[0]:
            return None
        column.append(two[0])
        padded = [*two, Fraction(0)]
        one, two = two, [one[k + 1] - one[0] / two[0] * padded[k + 1] for k in range(len(one) - 1)]
    return sum(a * b < 0 for a, b in pairwise(column))


def shift_origin(polynomial: Sequence[Fraction], line: Fraction) -> list[Fraction]:
    """Return the coefficients, highest power first, of p(x + line) [Horner]."""
    shifted = list(polynomial)
    for k in range(len(shifted) - 1):
        for j in range(1, len(shifted) - k):
            shifted[j] += line * shifted[j - 1]
    return shifted


def is_hurwitz(polynomial: Sequence[Fraction]) -> bool:
    """Whether all roots have a negative real part: only then Routh's array ends with all of one sign."""
    return count_roots_beyond(polynomial, Fraction(0)) == 0


def signature(matrix: Sequence[Sequence[Fraction]]) -> tuple[int, int, int]:
    """Return how many eigenvalues of a symmetric matrix are positive, zero and negative [Sylvester].

    Lagrange's reduction; where the diagonal is zero x y = ¼ (x + y)² − ¼ (x − y)² counts one of each sign.
    """
    left, positive, negative = [list(row) for row in matrix], 0, 0
    while any(any(row) for row in left):
        n = len(left)
        k = next((k for k in range(n) if left[k][k]), None)
        if k is None:
            i, j = next((i, j) for i in range(n) for j in range(n) if left[i][j])
            left = _add_row_and_column(left, i, j)
            k = i
        pivot = left[k][k]
        positive, negative = positive + (pivot > 0), negative + (pivot < 0)
        rest = [i for i in range(n) if i != k]
        left = [[left[i][j] - left[i][k] * left[k][j] / pivot for j in rest] for i in rest]
    return positive, len(matrix) - positive - negative, negative


def _add_row_and_column(matrix: Rows, i: int, j: int) -> Rows:
    """Return the form in coordinates in which the i-th direction is the sum of two."""
    rows = [list(row) for row in matrix]
    rows[i] = [x + y for x, y in zip(rows[i], rows[j], strict=True)]
    for row in rows:
        row[i] += row[j]
    return rows


def determinant(matrix: Sequence[Sequence[Fraction]]) -> Fraction:
    """Return the determinant, by elimination."""
    left, value = [list(row) for row in matrix], Fraction(1)
    while left:
        place = next((k for k, row in enumerate(left) if row[0]), None)
        if place is None:
            return Fraction(0)
        pivot = left.pop(place)
        value *= pivot[0] if place % 2 == 0 else -pivot[0]
        left = [[x - row[0] / pivot[0] * y for x, y in zip(row[1:], pivot[1:], strict=True)] for row in left]
    return value


def rank(matrix: Sequence[Sequence[Fraction]]) -> int:
    """Return the rank."""
    return len(reduce_rows(matrix, len(matrix[0]))[1]) if matrix else 0

"""Exact linear algebra and roots against NumPy's, on matrices and polynomials with known answers among them."""

from itertools import product

import numpy as np
import pytest
from flint import fmpq, fmpq_mat, fmpq_poly

from polhode._base.rational import _matrices as matrices
from polhode._base.rational._polynomials import linear_form, quadratic_form, total
from polhode._base.rational._univariate import has_root_to_the_right, largest_real_part


def random_matrices():
    rng = np.random.default_rng(0)
    for n in (2, 3, 4, 5, 6):
        for _ in range(20):
            yield rng, rng.integers(-4, 5, (n, n))


def test_roots_squares_and_solutions_agree_with_numerical_ones():
    for rng, numbers in random_matrices():
        n = len(numbers)
        A = fmpq_mat(n, n, numbers.ravel().tolist())
        count = matrices.count_roots_beyond(A.charpoly(), fmpq(1, 7))
        assert count in (None, (np.linalg.eigvals(numbers).real > 1 / 7).sum())
        positive = A.transpose() * A + matrices.identity(n) / 3
        squares = total(n, (d * linear_form(row) ** 2 for d, row in matrices.split_into_squares(positive)))
        assert squares == quadratic_form(positive.tolist())
        assert matrices.split_into_squares(-positive) is None
        b = [fmpq(int(x)) for x in rng.integers(-4, 5, n)]
        extended = fmpq_mat([[*row, x] for row, x in zip(A.tolist(), b, strict=True)])
        found = matrices.solve_near(extended, [fmpq(1, 3)] * n)
        if found is not None:
            assert (A * fmpq_mat(n, 1, found)).entries() == b
        else:
            assert np.linalg.matrix_rank(numbers) < n


def test_free_components_of_a_solution_are_those_nearby():
    extended = fmpq_mat([[1, 2, 0, 5], [0, 0, 1, 7]])
    assert matrices.solve_near(extended, [fmpq(9), fmpq(1, 2), fmpq(9)]) == [4, fmpq(1, 2), 7]
    assert matrices.solve_near(fmpq_mat([[1, 1, 1], [2, 2, 3]]), [fmpq(0)] * 2) is None


def test_null_spaces_have_the_dimension_that_is_left():
    for rng, numbers in random_matrices():
        n = len(numbers)
        low = numbers @ np.diag(rng.integers(0, 2, n))
        A = fmpq_mat(n, n, low.ravel().tolist())
        basis = matrices.null_space(A)
        assert basis.nrows() == n - np.linalg.matrix_rank(low) == basis.rank()
        assert not A * basis.transpose()
    assert matrices.null_space(matrices.matrix([], 3)) == matrices.identity(3)


def test_signatures_are_those_of_known_forms():
    """Of TᵀDT with D diagonal, by Sylvester's law; zeros and equal numbers, for which charpoly has equal roots."""
    rng = np.random.default_rng(1)
    for diagonal in product((-2, 0, 0.5), repeat=4):
        D = matrices.identity(4)
        for k, x in enumerate(diagonal):
            D[k, k] = fmpq(*x.as_integer_ratio())
        T = fmpq_mat(4, 4, rng.integers(-3, 4, (4, 4)).ravel().tolist())
        wanted = sum(x > 0 for x in diagonal), diagonal.count(0), diagonal.count(-2)
        assert matrices.signature(D) == wanted
        if T.rank() == 4:
            assert matrices.signature(T.transpose() * D * T) == wanted
    assert matrices.signature(fmpq_mat(0, 0)) == (0, 0, 0)
    assert matrices.signature(fmpq_mat([[0, 1], [1, 0]])) == (1, 0, 1)


def roots(*real, pairs=()):
    """Return the polynomial with real roots, and with pairs of real part and size of the imaginary one."""
    p = fmpq_poly([1])
    for x in real:
        p *= fmpq_poly([-x, 1])
    for a, b in pairs:
        p *= fmpq_poly([a * a + b * b, -2 * a, 1])
    return p


TINY = fmpq(1, 10**40)


@pytest.mark.parametrize(("polynomial", "largest"), [
    (roots(-1, -2), 0.0), (roots(0, 0, -1), 0.0), (roots(0, pairs=[(0, 1), (0, 1), (0, 3)]), 0.0),
    (roots(1, -1), 1.0), (roots(fmpq(1, 3), -5, pairs=[(0, 2)]), 1 / 3), (roots(pairs=[(fmpq(1, 7), 9)] * 2), 1 / 7),
    (roots(TINY, -TINY, pairs=[(0, 1)]), 1e-40), (roots(-TINY, pairs=[(-TINY, 1)]), 0.0),
    (roots(pairs=[(TINY, 1), (-TINY, 1), (0, 1)]), 1e-40), (roots(10**300, -1), 1e300), (roots(), 0.0),
], ids=str)  # fmt: skip
def test_the_largest_real_part_is_that_of_the_roots_and_rounded(polynomial, largest):
    """On the axis, within 1e-40 of it, and multiple."""
    assert has_root_to_the_right(polynomial) == (largest > 0)
    assert largest_real_part(polynomial) == largest

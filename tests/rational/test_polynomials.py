"""Polynomials of python-flint with what polhode adds, against SymPy's and against difference quotients."""

import copy
import pickle

import numpy as np
import pytest
import sympy
from flint import fmpq

from polhode._base.rational import _polynomials as polynomials
from polhode._base.rational._terms import show_terms

X = sympy.symbols("x1:4")


def random_polynomial(rng, terms):
    return polynomials.context(3).from_dict(
        {tuple(map(int, rng.integers(0, 6, 3))): fmpq(int(rng.integers(-9, 10)), 7) for _ in range(terms)})


def by_sympy(p):
    return sum((sympy.Rational(str(c)) * sympy.prod(x**k for x, k in zip(X, m, strict=True))
                for m, c in polynomials.terms_of(p)), sympy.Integer(0))  # fmt: skip


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("point", [(0, 0, 0), (fmpq(2, 3), 0, -1), (fmpq(1, 5), fmpq(-3, 2), 7)])
def test_shifts_and_derivatives_are_those_of_sympy(seed, point):
    p = random_polynomial(np.random.default_rng(seed), 8)
    moved = dict(zip(X, (x + sympy.Rational(str(z)) for x, z in zip(X, point, strict=True)), strict=True))
    wanted = sympy.Poly(by_sympy(p).subs(moved, simultaneous=True), *X)
    point = [fmpq(z) for z in point]
    shifted = polynomials.shift(p, point)
    assert {m: str(c) for m, c in polynomials.terms_of(shifted)} == {m: str(c) for m, c in wanted.terms() if c}
    assert polynomials.gradient(p, point) == [shifted[tuple(int(i == k) for i in range(3))] for k in range(3)]
    second = polynomials.quadratic_form(polynomials.half_hessian(p, point).tolist())
    assert second == polynomials.part(shifted, 2, 2)
    for highest in (0, 1, 2, 5):
        assert polynomials.part(shifted, 0, highest) + polynomials.part(shifted, highest + 1) == shifted
        assert all(sum(m) <= highest for m in polynomials.part(shifted, 0, highest).monoms())


def test_rates_agree_with_difference_quotients():
    rng = np.random.default_rng(4)
    x = polynomials.variables(3)
    p = 3 * x[0] ** 2 * x[1] - x[2] ** 3 + fmpq(1, 2) * x[0] - 4
    f = [x[1] * x[2], x[0] - 1, x[2] ** 2]
    at = [fmpq(round(64 * y), 64) for y in rng.normal(size=3)]
    step = fmpq(1, 10**9)
    moved = [a + step * g(*at) for a, g in zip(at, f, strict=True)]
    assert float((p(*moved) - p(*at)) / step) == pytest.approx(float(polynomials.rate(p, f)(*at)), rel=1e-6)


def test_terms_run_from_the_highest_degree_down():
    x, y, z = polynomials.variables(3)
    p = (x + 2 * y) * x - 3 + z**3 / 2 - y
    assert show_terms(polynomials.terms_of(p)) == "1/2 x3³ + x1² + 2 x1 x2 − x2 − 3"
    assert polynomials.magnitude(p) == fmpq(15, 2)


def test_polynomials_can_be_pickled_and_copied():
    p = random_polynomial(np.random.default_rng(0), 8)
    assert pickle.loads(pickle.dumps(p)) == p == copy.deepcopy(p)
    assert pickle.loads(pickle.dumps(p)).context().names() == p.context().names()

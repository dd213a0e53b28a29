"""Polynomials over the rationals, against SymPy's."""

from fractions import Fraction

import numpy as np
import pytest
import sympy

from polhode._base.rational._polynomials import RationalPolynomial

X = sympy.symbols("x1:4")


def random_polynomial(rng, terms):
    return RationalPolynomial(3, {tuple(map(int, rng.integers(0, 6, 3))): Fraction(int(rng.integers(-9, 10)), 7)
                                  for _ in range(terms)})  # fmt: skip


def by_sympy(p):
    return sum((sympy.Rational(c.numerator, c.denominator) * sympy.prod(x**k for x, k in zip(X, m, strict=True))
                for m, c in p.terms.items()), sympy.Integer(0))  # fmt: skip


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("point", [(0, 0, 0), (Fraction(2, 3), 0, -1), (Fraction(1, 5), Fraction(-3, 2), 7)])
def test_shifts_are_those_of_sympy(seed, point):
    p = random_polynomial(np.random.default_rng(seed), 8)
    moved = dict(zip(X, (x + sympy.Rational(str(z)) for x, z in zip(X, point, strict=True)), strict=True))
    wanted = sympy.Poly(by_sympy(p).subs(moved, simultaneous=True), *X)
    terms = {m: Fraction(int(c.p), int(c.q)) for m, c in wanted.terms() if c}
    point = [Fraction(z) for z in point]
    assert p.shift(point).terms == terms
    for highest in (0, 1, 2, 5):
        assert p.shift(point, highest).terms == {m: c for m, c in terms.items() if sum(m) <= highest}

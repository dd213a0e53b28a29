"""Polynomials as exact tables of terms, and their brackets, for linear algebra over the rationals."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from polhode._base.rational._terms import Terms
from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic._gate import sympy


def to_terms(expression: Any, coordinates: Sequence[Any]) -> Terms:
    """Return a polynomial with rational coefficients as {exponents: coefficient}.

    Raises:
        InvalidInput: for other expressions.
    """
    terms: Terms = {}
    for powers, value in symbolic_terms(expression, coordinates).items():
        if not value.is_Rational:
            raise InvalidInput(f"the coefficient {shown(str(value))} must be a rational number. Put numbers in place "
                               "of its symbols, as fractions.")
        terms[powers] = Fraction(int(value.p), int(value.q))
    return terms


def symbolic_terms(expression: Any, coordinates: Sequence[Any]) -> dict[tuple[int, ...], Any]:
    """Return a polynomial as {exponents: coefficient}, the coefficients free of the coordinates.

    Raises:
        InvalidInput: for other expressions.
    """
    try:
        poly = sympy.Poly(sympy.expand(expression), *coordinates)
    except sympy.PolynomialError:
        poly = None
    if poly is None or any(value.has(*coordinates) for value in poly.coeffs()):
        raise InvalidInput(
            f"exact linear algebra takes a polynomial in {', '.join(map(str, coordinates))}; got "
            f"{shown(str(expression))}. Expand it in these coordinates first."
        )
    return {tuple(map(int, powers)): value for powers, value in poly.terms() if value != 0}


def from_terms(terms: dict[tuple[int, ...], Any], coordinates: Sequence[Any]) -> Any:
    """Return the SymPy expression of {exponents: coefficient}."""
    total = sympy.Integer(0)
    for powers, value in terms.items():
        number = sympy.Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else value
        total += number * sympy.Mul(*(x**int(n) for x, n in zip(coordinates, powers, strict=True)))
    return total


def bracket_terms(
    constants: Sequence[Sequence[dict[int, Any]]], sign: int, F: dict[tuple[int, ...], Any],
    G: dict[tuple[int, ...], Any],
) -> dict[tuple[int, ...], Any]:
    """Return {F, G} of polynomials as tables of terms.

    Args:
        constants: [e_i, e_j] as {k: c_ijk}.
        sign: of the bracket.
        F: first polynomial.
        G: second polynomial.
    """
    total: dict[tuple[int, ...], Any] = defaultdict(int)
    for powers, value in F.items():
        for others, factor in G.items():
            both = [m + n for m, n in zip(powers, others, strict=True)]
            for i, m in enumerate(powers):
                for j, n in enumerate(others):
                    if not m * n:
                        continue
                    for k, c in constants[i][j].items():
                        raised = list(both)
                        raised[i] -= 1
                        raised[j] -= 1
                        raised[k] += 1
                        total[tuple(raised)] += sign * m * n * value * factor * c
    return {powers: value for powers, value in total.items() if value != 0}

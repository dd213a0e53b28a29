"""Polynomials of SymPy as python-flint's, and back."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from flint import fmpq, fmpq_mpoly

from polhode._base.rational._polynomials import context
from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic._gate import sympy


def to_rational(expression: Any, coordinates: Sequence[Any]) -> fmpq_mpoly:
    """Return a polynomial with rational coefficients as python-flint's.

    Raises:
        InvalidInput: for other expressions.
    """
    terms = symbolic_terms(expression, coordinates)
    if wrong := [value for value in terms.values() if not value.is_Rational]:
        raise InvalidInput(f"the coefficient {shown(str(wrong[0]))} must be a rational number. Put numbers in place "
                           "of its symbols, as fractions.")
    return context(len(coordinates)).from_dict({powers: fmpq(int(c.p), int(c.q)) for powers, c in terms.items()})


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


def to_expression(terms: Iterable[tuple[Sequence[Any], Any]], coordinates: Sequence[Any]) -> Any:
    """Return the SymPy expression of exponents with coefficients, which are python-flint's rationals or SymPy's."""
    total = sympy.Integer(0)
    for powers, value in terms:
        number = sympy.Rational(int(value.p), int(value.q)) if isinstance(value, fmpq) else value
        total += number * sympy.Mul(*(x**int(n) for x, n in zip(coordinates, powers, strict=True)))
    return total

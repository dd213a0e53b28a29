"""Polynomial integrals of a system's flow, by exact linear algebra.

The polynomials F of degree d or less with {F, H} = 0 are the null space of a matrix of rationals, as for the Casimirs.
Only new ones count: those that are not polynomials in H, the Casimirs and the integrals of lower degree.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections import defaultdict
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from polhode._base.rational._sparse import new_terms, null_space
from polhode._base.rational._terms import exponents_of, multiply_together, whole_terms
from polhode._base.rational.numbers import EXACT
from polhode.algebra.casimirs import check_degree
from polhode.errors import InvalidInput
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic._polynomials import bracket_terms, from_terms, symbolic_terms, to_terms
from polhode.proving.symbolic.systems import SymbolicSystem, as_symbolic
from polhode.systems.base import AbstractLiePoissonSystem


class IntegralLimits(NamedTuple):
    """What the search for polynomial integrals attempts.

    Attributes:
        max_symbolic_monomials: with coefficients that are functions of symbols; 209 take a second, 461 minutes.
    """

    max_symbolic_monomials: int = 250


LIMITS = IntegralLimits()
Polynomial = dict[tuple[int, ...], Any]


def polynomial_integrals(
    system: SymbolicSystem | AbstractLiePoissonSystem, degree: int, read_as: str = EXACT
) -> list[Any]:
    """Return generators of the polynomial integrals of a system's flow up to a degree, lowest first.

    Left out are polynomials in the Hamiltonian, the polynomial Casimirs and the integrals listed before, made of
    products up to the degree or that of H; so the list is empty for a system without further polynomial integrals of
    that degree. An integral is determined up to a factor and up to what is left out. Numbers are exact:
    doubles of a numerical system are read as ``read_as`` says, and 0.1 + 0.2 is no 0.3 in either reading. Where H has
    symbols, integrals are those for generic values of them, with coefficients that are rational functions; special
    values may have more.

    Args:
        system: with a Hamiltonian that is a polynomial in the coordinates, symbolic or from `polhode.systems`.
        degree: the highest degree, at least 1.
        read_as: of a numerical system's doubles, "exact" for the binary fractions that they are, "decimal" for the
            shortest decimals that round to them; a symbolic system has its numbers.

    Returns:
        SymPy polynomials in ``coordinates`` of the system's bracket, with coprime whole coefficients where these are
        numbers.

    Raises:
        InvalidInput: for a Hamiltonian that is not a polynomial, structure constants that are not rational, a degree
            below 1, a problem too large, or a missing python-flint.

    >>> from polhode.systems import HeavyTop
    >>> polynomial_integrals(HeavyTop((1.0, 1.0, 0.5), 1.0), 1)  # Lagrange's top
    [x3]
    >>> len(polynomial_integrals(HeavyTop((2.0, 2.0, 1.0), 1.0, (1.0, 0.0, 0.0)), 4))  # Kovalevskaya's
    1

    Source: Clebsch, Math. Ann. 3 (1871) 238; Steklov, Math. Ann. 42 (1893) 273; Kovalevskaya, Acta Math. 12 (1889) 177.
    """
    system = as_symbolic(system, read_as)
    bracket, x = system.bracket, system.bracket.coordinates
    dim = bracket.dim
    check_degree(degree, math.comb(dim + degree, degree) - 1 if isinstance(degree, int) and degree > 0 else 0, dim)
    parameters = sorted(system.hamiltonian.free_symbols - set(x), key=str)
    constants = bracket.rational_brackets()
    if not parameters:
        H: Polynomial = to_terms(system.hamiltonian, x)
        field = None
    else:
        if math.comb(dim + degree, degree) > LIMITS.max_symbolic_monomials:
            raise InvalidInput(
                f"`degree` {degree} in {dim} variables has more than {LIMITS.max_symbolic_monomials} monomials, "
                f"and the Hamiltonian has symbols ({', '.join(map(str, parameters))}). Put numbers in their place by "
                "`subs`, or lower it."
            )
        field, H = _in_field(symbolic_terms(system.hamiltonian, x), parameters)
    zero = (0,) * dim
    H = {powers: value for powers, value in H.items() if powers != zero}
    one = Fraction(1) if field is None else field.one
    # an integral of low degree may be a difference of products of higher degree, as L3 is of H and |L|²
    highest = max(degree, max(map(sum, H), default=0))
    known = [{m: v * one for m, v in to_terms(C, x).items()} for C in bracket.casimirs(highest)]
    known += [H] if H else []
    generators: list[Polynomial] = []
    for d in range(1, degree + 1):
        invariants = _commuting(constants, bracket.sign, H, dim, d, one, field)
        generators += _new(invariants, multiply_together([*known, *generators], highest), field)
    return [_as_expression(terms, x, field) for terms in generators]


def _commuting(
    constants: Sequence[Sequence[dict[int, Fraction]]], sign: int, H: Polynomial, dim: int, degree: int, one: Any,
    field: Any,
) -> list[Polynomial]:
    """Return a basis of the polynomials of degree 1 up to a given one that commute with H."""
    monomials = [exponents_of(m, dim) for d in range(degree, 0, -1)
                 for m in itertools.combinations_with_replacement(range(dim), d)]
    rows: dict[tuple[int, ...], dict[int, Any]] = defaultdict(dict)
    for column, monomial in enumerate(monomials):
        for powers, value in bracket_terms(constants, sign, {monomial: one}, H).items():
            rows[powers][column] = value
    vectors = _null_space(list(rows.values()), len(monomials), field)
    return [{monomials[c]: v for c, v in vector.items()} for vector in vectors]


def _null_space(rows: list[dict[int, Any]], columns: int, field: Any) -> list[dict[int, Any]]:
    if field is None:
        return null_space(rows, columns)
    if not rows:
        return [{c: field.one} for c in range(columns)]
    matrix = sympy.polys.matrices.DomainMatrix(dict(enumerate(rows)), (len(rows), columns), field)
    kernel = matrix.nullspace(divide_last=True)
    return [dict(row) for row in kernel.rep.to_sdm().values()]


def _new(invariants: list[Polynomial], products: list[Polynomial], field: Any) -> list[Polynomial]:
    """Return those invariants that are needed in addition to the products to span all."""
    if not invariants:
        return []
    if field is None:
        return [whole_terms(terms) for terms in new_terms(invariants, products)]
    monomials = sorted({m for terms in (*invariants, *products) for m in terms}, reverse=True)
    columns = [*products, *sorted(invariants, key=len)]
    rows = {r: {c: terms[m] for c, terms in enumerate(columns) if m in terms} for r, m in enumerate(monomials)}
    matrix = sympy.polys.matrices.DomainMatrix(rows, (len(monomials), len(columns)), field)
    _, pivots = matrix.rref()
    return [columns[c] for c in pivots if c >= len(products)]


def _in_field(terms: Polynomial, parameters: Sequence[Any]) -> tuple[Any, Polynomial]:
    """Return the field of rational functions of the parameters, and a polynomial with coefficients in it."""
    field = sympy.QQ.frac_field(*parameters)
    try:
        return field, {powers: field.from_sympy(sympy.together(value)) for powers, value in terms.items()}
    except (sympy.polys.polyerrors.CoercionFailed, ValueError):
        raise InvalidInput(
            "coefficients of the Hamiltonian must be rational functions of its symbols. Give a symbol to what is not."
        ) from None


def _as_expression(terms: Polynomial, coordinates: Sequence[Any], field: Any) -> Any:
    if field is None:
        return from_terms(terms, coordinates)
    # coprime polynomials in the parameters
    common = functools.reduce(lambda a, b: a.lcm(b), (value.denom for value in terms.values()))
    whole = {powers: value.numer * common.exquo(value.denom) for powers, value in terms.items()}
    shared = functools.reduce(lambda a, b: a.gcd(b), whole.values())
    return from_terms({powers: sympy.factor(v.exquo(shared).as_expr()) for powers, v in whole.items()}, coordinates)

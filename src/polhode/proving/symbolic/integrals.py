"""Polynomial integrals of a system's flow, by exact linear algebra.

The polynomials F of degree d or less with {F, H} = 0 are the null space of a matrix of rationals, as for the Casimirs.
Only new ones count: those that are not polynomials in H, the Casimirs and the integrals of lower degree.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from polhode._base import check
from polhode._base.rational._polynomials import context, poisson_field, poisson_tensor, rate
from polhode._base.rational._sparse import SparseRow, choose_independent, null_space, rows_of, whole_multiple
from polhode._base.rational._terms import exponents_of, multiply_together
from polhode._base.rational.numbers import EXACT
from polhode.algebra.casimirs import check_monomials
from polhode.errors import InvalidInput
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic._polynomials import symbolic_terms, to_expression, to_rational
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.systems import SymbolicSystem, as_symbolic
from polhode.systems.base import AbstractLiePoissonSystem


class IntegralLimits(NamedTuple):
    """What the search for polynomial integrals attempts.

    Attributes:
        max_symbolic_monomials: with coefficients that are functions of symbols; 209 take a second, 461 minutes.
    """

    max_symbolic_monomials: int = 250


LIMITS = IntegralLimits()
Polynomial = Any
"""Of python-flint, or of SymPy where coefficients are rational functions of symbols; both have terms and monoms."""


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
    degree = check.whole("degree", degree, 1)
    check_monomials(degree, math.comb(dim + degree, degree) - 1, dim)
    parameters = sorted(system.hamiltonian.free_symbols - set(x), key=str)
    bracket.rational_brackets()  # refuses symbols
    if parameters and math.comb(dim + degree, degree) > LIMITS.max_symbolic_monomials:
        raise InvalidInput(
            f"`degree` {degree} in {dim} variables has more than {LIMITS.max_symbolic_monomials} monomials, "
            f"and the Hamiltonian has symbols ({', '.join(map(str, parameters))}). Put numbers in their place by "
            "`subs`, or lower it."
        )
    over = _OverSymbols(bracket, parameters) if parameters else _OverNumbers(bracket)
    H = over.read(system.hamiltonian)
    flow = over.flow(H)
    # an integral of low degree may be a difference of products of higher degree, as L3 is of H and |L|²
    highest = max([degree, *(int(sum(m)) for m in H.monoms())])
    known = [over.read(C) for C in bracket.casimirs(highest)]
    if moves := {m: c for m, c in H.terms() if any(m)}:
        known.append(over.space.from_dict(moves))
    generators: list[Polynomial] = []
    for d in range(1, degree + 1):
        invariants = _commuting(over, flow, d)
        if invariants:
            generators += over.choose_new(invariants, multiply_together([*known, *generators], highest))
    return [over.show(p) for p in generators]


class _OverNumbers:
    """Polynomials of python-flint."""

    def __init__(self, bracket: LiePoissonBracket) -> None:
        self.bracket, self.space = bracket, context(bracket.dim)
        self.one, self.rate, self.null_space = 1, rate, null_space

    def read(self, expression: Any) -> Polynomial:
        return to_rational(expression, self.bracket.coordinates)

    def flow(self, H: Polynomial) -> Sequence[Polynomial]:
        return poisson_field(poisson_tensor(self.bracket.rational_brackets(), self.bracket.sign), H)

    def choose_new(self, invariants: list[Polynomial], products: list[Polynomial]) -> list[Polynomial]:
        """Return those invariants that are needed in addition to the products to span all."""
        return [whole_multiple(p) for p in choose_independent(invariants, products)]

    def show(self, p: Polynomial) -> Any:
        return to_expression(p.terms(), self.bracket.coordinates)


class _OverSymbols:
    """Polynomials of SymPy over the field of rational functions of parameters."""

    def __init__(self, bracket: LiePoissonBracket, parameters: Sequence[Any]) -> None:
        self.bracket, self.field = bracket, sympy.QQ.frac_field(*parameters)
        self.one, self.space = self.field.one, sympy.ring(bracket.coordinates, self.field)[0]

    def read(self, expression: Any) -> Polynomial:
        terms = symbolic_terms(expression, self.bracket.coordinates)
        try:
            return self.space.from_dict({m: self.field.from_sympy(sympy.together(c)) for m, c in terms.items()})
        except (sympy.polys.polyerrors.CoercionFailed, ValueError):
            raise InvalidInput("coefficients of the Hamiltonian must be rational functions of its symbols. Give a "
                               "symbol to what is not.") from None

    def flow(self, H: Polynomial) -> Sequence[Polynomial]:
        x, sign = self.space.gens, self.bracket.sign
        slopes = [H.diff(v) for v in x]
        return [sum((slopes[j] * x[k] * sympy.QQ(sign * c.numerator, c.denominator) for j, vector in enumerate(row)
                     for k, c in vector.items()), self.space.zero)
                for row in self.bracket.rational_brackets()]  # fmt: skip

    def rate(self, p: Polynomial, flow: Sequence[Polynomial]) -> Polynomial:
        return sum((f * p.diff(x) for f, x in zip(flow, self.space.gens, strict=True)), self.space.zero)

    def null_space(self, rows: list[SparseRow], columns: int) -> list[SparseRow]:
        if not rows:
            return [{c: self.field.one} for c in range(columns)]
        kernel = self._matrix(rows, columns).nullspace(divide_last=True)
        return [dict(row) for row in kernel.rep.to_sdm().values()]

    def choose_new(self, invariants: list[Polynomial], products: list[Polynomial]) -> list[Polynomial]:
        columns = [*products, *sorted(invariants, key=len)]
        _, pivots = self._matrix(rows_of(columns), len(columns)).rref()
        return [columns[c] for c in pivots if c >= len(products)]

    def _matrix(self, rows: list[SparseRow], columns: int) -> Any:
        return sympy.polys.matrices.DomainMatrix(dict(enumerate(rows)), (len(rows), columns), self.field)

    def show(self, p: Polynomial) -> Any:
        """Return a multiple with coprime polynomials in the parameters."""
        common = functools.reduce(lambda a, b: a.lcm(b), (c.denom for c in p.coeffs()))
        whole = [c.numer * common.exquo(c.denom) for c in p.coeffs()]
        shared = functools.reduce(lambda a, b: a.gcd(b), whole)
        factored = (sympy.factor(c.exquo(shared).as_expr()) for c in whole)
        return to_expression(zip(p.monoms(), factored, strict=True), self.bracket.coordinates)


def _commuting(over: _OverNumbers | _OverSymbols, flow: Sequence[Polynomial], degree: int) -> list[Polynomial]:
    """Return a basis of the polynomials of degree 1 up to a given one that a flow keeps."""
    dim = len(flow)
    monomials = [exponents_of(m, dim) for d in range(degree, 0, -1)
                 for m in itertools.combinations_with_replacement(range(dim), d)]
    rows = rows_of([over.rate(over.space.from_dict({m: over.one}), flow) for m in monomials])
    vectors = over.null_space(rows, len(monomials))
    return [over.space.from_dict({monomials[c]: v for c, v in vector.items()}) for vector in vectors]

"""Lie–Poisson brackets of SymPy expressions, for any algebra or table of structure constants.

{F, G} = sign · Σ c_ijk x_k ∂F/∂x_i ∂G/∂x_j in the coordinates x_k = ⟨μ, e_k⟩; minus (left-invariant) is the default,
and Ḟ = {F, H}. Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry* (1999), §10.1 and §13.1.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from polhode._base import check
from polhode._base.rational.numbers import EXACT, check_reading, read_number
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.casimirs import invariant_polynomials, rational_brackets
from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic._polynomials import to_expression

Expression = Any  # of SymPy, which has no types of its own for checkers


class LiePoissonBracket:
    """The bracket of functions on the dual of a Lie algebra, as SymPy expressions in its coordinates.

    Args:
        algebra: one of `polhode.algebra` with rational structure constants, or a table c (dim, dim, dim) with
            [e_i, e_j] = Σ_k c_ijk e_k of numbers, fractions or SymPy expressions, antisymmetric in i and j. Jacobi's
            identity is not required: ``jacobiator`` tests it.
        coordinates: (dim,) names or symbols of ⟨μ, e_k⟩; x1, x2, … by default.
        sign: −1 for the left-invariant (minus) bracket, +1 for the other.
        parameters: further symbols, or names, of which functions may be made; those of the table need not be repeated.
        read_as: "exact" for doubles as the binary fractions that they are, "decimal" for the shortest decimals that
            round to them, in the table and in all functions; SymPy's rationals are what they are.

    Attributes:
        algebra: the algebra, or None for a table.
        constants: c as nested tuples of SymPy numbers.
        coordinates: (dim,) real symbols.
        sign: −1 or +1.
        parameters: symbols as declared, with those of the table.
        read_as: as given.

    Raises:
        InvalidInput: for a table of wrong shape or not antisymmetric, constants that are rounded, a wrong number of
            coordinates, names that are taken twice, or a sign other than ±1.

    >>> from polhode.algebra import SO3
    >>> so3 = LiePoissonBracket(SO3(), ["L1", "L2", "L3"])
    >>> L1, L2, L3 = so3.coordinates
    >>> so3(L1, L2), so3(L1, L2**2), so3.with_sign(+1)(L1, L2)
    (-L3, -2*L2*L3, L3)
    """

    def __init__(
        self, algebra: Any, coordinates: Sequence[Any] | None = None, sign: int = -1, parameters: Sequence[Any] = (),
        read_as: str = EXACT,
    ) -> None:
        if sign not in (-1, 1):
            raise InvalidInput(f"`sign` must be −1 (left-invariant) or +1 (right-invariant); got {shown(sign)}.")
        check_reading(read_as)
        self.sign, self.read_as = sign, read_as
        self.algebra: AbstractLieAlgebra | None = algebra if isinstance(algebra, AbstractLieAlgebra) else None
        self.constants = (_own_table(self.algebra, read_as) if self.algebra is not None
                          else _given_table(algebra, read_as))
        self.coordinates = _symbols(coordinates, len(self.constants))
        self.parameters = _parameters(parameters, self.constants, self.coordinates)

    @property
    def dim(self) -> int:
        """Dimension of the algebra."""
        return len(self.constants)

    def with_sign(self, sign: int) -> LiePoissonBracket:
        """Return the bracket with the sign ±1 on these coordinates."""
        given = self.constants if self.algebra is None else self.algebra
        return LiePoissonBracket(given, self.coordinates, sign, self.parameters, self.read_as)

    def read(self, expression: Expression) -> Expression:
        """Return a function with this bracket's symbols, and fractions in place of doubles.

        A symbol with the name of a coordinate or a parameter is read as that one, whatever its assumptions in SymPy:
        ``sympy.symbols("L1")`` is otherwise another symbol than a real L1, of which all derivatives vanish.

        Raises:
            InvalidInput: for symbols that are neither, and for text, which SymPy would run.
        """
        expression = read_doubles(expression, self.read_as)
        return name_symbols(expression, (*self.coordinates, *self.parameters))

    @property
    def tensor(self) -> Any:
        """The Poisson tensor π_ij = {x_i, x_j}, a SymPy matrix (dim, dim) linear in the coordinates."""
        return sympy.Matrix(self.dim, self.dim, lambda i, j: self.sign * sum(
            c * x for c, x in zip(self.constants[i][j], self.coordinates, strict=True)))

    def __call__(self, F: Expression, G: Expression) -> Expression:
        """Return {F, G}, expanded."""
        F, G = self.read(F), self.read(G)
        dF = [sympy.diff(F, x) for x in self.coordinates]
        dG = [sympy.diff(G, x) for x in self.coordinates]
        total = sympy.Integer(0)
        for i, row in enumerate(self.constants):
            for j, vector in enumerate(row):
                if dF[i] == 0 or dG[j] == 0:
                    continue
                inner = sum(c * x for c, x in zip(vector, self.coordinates, strict=True) if c != 0)
                total += dF[i] * dG[j] * inner
        return sympy.expand(self.sign * total)

    def hamilton_equations(self, H: Expression) -> dict[Any, Expression]:
        """Return ẋ_k = {x_k, H} by coordinate, simplified."""
        return {x: sympy.factor_terms(sympy.simplify(self(x, H))) for x in self.coordinates}

    def jacobiator(self, F: Expression, G: Expression, K: Expression) -> Expression:
        """Return {F, {G, K}} + {G, {K, F}} + {K, {F, G}}, simplified: zero for every Lie algebra."""
        return sympy.simplify(self(F, self(G, K)) + self(G, self(K, F)) + self(K, self(F, G)))

    def broken_triples(self) -> dict[tuple[Any, Any, Any], Expression]:
        """Return the Jacobiators of triples of coordinates that do not vanish; empty for a Lie algebra.

        A biderivation's Jacobiator is a derivation in each argument, so that coordinates decide for all functions.
        """
        broken = {}
        for i in range(self.dim):
            for j in range(i + 1, self.dim):
                for k in range(j + 1, self.dim):
                    triple = tuple(self.coordinates[n] for n in (i, j, k))
                    value = sum(
                        self._contract(a, self.constants[b][c]) for a, b, c in ((i, j, k), (j, k, i), (k, i, j))
                    )
                    if (value := sympy.expand(value)) != 0:
                        broken[triple] = value
        return broken

    def _contract(self, i: int, vector: Sequence[Any]) -> Expression:
        """Return {x_i, Σ_j v_j x_j}, without the sign, which counts twice."""
        pairs = ((j, v) for j, v in enumerate(vector) if v != 0)
        return sum((v * c * x for j, v in pairs for c, x in zip(self.constants[i][j], self.coordinates, strict=True)),
                   sympy.Integer(0))

    def is_casimir(self, C: Expression) -> bool:
        """Return whether {x_k, C} vanishes for every coordinate."""
        C = self.read(C)
        return all(sympy.simplify(self(x, C)) == 0 for x in self.coordinates)

    def casimirs(self, degree: int) -> list[Expression]:
        """Return independent generators of the polynomial Casimirs up to a degree, lowest first.

        By the exact linear algebra of ``polhode.algebra.polynomial_casimirs``, for constants that are rational numbers.

        Raises:
            InvalidInput: for constants that are symbols, a degree below 1, a problem too large, or a missing
                python-flint.
        """
        found = invariant_polynomials(self.rational_brackets(), degree)
        return [to_expression(p.terms(), self.coordinates) for p in found]

    def rational_brackets(self) -> list[list[dict[int, Fraction]]]:
        """Return [e_i, e_j] as {k: c_ijk} with fractions.

        Raises:
            InvalidInput: for constants that are symbols.
        """
        wrong = [c for row in self.constants for vector in row for c in vector if not c.is_Rational]
        if wrong:
            check.refuse("structure constants", "numbers for exact linear algebra", str(wrong[0]),
                         "Put numbers in place of its symbols.")
        return [[{k: Fraction(int(c.p), int(c.q)) for k, c in enumerate(vector) if c != 0} for vector in row]
                for row in self.constants]

    def latex(self) -> str:
        """Return the brackets of coordinates that do not vanish, as LaTeX for a display."""
        lines = []
        for i in range(self.dim):
            for j in range(i + 1, self.dim):
                if (value := self(self.coordinates[i], self.coordinates[j])) != 0:
                    pair = ", ".join(sympy.latex(self.coordinates[n]) for n in (i, j))
                    lines.append(rf"\{{{pair}\}} &= {sympy.latex(value)}")
        return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def _own_table(algebra: AbstractLieAlgebra, read_as: str) -> tuple[tuple[tuple[Any, ...], ...], ...]:
    brackets = rational_brackets(algebra, read_as)
    zero = sympy.Integer(0)
    number = {(i, j, k): sympy.Rational(c.numerator, c.denominator)
              for i, row in enumerate(brackets) for j, vector in enumerate(row) for k, c in vector.items()}
    size = range(algebra.dim)
    return tuple(tuple(tuple(number.get((i, j, k), zero) for k in size) for j in size) for i in size)


def _given_table(table: Any, read_as: str) -> tuple[tuple[tuple[Any, ...], ...], ...]:
    shape = np.shape(np.asarray(table, dtype=object))
    if len(shape) != 3 or len(set(shape)) != 1 or not shape[0]:
        raise InvalidInput(
            f"`algebra` must be one of polhode.algebra or a table of structure constants (dim, dim, dim); got shape "
            f"{shape}."
        )
    rows = tuple(tuple(tuple(read_doubles(c, read_as) for c in vector) for vector in row) for row in table)
    for i in range(shape[0]):
        for j in range(i, shape[0]):
            for k in range(shape[0]):
                if sympy.expand(rows[i][j][k] + rows[j][i][k]) != 0:
                    raise InvalidInput(
                        f"the table must be antisymmetric, c[i,j,k] = −c[j,i,k]; got c[{i},{j},{k}] = {rows[i][j][k]} "
                        f"and c[{j},{i},{k}] = {rows[j][i][k]}. Change one of them."
                    )
    return rows


def read_doubles(value: Any, read_as: str) -> Expression:
    """Return a number or an expression of SymPy with fractions in place of its doubles.

    >>> str(read_doubles(0.5 * sympy.Symbol("x") ** 2, "exact")), read_doubles(0.1, "decimal")
    ('x**2/2', 1/10)
    """
    if not isinstance(value, sympy.Basic) or isinstance(value, sympy.Float):
        fraction = read_number(value, read_as)
        return sympy.Rational(fraction.numerator, fraction.denominator)
    numbers = {x: read_number(x, read_as) for x in value.atoms(sympy.Float)}
    return value.xreplace({x: sympy.Rational(n.numerator, n.denominator) for x, n in numbers.items()})


def name_symbols(expression: Expression, symbols: Sequence[Any]) -> Expression:
    """Return an expression whose symbols are replaced by the given ones of their names.

    Raises:
        InvalidInput: for symbols of other names.
    """
    known = {str(s): s for s in symbols}
    foreign = expression.free_symbols - set(symbols)
    if unknown := sorted({str(s) for s in foreign} - set(known)):
        raise InvalidInput(f"symbols must be coordinates or declared parameters, here {', '.join(known)}; got "
                           f"{shown(', '.join(unknown))}. Declare further ones by `parameters=`.")
    return expression.xreplace({s: known[str(s)] for s in foreign})


def _symbols(coordinates: Sequence[Any] | None, dim: int) -> tuple[Any, ...]:
    names = [f"x{k + 1}" for k in range(dim)] if coordinates is None else list(coordinates)
    symbols = tuple(x if isinstance(x, sympy.Symbol) else sympy.Symbol(str(x), real=True) for x in names)
    if len(set(symbols)) != dim:
        raise InvalidInput(f"`coordinates` must be {dim} different names or symbols; got {shown(names)}.")
    return symbols


def _parameters(given: Sequence[Any], table: Any, coordinates: Sequence[Any]) -> tuple[Any, ...]:
    symbols = {s for row in table for vector in row for c in vector for s in c.free_symbols}
    declared = [x if isinstance(x, sympy.Symbol) else sympy.Symbol(str(x), real=True)
                for x in ([given] if isinstance(given, str | sympy.Symbol) else given)]
    symbols |= set(declared)
    names = [str(s) for s in (*coordinates, *symbols)]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise InvalidInput(f"coordinates and parameters must have different names; got {shown(', '.join(twice))} "
                           "twice. Rename one.")
    return tuple(sorted(symbols, key=str))

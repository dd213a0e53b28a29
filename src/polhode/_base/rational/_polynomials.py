"""Polynomials with rational coefficients in several variables: sums, products, derivatives, shifts of the origin."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from polhode._base.rational._terms import Exponents, multiply_terms

SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


class RationalPolynomial:
    """Σ c_m Π x_i^{m_i}, exact; terms of any degrees.

    Args:
        size: how many variables there are.
        terms: coefficients by exponents; zeros are left out.

    >>> x, y = RationalPolynomial.variables(2)
    >>> str((x + 2 * y) * x - 3), (x * y).rate([y, x])
    ('x1² + 2 x1 x2 − 3', x1² + x2²)
    """

    __slots__ = ("size", "terms")

    def __init__(self, size: int, terms: Mapping[Exponents, Fraction | int] | None = None) -> None:
        self.size = size
        self.terms = {m: Fraction(c) for m, c in (terms or {}).items() if c}

    @staticmethod
    def variables(size: int) -> list[RationalPolynomial]:
        """Return x_1, …, x_n."""
        return [RationalPolynomial(size, {_unit(size, k): 1}) for k in range(size)]

    def constant(self, value: Fraction | int) -> RationalPolynomial:
        """Return a number as a polynomial in these variables."""
        return RationalPolynomial(self.size, {(0,) * self.size: value})

    def _like(self, other: RationalPolynomial | Fraction | int) -> RationalPolynomial:
        return other if isinstance(other, RationalPolynomial) else self.constant(other)

    def __add__(self, other: RationalPolynomial | Fraction | int) -> RationalPolynomial:
        return total(self.size, (self, self._like(other)))

    __radd__ = __add__

    def __neg__(self) -> RationalPolynomial:
        return self * -1

    def __sub__(self, other: RationalPolynomial | Fraction | int) -> RationalPolynomial:
        return self + self._like(other) * -1

    def __mul__(self, other: RationalPolynomial | Fraction | int) -> RationalPolynomial:
        if not isinstance(other, RationalPolynomial):
            return RationalPolynomial(self.size, {m: c * other for m, c in self.terms.items()})
        return RationalPolynomial(self.size, multiply_terms(self.terms, other.terms))

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> RationalPolynomial:
        result = self.constant(1)
        for _ in range(exponent):
            result = result * self
        return result

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RationalPolynomial) and self.size == other.size and self.terms == other.terms

    def __hash__(self) -> int:
        return hash((self.size, frozenset(self.terms.items())))

    @property
    def degree(self) -> int:
        """The highest degree of a term; zero for a constant."""
        return max(map(sum, self.terms), default=0)

    @property
    def magnitude(self) -> Fraction:
        """The sum of the sizes of all coefficients."""
        return sum((abs(c) for c in self.terms.values()), Fraction(0))

    def part(self, lowest: int, highest: int | None = None) -> RationalPolynomial:
        """Return the terms of degrees from lowest to highest, or of all degrees above."""
        top = self.degree if highest is None else highest
        return RationalPolynomial(self.size, {m: c for m, c in self.terms.items() if lowest <= sum(m) <= top})

    def derivative(self, k: int) -> RationalPolynomial:
        """Return ∂/∂x_k, counted from 0."""
        lowered = {(*m[:k], m[k] - 1, *m[k + 1 :]): m[k] * c for m, c in self.terms.items() if m[k]}
        return RationalPolynomial(self.size, lowered)

    def rate(self, field: Sequence[RationalPolynomial]) -> RationalPolynomial:
        """Return the rate of change along a field, Σ f_k ∂/∂x_k."""
        return total(self.size, (f * self.derivative(k) for k, f in enumerate(field)))

    def shift(self, point: Sequence[Fraction], highest: int | None = None) -> RationalPolynomial:
        """Return the polynomial of v whose value is that of this one at point + v; without terms above a degree.

        One coordinate after the other, (z + v)^m = Σ C(m, j) z^(m−j) v^j: the power of a sum of coordinates, whose
        terms times each other would be millions, takes thousands.
        """
        terms, most = dict(self.terms), self.degree if highest is None else highest
        for k, z in enumerate(point):
            moved: dict[Exponents, Fraction] = defaultdict(Fraction)
            powers = [Fraction(1)]
            for m, c in terms.items():
                while len(powers) <= m[k]:
                    powers.append(powers[-1] * z)
                before = sum(m[:k])
                for j in range(m[k] if not z else 0, min(m[k], most - before) + 1):
                    moved[(*m[:k], j, *m[k + 1 :])] += math.comb(m[k], j) * c * powers[m[k] - j]
            terms = moved
        return RationalPolynomial(self.size, terms)

    def at(self, point: Sequence[Fraction]) -> Fraction:
        """Return the value at a point."""
        value = Fraction(0)
        for m, c in self.terms.items():
            for x, exponent in zip(point, m, strict=True):
                c *= x**exponent
            value += c
        return value

    def slope(self) -> list[Fraction]:
        """Return the coefficients of x_1, …, x_n."""
        return [self.terms.get(_unit(self.size, k), Fraction(0)) for k in range(self.size)]

    def quadratic(self) -> list[list[Fraction]]:
        """Return the symmetric matrix of the terms of degree two, with xᵀMx their sum."""
        rows = []
        for i in range(self.size):
            pairs = (tuple(map(sum, zip(_unit(self.size, i), _unit(self.size, j), strict=True)))
                     for j in range(self.size))
            rows.append([self.terms.get(m, Fraction(0)) / (1 if i == j else 2) for j, m in enumerate(pairs)])
        return rows

    def sorted_terms(self) -> list[tuple[Exponents, Fraction]]:
        """Return the terms, highest degree first."""
        return sorted(self.terms.items(), key=lambda pair: (-sum(pair[0]), tuple(-e for e in pair[0])))

    def __str__(self) -> str:
        text = ""
        for m, c in self.sorted_terms():
            factors = [f"x{k + 1}" + (str(e).translate(SUPERSCRIPTS) if e > 1 else "") for k, e in enumerate(m) if e]
            size = [] if abs(c) == 1 and factors else [str(abs(c))]
            sign = ("" if c > 0 else "−") if not text else (" + " if c > 0 else " − ")
            text += sign + " ".join(size + factors)
        return text or "0"

    __repr__ = __str__


def total(size: int, parts: Iterable[RationalPolynomial]) -> RationalPolynomial:
    """Return the sum of polynomials in ``size`` variables."""
    terms: dict[Exponents, Fraction] = defaultdict(Fraction)
    for p in parts:
        for m, c in p.terms.items():
            terms[m] += c
    return RationalPolynomial(size, terms)


def linear_form(row: Sequence[Fraction]) -> RationalPolynomial:
    """Return Σ row_k x_k."""
    return RationalPolynomial(len(row), {_unit(len(row), k): c for k, c in enumerate(row)})


def quadratic_form(matrix: Sequence[Sequence[Fraction]]) -> RationalPolynomial:
    """Return xᵀMx."""
    x = RationalPolynomial.variables(len(matrix))
    return total(len(matrix), (x[i] * linear_form(row) for i, row in enumerate(matrix)))


def _unit(size: int, k: int) -> Exponents:
    return tuple(int(i == k) for i in range(size))

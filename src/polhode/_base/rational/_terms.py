"""Polynomials as tables of terms, {exponents: coefficient}: products, multiples with whole coefficients."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

Exponents = tuple[int, ...]
Terms = dict[Exponents, Fraction]


def exponents_of(indices: tuple[int, ...], dim: int) -> Exponents:
    """Return the exponents of the product of the variables with these indices.

    >>> exponents_of((0, 2, 2), 4)
    (1, 0, 2, 0)
    """
    counts = [0] * dim
    for i in indices:
        counts[i] += 1
    return tuple(counts)


def multiply_terms(a: dict[Exponents, Any], b: dict[Exponents, Any]) -> dict[Exponents, Any]:
    """Return the product of two polynomials; coefficients may be any numbers or symbols."""
    product: dict[Exponents, Any] = defaultdict(int)
    for m, x in a.items():
        for n, y in b.items():
            product[tuple(i + j for i, j in zip(m, n, strict=True))] += x * y
    return {powers: value for powers, value in product.items() if value != 0}


def multiply_together(polynomials: Sequence[dict[Exponents, Any]], degree: int) -> list[dict[Exponents, Any]]:
    """Return all products of given polynomials, with repetition, up to a degree."""
    degrees = [max(map(sum, terms)) for terms in polynomials]

    def extend(start: int, left: int) -> list[dict[Exponents, Any]]:
        results: list[dict[Exponents, Any]] = []
        for n in range(start, len(polynomials)):
            if degrees[n] <= left:
                results.append(polynomials[n])
                results += [multiply_terms(polynomials[n], rest) for rest in extend(n, left - degrees[n])]
        return results

    return extend(0, degree)


def whole_terms(terms: Terms) -> Terms:
    """Return a polynomial's multiple with coprime whole coefficients, sorted, the first one positive."""
    order = sorted(terms, reverse=True)
    denominator = math.lcm(*(v.denominator for v in terms.values()))
    divisor = math.gcd(*(int(v * denominator) for v in terms.values()))
    factor = Fraction(denominator, divisor) * (1 if terms[order[0]] > 0 else -1)
    return {m: terms[m] * factor for m in order}

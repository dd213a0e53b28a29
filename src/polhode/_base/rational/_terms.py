"""Polynomials as terms, exponents and coefficients: their text, and products that fit a degree."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

Exponents = tuple[int, ...]
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def show_terms(terms: Iterable[tuple[Sequence[int], Any]]) -> str:
    """Return a polynomial as text.

    >>> show_terms([((2, 0), 1), ((1, 1), -2), ((0, 0), -1)])
    'x1² − 2 x1 x2 − 1'
    """
    text = ""
    for m, c in terms:
        factors = [f"x{k + 1}" + (str(e).translate(SUPERSCRIPTS) if e > 1 else "") for k, e in enumerate(m) if e]
        size = [] if abs(c) == 1 and factors else [str(abs(c))]
        sign = ("" if c > 0 else "−") if not text else (" + " if c > 0 else " − ")
        text += sign + " ".join(size + factors)
    return text or "0"


def exponents_of(indices: tuple[int, ...], dim: int) -> Exponents:
    """Return the exponents of the product of the variables with these indices.

    >>> exponents_of((0, 2, 2), 4)
    (1, 0, 2, 0)
    """
    counts = [0] * dim
    for i in indices:
        counts[i] += 1
    return tuple(counts)


def multiply_together(polynomials: Sequence[Any], degree: int) -> list[Any]:
    """Return all products of given polynomials, of python-flint or SymPy, with repetition, up to a degree."""
    degrees = [max(map(sum, p.monoms())) for p in polynomials]

    def extend(start: int, left: int) -> list[Any]:
        results: list[Any] = []
        for n in range(start, len(polynomials)):
            if degrees[n] <= left:
                results.append(polynomials[n])
                results += [polynomials[n] * rest for rest in extend(n, left - degrees[n])]
        return results

    return extend(0, degree)

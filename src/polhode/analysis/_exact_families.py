"""Families of equilibria, by identities of polynomials: along symmetries, within planes, and whole leaves."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from polhode._base.rational._matrices import null_space, rank, reduce_rows, solve_near
from polhode._base.rational._polynomials import RationalPolynomial, total
from polhode.analysis._exact_functions import ExactFunctions
from polhode.certificates._equations import quadratic_integrals
from polhode.types import Array, Float64


class FamilyLimits(NamedTuple):
    """Bounds of the search for functions that move along equilibria."""

    max_quadratic_coordinates: int = 6  # up to which all integrals of second degree are tried, as columns of a matrix
    max_multiples: int = 200  # of Casimirs' levels that may add up to a field
    direction_error: float = 1e-7  # of a direction in doubles: its distance from an exact space that contains it


LIMITS = FamilyLimits()


def moves_along_equilibria(exact: ExactFunctions, z: Sequence[Fraction], directions: Float64[Array, "d n"]) -> bool:
    """Whether each direction leads along equilibria on the leaf of an equilibrium z, by an identity of polynomials.

    Flows of conserved functions take equilibria to equilibria. So do all steps on the leaf if H is constant on it, and
    those that stay in a plane of equilibria that crosses the leaf.
    """
    if not len(directions):
        return True
    n, field = len(z), exact.field
    conserved = [p for name, p in exact.conserved.items() if name != "H"]
    flows = [[f.at(z) for f in exact.flow(p)] for p in conserved]
    flows += [[f.at(z) for f in exact.flow(p)] for p in linear_integrals(field, n)]
    if _contains(flows, directions):
        return True
    if n <= LIMITS.max_quadratic_coordinates:
        flows += [[f.at(z) for f in exact.flow(p)] for p in quadratic_integrals(field).values()]
        if _contains(flows, directions):
            return True
    return _leaf_is_still(exact, z) or _contains(_plane_on_leaf(exact, z), directions)


def linear_integrals(field: Sequence[RationalPolynomial], n: int) -> list[RationalPolynomial]:
    """Return a basis of the linear functions that a field keeps."""
    monomials = sorted({m for f in field for m in f.terms})
    x = RationalPolynomial.variables(n)
    basis = null_space([[f.terms.get(m, Fraction(0)) for f in field] for m in monomials], n)
    return [total(n, (c * y for c, y in zip(v, x, strict=True))) for v in basis]


def _contains(vectors: Sequence[Sequence[Fraction]], directions: Float64[Array, "d n"]) -> bool:
    """Whether directions, which are known in doubles, are combinations of vectors, which are exact."""
    vectors = [v for v in vectors if any(v)]
    if not vectors:
        return False
    rows = np.array([[float(x / max(map(abs, v))) for x in v] for v in reduce_rows(vectors, len(vectors[0]))[0]])
    left = directions - np.linalg.lstsq(rows.T, directions.T, rcond=None)[0].T @ rows
    return bool(np.abs(left).max() <= LIMITS.direction_error * np.abs(directions).max())


def _plane_on_leaf(exact: ExactFunctions, z: Sequence[Fraction]) -> list[list[Fraction]]:
    """Return the directions within the leaf of the plane z + ker A, if all of that plane is at rest."""
    n = len(z)
    around = [f.shift(z) for f in exact.field]
    kernel = null_space([f.slope() for f in around], n)
    s = RationalPolynomial.variables(len(kernel))
    x = [total(len(kernel), (v[k] * s[a] for a, v in enumerate(kernel))) for k in range(n)]
    if not kernel or any(_substitute(f, x) for f in around):
        return []
    slopes = [slope for p in exact.casimirs.values() if any(slope := p.shift(z, 1).slope())]
    inside = [[sum((a * b for a, b in zip(slope, v, strict=True)), Fraction(0)) for v in kernel] for slope in slopes]
    if rank(inside) < rank(slopes):
        return []  # the plane touches the leaf: where they meet need not be smooth
    return [[sum((c * v[k] for c, v in zip(row, kernel, strict=True)), Fraction(0)) for k in range(n)]
            for row in null_space(inside, len(kernel))]


def _substitute(p: RationalPolynomial, x: Sequence[RationalPolynomial]) -> RationalPolynomial:
    parts = []
    for m, c in p.terms.items():
        term = x[0].constant(c)
        for k, exponent in enumerate(m):
            term = term * x[k] ** exponent if exponent else term
        parts.append(term)
    return total(x[0].size, parts)


def _leaf_is_still(exact: ExactFunctions, z: Sequence[Fraction]) -> bool:
    """Whether the field vanishes on the leaf: each component is a sum of multiples of C − C(z), the Casimirs of z."""
    n = len(z)
    levels = [p - p.at(z) for p in exact.casimirs.values()]
    if not levels or not exact.is_regular(z):
        return False
    highest = max(f.degree for f in exact.field)
    if not 0 < sum(math.comb(n + highest - p.degree, n) for p in levels if p.degree <= highest) <= LIMITS.max_multiples:
        return False
    columns: list[RationalPolynomial] = []
    for level in levels:
        for degree in range(highest - level.degree + 1):
            for chosen in itertools.combinations_with_replacement(range(n), degree):
                product = level
                for k in chosen:
                    product = product * RationalPolynomial.variables(n)[k]
                columns.append(product)
    monomials = sorted({m for p in (*columns, *exact.field) for m in p.terms})
    rows = [[p.terms.get(m, Fraction(0)) for p in columns] for m in monomials]
    return all(solve_near(rows, [f.terms.get(m, Fraction(0)) for m in monomials], [Fraction(0)] * len(columns))
               is not None for f in exact.field)

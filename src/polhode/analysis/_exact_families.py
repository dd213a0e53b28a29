"""Families of equilibria, by identities of polynomials: along symmetries, within planes, and whole leaves."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_mpoly

from polhode._base.rational._matrices import matrix, null_space, reduce_rows, solve_near
from polhode._base.rational._polynomials import (
    coefficients_of,
    gradient,
    linear_form,
    shift,
    total,
    variables,
)
from polhode.analysis._exact_functions import ExactFunctions
from polhode.certificates._equations import quadratic_integrals
from polhode.types import Array, Float64


class FamilyLimits(NamedTuple):
    """Bounds of the search for functions that move along equilibria."""

    max_quadratic_coordinates: int = 6  # up to which all integrals of second degree are tried, as columns of a matrix
    max_multiples: int = 200  # of Casimirs' levels that may add up to a field
    direction_error: float = 1e-7  # of a direction in doubles: its distance from an exact space that contains it


LIMITS = FamilyLimits()


def moves_along_equilibria(exact: ExactFunctions, z: Sequence[fmpq], directions: Float64[Array, "d n"]) -> bool:
    """Whether each direction leads along equilibria on the leaf of an equilibrium z, by an identity of polynomials.

    Flows of conserved functions take equilibria to equilibria. So do all steps on the leaf if H is constant on it, and
    those that stay in a plane of equilibria that crosses the leaf.
    """
    if not len(directions):
        return True
    n, field = len(z), exact.field
    conserved = [p for name, p in exact.conserved.items() if name != "H"]
    flows = [[f(*z) for f in exact.flow(p)] for p in conserved]
    flows += [[f(*z) for f in exact.flow(p)] for p in linear_integrals(field)]
    if _contains(flows, directions):
        return True
    if n <= LIMITS.max_quadratic_coordinates:
        flows += [[f(*z) for f in exact.flow(p)] for p in quadratic_integrals(field).values()]
        if _contains(flows, directions):
            return True
    return _leaf_is_still(exact, z) or _contains(_plane_on_leaf(exact, z), directions)


def linear_integrals(field: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly]:
    """Return a basis of the linear functions that a field keeps."""
    return [linear_form(v) for v in null_space(coefficients_of(field)).tolist()]


def _contains(vectors: Sequence[Sequence[fmpq]], directions: Float64[Array, "d n"]) -> bool:
    """Whether directions, which are known in doubles, are combinations of vectors, which are exact."""
    vectors = [v for v in vectors if any(v)]
    if not vectors:
        return False
    rows = np.array([[float(x / max(map(abs, v))) for x in v] for v in reduce_rows(fmpq_mat(vectors))[0]])
    left = directions - np.linalg.lstsq(rows.T, directions.T, rcond=None)[0].T @ rows
    return bool(np.abs(left).max() <= LIMITS.direction_error * np.abs(directions).max())


def _plane_on_leaf(exact: ExactFunctions, z: Sequence[fmpq]) -> list[list[fmpq]]:
    """Return the directions within the leaf of the plane z + ker A, if all of that plane is at rest."""
    n = len(z)
    kernel = null_space(matrix([gradient(f, z) for f in exact.field], n))
    d = kernel.nrows()
    s = variables(d)
    x = [total(d, (kernel[a, k] * s[a] for a in range(d))) for k in range(n)]
    if not d or any(shift(f, z).compose(*x) for f in exact.field):
        return []
    slopes = matrix([gradient(p, z) for p in exact.casimirs.values()], n)
    inside = slopes * kernel.transpose()
    if inside.rank() < slopes.rank():
        return []  # the plane touches the leaf: where they meet need not be smooth
    return (null_space(inside) * kernel).tolist()


def _leaf_is_still(exact: ExactFunctions, z: Sequence[fmpq]) -> bool:
    """Whether the field vanishes on the leaf: each component is a sum of multiples of C − C(z), the Casimirs of z."""
    n = len(z)
    levels = [p - p(*z) for p in exact.casimirs.values()]
    if not levels or not exact.is_regular(z):
        return False
    highest = max(f.total_degree() for f in exact.field)
    spare = [(level, highest - level.total_degree()) for level in levels if level.total_degree() <= highest]
    if not 0 < sum(math.comb(n + degree, n) for _, degree in spare) <= LIMITS.max_multiples:
        return False
    x = variables(n)
    columns = [math.prod((x[k] for k in chosen), start=level) for level, most in spare for degree in range(most + 1)
               for chosen in itertools.combinations_with_replacement(range(n), degree)]
    return all(solve_near(coefficients_of([*columns, f]), [fmpq(0)] * len(columns)) is not None for f in exact.field)

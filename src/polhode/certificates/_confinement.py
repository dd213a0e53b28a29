"""Proofs of stability: a conserved function with a strict minimum, its second variation as a sum of squares."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_mpoly

from polhode._base.rational._matrices import (
    Squares,
    as_floats,
    combine,
    identity,
    matrix,
    null_space,
    signature,
    split_into_squares,
)
from polhode._base.rational._polynomials import (
    half_hessian,
    linear_form,
    magnitude,
    part,
    rate,
    shift,
    total,
    variables,
)
from polhode._base.rational.numbers import as_fmpq
from polhode.certificates._definite import definite_combination
from polhode.certificates._definite_exact import definite_in_pencil, is_definite
from polhode.certificates._equations import ENERGY, Equations
from polhode.certificates._equations import LIMITS as RATIONAL_LIMITS
from polhode.types import Array

GROWTHS = range(-2, 24)  # powers of two by which squares of conserved quantities are tried


class ConfinementLimits(NamedTuple):
    """Bounds of the search for squares that make a function definite."""

    # power of two, tried by exact signs where doubles decide nothing: curvatures an ulp apart need some 100
    max_exact_growth: int = 240


LIMITS = ConfinementLimits()


@dataclass(frozen=True)
class Confinement:
    """G = Σ w C + Σ s (C − C⁰)² with G(z + v) − G(z) ≥ margin |v|² − … near z: solutions near z stay near it.

    Attributes:
        weights: w by the names of what is conserved.
        squares: s ≥ 0 by the same names.
        margin: m of ½ D²G = m + Σ d ℓℓᵀ.
        forms: pairs of d ≥ 0 and ℓ (n,).
        radius: up to which |v| terms of higher degree are smaller than the margin, at most 1.
        slice: s ≥ 0 of the square of the direction in which a symmetry moves the point; zero without one.
    """

    weights: Mapping[str, fmpq]
    squares: Mapping[str, fmpq]
    margin: fmpq
    forms: Squares
    radius: fmpq
    slice: fmpq = fmpq(0)

    verdict = "stable"

    def function(self, equations: Equations) -> fmpq_mpoly:
        """Return G."""
        c, levels = equations.conserved, equations.levels
        parts = [w * c[name] for name, w in self.weights.items()]
        parts += [s * (c[name] - levels[name]) ** 2 for name, s in self.squares.items()]
        return total(equations.size, parts)

    def raised(self, equations: Equations) -> fmpq_mpoly:
        """Return G(z + v) − G(z), with the square across a symmetry's orbit."""
        g = self.function(equations)
        moved = shift(g, equations.point) - g(*equations.point)
        if equations.flow:
            moved = moved + self.slice * linear_form(equations.along) ** 2
        return moved

    def rest(self, equations: Equations) -> fmpq_mpoly:
        """Return what is left of G(z + v) − G(z) without the margin and the squares; of third degree where it holds."""
        return self.raised(equations) - self.margin * norm(equations.size) - sum_of_squares(equations.size, self.forms)

    def find_faults(self, equations: Equations) -> list[str]:
        """Return what is wrong with the proof of these equations."""
        faults, raised, rest = [], self.raised(equations), self.rest(equations)
        if rate(self.function(equations), equations.field):
            faults.append("G is not conserved")
        if equations.flow and rate(self.function(equations), equations.flow):
            faults.append(f"the flow of {equations.flow_name} does not keep G")
        if part(raised, 0, 1):
            faults.append("G is not stationary at the point")
        if part(rest, 0, 2):
            faults.append("the second variation is not the sum of squares")
        if any(d < 0 for d, _ in self.forms):
            faults.append("a square has a negative factor")
        if not 0 < self.radius <= 1 or self.margin - magnitude(rest) * self.radius <= 0:
            faults.append("the margin does not cover the terms of higher degree")
        return faults

    def as_json(self) -> dict[str, Any]:
        """Return plain data, numbers as text."""
        return {
            "weights": {k: str(w) for k, w in self.weights.items()},
            "squares": {k: str(w) for k, w in self.squares.items()},
            "margin": str(self.margin), "forms": show_squares(self.forms), "radius": str(self.radius),
            **({"slice": str(self.slice)} if self.slice else {}),
        }  # fmt: skip


def norm(size: int) -> fmpq_mpoly:
    """Return |v|²."""
    return total(size, (x * x for x in variables(size)))


def sum_of_squares(size: int, forms: Squares) -> fmpq_mpoly:
    """Return Σ d (ℓ·v)²."""
    return total(size, (d * linear_form(row) ** 2 for d, row in forms))


def show_squares(forms: Squares) -> list[list[Any]]:
    """Return squares as plain data."""
    return [[str(d), [str(x) for x in row]] for d, row in forms]


def find_confinement(equations: Equations, hint: Mapping[str, float]) -> Confinement | None:
    """Return a proof that motions near the point stay near it, up to the flow if there is one; else None.

    Args:
        equations: exact.
        hint: weights of what is conserved from a numerical method, by name.
    """
    names = [*(k for k in equations.conserved if k != ENERGY), *(k for k in equations.conserved if k == ENERGY)]
    n, slopes = equations.size, [equations.slopes[k] for k in names]
    basis = null_space(matrix(slopes, n).transpose())
    halves = [half_hessian(equations.conserved[k], equations.point) for k in names]
    across = null_space(matrix([*slopes, *([equations.along] if equations.flow else [])], n))
    tried = set()
    for weights in _candidates(basis, names, hint, halves, across):
        if (key := tuple(weights)) not in tried:
            tried.add(key)
            if proof := _try_weights(equations, dict(zip(names, weights, strict=True)), halves, across):
                return proof
    return None


def restrict(form: fmpq_mat, vectors: fmpq_mat) -> fmpq_mat:
    """Return the matrix of a quadratic form on the span of vectors (d, n)."""
    return vectors * form * vectors.transpose()


def _candidates(
    basis: fmpq_mat, names: list[str], hint: Mapping[str, float], halves: list[fmpq_mat], across: fmpq_mat
) -> Iterator[list[fmpq]]:
    """Yield rational weights with a stationary sum: the hinted ones, rounded to ever more digits, then others."""
    if not basis:
        return

    def mix(*parts: fmpq) -> list[fmpq]:
        return (fmpq_mat([parts]) * basis).entries()

    vectors = basis.tolist()
    inner = [restrict(combine(v, halves), across) for v in vectors] if across else []
    if across and len(vectors) == 1:
        if is_definite(inner[0]):
            yield mix(fmpq(1))
        return
    free = [max(k for k, x in enumerate(vector) if x) for vector in vectors]
    wanted = [np.array([hint.get(name, 0.0) for name in names])] if hint else []
    if across:
        # entries an ulp apart keep their difference: the matrices are exact until here
        matrices = [as_floats(m) for m in inner]
        sizes = [np.abs(m).max() or 1.0 for m in matrices]
        combination = definite_combination(np.array([m / s for m, s in zip(matrices, sizes, strict=True)]), 1e-12)
        if combination is not None:
            other = np.array(combination) / sizes @ as_floats(basis)
            largest = abs(other[-1]) if names[-1] == ENERGY and abs(other[-1]) > 1e-9 else np.abs(other).max()
            wanted.append(other / largest)
    else:
        wanted.append(np.zeros(len(names)))
    for target in wanted:
        for d in RATIONAL_LIMITS.denominators:
            yield mix(*(as_fmpq(Fraction(float(target[k])).limit_denominator(d)) for k in free))
    if len(inner) == 2 and (pair := definite_in_pencil(*inner)):
        yield mix(*pair)


def _try_weights(
    equations: Equations, weights: dict[str, fmpq], halves: list[fmpq_mat], across: fmpq_mat
) -> Confinement | None:
    half = combine(weights.values(), halves)
    inner = restrict(half, across)
    if not is_definite(inner):
        return None
    sign = -1 if signature(inner)[2] else 1
    weights = {name: sign * w for name, w in weights.items() if w}
    half = sign * half
    rows = {name: g for name, g in equations.slopes.items() if any(g) and name != ENERGY}
    degrees = {name: int(equations.conserved[name].total_degree()) for name in rows}
    squares, low = _grow_squares(as_floats(half), rows, equations.along)
    if low > _unsure(half):
        squares, low = _drop_squares(as_floats(half), {**rows, "": equations.along}, squares, degrees)
    else:
        rows = {name: g for name, g in equations.slopes.items() if any(g)}
        squares = _grow_exactly(half, rows, equations.along)
    whole = _with_squares(half, {**rows, "": equations.along}, squares)
    split = _split_with_margin(whole, low)
    if split is None:
        return None
    margin, kept = split
    slice_ = squares.pop("", fmpq(0))
    unbounded = Confinement(weights, squares, margin, kept, fmpq(1), slice_)
    return Confinement(weights, squares, margin, kept, radius_for(margin, unbounded.rest(equations)), slice_)


def _unsure(half: fmpq_mat) -> float:
    """Return the size of an eigenvalue that rounding may make of zero."""
    return half.nrows() * 1e-12 * float(max(map(abs, half.entries())))


def _with_squares(half: fmpq_mat, rows: Mapping[str, Sequence[fmpq]], squares: Mapping[str, fmpq]) -> fmpq_mat:
    for name, s in squares.items():
        row = fmpq_mat([rows[name]])
        half = half + s * (row.transpose() * row)
    return half


def _grow_exactly(
    half: fmpq_mat, rows: Mapping[str, Sequence[fmpq]], along: Sequence[fmpq]
) -> dict[str, fmpq]:
    """Return the first multiples of the squares of gradients that make a matrix definite by its exact signature."""
    named = {**rows, **({"": along} if any(along) else {})}
    size = float(max(map(abs, half.entries()))) or 1.0
    for k in range(min(GROWTHS), LIMITS.max_exact_growth):
        squares = {name: power_of_two(size / float(sum(x * x for x in g))) * fmpq(2) ** k
                   for name, g in named.items()}
        if signature(_with_squares(half, named, squares))[0] == half.nrows():
            return squares
    return {}


def _split_with_margin(whole: fmpq_mat, low: float) -> tuple[fmpq, Squares] | None:
    """Return a margin and the squares that are left of a positive definite matrix; None of any other."""
    n = whole.nrows()
    if signature(whole)[0] < n:
        return None
    margin = power_of_two(low / 2) if low > 0 else power_of_two(float(min(whole[k, k] for k in range(n))))
    while (forms := split_into_squares(whole - margin * identity(n))) is None:
        margin /= 4
    return margin, forms


def _grow_squares(
    half: Array, rows: Mapping[str, Sequence[fmpq]], along: Sequence[fmpq]
) -> tuple[dict[str, fmpq], float]:
    """Return multiples of the squares of gradients that make a matrix definite, and its least eigenvalue then.

    The square of the direction of a symmetry has no name.
    """
    low = _least(half, rows, {})
    if low > 0:
        return {}, low
    size = float(np.abs(half).max()) or 1.0
    named = {**rows, **({"": along} if any(along) else {})}
    best: tuple[dict[str, fmpq], float] = ({}, low)
    for k in GROWTHS:
        squares = {name: power_of_two(size * 2.0**k / float(sum(x * x for x in g))) for name, g in named.items()}
        low = _least(half, named, squares)
        if best[1] > 0 and low < 1.5 * best[1]:
            break
        if low > best[1]:
            best = squares, low
        if low > size / 4:
            break
    return best


def _drop_squares(
    half: Array, rows: Mapping[str, Sequence[fmpq]], squares: dict[str, fmpq], degrees: Mapping[str, int]
) -> tuple[dict[str, fmpq], float]:
    """Return squares without those that are hardly needed, functions of high degree first."""
    low = _least(half, rows, squares)
    enough = low / 4
    for name in sorted((k for k in reversed(squares) if k), key=lambda k: -degrees[k]):
        fewer = {k: s for k, s in squares.items() if k != name}
        if (left := _least(half, rows, fewer)) > enough:
            squares, low = fewer, left
    return squares, low


def _least(half: Array, rows: Mapping[str, Sequence[fmpq]], squares: Mapping[str, fmpq]) -> float:
    """Return the least eigenvalue of a matrix with squares of gradients added."""
    vectors = ((float(s), np.array([float(x) for x in rows[name]])) for name, s in squares.items())
    return float(np.linalg.eigvalsh(half + sum((s * np.outer(v, v) for s, v in vectors), np.zeros_like(half)))[0])


def power_of_two(value: float) -> fmpq:
    """Return the largest power of two that is not above a positive number."""
    return fmpq(2) ** math.floor(math.log2(value))


def radius_for(margin: fmpq, rest: fmpq_mpoly) -> fmpq:
    """Return a radius, at most one, within which half of the margin covers terms of third degree and more."""
    return min(fmpq(1), power_of_two(float(margin / (2 * magnitude(rest))))) if rest else fmpq(1)

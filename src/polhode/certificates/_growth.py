"""Proofs of instability: a quadratic function that grows where it is positive, by the linear part or by a drift."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any, NamedTuple

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_mpoly

from polhode._base.rational._matrices import (
    Squares,
    as_floats,
    count_roots_beyond,
    identity,
    matrix,
    null_space,
    solve_near,
    split_into_squares,
)
from polhode._base.rational._polynomials import (
    coefficients_of,
    half_hessian,
    linear_form,
    magnitude,
    part,
    quadratic_form,
    rate,
    shift,
    total,
    variables,
)
from polhode._base.rational.numbers import as_fmpq
from polhode.certificates._confinement import norm, power_of_two, radius_for, show_squares, sum_of_squares
from polhode.certificates._equations import Equations, as_terms


class GrowthLimits(NamedTuple):
    """What decides that an exponent has a positive real part."""

    min_real_part: float = 1e-9  # of the largest entry: more than what doubles make of zero


LIMITS = GrowthLimits()


@dataclass(frozen=True)
class Growth:
    """V(v) = vᵀPv with V̇ ≥ 2γV near the point, and V > 0 on a ray: solutions that start on the ray leave.

    Attributes:
        rate: γ > 0 [1/s].
        form: P (n, n), symmetric.
        margin, forms: of AᵀP + PA − 2γP = margin + Σ d ℓℓᵀ, A the linear part.
        direction: (n,) of the ray.
        radius: as for a confinement.
        polynomial: coefficients of the characteristic polynomial of A, highest power first.
        beyond: how many of its roots have a real part greater than the rate, by Routh's theorem.
    """

    rate: fmpq
    form: tuple[tuple[fmpq, ...], ...]
    margin: fmpq
    forms: Squares
    direction: tuple[fmpq, ...]
    radius: fmpq
    polynomial: tuple[fmpq, ...]
    beyond: int

    verdict = "unstable"

    def excess(self, equations: Equations) -> fmpq_mpoly:
        """Return what is left of V̇ − 2γV without the margin and the squares; of third degree where it holds."""
        V, n = quadratic_form(self.form), equations.size
        return (rate(V, equations.around) - 2 * self.rate * V - self.margin * norm(n)
                - sum_of_squares(n, self.forms))

    def find_faults(self, equations: Equations) -> list[str]:
        """Return what is wrong with the proof of these equations."""
        faults, excess = [], self.excess(equations)
        if self.rate <= 0:
            faults.append("the rate is not positive")
        if part(excess, 0, 2):
            faults.append("V̇ − 2γV is not the sum of squares")
        if any(d < 0 for d, _ in self.forms):
            faults.append("a square has a negative factor")
        if not 0 < self.radius <= 1 or self.margin < magnitude(excess) * self.radius:
            faults.append("the margin does not cover the terms of higher degree")
        if quadratic_form(self.form)(*self.direction) <= 0:
            faults.append("V is not positive along the direction")
        polynomial = equations.linearization.charpoly()
        if tuple(polynomial.coeffs()[::-1]) != self.polynomial:
            faults.append("the characteristic polynomial is another")
        elif count_roots_beyond(polynomial, self.rate) != self.beyond or self.beyond < 1:
            faults.append("no eigenvalue has a real part beyond the rate")
        return faults

    def as_json(self) -> dict[str, Any]:
        """Return plain data, numbers as text."""
        return {
            "rate": str(self.rate), "form": [[str(x) for x in row] for row in self.form], "margin": str(self.margin),
            "forms": show_squares(self.forms), "direction": [str(x) for x in self.direction],
            "radius": str(self.radius), "characteristic_polynomial": [str(x) for x in self.polynomial],
            "eigenvalues_beyond_the_rate": self.beyond,
        }  # fmt: skip


@dataclass(frozen=True)
class Drift:
    """V(v) = vᵀPv with V̇ = K q, K(v) conserved and positive on a ray, q positive near the point [Chetaev].

    Attributes:
        form: P (n, n), symmetric.
        conserved: K, homogeneous of second degree in v.
        factor: q, positive at v = 0.
        direction: (n,) of the ray.
        radius: up to which |v| q is positive, at most 1.
    """

    form: tuple[tuple[fmpq, ...], ...]
    conserved: fmpq_mpoly
    factor: fmpq_mpoly
    direction: tuple[fmpq, ...]
    radius: fmpq

    verdict = "unstable"

    def find_faults(self, equations: Equations) -> list[str]:
        """Return what is wrong with the proof of these equations."""
        V, K, q, faults = quadratic_form(self.form), self.conserved, self.factor, []
        if rate(K, equations.around) or K != part(K, 2, 2):
            faults.append("K is not conserved, or not quadratic")
        if rate(V, equations.around) != K * q:
            faults.append("V̇ is not K q")
        start, rest = part(q, 0, 0), part(q, 1)
        if not 0 < self.radius <= 1 or start(*self.direction) <= magnitude(rest) * self.radius:
            faults.append("q is not positive near the point")
        if K(*self.direction) <= 0:
            faults.append("K is not positive along the direction")
        return faults

    def as_json(self) -> dict[str, Any]:
        """Return plain data, numbers as text."""
        return {
            "form": [[str(x) for x in row] for row in self.form], "conserved": as_terms(self.conserved),
            "factor": as_terms(self.factor), "direction": [str(x) for x in self.direction], "radius": str(self.radius),
        }  # fmt: skip


def find_growth(equations: Equations) -> Growth | None:
    """Return a proof by the linear part; None if it has no sure growth.

    For a γ below the largest real part the equation AᵀP + PA − 2γP = 1 has a P that is not negative semidefinite
    [Lyapunov]; rounded, it still makes the left side definite.
    """
    from scipy.linalg import matrix_balance

    A = equations.linearization
    numbers, n = as_floats(A), equations.size
    if float(np.linalg.eigvals(numbers).real.max()) <= LIMITS.min_real_part * float(np.abs(numbers).max(initial=0.0)):
        return None
    _, (scale, _) = matrix_balance(numbers, permute=False, separate=True)  # powers of two
    for units in (np.ones(n), scale) if (scale != 1.0).any() else (scale,):
        if proof := _grow_in_units(equations, [as_fmpq(float(x)) for x in units]):
            return proof
    return None


def _grow_in_units(equations: Equations, units: list[fmpq]) -> Growth | None:
    """Search for a proof in coordinates v/units: curvatures an ulp apart leave entries 1e15 apart in others."""
    shares = (0.5, 0.375, 0.625, 0.25, 0.75, 0.4375, 0.125, 0.875)  # of the fastest growth, tried one after the other
    from scipy.linalg import solve_continuous_lyapunov

    n = equations.size
    own, other = _diagonal(units), _diagonal([1 / x for x in units])
    A = other * equations.linearization * own
    numbers = as_floats(A)
    fastest = float(np.linalg.eigvals(numbers).real.max())
    polynomial = A.charpoly()
    for share in shares:
        speed = as_fmpq(Fraction(share * fastest).limit_denominator(max(8, int(64 / fastest))))
        beyond = count_roots_beyond(polynomial, speed) if speed > 0 else None
        if not beyond:
            continue
        shifted = numbers - float(speed) * np.eye(n)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of exponents that nearly add up to zero: the solution is checked below
            P = solve_continuous_lyapunov(shifted.T, np.eye(n))
        if not np.isfinite(P).all():
            continue
        _, vectors = np.linalg.eigh(0.5 * (P + P.T))
        for scaled, low in _rounded(P, A, speed):
            form = other * scaled * other
            margin = power_of_two(low / 2) / max(x * x for x in units)
            squares = split_into_squares(_rate_matrix(equations.linearization, form, speed) - margin * identity(n))
            rows = tuple(map(tuple, form.tolist()))
            direction = tuple(x * y for x, y in zip(_short_direction(vectors[:, -1]), units, strict=True))
            if squares is None or quadratic_form(rows)(*direction) <= 0:
                continue
            coefficients = tuple(polynomial.coeffs()[::-1])
            trial = Growth(speed, rows, margin, squares, direction, fmpq(1), coefficients, beyond)
            return replace(trial, radius=radius_for(margin, trial.excess(equations)))
    return None


def _diagonal(entries: Sequence[fmpq]) -> fmpq_mat:
    n = len(entries)
    return fmpq_mat(n, n, [x if i == j else 0 for i, x in enumerate(entries) for j in range(n)])


def _rate_matrix(A: fmpq_mat, P: fmpq_mat, speed: fmpq) -> fmpq_mat:
    product = P * A
    return product + product.transpose() - 2 * speed * P


def _rounded(P: Any, A: fmpq_mat, speed: fmpq) -> Iterator[tuple[fmpq_mat, float]]:
    """Yield P rounded to ever more digits where AᵀP + PA − 2γP is still definite, with its least eigenvalue."""
    digits = (4, 8, 12, 16, 24, 32, 40)  # binary ones, to which the function is rounded, relative to its largest entry
    unit = power_of_two(float(np.abs(P).max()))
    for places in digits:
        step = unit / 2**places
        n, unit_steps = len(P), P / float(step)
        form = step * fmpq_mat(n, n, [round(unit_steps[min(i, j), max(i, j)]) for i in range(n) for j in range(n)])
        low = float(np.linalg.eigvalsh(as_floats(_rate_matrix(A, form, speed)))[0])
        if low > 0.25:
            yield form, low


def _short_direction(vector: Any) -> tuple[fmpq, ...]:
    """Return an eigenvector in short fractions; of its two signs, which the libraries choose, one and the same."""
    scaled = vector / np.abs(vector).max()
    scaled = scaled * np.sign(scaled[np.argmax(np.abs(scaled) > 0.1)])
    return tuple(fmpq(round(float(x) * 64), 64) for x in scaled)


def find_drift(equations: Equations) -> Drift | None:
    """Return a proof by a steady drift; None if there is none of this form.

    K is a sum of conserved functions that is stationary at the point and of second degree; V and the linear part of
    q = ±1 + … solve V̇ = K q, which is linear in both.
    """
    n = equations.size
    names = list(equations.conserved)
    basis = null_space(matrix([equations.slopes[k] for k in names], n).transpose())
    for vector in basis.tolist():
        K = total(n, (w * equations.conserved[k] for w, k in zip(vector, names, strict=True)))
        K = part(shift(K, equations.point), 1)
        if not K or K != part(K, 2, 2):
            continue
        for sign in (1, -1):
            if drift := _drift_along(equations, sign * K):
                return drift
    return None


def _drift_along(equations: Equations, K: fmpq_mpoly) -> Drift | None:
    n, zeros = equations.size, [fmpq(0)] * equations.size
    direction = _positive_direction(half_hessian(K, zeros))
    if direction is None:
        return None
    x = variables(n)
    pairs = list(combinations_with_replacement(range(n), 2))
    columns = [rate(x[i] * x[j], equations.around) for i, j in pairs] + [-K * y for y in x]
    solution = solve_near(coefficients_of([*columns, K]), [fmpq(0)] * len(columns))
    if solution is None:
        return None
    V = total(n, (c * x[i] * x[j] for c, (i, j) in zip(solution, pairs, strict=False)))
    slope = linear_form(solution[len(pairs) :])
    return Drift(tuple(map(tuple, half_hessian(V, zeros).tolist())), K, slope + 1, direction,
                 radius_for(fmpq(1), slope))


def _positive_direction(form: fmpq_mat) -> tuple[fmpq, ...] | None:
    sizes, vectors = np.linalg.eigh(as_floats(form))
    direction = _short_direction(vectors[:, -1])
    return direction if sizes[-1] > 0 and quadratic_form(form.tolist())(*direction) > 0 else None

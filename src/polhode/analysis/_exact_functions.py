"""What a Lie–Poisson system conserves as polynomials over the rationals, where all of it is polynomial.

Doubles are taken as the binary fractions that they are. Whether a function is conserved, and whether the field vanishes
everywhere, are then identities between coefficients, which hold or do not: no rounding is between.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from polhode._base.rational._matrices import null_space, rank, signature
from polhode._base.rational._polynomials import RationalPolynomial
from polhode.algebra.casimirs import rational_brackets
from polhode.analysis._conserved import LIMITS as CONSERVATION_LIMITS
from polhode.analysis._conserved import (
    Casimirs,
    Derivatives,
    Energy,
    Given,
    Known,
    Source,
    choose_unit,
)
from polhode.certificates._equations import poisson_field
from polhode.certificates._exact_tracing import trace_polynomials
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.taylor.expressions import Untraceable
from polhode.types import Array, Float64

Brackets = list[list[dict[int, Fraction]]]
Named = dict[str, RationalPolynomial]


class ExactFunctionLimits(NamedTuple):
    """Sizes beyond which doubles decide, as exact algebra would take seconds."""

    max_coordinates: int = 12  # beyond it rows of fractions take seconds where doubles take milliseconds
    max_products: int = 30_000  # of terms, in one function: a fifth of a second, (x1 + x2 + x3)**33


LIMITS = ExactFunctionLimits()


class ExactFunctions(NamedTuple):
    """Polynomials of a system; all by the names that they have in a verdict.

    Attributes:
        brackets: [e_i, e_j] as {k: c_ijk}.
        sign: of the system's bracket.
        energy: H.
        casimirs: named by the algebra, from exact algebra, or given.
        known: what the system names conserved, whether it is or not.
        given: integrals of the user.
        field: (n,) that of H.
    """

    brackets: Brackets
    sign: int
    energy: RationalPolynomial
    casimirs: Named
    known: Named
    given: Named
    field: tuple[RationalPolynomial, ...]

    @property
    def still(self) -> bool:
        """Whether the field vanishes everywhere."""
        return not any(self.field)

    @property
    def conserved(self) -> Named:
        """All that the field keeps, the energy last."""
        named = {**self.casimirs, **self.known, **self.given}
        return {**{name: p for name, p in named.items() if not p.rate(self.field)}, "H": self.energy}

    def flow(self, function: RationalPolynomial) -> tuple[RationalPolynomial, ...]:
        """Return the Hamiltonian field (n,) of a function."""
        return poisson_field(self.brackets, self.sign, function)

    def commute(self, one: RationalPolynomial, other: RationalPolynomial) -> bool:
        """Whether the bracket of two functions vanishes."""
        return not one.rate(self.flow(other))

    def tensor(self, point: Sequence[Fraction]) -> list[list[Fraction]]:
        """Return π (n, n) at a point, as the field of x_j is its j-th column."""
        n = len(point)
        return [[sum((self.sign * c * point[k] for k, c in self.brackets[i][j].items()), Fraction(0))
                 for j in range(n)] for i in range(n)]

    @property
    def is_compact(self) -> bool:
        """Whether the Killing form is negative on a complement of the centre, by exact signs."""
        n, c = len(self.brackets), self.brackets
        killing = [[sum((x * c[j][m].get(k, Fraction(0)) for k in range(n) for m, x in c[i][k].items()), Fraction(0))
                    for j in range(n)] for i in range(n)]
        positive, zero, _ = signature(killing)
        moves = [[c[i][j].get(k, Fraction(0)) for i in range(n)] for j in range(n) for k in range(n)]
        return not positive and zero == len(null_space(moves, n))

    def is_regular(self, point: Sequence[Fraction]) -> bool:
        """Whether the leaf of a point is as large as those around."""
        n = len(point)
        rng = np.random.default_rng(0)
        around = [[Fraction(int(x)) for x in rng.integers(-999, 999, n)] for _ in range(2)]
        return rank(self.tensor(point)) == max(rank(self.tensor(x)) for x in around)


def exact_functions(
    system: AbstractLiePoissonSystem, casimirs: Casimirs, integrals: tuple[object, ...], z: Float64[Array, "n"]
) -> ExactFunctions | None:
    """Return the polynomials of a system; None where one of its functions is none, or the algebra's constants are not.

    Args:
        system: that moves by its energy.
        casimirs: chosen ones.
        integrals: of the user.
        z: (n,) the point; None too where doubles around it may overflow.
    """
    n = z.size
    if n > LIMITS.max_coordinates or choose_unit(z) != 1.0:
        return None
    try:
        brackets = rational_brackets(system.algebra)
        (energy,) = _trace(Energy(system), n)
        own = _trace(casimirs.source, n) if casimirs.names else []
        known = _trace(Known(system), n) if Known(system).names else []
        given = _trace(Given(system.algebra, integrals), n) if integrals else []  # type: ignore[arg-type]
    except (Untraceable, InvalidInput):
        return None
    return ExactFunctions(
        brackets, system.sign, energy, dict(zip(casimirs.names, own, strict=True)),
        dict(zip(Known(system).names, known, strict=True)), {f"J{k + 1}": p for k, p in enumerate(given)},
        poisson_field(brackets, system.sign, energy),
    )


def _trace(source: Source, n: int) -> list[RationalPolynomial]:
    return trace_polynomials(source, n, Fraction, LIMITS.max_products)


# ---------------------------------------------------------------------- derivatives and checks


def polynomial_derivatives(
    polynomials: Sequence[RationalPolynomial], z: Float64[Array, "n"], around: Float64[Array, "m n"]
) -> Derivatives:
    """Return what ``derivatives`` does: at z from exact ones, rounded at the end; at samples in doubles."""
    point, n, k = [Fraction(float(x)) for x in z], z.size, len(polynomials)
    moved = [p.shift(point, 2) for p in polynomials]
    slopes = np.array([[as_double(x) for x in p.slope()] for p in moved]).reshape(k, n)
    halves = np.array([[[as_double(x) for x in row] for row in p.quadratic()] for p in moved]).reshape(k, n, n)
    gradients = np.array([[_evaluate(p.derivative(i), around) for i in range(n)] for p in polynomials])
    # exact as the entries are, what is made of them in doubles is not: the same thresholds hold
    return Derivatives(slopes, 2.0 * halves, gradients.reshape(k, n, len(around)).transpose(2, 0, 1),
                       np.full(k, CONSERVATION_LIMITS.derivative_error), np.zeros(k))


def as_double(x: Fraction) -> float:
    """Return the nearest double, an infinity beyond the largest."""
    try:
        return float(x)
    except OverflowError:
        return math.inf if x > 0 else -math.inf


def _evaluate(p: RationalPolynomial, points: Float64[Array, "m n"]) -> Float64[Array, "m"]:
    if not p:
        return np.zeros(len(points))
    exponents = np.array(list(p.terms))
    with np.errstate(over="ignore", invalid="ignore"):
        return np.prod(points[:, None, :] ** exponents, axis=2) @ np.array([as_double(c) for c in p.terms.values()])


def refuse_inexact(exact: ExactFunctions, casimirs_given: bool) -> None:
    """Refuse functions of the user that are conserved up to rounding alone: nothing follows from these.

    Raises:
        InvalidInput: with the size of what is left.
    """
    remedy = "Give equal numbers where they are meant to be equal; a function that is nearly conserved proves nothing."
    for name, p in exact.given.items():
        if left := p.rate(exact.field):
            raise InvalidInput(f"{{{name}, H}} must vanish; in exact arithmetic it does not, and the largest "
                               f"coefficient of what is left is {_largest(left):.3g}. {remedy}")
    for k, p in enumerate(exact.casimirs.values()) if casimirs_given else ():
        if left := [f for f in exact.flow(p) if f]:
            raise InvalidInput(f"casimirs[{k}] must commute with every coordinate; in exact arithmetic it does not, "
                               f"and the largest coefficient of what is left is {_largest(left[0]):.3g}. "
                               f"{remedy}")


def _largest(p: RationalPolynomial) -> float:
    return float(max(map(abs, p.terms.values())))

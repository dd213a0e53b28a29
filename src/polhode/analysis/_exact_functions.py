"""What a Lie–Poisson system conserves as polynomials over the rationals, where all of it is polynomial.

Doubles are taken as the binary fractions that they are. Whether a function is conserved, and whether the field vanishes
everywhere, are then identities between coefficients, which hold or do not: no rounding is between.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from flint import fmpq, fmpq_mat, fmpq_mpoly

from polhode._base.rational._matrices import as_floats, matrix, null_space, signature
from polhode._base.rational._polynomials import Tensor, gradient, half_hessian, poisson_field, poisson_tensor, rate
from polhode._base.rational.numbers import as_fmpq, nearest_double
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
from polhode.certificates._exact_tracing import trace_polynomials
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.taylor.expressions import Untraceable
from polhode.types import Array, Float64

Named = dict[str, fmpq_mpoly]


class ExactFunctionLimits(NamedTuple):
    """Sizes beyond which doubles decide, as exact algebra would take seconds."""

    max_coordinates: int = 12  # beyond it rows of fractions take seconds where doubles take milliseconds
    max_products: int = 30_000  # of terms, in one function: a fifth of a second, (x1 + x2 + x3)**33


LIMITS = ExactFunctionLimits()


class ExactFunctions(NamedTuple):
    """Polynomials of a system; all by the names that they have in a verdict.

    Attributes:
        tensor: π (n, n), {x_i, x_j} with the system's sign.
        energy: H.
        casimirs: named by the algebra, from exact algebra, or given.
        known: what the system names conserved, whether it is or not.
        given: integrals of the user.
        field: (n,) that of H.
    """

    tensor: Tensor
    energy: fmpq_mpoly
    casimirs: Named
    known: Named
    given: Named
    field: tuple[fmpq_mpoly, ...]

    @property
    def still(self) -> bool:
        """Whether the field vanishes everywhere."""
        return not any(self.field)

    @property
    def conserved(self) -> Named:
        """All that the field keeps, the energy last."""
        named = {**self.casimirs, **self.known, **self.given}
        return {**{name: p for name, p in named.items() if not rate(p, self.field)}, "H": self.energy}

    def flow(self, function: fmpq_mpoly) -> tuple[fmpq_mpoly, ...]:
        """Return the Hamiltonian field (n,) of a function."""
        return poisson_field(self.tensor, function)

    def commute(self, one: fmpq_mpoly, other: fmpq_mpoly) -> bool:
        """Whether the bracket of two functions vanishes."""
        return not rate(one, self.flow(other))

    def tensor_at(self, point: Sequence[fmpq]) -> fmpq_mat:
        """Return π (n, n) at a point, as the field of x_j is its j-th column."""
        return matrix([[f(*point) for f in row] for row in self.tensor], len(point))

    @property
    def is_compact(self) -> bool:
        """Whether the Killing form is negative on a complement of the centre, by exact signs."""
        n = len(self.tensor)
        moves = [matrix([gradient(f, [fmpq(0)] * n) for f in row], n) for row in self.tensor]  # ad of x_i, up to a sign
        traces = [sum((a * b)[k, k] for k in range(n)) for a in moves for b in moves]
        positive, zero, _ = signature(fmpq_mat(n, n, traces))
        centre = null_space(fmpq_mat([a.entries() for a in moves]).transpose())
        return not positive and zero == centre.nrows()

    def is_regular(self, point: Sequence[fmpq]) -> bool:
        """Whether the leaf of a point is as large as those around."""
        n = len(point)
        rng = np.random.default_rng(0)
        around = [[fmpq(int(x)) for x in rng.integers(-999, 999, n)] for _ in range(2)]
        return self.tensor_at(point).rank() == max(self.tensor_at(x).rank() for x in around)


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
        tensor = poisson_tensor(rational_brackets(system.algebra), system.sign)
        (energy,) = _trace(Energy(system), n)
        own = _trace(casimirs.source, n) if casimirs.names else []
        known = _trace(Known(system), n) if Known(system).names else []
        given = _trace(Given(system.algebra, integrals), n) if integrals else []  # type: ignore[arg-type]
    except (Untraceable, InvalidInput):
        return None
    return ExactFunctions(
        tensor, energy, dict(zip(casimirs.names, own, strict=True)),
        dict(zip(Known(system).names, known, strict=True)), {f"J{k + 1}": p for k, p in enumerate(given)},
        poisson_field(tensor, energy),
    )


def _trace(source: Source, n: int) -> list[fmpq_mpoly]:
    return trace_polynomials(source, n, Fraction, LIMITS.max_products)


# ---------------------------------------------------------------------- derivatives and checks


def polynomial_derivatives(
    polynomials: Sequence[fmpq_mpoly], z: Float64[Array, "n"], around: Float64[Array, "m n"]
) -> Derivatives:
    """Return what ``derivatives`` does: at z from exact ones, rounded at the end; at samples in doubles."""
    point, n, k = [as_fmpq(float(x)) for x in z], z.size, len(polynomials)
    slopes = as_floats(matrix([gradient(p, point) for p in polynomials], n))
    halves = np.array([as_floats(half_hessian(p, point)) for p in polynomials]).reshape(k, n, n)
    gradients = np.array([[_evaluate(p.derivative(i), around) for i in range(n)] for p in polynomials])
    # exact as the entries are, what is made of them in doubles is not: the same thresholds hold
    return Derivatives(slopes, 2.0 * halves, gradients.reshape(k, n, len(around)).transpose(2, 0, 1),
                       np.full(k, CONSERVATION_LIMITS.derivative_error), np.zeros(k))


def _evaluate(p: fmpq_mpoly, points: Float64[Array, "m n"]) -> Float64[Array, "m"]:
    exponents = np.array(p.monoms(), int).reshape(-1, points.shape[1])
    with np.errstate(over="ignore", invalid="ignore"):
        return np.prod(points[:, None, :] ** exponents, axis=2) @ np.array([nearest_double(c) for c in p.coeffs()])


def refuse_inexact(exact: ExactFunctions, casimirs_given: bool) -> None:
    """Refuse functions of the user that are conserved up to rounding alone: nothing follows from these.

    Raises:
        InvalidInput: with the size of what is left.
    """
    remedy = "Give equal numbers where they are meant to be equal; a function that is nearly conserved proves nothing."
    for name, p in exact.given.items():
        if left := rate(p, exact.field):
            raise InvalidInput(f"{{{name}, H}} must vanish; in exact arithmetic it does not, and the largest "
                               f"coefficient of what is left is {_largest(left):.3g}. {remedy}")
    for k, p in enumerate(exact.casimirs.values()) if casimirs_given else ():
        if left := [f for f in exact.flow(p) if f]:
            raise InvalidInput(f"casimirs[{k}] must commute with every coordinate; in exact arithmetic it does not, "
                               f"and the largest coefficient of what is left is {_largest(left[0]):.3g}. "
                               f"{remedy}")


def _largest(p: fmpq_mpoly) -> float:
    return float(max(map(abs, p.coeffs())))

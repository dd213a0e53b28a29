"""An equilibrium of polynomial equations, exact: field, conserved quantities, point."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement
from operator import mul
from typing import Any, NamedTuple

from flint import fmpq, fmpq_mat, fmpq_mpoly

from polhode._base.rational._matrices import combine, matrix, null_space, solve_near
from polhode._base.rational._polynomials import (
    coefficients_of,
    context,
    gradient,
    half_hessian,
    part,
    rate,
    shift,
    terms_of,
    total,
    variables,
)
from polhode._base.rational._terms import show_terms
from polhode._base.rational.numbers import EXACT, READINGS, as_fmpq
from polhode.errors import InvalidInput

ENERGY = "H"


class RationalLimits(NamedTuple):
    """How far, and to which fractions, points and weights may be rounded."""

    max_move: fmpq = fmpq(1, 10**9)  # of the largest component of a point, to an exact equilibrium
    denominators: tuple[int, ...] = (1, 2, 4, 8, 10, 16, 32, 100, 1000, 10**4, 10**6, 10**9, 10**12, 10**15)


LIMITS = RationalLimits()


@dataclass(frozen=True)
class Equations:
    """ẋ = f(x) with rational coefficients, what it conserves, and a point where f vanishes.

    Attributes:
        system: what the equations are of, in words.
        field: (n,) f.
        conserved: functions by name, the energy "H" among them where it is conserved.
        point: (n,) the equilibrium, or the point whose motion is that of a symmetry.
        moved: the largest change of a component from the point that was asked about.
        flow: field X of the symmetry along which neighbours may move away, linear, with X³ = −X and |x| kept, so that
            it turns points, at one radian in a unit of time; empty for none.
        flow_name: what generates it.
        within: what solutions the equations are restricted to, in words; empty for all.
        read_as: how doubles of system and point were read, "exact" or "decimal".
    """

    system: str
    field: tuple[fmpq_mpoly, ...]
    conserved: Mapping[str, fmpq_mpoly]
    point: tuple[fmpq, ...]
    moved: fmpq = fmpq(0)
    flow: tuple[fmpq_mpoly, ...] = ()
    flow_name: str = ""
    within: str = ""
    read_as: str = EXACT

    @property
    def size(self) -> int:
        """How many variables there are."""
        return len(self.point)

    @cached_property
    def around(self) -> tuple[fmpq_mpoly, ...]:
        """The field in v = x − point, (n,)."""
        return tuple(shift(f, self.point) for f in self.field)

    @cached_property
    def levels(self) -> dict[str, fmpq]:
        """The values of what is conserved at the point."""
        return {name: c(*self.point) for name, c in self.conserved.items()}

    @cached_property
    def slopes(self) -> dict[str, list[fmpq]]:
        """The gradients (n,) of what is conserved at the point."""
        return {name: gradient(c, self.point) for name, c in self.conserved.items()}

    @cached_property
    def linearization(self) -> fmpq_mat:
        """The derivative of the field at the point, (n, n)."""
        return matrix([gradient(f, self.point) for f in self.field], self.size)

    @property
    def along(self) -> list[fmpq]:
        """Where the symmetry moves the point, (n,); empty without one."""
        return [f(*self.point) for f in self.flow]

    def find_faults(self) -> list[str]:
        """Return what is wrong: functions that are not conserved, and whether the point is no equilibrium."""
        faults = [f"{name} is not conserved" for name, c in self.conserved.items() if rate(c, self.field)]
        if not self.flow and any(f(*self.point) for f in self.field):
            faults.append("the point is no equilibrium")
        if self.flow and not turns(self.flow):
            faults.append(f"the flow of {self.flow_name} does not turn points")
        return faults

    def as_json(self) -> dict[str, Any]:
        """Return plain data; polynomials as lists of coefficient and exponents, numbers as text."""
        return {
            "system": self.system, "field": [as_terms(f) for f in self.field],
            "conserved": {name: as_terms(c) for name, c in self.conserved.items()},
            "point": [str(x) for x in self.point], "moved": str(self.moved), "numbers": READINGS[self.read_as],
            **({"within": self.within} if self.within else {}),
            **({"flow": [as_terms(f) for f in self.flow], "flow_of": self.flow_name} if self.flow else {}),
        }  # fmt: skip


def restrict_to_zeros(equations: Equations, zeros: Sequence[int]) -> Equations:
    """Return the equations for solutions on which those of some coordinates that stay zero are zero.

    Args:
        equations: in all coordinates.
        zeros: coordinates, counted from 0, that are zero at the point; those that others drive are left in.

    Raises:
        InvalidInput: if no coordinate is left out, or none is left.
    """
    kept = set(range(equations.size)) - set(zeros)
    left_out = set(zeros)
    while driven := {k for k in left_out if equations.field[k].subs(dict.fromkeys(left_out, 0))}:
        left_out -= driven
        kept |= driven
    if not left_out or not kept:
        raise InvalidInput(
            "an exact proof on a leaf needs coordinates that are zero on it and stay so, and others that move; "
            f"{len(left_out)} of {equations.size} are. The numerical verdict holds without one."
        )
    places = sorted(kept)
    images = [context(len(places)).constant(0)] * equations.size
    for k, x in zip(places, variables(len(places)), strict=True):
        images[k] = x
    names = " = ".join(f"x{k + 1}" for k in sorted(left_out))
    kept_names, new_names = (", ".join(f"x{k + 1}" for k in row) for row in (places, range(len(places))))
    called = "is" if len(places) == 1 else "are"
    renamed = "" if kept_names == new_names else f", where {kept_names} {called} now {new_names}"
    field = tuple(equations.field[k].compose(*images) for k in places)
    known = {name: c for name, p in equations.conserved.items() if not (c := p.compose(*images)).is_constant()}
    return Equations(
        equations.system, field, {**quadratic_integrals(field), **known},
        tuple(equations.point[k] for k in places), equations.moved,
        within=f"{names} = 0{renamed}", read_as=equations.read_as,
    )


def quadratic_integrals(field: Sequence[fmpq_mpoly]) -> dict[str, fmpq_mpoly]:
    """Return a basis of the polynomials of at most second degree that a field keeps, without constants, by name."""
    n = len(field)
    x = variables(n)
    monomials = [*x, *(x[i] * x[j] for i, j in combinations_with_replacement(range(n), 2))]
    basis = null_space(coefficients_of([rate(m, field) for m in monomials]))
    polynomials = (total(n, (c * m for c, m in zip(vector, monomials, strict=True) if c)) for vector in basis.tolist())
    return {show(p): p for p in polynomials}


def turns(flow: Sequence[fmpq_mpoly]) -> bool:
    """Whether a field X is linear, keeps |x|, and X³ = −X, so that its flow is x + sin a Xx + (1 − cos a) XXx."""
    twice = [rate(x, flow) for x in flow]
    norm = total(len(flow), (x * x for x in variables(len(flow))))
    return (all(x == part(x, 1, 1) for x in flow) and not rate(norm, flow)
            and all(rate(x, flow) == -y for x, y in zip(twice, flow, strict=True)))


def show(p: fmpq_mpoly) -> str:
    """Return a polynomial as text that people read."""
    return show_terms(terms_of(p))


def as_terms(p: fmpq_mpoly) -> list[list[Any]]:
    """Return a polynomial as plain data."""
    return [[str(c), list(m)] for m, c in terms_of(p)]


def rational_equilibrium(
    vanishing: Sequence[fmpq_mpoly],
    conserved: Mapping[str, fmpq_mpoly],
    weights: Mapping[str, float],
    point: Sequence[float],
    read: Callable[[float], Fraction],
) -> tuple[tuple[fmpq, ...], fmpq]:
    """Return a rational point at which all of ``vanishing`` are exactly zero, and its largest distance in a component.

    The point itself where it is one; else one with rounding errors of zero left out; else, as the energy and the rest
    are of second degree, the solution of dH + Σ w dC = 0 for weights w rounded to rational numbers.

    Raises:
        InvalidInput: if there is none within a billionth of the point's size.
    """
    fractions = [read(x) for x in point]
    given = list(map(as_fmpq, fractions))
    zeros, size = [fmpq(0)] * len(given), max(map(abs, given), default=fmpq(0))
    trials = [given, [x if abs(x) > size / 10**12 else fmpq(0) for x in given]]
    trials += [[as_fmpq(x.limit_denominator(d)) for x in fractions] for d in LIMITS.denominators[7:10]]
    for trial in trials:
        if accepted := _accept(trial, given, size, vanishing):
            return accepted
    if all(c.total_degree() <= 2 for name, c in conserved.items() if weights.get(name)):
        for d in LIMITS.denominators:
            rounded = {name: as_fmpq(Fraction(x).limit_denominator(d)) for name, x in weights.items()
                       if name in conserved}
            names = [name for name, w in rounded.items() if w]
            if not names:
                continue
            w = [rounded[name] for name in names]
            slopes = [gradient(conserved[name], zeros) for name in names]
            halves = combine(w, [half_hessian(conserved[name], zeros) for name in names]).tolist()
            rows = [[*(2 * x for x in row), -sum(map(mul, w, column))]
                    for row, column in zip(halves, zip(*slopes, strict=True), strict=True)]
            solution = solve_near(matrix(rows, len(given) + 1), given)
            if solution and (accepted := _accept(solution, given, size, vanishing)):
                return accepted
    residual = max((abs(float(f(*given))) for f in vanishing), default=0.0)
    raise InvalidInput(
        f"the point must be an equilibrium in rational numbers for a proof; there the field is {residual:.3g}, and "
        "none is within a billionth of its size. Give a point, or parameters, that solve the equations exactly."
    )


def _accept(
    trial: Sequence[fmpq], given: Sequence[fmpq], size: fmpq, vanishing: Sequence[fmpq_mpoly]
) -> tuple[tuple[fmpq, ...], fmpq] | None:
    moved = max((abs(x - y) for x, y in zip(trial, given, strict=True)), default=fmpq(0))
    if moved > LIMITS.max_move * size or any(f(*trial) for f in vanishing):
        return None
    return tuple(trial), moved

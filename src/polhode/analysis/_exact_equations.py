"""The exact equations behind a verdict: polynomials of the system's own functions, and a rational equilibrium."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import combinations
from typing import TYPE_CHECKING, NamedTuple

import equinox as eqx
import jax.numpy as jnp
from flint import fmpq, fmpq_mpoly

from polhode._base.rational._polynomials import context, magnitude, poisson_field, poisson_tensor, rate, variables
from polhode._base.rational.numbers import EXACT, as_fmpq, check_reading, read_number
from polhode.algebra._functions import Function
from polhode.algebra.casimirs import polynomial_casimirs, rational_brackets
from polhode.analysis._conserved import LIMITS as CONSERVATION_LIMITS
from polhode.analysis._conserved import Energy, Source, choose_casimirs
from polhode.certificates._equations import (
    ENERGY,
    Equations,
    quadratic_integrals,
    rational_equilibrium,
    restrict_to_zeros,
    turns,
)
from polhode.certificates._exact_tracing import trace_polynomials
from polhode.certificates.rational import RationalCertificate, find_certificate
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.taylor.expressions import Untraceable
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.analysis.certificate import Subject
    from polhode.analysis.energy_casimir import Stability

Reader = Callable[[float], Fraction]
Named = dict[str, fmpq_mpoly]


class ExactEquationLimits(NamedTuple):
    """Numbers that decide which exact equations agree with the code, and where integrals are sought."""

    # of the largest coefficient of a field: what the code's own rounding of parameters may change
    field_rounding: float = 1e-12
    max_coordinates: int = 12  # of a system whose integrals of second degree are sought


LIMITS = ExactEquationLimits()


class Field(Source):
    """The rate of change of the coordinates."""

    system: AbstractLiePoissonSystem

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "n"]:
        algebra = self.system.algebra
        return algebra.to_dual_vector(self.system.vector_field(0.0, algebra.from_dual_vector(x)))


class Flat(eqx.Module):
    """A function of points, which may have several values, as one with a row of them."""

    function: Function

    def __call__(self, point: Array) -> Array:
        return jnp.ravel(self.function(point))


def make_rational(judgement: Stability, subject: Subject, read_as: str) -> RationalCertificate:
    """Return the exact proof of a verdict; see ``Certificate.as_rational``.

    Raises:
        InvalidInput: as there.
    """
    check_reading(read_as)
    if getattr(judgement.reason, "leaves_nearby", "") == "larger":
        equations, hint = make_equations(judgement, subject, read_as)
        return find_certificate(restrict_to_zeros(equations, _zeros_of_leaf(equations, subject)), "stable", hint)
    if judgement.verdict not in ("stable", "unstable"):
        raise InvalidInput(
            f"an exact proof needs a decided verdict; got {judgement.verdict}: {judgement.certificate}. "
            "Give a further conserved function by `integrals=`, if one is known."
        )
    if judgement.verdict == "stable" and not subject.system.conserves_energy:
        raise InvalidInput(
            "an exact proof of stability needs a conserved energy; this system loses energy, and its verdict is by "
            "exponents. Verdicts of instability have proofs there too."
        )
    equations, hint = make_equations(judgement, subject, read_as)
    try:
        return find_certificate(equations, judgement.verdict, hint)
    except InvalidInput as error:
        for more in _further_integrals(equations, judgement.verdict):
            try:
                richer = replace(equations, conserved={**more, **equations.conserved})
                return find_certificate(richer, judgement.verdict, hint)
            except InvalidInput:
                continue
        raise error from None


def _further_integrals(equations: Equations, verdict: str) -> Iterator[Named]:
    """Yield what else is conserved: coordinates that do not move, then all polynomials of second degree."""
    if verdict == "stable":
        if still := {f"x{k + 1}": x for k, x in enumerate(variables(equations.size))
                     if not equations.field[k]}:
            yield still
        if equations.size <= LIMITS.max_coordinates:
            yield quadratic_integrals(equations.field)


def make_equations(judgement: Stability, subject: Subject, read_as: str = EXACT) -> tuple[Equations, dict[str, float]]:
    """Return the equations with a rational equilibrium, and the numerical weights of what is conserved, by name.

    Raises:
        InvalidInput: where they are not polynomial, or no rational equilibrium is near.
    """
    system, n, read = subject.system, subject.system.algebra.dim, partial(read_number, read_as=read_as)
    vector_field = tuple(_trace("the field", Field(system), n, read))
    conserved, flow, flow_name = _trace_casimirs(subject, read, read_as), (), _find_flow(judgement)
    hint = _weights_by_name(judgement)
    if system.conserves_energy:
        (energy,) = _trace("the energy", Energy(system), n, read)
        tensor = poisson_tensor(rational_brackets(system.algebra, read_as), system.sign)
        exact = poisson_field(tensor, energy)
        _compare_fields(vector_field, exact)
        vector_field = exact
        conserved |= _trace_integrals(subject, read)
        if flow_name:
            if flow_name not in conserved:
                raise InvalidInput(
                    f"an exact proof up to flows is for one polynomial integral; got {flow_name}. "
                    "Give one whose flow alone is divided out."
                )
            flow = _scale_to_turns(poisson_field(tensor, conserved[flow_name]), flow_name)
        conserved[ENERGY] = energy
    conserved = {k: c for k, c in conserved.items() if not rate(c, vector_field)}
    vanishing = _parallel(vector_field, flow) if flow else vector_field
    point, moved = rational_equilibrium(vanishing, conserved, hint, subject.point.tolist(), read)
    name = type(system).__name__
    return Equations(name, vector_field, conserved, point, moved, flow, flow_name, read_as=read_as), hint


def _trace(what: str, function: Source, n: int, read: Reader) -> list[fmpq_mpoly]:
    try:
        return trace_polynomials(function, n, read)
    except Untraceable as error:
        raise InvalidInput(
            f"{what} must be a polynomial with rational coefficients for an exact proof; it has {error}. "
            "The numerical verdict holds without one."
        ) from None


def _trace_casimirs(subject: Subject, read: Reader, read_as: str) -> Named:
    """Return the Casimirs by their names in the verdict; where these are not polynomials, those of exact algebra."""
    algebra = subject.system.algebra
    known = choose_casimirs(algebra, subject.casimirs)
    try:
        polynomials = trace_polynomials(known.source, algebra.dim, read) if known.names else []
        return dict(zip(known.names, polynomials, strict=True))
    except Untraceable:
        try:
            polynomials = polynomial_casimirs(algebra, CONSERVATION_LIMITS.max_casimir_degree, read_as)
        except InvalidInput:
            return {}
        parts = ((str(p), zip(p.exponents.tolist(), p.coefficients, strict=True)) for p in polynomials)
        return {name: context(algebra.dim).from_dict({tuple(m): as_fmpq(c) for m, c in terms}) for name, terms in parts}


def _trace_integrals(subject: Subject, read: Reader) -> Named:
    """Return the polynomials among the integrals that the system names or the user gave."""
    system, polynomials = subject.system, {}
    algebra = system.algebra
    named = [*system.extra_invariants.items(), *((f"J{k + 1}", f) for k, f in enumerate(subject.integrals))]
    for name, function in named:
        try:
            values = trace_polynomials(_Row(algebra, Flat(function)), algebra.dim, read)
        except Untraceable:
            continue
        # a given integral replaces the system's own
        polynomials = {k: p for k, p in polynomials.items() if p not in values}
        polynomials |= {name: values[0]} if len(values) == 1 else {f"{name}, {k + 1}": p for k, p in enumerate(values)}
    return polynomials


class _Row(Source):
    """The values of one function at coordinates."""

    algebra: eqx.Module
    function: Flat

    def __call__(self, x: Float64[Array, "n"]) -> Float64[Array, "k"]:
        return self.function(self.algebra.from_dual_vector(x))  # type: ignore[attr-defined]


def _find_flow(judgement: Stability) -> str:
    """Return the name of the integral whose flow is divided out; empty for none."""
    flows = judgement.restricted.flows if judgement.restricted is not None else ()
    if len(flows) > 1:
        raise InvalidInput(
            f"an exact proof up to flows is for one integral; this verdict divides out {', '.join(flows)}. "
            "Give fewer integrals, if one is enough."
        )
    if judgement.restricted is not None and not flows:
        raise InvalidInput(f"an exact proof is for all coordinates; this verdict holds {judgement.restricted}.")
    return flows[0] if flows else ""


def _weights_by_name(judgement: Stability) -> dict[str, float]:
    if judgement.function is None or judgement.function.unit != 1.0:
        return {}
    return dict(zip((ENERGY, *judgement.function.names), map(float, judgement.function.weights), strict=True))


def _compare_fields(one: tuple[fmpq_mpoly, ...], other: tuple[fmpq_mpoly, ...]) -> None:
    """Refuse a field that is not that of the energy, beyond the code's own rounding of parameters."""
    size = max(map(magnitude, other), default=fmpq(0))
    off = max((magnitude(p - q) for p, q in zip(one, other, strict=True)), default=fmpq(0))
    if off > size * as_fmpq(LIMITS.field_rounding):
        raise InvalidInput(
            f"the field must be that of the energy; its coefficients differ by {float(off / (size or 1)):.2g} of the "
            "largest. Check `vector_field` and `energy` of the system."
        )


def _zeros_of_leaf(equations: Equations, subject: Subject) -> list[int]:
    """Return the coordinates that are zero at the point and along the leaf's tangent space."""
    tensor, point = poisson_tensor(rational_brackets(subject.system.algebra, equations.read_as), 1), equations.point
    return [k for k, row in enumerate(tensor) if not point[k] and not any(f(*point) for f in row)]


def _scale_to_turns(flow: tuple[fmpq_mpoly, ...], name: str) -> tuple[fmpq_mpoly, ...]:
    """Return a symmetry's field at one radian in a unit of time.

    Raises:
        InvalidInput: if it turns nothing, or not all at one rational rate.
    """
    square = [rate(x, flow) for x in flow]
    cube = [rate(x, flow) for x in square]
    term = next(((k, m) for k, x in enumerate(flow) for m in x.monoms()), None)
    if term is not None:
        k, m = term
        speed = -cube[k][m] / flow[k][m]
        root = fmpq(math.isqrt(max(int(speed.p), 0)), math.isqrt(int(speed.q)))
        if root and root**2 == speed and turns(scaled := tuple(x / root for x in flow)):
            return scaled
    raise InvalidInput(
        f"an exact proof up to a flow needs one that turns all coordinates at one rational rate; that of {name} is "
        "another. Divide out another integral, if one is enough."
    )


def _parallel(field: tuple[fmpq_mpoly, ...], flow: tuple[fmpq_mpoly, ...]) -> list[fmpq_mpoly]:
    """Return what vanishes where a field is parallel to another."""
    return [field[i] * flow[j] - field[j] * flow[i] for i, j in combinations(range(len(field)), 2)]



"""The claims of a certificate for the solver z3, which finds its own proof of each or a counterexample."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from flint import fmpq, fmpq_mpoly

from polhode._base.extras import needing
from polhode._base.rational._polynomials import part, quadratic_form, rate
from polhode.certificates._confinement import Confinement
from polhode.certificates._equations import Equations
from polhode.certificates._growth import Drift, Growth
from polhode.certificates.rational import RationalCertificate, require_rational
from polhode.errors import InvalidInput


class SolverLimits(NamedTuple):
    """How long a solver may take.

    Attributes:
        max_time: milliseconds for one claim; after that it counts as undecided.
    """

    max_time: int = 20_000


LIMITS = SolverLimits()


def check_by_z3(certificate: RationalCertificate) -> None:
    """Check the claims by the solver z3, which gets neither weights nor squares, only the claims.

    Args:
        certificate: as ``certificate.as_rational()`` of a verdict gives it, which takes about a tenth of a second.

    Raises:
        InvalidInput: with the claim that fails or stays open, or if z3-solver, the extra `prove`, is missing.
    """
    require_rational(certificate)
    with needing("checks by z3 need", "`as_rational().check()` needs no solver."):
        import z3
    equations = certificate.equations
    v: list[Any] = [z3.Real(f"v{k + 1}") for k in range(equations.size)]
    for claim, counterexample in _claims(equations, certificate.proof, v):
        solver = z3.Solver()
        solver.set("timeout", LIMITS.max_time)
        solver.add(*counterexample)
        answer = solver.check()
        if answer == z3.sat:
            place = ", ".join(f"{d.name()} = {solver.model()[d]}" for d in solver.model().decls())
            raise InvalidInput(f"the claim must hold that {claim}; z3 refutes it at {place or 'every point'}. "
                               "Take the certificate from `stability`.")
        if answer != z3.unsat:
            seconds = LIMITS.max_time // 1000
            raise InvalidInput(f"z3 must decide that {claim}; it gave up after at most {seconds} s. "
                               "Check the certificate by `as_rational().check()` or by Rocq.")


def _claims(
    equations: Equations, proof: Confinement | Growth | Drift, v: list[Any]
) -> Iterator[tuple[str, list[Any]]]:
    """Yield each claim in words, with conditions on v that hold together only where it is wrong."""
    if not equations.flow:
        still = [_term(part(f, 0, 0), v) for f in equations.around]
        yield "the point is an equilibrium", [_any(x != 0 for x in still)]
    if isinstance(proof, Confinement):
        g, raised = proof.function(equations), proof.raised(equations)
        x = [y + _number(z) for y, z in zip(v, equations.point, strict=True)]
        parts = [_term(g.derivative(k), x) * _term(f, x) for k, f in enumerate(equations.field)]
        yield "G is conserved", [_sum(parts) != 0]
        yield "G is stationary at the point", [_term(part(raised, 1, 1), v) != 0]
        yield "the second variation of G is positive definite", _not_positive(part(raised, 2, 2), v)
    elif isinstance(proof, Growth):
        V = quadratic_form(proof.form)
        excess = part(rate(V, equations.around) - 2 * proof.rate * V, 2, 2)
        yield "the rate is positive", [_number(proof.rate) <= 0]
        yield "V grows at twice the rate", _not_positive(excess, v)
        yield "V is positive along the direction", [_number(V(*proof.direction)) <= 0]
    else:
        V, K, q = quadratic_form(proof.form), proof.conserved, proof.factor
        yield "K is conserved", [_rate(K, equations, v) != 0]
        yield "V has the rate K q", [_rate(V, equations, v) != _term(K, v) * _term(q, v)]
        yield "q is positive at the point", [_term(part(q, 0, 0), v) <= 0]
        yield "K is positive along the direction", [_number(K(*proof.direction)) <= 0]


def _rate(p: fmpq_mpoly, equations: Equations, v: list[Any]) -> Any:
    """Return the rate of change along the equations around the point, unexpanded."""
    return _sum([_term(p.derivative(k), v) * _term(f, v) for k, f in enumerate(equations.around)])


def _not_positive(form: fmpq_mpoly, v: list[Any]) -> list[Any]:
    return [_term(form, v) <= 0, _any(x != 0 for x in v)]


def _any(conditions: Iterator[Any]) -> Any:
    import z3

    return z3.Or(list(conditions))


def _term(p: fmpq_mpoly, v: list[Any]) -> Any:
    """Return a polynomial as z3 has it."""
    factors = ([x for x, e in zip(v, m, strict=True) for _ in range(int(e))] for m in p.monoms())
    return _sum([math.prod(xs, start=_number(c)) for xs, c in zip(factors, p.coeffs(), strict=True)])


def _sum(terms: list[Any]) -> Any:
    import z3

    return z3.Sum(terms) if terms else z3.RealVal(0)


def _number(x: fmpq) -> Any:
    import z3

    return z3.Q(int(x.p), int(x.q))

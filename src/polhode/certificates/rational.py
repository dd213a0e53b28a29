"""A certificate in rational numbers: the equations, the verdict and its proof, as data that anyone can check."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from polhode._base import check
from polhode.certificates._confinement import Confinement, find_confinement
from polhode.certificates._equations import Equations
from polhode.certificates._growth import Drift, Growth, find_drift, find_growth
from polhode.errors import InvalidInput

Proof = Confinement | Growth | Drift


@dataclass(frozen=True)
class RationalCertificate:
    """A verdict on an equilibrium of polynomial equations, with a proof in rational numbers.

    It holds for exactly these equations: ``check`` decides that in rational arithmetic. The function
    ``check_by_z3`` has the solver z3 do so, and ``write_proof`` writes it for the prover Rocq, which derives the
    theorem about solutions from the axioms of the real numbers.

    Attributes:
        equations: field, conserved functions and point, exact.
        proof: a ``Confinement`` for "stable", a ``Growth`` or ``Drift`` for "unstable".
    """

    equations: Equations
    proof: Proof

    @property
    def verdict(self) -> str:
        """That of ``stability``: "undecided" where the proof is for solutions on a leaf alone."""
        return "undecided" if self.equations.within else self.proof.verdict

    @property
    def statement(self) -> str:
        """What is proved, in a sentence."""
        if self.equations.flow:
            return (f"every solution that starts near enough stays near the point up to the flow of "
                    f"{self.equations.flow_name}")
        if self.equations.within:
            return (f"every solution with {self.equations.within}, that starts near enough stays near the point; of "
                    "other solutions, on leaves nearby, nothing is proved")
        if self.verdict == "stable":
            return "every solution that starts near enough, in any direction, stays near the point"
        return "arbitrarily near the point are starts from which no solution stays near it beyond some time"

    def find_faults(self) -> list[str]:
        """Return what is wrong, in words; empty for a certificate that proves its verdict."""
        return [*self.equations.find_faults(), *self.proof.find_faults(self.equations)]

    def check(self) -> None:
        """Check every claim in rational arithmetic.

        Raises:
            InvalidInput: naming the claims that do not hold.
        """
        if faults := self.find_faults():
            raise InvalidInput(
                f"the certificate must prove its verdict; but {'; '.join(faults)}. Take it from `stability`."
            )

    def as_json(self) -> dict[str, Any]:
        """Return plain data: text for numbers, lists of coefficient and exponents for polynomials."""
        kind = type(self.proof).__name__.lower()
        return {"verdict": self.verdict, "statement": self.statement, **self.equations.as_json(),
                "proof": {"kind": kind, **self.proof.as_json()}}  # fmt: skip

    def json(self) -> str:
        """Return these data as JSON."""
        return json.dumps(self.as_json(), ensure_ascii=False, indent=1)


def require_rational(certificate: RationalCertificate) -> None:
    """Refuse what is no exact certificate, such as the sentence of a verdict.

    Raises:
        InvalidInput: for anything else.
    """
    check.instance("certificate", certificate, RationalCertificate, "a RationalCertificate",
                   "Make one by `as_rational()` of the certificate of a verdict.")


def find_certificate(
    equations: Equations, verdict: str, hint: Mapping[str, float], undecided: str = ""
) -> RationalCertificate:
    """Return a proof of a verdict in rational numbers.

    Args:
        equations: exact.
        verdict: "stable" or "unstable".
        hint: weights of conserved functions by name, from a numerical method.
        undecided: what to say where there is nothing to prove.

    Raises:
        InvalidInput: for "undecided", and where the search finds no proof.
    """
    proof: Proof | None = None
    if verdict == "stable":
        proof = find_confinement(equations, hint)
    elif verdict == "unstable":
        proof = find_growth(equations) or find_drift(equations)
    else:
        raise InvalidInput(f"the verdict must be decided to be proved; got {undecided or verdict}. "
                           "Look for a further conserved function.")
    if proof is None:
        raise InvalidInput(
            f"no proof of the verdict {verdict!s} in rational numbers was found: {_why(equations, verdict)}. Give the "
            "polynomial Casimirs or integrals that it rests on."
        )
    certificate = RationalCertificate(equations, proof)
    certificate.check()
    return certificate


def _why(equations: Equations, verdict: str) -> str:
    names = ", ".join(equations.conserved) or "no function"
    if verdict == "stable":
        return f"no combination of {names} has a definite second variation"
    return "the linear part has no growth that is sure, and no drift was found"

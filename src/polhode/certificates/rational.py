"""A certificate in rational numbers: the equations, the verdict and its proof, as data that anyone can check."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from polhode.certificates._confinement import Confinement, find_confinement
from polhode.certificates._equations import Equations
from polhode.certificates._growth import Drift, Growth, find_drift, find_growth
from polhode.certificates._rocq import write_rocq
from polhode.certificates._smt import check_by_z3
from polhode.errors import InvalidInput

Proof = Confinement | Growth | Drift


@dataclass(frozen=True)
class RationalCertificate:
    """A verdict on an equilibrium of polynomial equations, with a proof in rational numbers.

    What it says is about exactly these equations: ``check`` decides it in rational arithmetic, ``check_by_z3`` has the
    solver z3 do so, and ``write_proof`` writes it for the prover Rocq, which derives the theorem about solutions from
    the axioms of the real numbers.

    Attributes:
        equations: field, conserved functions and point, exact.
        proof: a ``Confinement`` for "stable", a ``Growth`` or ``Drift`` for "unstable".
    """

    equations: Equations
    proof: Proof

    @property
    def verdict(self) -> str:
        """"stable" or "unstable"."""
        return self.proof.verdict

    @property
    def statement(self) -> str:
        """What is proved, in a sentence."""
        if self.equations.flow:
            return (f"every solution that starts near enough stays near the point up to the flow of "
                    f"{self.equations.flow_name}")  # fmt: skip
        if self.equations.within:
            return f"every solution with {self.equations.within}, that starts near enough stays near the point"
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

    def check_by_z3(self) -> None:
        """Check the claims by the solver z3, which is told neither weights nor squares but what they prove.

        Raises:
            InvalidInput: naming the claim that fails or stays open, or if z3-solver, the extra `prove`, is missing.
        """
        check_by_z3(self.equations, self.proof)

    def as_json(self) -> dict[str, Any]:
        """Return plain data: text for numbers, lists of coefficient and exponents for polynomials."""
        kind = type(self.proof).__name__.lower()
        return {"verdict": self.verdict, "statement": self.statement, **self.equations.as_json(),
                "proof": {"kind": kind, **self.proof.as_json()}}  # fmt: skip

    def json(self) -> str:
        """Return the same as JSON."""
        return json.dumps(self.as_json(), ensure_ascii=False, indent=1)

    def write_proof(self, path: str | Path) -> Path:
        """Write a Rocq file that proves the verdict, and beside it ``checker.v``, on which it rests.

        ``coqc -Q . Polhode checker.v`` and then ``coqc -Q . Polhode FILE.v`` in that folder check both; they need Coq
        8.16 or Rocq, and no other library.

        Args:
            path: of the file, ending in .v, a name that starts with a letter.

        Returns:
            The path.

        Raises:
            InvalidInput: for another name, or a certificate that proves nothing.
        """
        return write_rocq(self, Path(path))


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
        InvalidInput: for "undecided", and where no proof is found.
    """
    proof: Proof | None = None
    if verdict == "stable":
        proof = find_confinement(equations, hint)
    elif verdict == "unstable":
        proof = find_growth(equations) or find_drift(equations)
    else:
        raise InvalidInput(f"the verdict must be decided to be proved; got {undecided or verdict}. "
                           "Look for a further conserved function.")  # fmt: skip
    if proof is None:
        raise InvalidInput(
            f"no proof of the verdict {verdict!s} in rational numbers was found: {_why(equations, verdict)}. Give the "
            "polynomial Casimirs or integrals that it rests on."
        )
    found = RationalCertificate(equations, proof)
    found.check()
    return found


def _why(equations: Equations, verdict: str) -> str:
    names = ", ".join(equations.conserved) or "no function"
    if verdict == "stable":
        return f"no combination of {names} has a definite second variation"
    return "the linear part has no growth that is sure, and no drift was found"



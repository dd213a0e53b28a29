"""The certificate of a verdict: a sentence, and on demand a proof in rational numbers of exactly these equations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from polhode._base.rational.numbers import EXACT
from polhode.errors import InvalidInput
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.algebra._functions import Function
    from polhode.analysis.energy_casimir import Stability
    from polhode.certificates.rational import RationalCertificate
    from polhode.systems.base import AbstractLiePoissonSystem


@dataclass(frozen=True, eq=False)
class Subject:
    """What a verdict is about.

    Attributes:
        source: a Lie–Poisson system, or the moments (3,) of a free body, which is made when it is asked for.
        point: (n,) coordinates of the equilibrium.
        integrals: as given to ``stability``.
        casimirs: the same.
    """

    source: AbstractLiePoissonSystem | tuple[float, float, float]
    point: Float64[Array, "n"]
    integrals: Sequence[Function] = ()
    casimirs: Sequence[Function] | None = None

    @property
    def system(self) -> AbstractLiePoissonSystem:
        """The system."""
        if isinstance(self.source, tuple):
            from polhode.systems.free_rigid_body import FreeRigidBody

            return FreeRigidBody(self.source)
        return self.source


class Certificate(str):
    """The reason of a verdict as a sentence, from which a proof in rational numbers can be made.

    It is text like any other; the proof is computed on demand. ``polhode.proving.check_by_z3`` has the solver z3 check
    it, ``polhode.proving.write_proof`` writes it for the prover Rocq.

    >>> import numpy as np
    >>> import polhode as ph
    >>> verdict = ph.stability(ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), np.array([0.0, 0.0, 0.1]))
    >>> exact = verdict.certificate.as_rational("decimal")
    >>> exact.equations.point[2], exact.equations.field[0], exact.proof.weights["|L|²"]  # python-flint's rationals
    (1/10, -1/6*x2*x3, -1/6)
    """

    found: Stability | None

    def __new__(cls, text: str, found: Stability | None = None) -> Certificate:
        made = super().__new__(cls, text)
        made.found = found
        return made

    def __reduce__(self) -> tuple[type[str], tuple[str]]:
        return str, (str(self),)  # a system may hold functions that cannot be pickled

    def as_rational(self, read_as: str = EXACT) -> RationalCertificate:
        """Return the verdict with an exact proof: equations, weights and sums of squares as fractions.

        The proof starts anew from the equations, with the numerical weights as a first guess, and is then checked in
        rational arithmetic. An equilibrium that solves the equations only up to rounding is moved to one with rational
        coordinates within a billionth of its size; ``equations.moved`` says how far.

        Args:
            read_as: "exact" takes each double of system and point as the binary fraction that it is, "decimal" as the
                shortest decimal that rounds to it: 0.1 is 1/10. ``equations.read_as`` says which.

        Raises:
            InvalidInput: for a verdict that is undecided or of a system without polynomial equations, an equilibrium
                with no rational one near it, and where the search finds no exact proof.
        """
        from polhode.analysis._exact_equations import make_rational

        if self.found is None or self.found.subject is None:
            raise InvalidInput(
                "an exact proof needs the equations; this verdict is of matrices or of a formula alone. "
                "Take it from `stability(system, equilibrium)`."
            )
        return make_rational(self.found, self.found.subject, read_as)

"""The rigid body in four dimensions: Manakov's equations, the Casimirs of so(4)*, and the further integral."""

from __future__ import annotations

from typing import Any

from polhode.algebra import SO
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.manakov import Manakov


def derive() -> Page:
    """Return the page."""
    masses = sympy.symbols("Lambda1:5", positive=True)
    pairs = [(1, 2), (1, 3), (1, 4), (2, 3), (2, 4), (3, 4)]
    bracket = LiePoissonBracket(SO(4), [f"M{i}{j}" for i, j in pairs], parameters=[*masses])
    upper = dict(zip(pairs, bracket.coordinates, strict=True))
    # coordinates belong to E_ji − E_ij, so that they are the entries below the diagonal
    M = sympy.Matrix(4, 4, lambda i, j: -upper[i + 1, j + 1] if i < j else upper[j + 1, i + 1] if j < i else 0)
    velocity = sympy.Matrix(4, 4, lambda i, j: M[i, j] / (masses[i] + masses[j]))
    H = sum(x**2 / (2 * (masses[i - 1] + masses[j - 1])) for (i, j), x in upper.items())
    names = [str(v) for v in masses]
    samples = [
        {"Lambda1": 1.0, "Lambda2": 2.0, "Lambda3": 3.0, "Lambda4": 4.5},
        {"Lambda1": 2.0, "Lambda2": 0.5, "Lambda3": 1.5, "Lambda4": 1.0},
    ]
    page = Derivation("The rigid body in four dimensions", SymbolicSystem(bracket, H),
                      Numerical(lambda v: Manakov([v[name] for name in names]), samples))
    stated = {}
    for (i, j), x in upper.items():
        for (k, n), y in upper.items():
            shared = {i, j} & {k, n}
            if (i, j) < (k, n) and len(shared) == 1:
                stated[x, y] = -_commutator(M, (i, j), (k, n))
    page.brackets("The angular momentum is an antisymmetric matrix, whose entries below the diagonal are coordinates "
                  "of so(4)*, with the minus bracket.", stated)
    page.hamiltonian("The energy, with the second moments of mass along the axes.")
    rates = M * velocity - velocity * M
    page.equations("Hamilton's equations are the commutator of momentum and angular velocity.",
                   {x: rates[j - 1, i - 1] for (i, j), x in upper.items()})
    square = sum(x**2 for x in upper.values())
    pfaffian = upper[1, 2] * upper[3, 4] - upper[1, 3] * upper[2, 4] + upper[1, 4] * upper[2, 3]
    names_of = {Name(r"\tfrac12|M|^2", "½|M|²"): square, Name(r"\operatorname{Pf} M", "Pf M"): pfaffian}
    page.casimirs("The Casimirs are the sum of squares and the Pfaffian.", names_of)
    F = sum((masses[i - 1] ** 2 + masses[j - 1] ** 2) * x**2 for (i, j), x in upper.items())
    page.integral("Manakov's further integral is of second degree too.", Name("F", "F"), F)
    page.further_integrals(
        "Linear algebra over rational functions of the parameters finds it, up to energy and Casimirs, and no other.",
        2, [F],
    )
    return page.page()


def _commutator(M: Any, first: tuple[int, int], second: tuple[int, int]) -> Any:
    """Return ⟨M, [X, Y]⟩ = ½ tr Mᵀ(XY − YX) of two basis elements E_ji − E_ij."""
    X, Y = sympy.zeros(4, 4), sympy.zeros(4, 4)
    for matrix, (i, j) in ((X, first), (Y, second)):
        matrix[j - 1, i - 1], matrix[i - 1, j - 1] = 1, -1
    return (M.T * (X * Y - Y * X)).trace() / 2

"""Steklov's and Lyapunov's case of a body in an ideal fluid, with its integral of second degree."""

from __future__ import annotations

import numpy as np

from polhode.algebra import SE3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.derivations.heavy_top import se3_brackets
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.kirchhoff import Kirchhoff


def inertia(v: dict[str, float]) -> np.ndarray:
    """Return M (6, 6), the inverse of the Hamiltonian's matrix."""
    b = np.array([v["b1"], v["b2"], v["b3"]])
    after, last = np.roll(b, -1), np.roll(b, -2)
    mixed, linear = v["nu"] * after * last, v["nu"] ** 2 * b * (after - last) ** 2 + v["c"]
    return np.linalg.inv(np.block([[np.diag(b), np.diag(mixed)], [np.diag(mixed), np.diag(linear)]]))


def derive() -> Page:
    """Return the page."""
    b = sympy.symbols("b1 b2 b3", positive=True)
    nu, c = sympy.symbols("nu c", positive=True)
    bracket = LiePoissonBracket(SE3(), ["Pi1", "Pi2", "Pi3", "P1", "P2", "P3"], parameters=[*b, nu, c])
    L, P = bracket.coordinates[:3], bracket.coordinates[3:]
    H, F = c * sum(p**2 for p in P) / 2, sympy.Integer(0)
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        H += (b[i] * L[i] ** 2 + 2 * nu * b[j] * b[k] * L[i] * P[i] + nu**2 * b[i] * (b[j] - b[k]) ** 2 * P[i] ** 2) / 2
        F += L[i] ** 2 - 2 * nu * b[i] * L[i] * P[i] + nu**2 * (b[j] - b[k]) ** 2 * P[i] ** 2
    samples = [
        {"b1": 1.0, "b2": 2.0, "b3": 4.0, "nu": 0.5, "c": 20.0},
        {"b1": 2.0, "b2": 0.7, "b3": 1.1, "nu": 0.3, "c": 1.0},
    ]
    page = Derivation("The case of Steklov and Lyapunov", SymbolicSystem(bracket, H),
                      Numerical(lambda v: Kirchhoff(inertia(dict(v))), samples))
    page.brackets("The bracket is that of se(3)*.", se3_brackets(bracket))
    page.hamiltonian("The energy couples angular and linear momentum; the square of P, a Casimir, makes it positive.")
    page.integral("Lyapunov's integral.", Name("F", "F"), F)
    page.further_integrals(
        "Linear algebra over rational functions of the parameters finds it, up to energy and Casimirs, and no other.",
        2, [F],
    )
    return page.page()

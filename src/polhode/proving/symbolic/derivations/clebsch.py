"""Clebsch's case of a body in an ideal fluid, with its integral of second degree."""

from __future__ import annotations

from polhode.algebra import SE3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.derivations.heavy_top import se3_brackets
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.kirchhoff import Kirchhoff


def inertia(a: tuple[float, float, float], theta: float) -> list[float]:
    """Return moments and masses (6,) of Clebsch's case: b1 = θ a2 a3 and so on."""
    a1, a2, a3 = a
    return [1 / a1, 1 / a2, 1 / a3, 1 / (theta * a2 * a3), 1 / (theta * a3 * a1), 1 / (theta * a1 * a2)]


def derive() -> Page:
    """Return the page."""
    a1, a2, a3, theta = sympy.symbols("a1 a2 a3 theta", positive=True)
    bracket = LiePoissonBracket(SE3(), ["Pi1", "Pi2", "Pi3", "P1", "P2", "P3"], parameters=[a1, a2, a3, theta])
    L1, L2, L3, P1, P2, P3 = bracket.coordinates
    H = (a1 * L1**2 + a2 * L2**2 + a3 * L3**2 + theta * (a2 * a3 * P1**2 + a3 * a1 * P2**2 + a1 * a2 * P3**2)) / 2
    samples = [
        {"a1": 1.0, "a2": 0.5, "a3": 0.25, "theta": 1.3},
        {"a1": 2.0, "a2": 0.7, "a3": 1.1, "theta": 0.4},
    ]
    numerical = Numerical(lambda v: Kirchhoff(inertia((v["a1"], v["a2"], v["a3"]), v["theta"])), samples)
    page = Derivation("Clebsch's case", SymbolicSystem(bracket, H), numerical)
    page.brackets("The bracket is that of se(3)*.", se3_brackets(bracket))
    page.hamiltonian("The reciprocal masses are products of the reciprocal moments, up to a factor; a multiple of the "
                     "square of P could be added.")
    b1, b2, b3 = theta * a2 * a3, theta * a3 * a1, theta * a1 * a2
    page.vanishes("Clebsch's condition on the coefficients of the momenta holds.",
                  (b2 - b3) / a1 + (b3 - b1) / a2 + (b1 - b2) / a3)
    F = L1**2 + L2**2 + L3**2 - theta * (a1 * P1**2 + a2 * P2**2 + a3 * P3**2)
    page.integral("Clebsch's integral.", Name("F", "F"), F)
    page.further_integrals(
        "Linear algebra over rational functions of the parameters finds it, up to energy and Casimirs, and no other.",
        2, [F],
    )
    return page.page()

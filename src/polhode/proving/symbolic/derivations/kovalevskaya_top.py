"""Kovalevskaya's top, and its integral of fourth degree by linear algebra."""

from __future__ import annotations

from polhode.algebra import SE3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.derivations.heavy_top import se3_brackets
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.heavy_top import HeavyTop


def derive() -> Page:
    """Return the page."""
    I3, m, g, ell = sympy.symbols("I3 m g l", positive=True)
    bracket = LiePoissonBracket(SE3(), ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"], parameters=[I3, m, g, ell])
    P1, P2, P3, G1, G2, G3 = bracket.coordinates
    weight = m * g * ell
    system = SymbolicSystem(bracket, (P1**2 + P2**2) / (4 * I3) + P3**2 / (2 * I3) + weight * G1)
    samples = [{"I3": 1.0, "m": 0.5, "g": 2.0, "l": 1.5}, {"I3": 0.7, "m": 1.0, "g": 1.5, "l": 0.5}]
    numerical = Numerical(
        lambda v: HeavyTop((2 * v["I3"], 2 * v["I3"], v["I3"]), v["m"] * v["g"] * v["l"], (1.0, 0.0, 0.0)), samples
    )
    page = Derivation("Kovalevskaya's top", system, numerical)
    page.brackets("The bracket is that of se(3)*.", se3_brackets(bracket))
    page.hamiltonian("Two moments are equal and twice the third; the centre of mass lies in their plane.")
    page.equations(
        "Hamilton's equations.",
        {
            P1: P2 * P3 / (2 * I3),
            P2: weight * G3 - P3 * P1 / (2 * I3),
            P3: -weight * G2,
            G1: G2 * P3 / I3 - G3 * P2 / (2 * I3),
            G2: G3 * P1 / (2 * I3) - G1 * P3 / I3,
            G3: (G1 * P2 - G2 * P1) / (2 * I3),
        },
    )
    unit, vertical = G1**2 + G2**2 + G3**2, P1 * G1 + P2 * G2 + P3 * G3
    page.casimirs("The Casimirs are the square of the upward direction and the vertical momentum.",
                  {Name(r"|\Gamma|^2", "|Γ|²"): unit, Name(r"\Pi\cdot\Gamma", "Π·Γ"): vertical})
    rate1, rate2, strength = P1 / (2 * I3), P2 / (2 * I3), weight / I3
    K = (rate1**2 - rate2**2 - strength * G1) ** 2 + (2 * rate1 * rate2 - strength * G2) ** 2
    page.integral("Kovalevskaya's integral is of fourth degree in the momentum, here from the angular velocity.",
                  Name("K", "K"), K)
    page.further_integrals(
        "Linear algebra over rational functions of the parameters finds it, up to energy and Casimirs, and no other.",
        4, [K],
    )
    return page.page()

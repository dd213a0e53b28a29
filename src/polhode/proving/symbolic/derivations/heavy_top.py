"""Equations of the heavy top from the bracket of se(3)*, upright spin, and no further integral for general moments."""

from __future__ import annotations

from typing import Any

from polhode.algebra import SE3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.heavy_top import HeavyTop


def se3_brackets(bracket: LiePoissonBracket) -> dict[tuple[Any, Any], Any]:
    """Return the brackets of se(3)* that do not vanish, by pairs of coordinates (Π, P)."""
    Pi, P = bracket.coordinates[:3], bracket.coordinates[3:]
    stated = {}
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        stated[Pi[i], Pi[j]] = -Pi[k]
        stated[Pi[i], P[j]] = -P[k]
        stated[P[i], Pi[j]] = -P[k]
    return stated


def derive() -> Page:
    """Return the page."""
    I1, I2, I3, m, g, ell, S = sympy.symbols("I1 I2 I3 m g l S", positive=True)
    bracket = LiePoissonBracket(
        SE3(), ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"], parameters=[I1, I2, I3, m, g, ell, S]
    )
    P1, P2, P3, G1, G2, G3 = bracket.coordinates
    weight = m * g * ell
    system = SymbolicSystem(bracket, P1**2 / (2 * I1) + P2**2 / (2 * I2) + P3**2 / (2 * I3) + weight * G3)
    # the first spins fast enough, the second too slowly for the proof; the axis of the third is intermediate
    samples = [
        {"I1": 1.0, "I2": 2.0, "I3": 2.5, "m": 0.5, "g": 2.0, "l": 1.5, "S": 6.0},
        {"I1": 1.0, "I2": 2.0, "I3": 2.5, "m": 0.5, "g": 2.0, "l": 1.5, "S": 2.0},
        {"I1": 2.0, "I2": 1.5, "I3": 1.75, "m": 1.0, "g": 1.5, "l": 0.5, "S": 3.0},
    ]
    numerical = Numerical(lambda v: HeavyTop((v["I1"], v["I2"], v["I3"]), v["m"] * v["g"] * v["l"]), samples)
    page = Derivation("The heavy top", system, numerical)
    page.brackets(
        "Angular momentum about the fixed point and the upward direction, both along the body's axes, are a point of "
        "se(3)*, with the minus bracket.",
        se3_brackets(bracket),
    )
    page.hamiltonian("Energy of rotation and weight; the centre of mass lies on the third principal axis.")
    page.equations(
        "Hamilton's equations are those of Euler and Poisson: weight turns the momentum, and the upward direction "
        "stays fixed in space.",
        {
            P1: (1 / I3 - 1 / I2) * P2 * P3 + weight * G2,
            P2: (1 / I1 - 1 / I3) * P3 * P1 - weight * G1,
            P3: (1 / I2 - 1 / I1) * P1 * P2,
            G1: G2 * P3 / I3 - G3 * P2 / I2,
            G2: G3 * P1 / I1 - G1 * P3 / I3,
            G3: G1 * P2 / I2 - G2 * P1 / I1,
        },
    )
    unit, vertical = G1**2 + G2**2 + G3**2, P1 * G1 + P2 * G2 + P3 * G3
    page.casimirs("The Casimirs are the square of the upward direction and the vertical momentum.",
                  {Name(r"|\Gamma|^2", "|Γ|²"): unit, Name(r"\Pi\cdot\Gamma", "Π·Γ"): vertical})
    page.further_integrals(
        "With general moments there is no further polynomial integral up to degree four.", 4, []
    )
    page.stable_if(
        "Spin about the upright third axis is an equilibrium. The second variation is definite if the spin is fast and "
        "the axis is that of the largest moment.",
        (0, 0, S, 0, 0, 1), [unit / 2, vertical],
        sympy.And(S**2 * (I3 - I1) > I3**2 * weight, S**2 * (I3 - I2) > I3**2 * weight),
    )
    return page.page()

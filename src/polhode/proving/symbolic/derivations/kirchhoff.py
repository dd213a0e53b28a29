"""A body in an ideal fluid: Kirchhoff's equations, and which way along it moves stably."""

from __future__ import annotations

from polhode.algebra import SE3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.derivations.heavy_top import se3_brackets
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.second_variation import EXPONENT as s
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.kirchhoff import Kirchhoff


def derive() -> Page:
    """Return the page."""
    I1, I2, I3, M1, M2, M3, p = sympy.symbols("I1 I2 I3 M1 M2 M3 p", positive=True)
    bracket = LiePoissonBracket(SE3(), ["Pi1", "Pi2", "Pi3", "P1", "P2", "P3"], parameters=[I1, I2, I3, M1, M2, M3, p])
    x = bracket.coordinates
    inertia = (I1, I2, I3, M1, M2, M3)
    system = SymbolicSystem(bracket, sum(v**2 / (2 * i) for v, i in zip(x, inertia, strict=True)))
    samples = [
        {"I1": 1.0, "I2": 2.0, "I3": 2.5, "M1": 1.0, "M2": 2.0, "M3": 3.0, "p": 1.5},
        {"I1": 1.0, "I2": 2.0, "I3": 2.5, "M1": 1.0, "M2": 3.0, "M3": 2.0, "p": 0.7},
    ]
    numerical = Numerical(lambda v: Kirchhoff([v[k] for k in ("I1", "I2", "I3", "M1", "M2", "M3")]), samples)
    page = Derivation("A body in an ideal fluid", system, numerical)
    page.brackets("The impulses of body and fluid, angular and linear, are a point of se(3)*, with the minus bracket.",
                  se3_brackets(bracket))
    page.hamiltonian("Kinetic energy of body and fluid; moments and masses include what the fluid adds.")
    L1, L2, L3, P1, P2, P3 = x
    page.equations(
        "Hamilton's equations are Kirchhoff's.",
        {
            L1: (1 / I3 - 1 / I2) * L2 * L3 + (1 / M3 - 1 / M2) * P2 * P3,
            L2: (1 / I1 - 1 / I3) * L3 * L1 + (1 / M1 - 1 / M3) * P3 * P1,
            L3: (1 / I2 - 1 / I1) * L1 * L2 + (1 / M2 - 1 / M1) * P1 * P2,
            P1: P2 * L3 / I3 - P3 * L2 / I2,
            P2: P3 * L1 / I1 - P1 * L3 / I3,
            P3: P1 * L2 / I2 - P2 * L1 / I1,
        },
    )
    square, product = P1**2 + P2**2 + P3**2, L1 * P1 + L2 * P2 + L3 * P3
    page.casimirs("The Casimirs are the square of the linear impulse and its product with the angular one.",
                  {Name("|P|^2", "|P|²"): square, Name(r"\Pi\cdot P", "Π·P"): product})
    along = (0, 0, 0, 0, 0, p)
    page.unstable_if(
        "Motion along the third axis without spin is an equilibrium. It is unstable if another direction has the "
        "larger mass: a long body turns its broadside forward.",
        along, sympy.Or(M1 > M3, M2 > M3),
        s**2 * (s**2 + p**2 * (1 / M1 - 1 / M3) / I2) * (s**2 + p**2 * (1 / M2 - 1 / M3) / I1),
    )
    page.stable_if("The second variation is definite if the mass along the third axis is the largest.",
                   along, [square / 2, product], sympy.And(M3 > M1, M3 > M2))
    return page.page()

"""Euler's equations from the bracket of so(3)*, stability of the axes, and the reduction to a sphere."""

from __future__ import annotations

from polhode.algebra import SO3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.second_variation import EXPONENT as s
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.free_rigid_body import FreeRigidBody


def derive() -> Page:
    """Return the page."""
    I1, I2, I3, size = sympy.symbols("I1 I2 I3 L", positive=True)
    bracket = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3, size])
    L1, L2, L3 = bracket.coordinates
    system = SymbolicSystem(bracket, L1**2 / (2 * I1) + L2**2 / (2 * I2) + L3**2 / (2 * I3))
    samples = [
        {"I1": 1.0, "I2": 2.0, "I3": 2.5, "L": 1.5},
        {"I1": 2.0, "I2": 1.0, "I3": 2.5, "L": 0.7},
        {"I1": 3.0, "I2": 2.0, "I3": 2.5, "L": 1.1},
    ]
    numerical = Numerical(lambda v: FreeRigidBody((v["I1"], v["I2"], v["I3"])), samples)
    page = Derivation("The free rigid body", system, numerical)
    page.brackets(
        "The angular momentum along the body's axes is a point of so(3)*, with the minus (left-invariant) bracket.",
        {(L1, L2): -L3, (L2, L3): -L1, (L3, L1): -L2},
    )
    page.hamiltonian("The energy is that of rotation, with principal moments of inertia.")
    page.equations(
        "Hamilton's equations are Euler's.",
        {L1: (1 / I3 - 1 / I2) * L2 * L3, L2: (1 / I1 - 1 / I3) * L3 * L1, L3: (1 / I2 - 1 / I1) * L1 * L2},
    )
    square = L1**2 + L2**2 + L3**2
    page.casimirs("The square of the momentum is a Casimir: it is constant whatever the Hamiltonian.",
                  {Name(r"|L|^2", "|L|²"): square})
    page.further_integrals(
        "With general moments every polynomial integral up to degree four is a polynomial in energy and Casimir.", 4, []
    )
    spin = (size, 0, 0)
    page.unstable_if(
        "Spin about the first axis is an equilibrium. Linearised there, small deviations grow if the first moment lies "
        "between the others.",
        spin, sympy.Or(sympy.And(I2 < I1, I1 < I3), sympy.And(I3 < I1, I1 < I2)),
        s * (s**2 + size**2 * (I1 - I2) * (I1 - I3) / (I1**2 * I2 * I3)),
    )
    page.stable_if(
        "The second variation of energy and Casimir, on deviations that keep the Casimir, is definite if the first "
        "moment is the largest or the least: then the spin is stable.",
        spin, [square / 2],
        sympy.Or(sympy.And(I1 > I2, I1 > I3), sympy.And(I1 < I2, I1 < I3)),
    )
    page.sphere("On a sphere of constant momentum the motion has one degree of freedom, with the angle about the third "
                "axis and the height as coordinates.")
    return page.page()

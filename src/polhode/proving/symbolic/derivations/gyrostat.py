"""A body with a rotor: Zhukovskii's and Volterra's equations, stability of spin along the rotor, a sphere."""

from __future__ import annotations

from polhode.algebra import SO3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.proving.symbolic.rendering import Name, Page
from polhode.proving.symbolic.second_variation import EXPONENT as s
from polhode.proving.symbolic.sign_conditions import positive_condition
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.gyrostat import Gyrostat


def derive() -> Page:
    """Return the page."""
    I1, I2, I3, h, size = sympy.symbols("I1 I2 I3 h L", positive=True)
    bracket = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3, h, size])
    L1, L2, L3 = bracket.coordinates
    system = SymbolicSystem(bracket, L1**2 / (2 * I1) + L2**2 / (2 * I2) + (L3 - h) ** 2 / (2 * I3))
    # the second spins about the middle axis without enough help of its rotor; the third is held by it
    samples = [
        {"I1": 1.0, "I2": 2.0, "I3": 2.5, "h": 0.5, "L": 1.5},
        {"I1": 2.0, "I2": 3.0, "I3": 2.5, "h": 0.5, "L": 6.0},
        {"I1": 2.0, "I2": 3.0, "I3": 2.5, "h": 2.0, "L": 1.1},
    ]
    numerical = Numerical(lambda v: Gyrostat((v["I1"], v["I2"], v["I3"]), (0.0, 0.0, v["h"])), samples)
    page = Derivation("The gyrostat", system, numerical)
    page.brackets("The angular momentum of body and rotor together is a point of so(3)*, with the minus bracket.",
                  {(L1, L2): -L3, (L2, L3): -L1, (L3, L1): -L2})
    page.hamiltonian("The energy is that of the carrier; the rotor's momentum is constant along the third axis.")
    spin = (L3 - h) / I3
    page.equations("Hamilton's equations.", {
        L1: L2 * spin - L3 * L2 / I2, L2: L3 * L1 / I1 - L1 * spin, L3: (1 / I2 - 1 / I1) * L1 * L2,
    })
    square = L1**2 + L2**2 + L3**2
    page.casimirs("The square of the momentum is a Casimir.", {Name(r"|L|^2", "|L|²"): square})
    along = (sympy.Integer(0), sympy.Integer(0), size)
    rate = (size - h) / I3
    first, second = size / I1 - rate, size / I2 - rate
    page.unstable_if(
        "Spin along the rotor's axis is an equilibrium. Its exponents are those of a free body whose third moment is "
        "the momentum divided by the spin.",
        along, positive_condition(-first * second), s * (s**2 + first * second),
    )
    page.stable_if(
        "The second variation is definite if the spin is slower, or faster, than the momentum divided by each of the "
        "other moments; a rotor can stabilise every axis.",
        along, [square / 2],
        sympy.Or(*(sympy.And(positive_condition(a * first), positive_condition(a * second)) for a in (1, -1))),
    )
    page.sphere("On a sphere of constant momentum, with the angle about the rotor's axis and the height.")
    return page.page()

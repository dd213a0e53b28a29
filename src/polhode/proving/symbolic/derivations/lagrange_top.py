"""The symmetric heavy top: its third integral, and the condition under which it sleeps."""

from __future__ import annotations

from polhode.algebra import SE3
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.derivation import Derivation, DerivationBroken, Numerical
from polhode.proving.symbolic.derivations.heavy_top import se3_brackets
from polhode.proving.symbolic.rendering import Equation, Name, Page
from polhode.proving.symbolic.second_variation import EXPONENT as s
from polhode.proving.symbolic.second_variation import characteristic_polynomial
from polhode.proving.symbolic.sign_conditions import positive_condition
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.heavy_top import HeavyTop


def derive() -> Page:
    """Return the page."""
    I1, I3, m, g, ell, S = sympy.symbols("I1 I3 m g l S", positive=True)
    nu = sympy.Symbol("nu", real=True)
    bracket = LiePoissonBracket(
        SE3(), ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"], parameters=[I1, I3, m, g, ell, S, nu]
    )
    P1, P2, P3, G1, G2, G3 = bracket.coordinates
    weight = m * g * ell
    system = SymbolicSystem(bracket, (P1**2 + P2**2) / (2 * I1) + P3**2 / (2 * I3) + weight * G3)
    samples = [
        {"I1": 1.0, "I3": 0.5, "m": 0.5, "g": 2.0, "l": 1.5, "S": 3.0},
        {"I1": 1.0, "I3": 0.5, "m": 0.5, "g": 2.0, "l": 1.5, "S": 2.0},
        {"I1": 1.0, "I3": 1.75, "m": 1.0, "g": 1.5, "l": 0.5, "S": 1.0},
    ]
    numerical = Numerical(lambda v: HeavyTop((v["I1"], v["I1"], v["I3"]), v["m"] * v["g"] * v["l"]), samples)
    page = Derivation("The Lagrange top", system, numerical)
    page.brackets("The bracket is that of se(3)*.", se3_brackets(bracket))
    page.hamiltonian("Two moments are equal, and the centre of mass lies on the axis of symmetry.")
    page.equations(
        "Hamilton's equations: the spin about the axis of symmetry does not change.",
        {
            P1: (1 / I3 - 1 / I1) * P2 * P3 + weight * G2,
            P2: (1 / I1 - 1 / I3) * P3 * P1 - weight * G1,
            P3: sympy.Integer(0),
            G1: G2 * P3 / I3 - G3 * P2 / I1,
            G2: G3 * P1 / I1 - G1 * P3 / I3,
            G3: (G1 * P2 - G2 * P1) / I1,
        },
    )
    unit, vertical = G1**2 + G2**2 + G3**2, P1 * G1 + P2 * G2 + P3 * G3
    page.casimirs("The Casimirs are the square of the upward direction and the vertical momentum.",
                  {Name(r"|\Gamma|^2", "|Γ|²"): unit, Name(r"\Pi\cdot\Gamma", "Π·Γ"): vertical})
    page.integral("The spin is an integral, and makes the top integrable.", Name(r"\Pi_3", "Π₃"), P3)
    page.further_integrals("It is the only further polynomial integral of degree 2 or less.", 2, [P3])
    sleeping = (0, 0, S, 0, 0, 1)
    page.stable_if(
        "The sleeping top spins upright. Its spin takes part like a Casimir, so that one multiplier is free; for the "
        "best one the second variation is definite if the spin is fast.",
        sleeping, [unit / 2, vertical, P3], S**2 > 4 * I1 * weight,
    )
    # with δΠ1 + iδΠ2 and δΓ1 + iδΓ2 the equations are two, and the polynomial is p times its conjugate
    p = I1 * (nu + S / I3) ** 2 - S * (nu + S / I3) + weight
    product = sympy.expand(s**2 * p.subs(nu, s / sympy.I) * p.subs(nu, -s / sympy.I) / I1**2)
    if sympy.simplify(product - characteristic_polynomial(system, sleeping)) != 0:
        raise DerivationBroken(f"The exponents of the sleeping top: {product} is not the characteristic polynomial.")
    threshold = sympy.factor(sympy.discriminant(p, nu))
    page.say(
        "The exponents that do not vanish are i times the roots of a quadratic, and their conjugates. They leave the "
        "imaginary axis if its discriminant is negative.",
        Equation(Name(r"p(\nu)", "p(ν)"), p), Equation(Name(r"\operatorname{disc} p", "disc p"), threshold),
        checks=("the characteristic polynomial is s² times p and its conjugate",),
    )
    page.exponents_if("So the sleeping top is unstable just where the second variation proves nothing, apart from "
                      "equality.", sleeping, positive_condition(-threshold))
    return page.page()

"""A derivation of another package, for ``polhode derive symmetric-body``."""

import sympy

from polhode.algebra import SO3
from polhode.proving import Derivation, LiePoissonBracket, Name, Numerical, Page, SymbolicSystem
from polhode.systems import FreeRigidBody

SAMPLES = [{"I1": 2.0, "I3": 1.3}, {"I1": 0.7, "I3": 1.2}]


def derive() -> Page:
    """A body with two equal moments keeps the momentum along the third axis."""
    I1, I3 = sympy.symbols("I1 I3", positive=True)
    bracket = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I3])
    L1, L2, L3 = bracket.coordinates
    system = SymbolicSystem(bracket, (L1**2 + L2**2) / (2 * I1) + L3**2 / (2 * I3))
    page = Derivation("The symmetric body", system,
                      Numerical(lambda v: FreeRigidBody((v["I1"], v["I1"], v["I3"])), SAMPLES))  # fmt: skip
    page.hamiltonian("Two moments are equal.")
    rate = 1 / I3 - 1 / I1
    equations = {L1: rate * L2 * L3, L2: -rate * L3 * L1, L3: 0}
    page.equations("The axis of the momentum turns about the third one.", equations)
    page.integral("The momentum along that axis is constant.", Name("L_3", "L3"), L3)
    return page.page()

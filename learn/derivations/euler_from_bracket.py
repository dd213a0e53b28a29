"""Euler's equations as Hamilton's, with the bracket of the angular momentum."""

import sympy
from sympy import Matrix


def derive(lines):
    """The minus bracket on functions of L."""
    L = L1, L2, L3 = sympy.symbols("L_1:4", real=True)
    I = I1, I2, I3 = sympy.symbols("I_1:4", positive=True)

    def gradient(f):
        return Matrix([sympy.diff(f, part) for part in L])

    def bracket(f, g):
        return -Matrix(L).dot(gradient(f).cross(gradient(g)))

    lines.define("Two functions of L have a bracket.",
                 r"\{F, G\} = -\mathbf L \cdot (\nabla F \times \nabla G)")  # fmt: skip
    for a, b, c in ((L1, L2, L3), (L2, L3, L1), (L3, L1, L2)):
        lines.equal("Two components give the third.", bracket(a, b), -c,
                    shown=rf"\{{{a}, {b}\}}")  # fmt: skip
    energy = sum(part**2 / (2 * moment) for part, moment in zip(L, I, strict=True))
    lines.define("The Hamilton function is the energy of turning. Its gradient is Ω.", ("H", energy))
    lines.equal("Check the gradient.", gradient(energy), Matrix([L1 / I1, L2 / I2, L3 / I3]), shown=r"\nabla H")
    law = Matrix([bracket(part, energy) for part in L])
    lines.equal("Hamilton's equation F' = {F, H} for the three components is L × Ω: Euler's equations.", law,
                Matrix(L).cross(gradient(energy)), shown=r"\{\mathbf L, H\}")  # fmt: skip
    general = sympy.Function("H")(*L)
    square = sum(part**2 for part in L)
    lines.equal("|L|² has a zero bracket with every function, whatever H is.", bracket(square, general), 0,
                shown=r"\{|\mathbf L|^2, H\}")  # fmt: skip
    lines.equal("Jacobi's identity for the components.",
                bracket(L1, bracket(L2, L3)) + bracket(L2, bracket(L3, L1)) + bracket(L3, bracket(L1, L2)), 0,
                shown=r"\{L_1,\{L_2,L_3\}\} + \{L_2,\{L_3,L_1\}\} + \{L_3,\{L_1,L_2\}\}")  # fmt: skip

"""From the bracket to Euler's equations, the Casimir and the conserved energy."""

import sympy


def derive(lines):
    """The minus bracket of so(3)."""
    L = sympy.Matrix(sympy.symbols("L_1:4", real=True))
    moments = sympy.symbols("I_1:4", positive=True)
    F = sympy.Function("F")(*L)
    energy = sum(x**2 / (2 * i) for x, i in zip(L, moments, strict=True))
    omega = sympy.Matrix([x / i for x, i in zip(L, moments, strict=True)])

    def gradient(function):
        return sympy.Matrix([sympy.diff(function, x) for x in L])

    def bracket(first, second):
        return -L.dot(gradient(first).cross(gradient(second)))

    lines.define("The bracket.", r"\{F, G\} = -\mathbf L \cdot (\nabla F \times \nabla G)")
    for i, j in ((0, 1), (1, 2), (2, 0)):
        lines.equal("Of components: gradients are unit vectors, and the cross product of two is the third."
                    if i == 0 else "And cyclically.", bracket(L[i], L[j]), -L[3 - i - j],
                    shown=rf"\{{L_{i + 1}, L_{j + 1}\}}")
    lines.equal("The gradient of the energy is the angular velocity.", gradient(energy), omega, shown=r"\nabla H")
    rates = sympy.Matrix([bracket(x, energy) for x in L])
    lines.equal("Put each component for F: its rate of change is a component of L × Ω. These are Euler's equations.",
                rates, L.cross(omega), shown=r"\dot{\mathbf L}")
    lines.equal("|L|² has the gradient 2L, and L · (L × anything) = 0: its bracket with any F vanishes.",
                sympy.expand(bracket(L.dot(L), F)), 0, shown=r"\{|\mathbf L|^2, F\}")
    lines.equal("H commutes with itself, as any function does: the energy is conserved.", bracket(energy, energy), 0,
                shown=r"\{H, H\}")
    lines.equal("With the other sign of the bracket, L would go the other way.", sympy.Matrix([-bracket(x, energy)
                for x in L]), omega.cross(L), shown=r"\dot{\mathbf L}_+")

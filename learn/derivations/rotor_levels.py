"""The levels of a rotor with one unit of angular momentum, and the area rule for a symmetric one."""

import sympy


def derive(lines):
    """Matrices of the components for J = 1, with ħ = 1."""
    A, B, C = sympy.symbols("A B C", positive=True)
    La, Lb, Lc = (sympy.Matrix(3, 3, _component(axis)) for axis in range(3))
    lines.define("For J = 1 there are three states. These matrices stand for the components along the body's axes with "
                 "their signs changed, with ħ = 1.",
                 ("L_a", La), ("L_b", Lb), ("L_c", Lc))
    lines.equal("They do not commute. With the signs changed back, the right side has −i.",
                La * Lb - Lb * La, sympy.I * Lc, shown="L_aL_b - L_bL_a")
    lines.equal("The length is sharp: L² = J(J+1) with J = 1.", La**2 + Lb**2 + Lc**2, 2 * sympy.eye(3),
                shown="L_a^2 + L_b^2 + L_c^2")
    lines.equal("The squares do commute, for J = 1.", La**2 * Lb**2, Lb**2 * La**2, shown="L_a^2 L_b^2")
    lines.equal("So the energy H = A L_a² + B L_b² + C L_c² is diagonal, and its three levels stand there.",
                A * La**2 + B * Lb**2 + C * Lc**2, sympy.diag(B + C, A + C, A + B), shown="H")
    J, n = sympy.symbols("J n", nonnegative=True)
    G = J + sympy.Rational(1, 2)
    lines.define("Now the area rule, for A = B and any J: allowed are the circles about axis c whose cap has n + ½ "
                 "cells on the sphere of radius G = J + ½.", (r"G\,\Omega_c", r"2\pi\left(n + \tfrac12\right)"))
    K = sympy.symbols("K", real=True)
    lines.solves("A cap that ends at L_c = K measures 2π(1 − K/G). So K is a whole number.",
                 sympy.Eq(G * 2 * sympy.pi * (1 - K / G), 2 * sympy.pi * (n + sympy.Rational(1, 2))), K, J - n)
    lines.equal("The energy on this circle is the exact level and a quarter of B more.",
                B * (G**2 - K**2) + C * K**2, B * (J * (J + 1) - K**2) + C * K**2 + B / 4,
                shown=r"B\,(G^2 - K^2) + C K^2")


def _component(axis):
    def entry(row, column):
        return -sympy.I * sympy.LeviCivita(axis, row, column)

    return entry

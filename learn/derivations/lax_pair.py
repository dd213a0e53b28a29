"""Euler's equations as a change of a matrix that keeps its eigenvalues, with a parameter."""

import sympy
from sympy import Matrix


def hat(v):
    """Return the antisymmetric matrix of v."""
    return Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def derive(lines):
    """Manakov's pair."""
    a = sympy.symbols("a_1:4", positive=True)
    W = Matrix(sympy.symbols("Omega_1:4", real=True))
    x = sympy.Symbol("lambda")
    A = sympy.diag(*a)
    moments = [a[1] + a[2], a[2] + a[0], a[0] + a[1]]
    L = Matrix([moment * part for moment, part in zip(moments, W, strict=True)])
    lines.define("Let aᵢ be the second moments of the mass, so that I₁ = a₂ + a₃ and cyclically.",
                 r"A = \operatorname{diag}(a_1, a_2, a_3)")  # fmt: skip
    lines.equal("Then the hat of L is", A * hat(W) + hat(W) * A, hat(L), shown=r"A\widehat\Omega + \widehat\Omega A")
    change = hat(L.cross(W))
    pair = (hat(L) + x * A**2) * (hat(W) + x * A) - (hat(W) + x * A) * (hat(L) + x * A**2)
    lines.equal("For every λ Euler’s equations are a commutator: the terms with λ and λ² cancel.", pair - change,
                sympy.zeros(3, 3), shown=r"[\widehat L + \lambda A^2,\ \widehat\Omega + \lambda A] - "
                                         r"\widehat{\mathbf L \times \boldsymbol\Omega}")  # fmt: skip
    l1, l2, l3 = momentum = sympy.symbols("L_1:4", real=True)
    whole = (hat(momentum) + x * A**2).det()
    lines.equal("So its eigenvalues, and with them its determinant, are conserved for every λ.",
                sympy.expand(whole), x**3 * (a[0] * a[1] * a[2]) ** 2
                + x * (a[0] ** 2 * l1**2 + a[1] ** 2 * l2**2 + a[2] ** 2 * l3**2),
                shown=r"\det(\widehat L + \lambda A^2)")  # fmt: skip
    energy = sum(part**2 / (2 * moment) for part, moment in zip(momentum, moments, strict=True))
    size = sum(part**2 for part in momentum)
    product = moments[0] * moments[1] * moments[2]
    new = sum(second**2 * part**2 for second, part in zip(a, momentum, strict=True))
    lines.equal("The conserved sum is 2 I₁I₂I₃ times the energy, less a multiple of |L|².",
                new, 2 * product * energy - (a[0] * a[1] + a[1] * a[2] + a[2] * a[0]) * size,
                shown=r"\sum_i a_i^2 L_i^2")  # fmt: skip

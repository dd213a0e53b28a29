"""The motion on the separatrix, through the middle axis."""

import sympy


def derive(lines):
    """Hyperbolic functions solve Euler's equations at the energy of the middle axis."""
    I1, I2, I3, c, u, v = sympy.symbols("I_1 I_2 I_3 c u v", positive=True)
    t = sympy.symbols("t", real=True)
    order = {I2: I1 + u**2, I3: I1 + u**2 + v**2}  # roots of differences are then u and v

    def ordered(expression):
        return expression.subs(order)

    A = c * sympy.sqrt(ordered(I1 / (I2 * (I3 - I1)))) * v
    B = c * sympy.sqrt(ordered(I3 / (I2 * (I3 - I1)))) * u
    rate = c * u * v / ordered(I2 * sympy.sqrt(I1 * I3))
    L1, L2, L3 = A * sympy.sech(rate * t), c * sympy.tanh(rate * t), B * sympy.sech(rate * t)
    lines.define("Try hyperbolic functions, with λ the rate of growth at axis 2 for |L| = c.",
                 r"L = \left(A \,\mathrm{sech}\,\lambda t,\; c \tanh \lambda t,\; B \,\mathrm{sech}\,\lambda t\right)",
                 (r"A^2", c**2 * I1 * (I3 - I2) / (I2 * (I3 - I1))), (r"B^2", c**2 * I3 * (I2 - I1) / (I2 * (I3 - I1))),
                 (r"\lambda^2", c**2 * (I2 - I1) * (I3 - I2) / (I1 * I2**2 * I3)))
    lines.equal("The squares of A and B add up to c², so |L|² = c² at all times, by sech² + tanh² = 1.",
                A**2 + B**2, c**2, shown="A^2 + B^2")
    lines.equal("The energy is that of a spin about axis 2. It is enough to see it at t = 0, where L₂ = 0.",
                A**2 / I1 + B**2 / ordered(I3) - c**2 / ordered(I2), 0,
                shown=r"\frac{A^2}{I_1} + \frac{B^2}{I_3} - \frac{c^2}{I_2}")
    left = [(L1, ordered(1 / I3 - 1 / I2) * L2 * L3), (L2, ordered(1 / I1 - 1 / I3) * L3 * L1),
            (L3, ordered(1 / I2 - 1 / I1) * L1 * L2)]
    names = [r"\dot L_1 - \left(\tfrac1{I_3} - \tfrac1{I_2}\right) L_2 L_3",
             r"\dot L_2 - \left(\tfrac1{I_1} - \tfrac1{I_3}\right) L_3 L_1",
             r"\dot L_3 - \left(\tfrac1{I_2} - \tfrac1{I_1}\right) L_1 L_2"]
    for k, ((x, y), name) in enumerate(zip(left, names, strict=True), 1):
        lines.equal(f"Euler's equation {k} holds.", (sympy.diff(x, t) - y).rewrite(sympy.exp), 0, shown=name)
    lines.tends("At late times L stands along axis 2.", sympy.tanh(t), t, sympy.oo, 1, direction="-")
    lines.tends("At early times it stood along the same axis the other way.", sympy.tanh(t), t, -sympy.oo, -1)

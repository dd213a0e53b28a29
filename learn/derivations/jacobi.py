"""Jacobi's functions solve Euler's equations, in short-axis mode."""

import sympy


def derive(lines):
    """Amplitudes, rate and parameter from energy and momentum."""
    I1, I2, I3, E, G = sympy.symbols("I_1 I_2 I_3 E G", positive=True)
    s, c, d, m, rate = sympy.symbols("s c d m lambda", real=True)
    A, B, C = sympy.symbols("A B C", positive=True)
    lines.define("Short-axis mode. Let G = |L|, and s, c, d stand for sn, cn, dn of λt with parameter m.",
                 r"L_1 = A\,c, \quad L_2 = B\,s, \quad L_3 = C\,d", r"c^2 = 1 - s^2, \quad d^2 = 1 - m s^2")
    squares = {A**2: I1 * (2 * E * I3 - G**2) / (I3 - I1), B**2: I2 * (2 * E * I3 - G**2) / (I3 - I2),
               C**2: I3 * (G**2 - 2 * E * I1) / (I3 - I1)}
    rate2 = (I3 - I2) * (G**2 - 2 * E * I1) / (I1 * I2 * I3)
    parameter = (I2 - I1) * (2 * E * I3 - G**2) / ((I3 - I2) * (G**2 - 2 * E * I1))
    lines.define("Claim: with these values they solve Euler's equations.",
                 *((sympy.latex(square), value) for square, value in squares.items()), (r"\lambda^2", rate2),
                 ("m", parameter))

    def known(expression):
        put = expression.subs({c**2: 1 - s**2, d**2: 1 - m * s**2})
        return sympy.factor(sympy.expand(put).subs(squares).subs(m, parameter))

    lines.equal("The length is G at all times.", known(A**2 * c**2 + B**2 * s**2 + C**2 * d**2), G**2,
                shown="A^2 c^2 + B^2 s^2 + C^2 d^2")
    lines.equal("The energy is E at all times.",
                known(A**2 * c**2 / (2 * I1) + B**2 * s**2 / (2 * I2) + C**2 * d**2 / (2 * I3)), E,
                shown=r"\frac{A^2 c^2}{2I_1} + \frac{B^2 s^2}{2I_2} + \frac{C^2 d^2}{2I_3}")
    products = (
        (1, r"A^2 \lambda^2 = \left(\tfrac1{I_2} - \tfrac1{I_3}\right)^2 B^2 C^2", A**2 * rate**2,
         ((1 / I2 - 1 / I3) * B * C) ** 2),
        (2, r"B^2 \lambda^2 = \left(\tfrac1{I_1} - \tfrac1{I_3}\right)^2 C^2 A^2", B**2 * rate**2,
         ((1 / I1 - 1 / I3) * C * A) ** 2),
        (3, r"m^2 C^2 \lambda^2 = \left(\tfrac1{I_1} - \tfrac1{I_2}\right)^2 A^2 B^2", C**2 * rate**2 * m**2,
         ((1 / I1 - 1 / I2) * A * B) ** 2),
    )
    for number, shown, left, right in products:
        lines.equal("The derivatives of cn, sn, dn are −λ s d, λ c d, −mλ s c, so Euler's equations ask for −Aλ = "
                    "(1/I₃ − 1/I₂)BC and so on. All amplitudes are positive and the signs agree; the squares:"
                    if number == 1 else f"Equation {number}:",
                    known(sympy.expand(left).subs(rate**2, rate2)), known(sympy.expand(right)), shown=shown)
    lines.equal("m < 1 is the condition of the mode: 1 − m has the sign of G² − 2E I₂.", 1 - parameter,
                (I3 - I1) * (G**2 - 2 * E * I2) / ((I3 - I2) * (G**2 - 2 * E * I1)), shown="1 - m")

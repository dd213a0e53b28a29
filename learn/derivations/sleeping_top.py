"""The second variation of an upright top, and when it is definite."""

import sympy


def derive(lines):
    """Energy, Casimirs and the axial momentum combined."""
    I1, I3, w, p = sympy.symbols("I_1 I_3 w p", positive=True)
    rate, k = sympy.symbols("lambda kappa", real=True)
    lines.names[w] = "mgl"
    P = sympy.Matrix(sympy.symbols("Pi_1:4", real=True))
    G = sympy.Matrix(sympy.symbols("Gamma_1:4", real=True))
    energy = (P[0]**2 + P[1]**2) / (2 * I1) + P[2]**2 / (2 * I3) + w * G[2]
    alpha, beta = rate - p / I3, (rate * p - w) / 2
    function = (energy - rate * P.dot(G) + alpha * P[2] + beta * G.dot(G) + k * (P[2] - p)**2
                + k * (G.dot(G) - 1)**2)
    lines.define("The upright top: Π = (0, 0, p), Γ = (0, 0, 1). All terms of V are conserved: energy, Casimirs, Π₃.",
                 r"V = H - \lambda\, \Pi\cdot\Gamma + \alpha\, \Pi_3 + \beta\, |\Gamma|^2 + \kappa\, (\Pi_3 - p)^2 + "
                 r"\kappa\, (|\Gamma|^2 - 1)^2", (r"\alpha", alpha), (r"\beta", beta))
    entries = [*P, *G]
    upright = {**dict.fromkeys(entries, 0), P[2]: p, G[2]: 1}
    slope = sympy.Matrix([function.diff(x) for x in entries]).subs(upright)
    lines.equal("With these α and β it is critical there: all six derivatives vanish.", slope.T, sympy.zeros(1, 6),
                shown=r"\nabla V")
    hessian = sympy.hessian(function, entries).subs(upright)
    across = hessian.extract([0, 3], [0, 3])
    lines.equal("Its second variation falls into three blocks. Two equal ones are across, in (Π₁, Γ₁) and (Π₂, Γ₂):",
                across, sympy.Matrix([[1 / I1, -rate], [-rate, rate * p - w]]), shown=r"D^2 V_{\perp}")
    lines.equal("the other across block is the same,", hessian.extract([1, 4], [1, 4]) - across, sympy.zeros(2),
                shown=r"D^2 V_{22} - D^2 V_{11}")
    mixed = hessian.extract([0, 3], [1, 2, 4, 5])
    lines.equal("nothing mixes them,", mixed, sympy.zeros(2, 4), shown=r"D^2 V_{\mathrm{mixed}}")
    along = hessian.extract([2, 5], [2, 5])
    lines.equal("and along the axis:", along, sympy.Matrix([[1 / I3 + 2 * k, -rate], [-rate, rate * p - w + 8 * k]]),
                shown=r"D^2 V_{\parallel}")
    lines.equal("The last is positive for large κ. The first is positive if its determinant is: a quadratic in λ.",
                across.det(), -(I1 * rate**2 - p * rate + w) / I1, shown=r"\det D^2 V_{\perp}")
    lines.equal("Choose λ = p/(2I₁), half way between the roots.", across.det().subs(rate, p / (2 * I1)),
                (p**2 - 4 * I1 * w) / (4 * I1**2), shown=r"\det D^2 V_{\perp}")

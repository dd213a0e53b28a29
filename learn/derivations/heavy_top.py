"""The heavy top from the bracket of se(3)*: equations, Casimirs, two of the integrals."""

import sympy


def derive(lines):
    """Bracket, equations, Casimirs, Lagrange's and Kovalevskaya's integral."""
    P = sympy.Matrix(sympy.symbols("Pi_1:4", real=True))
    G = sympy.Matrix(sympy.symbols("Gamma_1:4", real=True))
    moments = sympy.symbols("I_1:4", positive=True)
    x = sympy.Matrix(sympy.symbols("chi_1:4", real=True))
    w = sympy.symbols("w", positive=True)
    lines.names[w] = "mgl"
    omega = sympy.Matrix([p / i for p, i in zip(P, moments, strict=True)])
    energy = P.dot(omega) / 2 + w * G.dot(x)

    def gradient(function, vector):
        return sympy.Matrix([sympy.diff(function, entry) for entry in vector])

    def bracket(first, second):
        a, b, c, d = gradient(first, P), gradient(first, G), gradient(second, P), gradient(second, G)
        return -P.dot(a.cross(c)) - G.dot(a.cross(d) + b.cross(c))

    lines.define("The bracket of se(3)*, and the top's energy.",
                 r"\{F, K\} = -\Pi \cdot (F_\Pi \times K_\Pi) - \Gamma \cdot (F_\Pi \times K_\Gamma + F_\Gamma \times "
                 r"K_\Pi)", r"H = \tfrac12 \Pi \cdot I^{-1} \Pi + mgl\, \Gamma \cdot \chi")
    for k in range(3):
        lines.equal("Component by component the bracket with H gives dΠ/dt = Π × Ω + mgl Γ × χ: the torque of the "
                    "weight, in the body's axes." if k == 0 else f"Component {k + 1}.", bracket(P[k], energy),
                    (P.cross(omega) + w * G.cross(x))[k], shown=rf"\dot\Pi_{k + 1}")
    lines.equal("And dΓ/dt = Γ × Ω: the vertical stays where it is in space.",
                sympy.Matrix([bracket(entry, energy) for entry in G]) - G.cross(omega), sympy.zeros(3, 1),
                shown=r"\dot\Gamma - \Gamma \times \Omega")
    F = sympy.Function("F")(*P, *G)
    lines.equal("|Γ|² commutes with every F,", sympy.expand(bracket(G.dot(G), F)), 0, shown=r"\{|\Gamma|^2, F\}")
    lines.equal("and so does Π·Γ, the momentum about the vertical.", sympy.expand(bracket(P.dot(G), F)), 0,
                shown=r"\{\Pi\cdot\Gamma, F\}")
    lagrange = {moments[1]: moments[0], x[0]: 0, x[1]: 0, x[2]: 1}
    lines.equal("Lagrange: I₁ = I₂ and χ along axis 3. Then Π₃ is conserved.", bracket(P[2], energy).subs(lagrange), 0,
                shown=r"\dot\Pi_3")
    kowalevski = {moments[0]: 2 * moments[2], moments[1]: 2 * moments[2], x[0]: 1, x[1]: 0, x[2]: 0}
    I3 = moments[2]
    real = (P[0]**2 - P[1]**2) / (4 * I3**2) - w * G[0] / I3
    imaginary = P[0] * P[1] / (2 * I3**2) - w * G[1] / I3
    top = energy.subs(kowalevski)
    turning = P[2] / I3
    lines.define("Kovalevskaya: I₁ = I₂ = 2I₃ and χ along axis 1. Look at the complex number z.",
                 r"z = (\Omega_1 + i\Omega_2)^2 - \frac{mgl}{I_3}(\Gamma_1 + i\Gamma_2)")
    lines.equal("It turns at the rate Ω₃, and does nothing else: dz/dt = −iΩ₃ z. The real part:",
                bracket(real, top) - turning * imaginary, 0, shown=r"\mathrm{Re}(\dot z + i\Omega_3 z)")
    lines.equal("The imaginary part:", bracket(imaginary, top) + turning * real, 0,
                shown=r"\mathrm{Im}(\dot z + i\Omega_3 z)")
    lines.equal("So |z|² is conserved: Kovalevskaya's integral.", bracket(real**2 + imaginary**2, top), 0,
                shown=r"\frac{d}{dt}|z|^2")

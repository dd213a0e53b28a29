"""The energy–Casimir method: spins about the third axis, and the sleeping top."""

import sympy


def derive(lines):
    """A function of conserved quantities with a strict minimum at the equilibrium."""
    L = L1, L2, L3 = sympy.symbols("L_1:4", real=True)
    I1, I2, I3 = sympy.symbols("I_1:4", positive=True)
    length, k = sympy.symbols("l k", positive=True)
    H = L1**2 / (2 * I1) + L2**2 / (2 * I2) + L3**2 / (2 * I3)
    square = L1**2 + L2**2 + L3**2
    F = H - square / (2 * I3) + k * (square - length**2) ** 2 / 8
    at = {L1: 0, L2: 0, L3: length}
    lines.define("Spin about the third axis, at L = (0, 0, l). Add to H a function of the Casimir.",
                 ("F", r"H - \frac{|L|^2}{2 I_3} + \frac{k}{8}\left(|L|^2 - l^2\right)^2"))
    lines.equal("Its first variation vanishes there.",
                sympy.Matrix([sympy.diff(F, x) for x in L]).subs(at), sympy.zeros(3, 1), shown="dF(0, 0, l)")
    lines.equal("Its second variation is diagonal. It is positive if I₃ is the largest moment, for any k > 0.",
                sympy.hessian(F, L).subs(at), sympy.diag(1 / I1 - 1 / I3, 1 / I2 - 1 / I3, k * length**2),
                shown="D^2F(0, 0, l)")
    _top(lines)


def _top(lines):
    P1, P2, P3, U1, U2, U3 = point = sympy.symbols("Pi_1:4 Gamma_1:4", real=True)
    I1, I3, mgl = sympy.symbols("I_1 I_3 mgl", positive=True)
    p, a = sympy.symbols("p a", real=True)
    H = (P1**2 + P2**2) / (2 * I1) + P3**2 / (2 * I3) + mgl * U3
    F = H + a * (P1 * U1 + P2 * U2 + P3 * U3) - (mgl + a * p) * (U1**2 + U2**2 + U3**2) / 2 - (p / I3 + a) * P3
    lines.define("The upright top: Π = (0, 0, p), Γ = (0, 0, 1). Beside the Casimirs Π·Γ and |Γ|² its Π₃ is conserved.",
                 ("F", r"H + a\,\Pi\cdot\Gamma - \frac{mgl + ap}{2}\,|\Gamma|^2 - \left(\frac{p}{I_3} + a\right)\Pi_3"))
    at = {P1: 0, P2: 0, P3: p, U1: 0, U2: 0, U3: 1}
    lines.equal("Its first variation vanishes for every a.", sympy.Matrix([sympy.diff(F, x) for x in point]).subs(at),
                sympy.zeros(6, 1), shown="dF")
    block = sympy.hessian(F, (P1, U1)).subs(at)
    lines.equal("In (Π₁, Γ₁), and likewise in (Π₂, Γ₂), the second variation is this.", block,
                sympy.Matrix([[1 / I1, a], [a, -mgl - a * p]]), shown="D^2F")
    best = -p / (2 * I1)
    lines.equal("Its determinant is largest for a = −p/2I₁. It is positive for p² > 4 I₁ mgl: then the top sleeps.",
                block.det().subs(a, best) * I1, (p**2 - 4 * I1 * mgl) / (4 * I1), shown=r"I_1\det D^2F")

"""Euler's equations from the fixed momentum in space, with and without a torque."""

import sympy
from sympy import Matrix, cos, sin


def derive(lines):
    """The rule of moving frames, applied to L."""
    L = L1, L2, L3 = sympy.symbols("L_1:4", real=True)
    I = I1, I2, I3 = sympy.symbols("I_1:4", positive=True)
    momentum = Matrix(L)
    velocity = Matrix([part / moment for part, moment in zip(L, I, strict=True)])
    lines.define("The angular momentum in space is π = R L. Only a torque, in the body’s axes τ, changes it.",
                 r"\dot{\boldsymbol\pi} = R\, \boldsymbol\tau")  # fmt: skip
    lines.define("By the rule of moving frames (chapter 2) the left side is R times a sum.",
                 r"\frac{d}{dt}(R\,\mathbf L) = R\,(\dot{\mathbf L} + \boldsymbol\Omega \times \mathbf L)")  # fmt: skip
    lines.define("So, with L × Ω = −Ω × L,",
                 r"\dot{\mathbf L} = \mathbf L \times \boldsymbol\Omega + \boldsymbol\tau, \qquad "
                 r"\Omega_i = L_i / I_i")  # fmt: skip
    field = Matrix([(1 / I3 - 1 / I2) * L2 * L3, (1 / I1 - 1 / I3) * L3 * L1, (1 / I2 - 1 / I1) * L1 * L2])
    lines.equal("By components, along the principal axes:", momentum.cross(velocity), field,
                shown=r"\mathbf L \times \boldsymbol\Omega")  # fmt: skip
    W = Matrix(sympy.symbols("Omega_1:4", real=True))
    spin = Matrix([moment * part for moment, part in zip(I, W, strict=True)])
    old = Matrix([(I2 - I3) * W[1] * W[2], (I3 - I1) * W[2] * W[0], (I1 - I2) * W[0] * W[1]])
    lines.equal("In terms of Ω, as Euler wrote them: the right sides of I₁Ω̇₁, I₂Ω̇₂ and I₃Ω̇₃.", spin.cross(W), old,
                shown=r"(I\boldsymbol\Omega) \times \boldsymbol\Omega")  # fmt: skip
    lines.equal("Without a torque the energy is conserved, because L × Ω is at right angles to Ω.",
                velocity.dot(field), 0, shown=r"\dot E = \boldsymbol\Omega \cdot (\mathbf L \times \boldsymbol\Omega)")
    lines.equal("|L|² is conserved, because L × Ω is at right angles to L.", momentum.dot(field), 0,
                shown=r"\tfrac12 \tfrac{d}{dt} |\mathbf L|^2 = "
                      r"\mathbf L \cdot (\mathbf L \times \boldsymbol\Omega)")  # fmt: skip
    t, A = sympy.symbols("t A", real=True)
    rate = (1 / I1 - 1 / I3) * L3
    round_body = Matrix([A * cos(rate * t), A * sin(rate * t), L3])
    put = {L1: round_body[0], L2: round_body[1], I2: I1}
    lines.equal("If I₁ = I₂, then L goes round the axis of symmetry on a circle, at the rate ν.",
                sympy.diff(round_body, t) - field.subs(put), sympy.zeros(3, 1),
                shown=r"\mathbf L = (A\cos\nu t,\ A\sin\nu t,\ L_3): \quad "
                      r"\dot{\mathbf L} - \mathbf L \times \boldsymbol\Omega")  # fmt: skip
    lines.define("That rate has the sign of I₃ − I₁ times that of L₃: with the spin for a plate, against it for a rod.",
                 (r"\nu", sympy.factor(rate)))  # fmt: skip

"""Torque-free precession of a symmetric body: rates and cones in the body and in space."""

import sympy


def derive(lines):
    """Ω turns in the body at (I₃ − I₁)Ω₃/I₁; the axis turns in space at |L|/I₁."""
    I1, I3, a, spin = sympy.symbols("I_1 I_3 a Omega_3", positive=True)
    t = sympy.symbols("t", real=True)
    rate = (I3 - I1) * spin / I1
    lines.define("Euler's equations with I₁ = I₂: the third component of Ω is constant.",
                 r"I_1 \dot\Omega_1 = (I_1 - I_3)\,\Omega_2 \Omega_3,\quad I_1 \dot\Omega_2 = "
                 r"(I_3 - I_1)\,\Omega_3 \Omega_1,\quad I_3 \dot\Omega_3 = 0")
    omega = sympy.Matrix([a * sympy.cos(rate * t), a * sympy.sin(rate * t), spin])
    lines.define("Try an Ω that goes round axis 3 at the rate n, counted positive in the sense of the spin.",
                 r"\boldsymbol\Omega = (a \cos nt,\; a \sin nt,\; \Omega_3)", ("n", rate))
    momentum = sympy.Matrix([I1 * omega[0], I1 * omega[1], I3 * omega[2]])
    lines.equal("It solves them: dL/dt = L × Ω.", momentum.diff(t) - momentum.cross(omega), sympy.zeros(3, 1),
                shown=r"\dot{\mathbf L} - \mathbf L \times \boldsymbol\Omega")
    axis = sympy.Matrix([0, 0, 1])
    inverse = sympy.Matrix([x / I1 for x in momentum])
    lines.equal("L, Ω and the axis lie in one plane: Ω is L/I₁ and a spin about the axis.", omega,
                inverse - rate * axis, shown=r"\boldsymbol\Omega")
    lines.equal("So the axis, which is fixed in the body, moves in space with the velocity Ω × e = L × e/I₁. It turns "
                "about L at the rate |L|/I₁, always in the sense of L.", omega.cross(axis),
                momentum.cross(axis) / I1, shown=r"\boldsymbol\Omega \times \mathbf e_3")
    tilt = sympy.symbols("theta", positive=True)
    norm = I3 * spin / sympy.cos(tilt)
    lines.equal("With θ between axis and L, |L| cos θ = I₃Ω₃. The rate in space, φ̇, by the spin:", norm / I1,
                I3 * spin / (I1 * sympy.cos(tilt)), shown=r"\dot\phi = \frac{|\mathbf L|}{I_1}")
    lines.equal("And the spin is the sum of the turn about the axis, −n, and the part of φ̇ along it.",
                -rate + norm / I1 * sympy.cos(tilt), spin, shown=r"-n + \dot\phi \cos\theta")
    cone_body = a / spin
    cone_momentum = a * I1 / (I3 * spin)
    lines.equal("The angles of Ω and of L from the axis: L is nearer to the axis if I₃ > I₁ (disk, Earth), farther if "
                "I₃ < I₁ (rod).", cone_momentum, cone_body * I1 / I3,
                shown=r"\tan\theta = \frac{I_1 a}{I_3 \Omega_3}")
    lines.tends("A flat disk has I₃ = 2I₁. Nearly level, it wobbles twice for each spin.",
                (norm / I1 / spin).subs(I3, 2 * I1), tilt, 0, 2)

"""Euler's disk: the tilt law from a balance of torques, the energy, and how the tilt runs out."""

import sympy


def derive(lines):
    """The centre is at rest and the contact does not slip."""
    Omega, a, m, g, A = sympy.symbols("Omega a m g A", positive=True)
    alpha, spin = sympy.symbols(r"alpha \dot{\psi}", real=True)
    z = sympy.Matrix([0, 0, 1])
    up_face = sympy.Matrix([sympy.cos(alpha), 0, sympy.sin(alpha)])
    axis = sympy.Matrix([-sympy.sin(alpha), 0, sympy.cos(alpha)])
    lines.define("Components: horizontal towards the centre, horizontal along the rim, up. The vector e₂ runs up the "
                 "face from the contact to the centre, e₃ is the axis of the disk.", ("e_2", up_face), ("e_3", axis))
    omega = Omega * z + spin * axis
    lines.define("The tilt stays the same, the contact goes round at the rate Ω, and the disk turns in its own plane "
                 "at the rate ψ̇.", (r"\omega", omega))
    lines.solves("The centre is at rest, and so is the point of the disk that touches. So ω × (−a e₂) vanishes.",
                 sympy.Eq(omega.cross(-a * up_face)[1], 0), spin, -Omega * sympy.cos(alpha))
    rolling = omega.subs(spin, -Omega * sympy.cos(alpha))
    lines.equal("The disk turns about the diameter through the contact, slowly when the tilt is small.",
                rolling, Omega * sympy.sin(alpha) * up_face, shown=r"\omega")
    L = A * Omega * sympy.sin(alpha) * up_face
    change, torque = Omega * z.cross(L), (-a * up_face).cross(m * g * z)
    lines.equal("L = Aω is carried round at the rate Ω. This is its change.",
                change, A * Omega**2 * sympy.sin(alpha) * sympy.cos(alpha) * sympy.Matrix([0, 1, 0]),
                shown=r"\dot L = \Omega z\times L")
    lines.equal("The table pushes up with mg at the contact. This is its torque about the centre.",
                torque, m * g * a * sympy.cos(alpha) * sympy.Matrix([0, 1, 0]), shown=r"(-a\,e_2)\times mg\,z")
    law = sympy.sqrt(m * g * a / (A * sympy.sin(alpha)))
    square = sympy.Symbol("Omega^2", positive=True)
    lines.solves("Change and torque are equal. The factor cos α cancels, and the tilt law is left.",
                 sympy.Eq(change[1].subs(Omega**2, square), torque[1]), square, law**2)
    lines.equal("A thin uniform disk has A = ma²/4.", law.subs(A, m * a**2 / 4) ** 2, 4 * g / (a * sympy.sin(alpha)),
                shown=r"\Omega^2")
    lines.expands("A print on the face turns at Ω + ψ̇, seen from above. It slows down while the contact speeds up, "
                  "since Ω only grows as α^(−1/2).", Omega * (1 - sympy.cos(alpha)), alpha, 4, Omega * alpha**2 / 2)
    height, motion = m * g * a * sympy.sin(alpha), A * (law * sympy.sin(alpha)) ** 2 / 2
    lines.equal("The energy is two parts height and one part motion.", height + motion,
                sympy.Rational(3, 2) * m * g * a * sympy.sin(alpha),
                shown=r"mga\sin\alpha + \tfrac12 A\,\Omega^2\sin^2\alpha")
    _runs_out(lines)


def _runs_out(lines):
    c, q, s = sympy.symbols("c q s", positive=True)
    lines.define("Let losses take the energy away with a power proportional to α^(−q). At small tilt the energy is "
                 "proportional to α.", (r"\dot\alpha", r"-c\,\alpha^{-q}"))
    path = (c * (1 + q) * s) ** (1 / (1 + q))
    lines.equal("With s = t₀ − t, the time that is left, this is solved by a power.",
                -sympy.diff(path, s), -c * path ** (-q),
                shown=r"\alpha = \left(c(1+q)s\right)^{1/(1+q)}, \qquad \dot\alpha = -\frac{d\alpha}{ds}")
    exponent = s * sympy.diff(path ** sympy.Rational(-1, 2), s) / path ** sympy.Rational(-1, 2)
    lines.equal("The tilt has the exponent n = 1/(1+q) in the time that is left, and Ω has −n/2.",
                exponent, -1 / (2 * (1 + q)),
                shown=r"\frac{s}{\Omega}\frac{d\Omega}{ds}")

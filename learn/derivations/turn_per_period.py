"""How far the body turns about L while L runs once round its polhode."""

import sympy


def derive(lines):
    """The rate of precession is a dynamic part plus a part that only the path knows."""
    L = sympy.Matrix(sympy.symbols("L_1:4", positive=True))
    moments = sympy.symbols("I_1:4", positive=True)
    theta, tilt = sympy.symbols("theta vartheta", positive=True)
    omega = sympy.Matrix([one / moment for one, moment in zip(L, moments, strict=True)])
    third, G = sympy.Matrix([0, 0, 1]), sympy.sqrt(L.dot(L))
    across, turning = L[0] ** 2 + L[1] ** 2, L[0] * omega[0] + L[1] * omega[1]
    precession = (L / G).dot(third.cross(omega.cross(third))) / (across / G**2)
    lines.equal("In space the third axis e₃ has the velocity Ω × e₃. Its azimuth about L grows at this rate.",
                precession, G * turning / across,
                shown=r"\dot\varphi = \frac{L\cdot(e_3\times(\Omega\times e_3))}{G\,\sin^2\theta}")
    rate = L.cross(omega)
    azimuth = (L[0] * rate[1] - L[1] * rate[0]) / across
    lines.equal("Seen in the body, L goes round the third axis with the azimuth χ. Euler's equations give its rate.",
                azimuth, L[2] * turning / across - omega[2],
                shown=r"\dot\chi = \frac{L_1\dot L_2 - L_2\dot L_1}{L_1^2 + L_2^2}")
    lines.equal("The first rate is an energy part, 2E = L·Ω, plus cos θ = L₃/G times the second.",
                precession, L.dot(omega) / G + L[2] / G * (L[2] * turning / across - omega[2]),
                shown=r"\dot\varphi = \frac{2E}{G} + \cos\theta\,\dot\chi")
    lines.equal("Round a closed curve in the sense of growing χ, the second part adds up to 2π less the solid angle of "
                "the cap. This is so for a circle of constant θ; any curve follows by adding strips of dχ.",
                2 * sympy.pi - sympy.integrate(2 * sympy.pi * sympy.sin(tilt), (tilt, 0, theta)),
                2 * sympy.pi * sympy.cos(theta),
                shown=r"\oint\cos\theta\,d\chi = 2\pi - \int_0^\theta 2\pi\sin\vartheta\,d\vartheta")

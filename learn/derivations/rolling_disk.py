"""The rolling disk without losses: its two linear integrals, and the nutation about a steady roll."""

import sympy


def derive(lines):
    """Thin disk, any moments A and C."""
    theta = sympy.symbols("theta", positive=True)
    m, a, A, C, g, w2 = sympy.symbols("m a A C g omega_2", positive=True)
    x2, x3 = sympy.Function("omega_2")(theta), sympy.Function("omega_3")(theta)
    s, c = sympy.sin(theta), sympy.cos(theta)
    lines.define("The rates ω₂ (up the face) and ω₃ (axis) of a rolling disk change with the tilt θ only: divide their "
                 "equations of motion by the rate of θ.",
                 (r"\frac{d\omega_2}{d\theta}", (C / A) * sympy.Symbol("omega_3") - w2 * c / s),
                 (r"\frac{d\omega_3}{d\theta}", m * a**2 / (C + m * a**2) * w2))
    slope2 = (C / A) * x3 - x2 * c / s
    slope3 = m * a**2 / (C + m * a**2) * x2
    second = sympy.diff(slope3, theta).subs(sympy.diff(x2, theta), slope2)
    k = m * a**2 * C / (A * (C + m * a**2))
    lines.equal("Differentiate the second and put in the first: Legendre's equation with ν(ν+1) = −k.",
                second + c / s * slope3 - k * x3, 0,
                shown=r"\frac{d^2\omega_3}{d\theta^2} + \cot\theta\,\frac{d\omega_3}{d\theta} - k\,\omega_3")
    lines.equal("Here k is a ratio of moments. For the uniform disk C = ma²/2 and A = ma²/4.",
                k.subs(C, m * a**2 / 2).subs(A, m * a**2 / 4), sympy.Rational(4, 3),
                shown=r"k = \frac{ma^2\,C}{A\,(C + ma^2)}")
    push = A * x2**2 * c / s - (C + m * a**2) * x2 * x3 - m * g * a * c
    lines.define("The tilt obeys an equation in which ω₂ and ω₃ are now known functions of θ.",
                 (r"(A + ma^2)\,\ddot\theta",
                  r"A\omega_2^2\cot\theta - (C + ma^2)\,\omega_2\omega_3 - mga\cos\theta"))
    slope = sympy.diff(push, theta).subs({sympy.diff(x2, theta): slope2, sympy.diff(x3, theta): slope3})
    slope = slope.subs({x2: w2, x3: 0}).subs(g, A * w2**2 / (m * a * s))
    stiffness = w2**2 * (2 * A * c**2 / s**2 + A / s**2 + m * a**2 - A)
    lines.equal("Take its slope at the steady motion with the centre at rest, ω₃ = 0 and Aω₂² = mga sin θ.",
                slope, -stiffness, shown=r"\frac{d}{d\theta}\left[\ldots\right]")
    ratio = stiffness * s**2 / (w2**2 * (A + m * a**2))
    lines.equal("Small nutations have the rate n with n² = stiffness/(A + ma²); Ω = ω₂/sin θ. For the uniform disk:",
                ratio.subs(A, m * a**2 / 4), sympy.Rational(3, 5) + s**2 / 5, shown=r"\frac{n^2}{\Omega^2}")

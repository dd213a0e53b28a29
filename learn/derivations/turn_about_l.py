"""The azimuth of a body axis about L: a rate by energy and one by the motion of L in the body."""

import sympy


def derive(lines):
    """dφ/dt = 2E/G + cos θ dχ/dt."""
    L1, L2, L3 = L = sympy.Matrix(sympy.symbols("L_1:4", real=True))
    moments = sympy.symbols("I_1:4", positive=True)
    length, G = sympy.sqrt(L.dot(L)), sympy.Symbol("G", positive=True)
    omega = sympy.Matrix([x / i for x, i in zip(L, moments, strict=True)])
    twice = L.dot(omega)
    rates = L.cross(omega)
    axis = sympy.Matrix([0, 0, 1])
    across = L1**2 + L2**2
    velocity = omega.cross(axis)
    sideways = L.cross(axis)
    lines.define("All vectors along the body's axes. The axis e₃ is fixed in the body, so in space it moves with "
                 "Ω × e₃; going round L means moving along L × e₃.")
    lines.equal("Its angular rate about L is the velocity along L × e₃, over the distance from L. It is positive: the "
                "axis always goes on.", (G * velocity.dot(sideways) / sideways.dot(sideways)),
                G * (L1**2 / moments[0] + L2**2 / moments[1]) / across, shown=r"\dot\phi")
    longitude = (L1 * rates[1] - L2 * rates[0]) / across
    lines.define("In the body, L has the longitude χ about axis 3, and cos θ = L₃/G.",
                 r"\dot\chi = \frac{L_1 \dot L_2 - L_2 \dot L_1}{L_1^2 + L_2^2}")
    lines.equal("By Euler's equations the first rate is the sum of two. The component of Ω along L is 2E/G.",
                (G * (L1**2 / moments[0] + L2**2 / moments[1]) / across - twice / G - L3 / G * longitude
                 ).subs(G, length), 0,
                shown=r"\dot\phi - \frac{2E}{G} - \cos\theta\, \dot\chi")

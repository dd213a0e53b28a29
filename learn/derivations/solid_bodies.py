"""Moments of solid bodies by integration."""

import sympy
from sympy import cos, integrate, sin


def derive(lines):
    """Box, cylinder and ball, each from the squares of the coordinates."""
    M, a, b, c, R, h = sympy.symbols("M a b c R h", positive=True)
    x, y, z, r, phi, theta = sympy.symbols("x y z r varphi theta", real=True)
    lines.define("All that counts are the mean squares of the coordinates over the mass.",
                 r"I_1 = M\,(\langle y^2\rangle + \langle z^2\rangle) \quad\text{and cyclically}")  # fmt: skip
    edge = integrate(x**2 / a, (x, -a / 2, a / 2))
    lines.equal("Along an edge of length a of a box:", edge, a**2 / 12, shown=r"\langle x^2\rangle")
    height = integrate(y**2 / b, (y, -b / 2, b / 2)), integrate(z**2 / c, (z, -c / 2, c / 2))
    lines.equal("So a box has about its edge a", M * sum(height), M * (b**2 + c**2) / 12, shown="I_a")
    area = sympy.pi * R**2
    across = integrate(integrate((r * cos(phi)) ** 2 * r, (r, 0, R)), (phi, 0, 2 * sympy.pi)) / area
    lines.equal("Across a cylinder of radius R:", across, R**2 / 4, shown=r"\langle x^2\rangle = \langle y^2\rangle")
    lines.equal("Its moment about the axis is", 2 * M * across, M * R**2 / 2, shown="I_3")
    length = integrate(z**2 / h, (z, -h / 2, h / 2))
    lines.equal("Across the axis a height h counts as well.", M * (across + length), M * (R**2 / 4 + h**2 / 12),
                shown="I_1 = I_2")  # fmt: skip
    volume = integrate(integrate(r**2 * sin(theta), (r, 0, R)), (theta, 0, sympy.pi)) * 2 * sympy.pi
    shell = integrate(integrate((r * cos(theta)) ** 2 * r**2 * sin(theta), (r, 0, R)), (theta, 0, sympy.pi))
    ball = shell * 2 * sympy.pi / volume
    lines.equal("In a ball of radius R:", ball, R**2 / 5, shown=r"\langle z^2\rangle")
    lines.equal("So its moment about each line through the centre is", 2 * M * ball, 2 * M * R**2 / 5, shown="I")

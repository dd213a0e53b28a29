"""One recipe, three systems: two vortices, a pendulum, a chain of spins."""

import sympy


def derive(lines):
    """Bracket and Hamiltonian in, equations of motion out."""
    _vortices(lines)
    _pendulum(lines)
    _chain(lines)


def _vortices(lines):
    x1, y1, x2, y2 = sympy.symbols("x_1 y_1 x_2 y_2", real=True)
    G1, G2, d = sympy.symbols("Gamma_1 Gamma_2 d", positive=True)
    square = (x1 - x2) ** 2 + (y1 - y2) ** 2
    H = -G1 * G2 / (4 * sympy.pi) * sympy.log(square)

    def bracket(f, g):
        return sum((sympy.diff(f, x) * sympy.diff(g, y) - sympy.diff(f, y) * sympy.diff(g, x)) / strength
                   for x, y, strength in ((x1, y1, G1), (x2, y2, G2)))  # fmt: skip

    lines.define("Two whirlpools of strengths Γ₁ and Γ₂ in a plane. The two coordinates of each do not commute.",
                 (r"\{x_i, y_i\}", r"\frac{1}{\Gamma_i}"), ("H", r"-\frac{\Gamma_1\Gamma_2}{2\pi}\ln d"))
    lines.equal("Their distance d is conserved.", bracket(square, H), 0, shown=r"\{d^2, H\}")
    lines.equal("So is their centre of vorticity.", bracket(G1 * x1 + G2 * x2, H), 0,
                shown=r"\{\Gamma_1x_1 + \Gamma_2x_2, H\}")
    angle = sympy.atan2(y2 - y1, x2 - x1)
    turned = sympy.simplify(bracket(angle, H)).subs({x1: 0, y1: 0, x2: d, y2: 0})
    lines.equal("The line from one to the other turns at this rate.", turned, (G1 + G2) / (2 * sympy.pi * d**2),
                shown=r"\dot\vartheta = \{\vartheta, H\}")


def _pendulum(lines):
    theta, c, Pi = sympy.symbols("theta c Pi", real=True)
    P1, P2 = c * sympy.cos(theta), c * sympy.sin(theta)
    lines.define("A momentum Π and a vector P in the plane, with the bracket of se(2) and this energy.",
                 (r"\{\Pi, P_1\}", "-P_2"), (r"\{\Pi, P_2\}", "P_1"), (r"\{P_1, P_2\}", "0"),
                 ("H", r"\tfrac12\Pi^2 - P_1"))
    lines.equal("The equations are Ṗ₁ = ΠP₂, Ṗ₂ = −ΠP₁, Π̇ = P₂. The length of P is conserved, for any energy.",
                2 * P1 * Pi * P2 - 2 * P2 * Pi * P1, 0, shown=r"\frac{d}{dt}\left(P_1^2 + P_2^2\right)")
    rate = sympy.symbols(r"\dot\theta", real=True)
    lines.solves("With P = c (cos θ, sin θ) the first of them gives the rate of the angle.",
                 sympy.Eq(sympy.diff(P1, theta) * rate, Pi * P2), rate, -Pi)
    lines.equal("So θ̈ = −Π̇ = −P₂: this is the pendulum.", -P2, -c * sympy.sin(theta), shown=r"\ddot\theta")


def _chain(lines):
    S, J, k, phi, tilt = sympy.symbols("S J k phi vartheta", positive=True)

    def spin(angle):
        across = sympy.sin(tilt)
        return S * sympy.Matrix([across * sympy.cos(angle), across * sympy.sin(angle), sympy.cos(tilt)])

    lines.define("A chain of spins of length S, each coupled to its two neighbours. Each leans by ϑ, its neighbour "
                 "is turned by k.", (r"\dot S_j", r"J\,S_j\times(S_{j-1} + S_{j+1})"))
    rate = sympy.symbols("omega", real=True)
    torque = J * spin(phi).cross(spin(phi - k) + spin(phi + k))
    turning = rate * sympy.Matrix([0, 0, 1]).cross(spin(phi))
    solution = -2 * J * S * sympy.cos(tilt) * (1 - sympy.cos(k))
    lines.solves("If all spins turn about the third axis at the rate ω, one component of this equation gives ω.",
                 sympy.Eq(torque[0], turning[0]), rate, solution)
    lines.equal("The other components then hold as well: the wave is exact for any lean.",
                torque, turning.subs(rate, solution), shown=r"J\,S_j\times(S_{j-1} + S_{j+1}) = \omega\,e_3\times S_j")

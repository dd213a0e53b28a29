"""Minus for components along the body, plus along space: both from canonical brackets of Euler's angles."""

import sympy


def derive(lines):
    """Brackets of momenta in both frames."""
    phi, theta, psi, p, q, r = sympy.symbols("phi theta psi p_phi p_theta p_psi", real=True)
    angles, momenta = (phi, theta, psi), (p, q, r)
    s, c = sympy.sin, sympy.cos
    about_z = sympy.Matrix([[c(phi), -s(phi), 0], [s(phi), c(phi), 0], [0, 0, 1]])
    about_x = sympy.Matrix([[1, 0, 0], [0, c(theta), -s(theta)], [0, s(theta), c(theta)]])
    attitude = about_z * about_x * about_z.subs(phi, psi)
    lines.define("Attitude by Euler's angles, from body to space, and their canonical bracket.",
                 r"R = R_z(\phi)\, R_x(\theta)\, R_z(\psi)",
                 r"\{F, G\} = \sum_{a = \phi, \theta, \psi} \left( \frac{\partial F}{\partial a} "
                 r"\frac{\partial G}{\partial p_a} - \frac{\partial G}{\partial a} \frac{\partial F}{\partial p_a} "
                 r"\right)")
    rates = sympy.symbols("a b d", real=True)
    lines.names.update(zip(rates, (r"\dot\phi", r"\dot\theta", r"\dot\psi"), strict=True))
    turning = sum((attitude.diff(angle) * rate for angle, rate in zip(angles, rates, strict=True)), sympy.zeros(3))
    spin = (attitude.T * turning).applyfunc(sympy.simplify)
    omega = sympy.Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])
    body = sympy.Matrix([(p - r * c(theta)) * s(psi) / s(theta) + q * c(psi),
                         (p - r * c(theta)) * c(psi) / s(theta) - q * s(psi), r])
    work = sum(x * y for x, y in zip(momenta, rates, strict=True))
    lines.equal("The momentum along the body's axes is the L whose product with Ω is the sum of p times rate, for all "
                "rates of the angles.", body.dot(omega), work, shown=r"L_1 \Omega_1 + L_2 \Omega_2 + L_3 \Omega_3")
    for k, component in enumerate(body, 1):
        lines.define(f"Its component {k}.", (f"L_{k}", component))
    space = (attitude * body).applyfunc(sympy.simplify)
    lines.equal("In space π = R L. Its vertical component is the momentum that belongs to φ.", space[2], p,
                shown=r"\pi_3")

    def bracket(first, second):
        return sum(first.diff(a) * second.diff(m) - second.diff(a) * first.diff(m)
                   for a, m in zip(angles, momenta, strict=True))

    for i, j in ((0, 1), (1, 2), (2, 0)):
        k = 3 - i - j
        lines.equal("Along the body: minus." if i == 0 else "And cyclically.",
                    sympy.simplify(bracket(body[i], body[j]) + body[k]), 0,
                    shown=rf"\{{L_{i + 1}, L_{j + 1}\}} + L_{k + 1}")
    for i, j in ((0, 1), (1, 2), (2, 0)):
        k = 3 - i - j
        lines.equal("Along space: plus." if i == 0 else "And cyclically.",
                    sympy.simplify(bracket(space[i], space[j]) - space[k]), 0,
                    shown=rf"\{{\pi_{i + 1}, \pi_{j + 1}\}} - \pi_{k + 1}")
    mixed = sympy.Matrix(3, 3, lambda i, j: sympy.simplify(bracket(body[i], space[j])))
    lines.equal("Between body and space: zero, all nine.", mixed, sympy.zeros(3), shown=r"\{L_i, \pi_j\}")

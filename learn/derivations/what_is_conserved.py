"""Inner forces exert no torque, uniform gravity none about the centre of mass; L splits into two parts."""

import sympy
from sympy import Matrix


def derive(lines):
    """Three point masses with central forces, in uniform gravity."""
    m = sympy.symbols("m_1:4", positive=True)
    r = [Matrix(sympy.symbols(f"x_{k} y_{k} z_{k}", real=True)) for k in (1, 2, 3)]
    v = [Matrix(sympy.symbols(f"u_{k} v_{k} w_{k}", real=True)) for k in (1, 2, 3)]
    f12, f13, f23 = sympy.symbols("f_12 f_13 f_23", real=True)
    g = Matrix(sympy.symbols("g_1:4", real=True))
    lines.define("The force of mass j on mass i acts along the line between them, with any strength. The force of i "
                 "on j is opposite.",
                 r"\mathbf F_{ij} = f_{ij}\, (\mathbf r_i - \mathbf r_j), \qquad f_{ij} = f_{ji}")  # fmt: skip
    forces = [
        f12 * (r[0] - r[1]) + f13 * (r[0] - r[2]),
        f12 * (r[1] - r[0]) + f23 * (r[1] - r[2]),
        f13 * (r[2] - r[0]) + f23 * (r[2] - r[1]),
    ]
    inner = sum((a.cross(b) for a, b in zip(r, forces, strict=True)), sympy.zeros(3, 1))
    lines.equal("The torques of the inner forces cancel in pairs.", inner, sympy.zeros(3, 1),
                shown=r"\sum_{i \ne j} \mathbf r_i \times \mathbf F_{ij}")  # fmt: skip
    mass = sum(m)
    centre = sum((k * a for k, a in zip(m, r, strict=True)), sympy.zeros(3, 1)) / mass
    speed = sum((k * a for k, a in zip(m, v, strict=True)), sympy.zeros(3, 1)) / mass
    pull = sum(((a - centre).cross(k * g) for k, a in zip(m, r, strict=True)), sympy.zeros(3, 1))
    lines.define("Let R be the centre of mass, V its velocity, and M the whole mass.",
                 r"M \mathbf R = \sum_i m_i \mathbf r_i, \qquad M \mathbf V = \sum_i m_i \mathbf v_i")  # fmt: skip
    lines.equal("Uniform gravity exerts no torque about the centre of mass.", pull, sympy.zeros(3, 1),
                shown=r"\sum_i (\mathbf r_i - \mathbf R) \times m_i \mathbf g")  # fmt: skip
    whole = sum((k * a.cross(b) for k, a, b in zip(m, r, v, strict=True)), sympy.zeros(3, 1))
    about = sum((k * (a - centre).cross(b - speed) for k, a, b in zip(m, r, v, strict=True)), sympy.zeros(3, 1))
    lines.equal("Angular momentum about the origin is that of the centre and that about the centre: no mixed terms.",
                whole - mass * centre.cross(speed) - about, sympy.zeros(3, 1),
                shown=r"\sum_i m_i \mathbf r_i \times \mathbf v_i - M \mathbf R \times \mathbf V - "
                      r"\sum_i m_i (\mathbf r_i - \mathbf R) \times (\mathbf v_i - \mathbf V)")  # fmt: skip
    energy = sum(k * b.dot(b) for k, b in zip(m, v, strict=True)) / 2
    inside = sum(k * (b - speed).dot(b - speed) for k, b in zip(m, v, strict=True)) / 2
    lines.equal("The kinetic energy splits in the same way.", energy - mass * speed.dot(speed) / 2 - inside, 0,
                shown=r"\tfrac12 \sum_i m_i v_i^2 - \tfrac12 M V^2 - "
                      r"\tfrac12 \sum_i m_i |\mathbf v_i - \mathbf V|^2")  # fmt: skip

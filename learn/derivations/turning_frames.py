"""From the attitude R(t) to angular velocity: in the body, in space, and what changes between the two."""

import sympy
from sympy import Matrix, cos, sin


def hat(v):
    """Return the antisymmetric matrix of v."""
    return Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def about_z(angle):
    """Return the turn about the third axis."""
    return Matrix([[cos(angle), -sin(angle), 0], [sin(angle), cos(angle), 0], [0, 0, 1]])


def about_x(angle):
    """Return the turn about the first axis."""
    return Matrix([[1, 0, 0], [0, cos(angle), -sin(angle)], [0, sin(angle), cos(angle)]])


def derive(lines):
    """Euler's angles stand for any motion: all attitudes but the upright ones have them."""
    v = Matrix(sympy.symbols("v_1:4", real=True))
    w = Matrix(sympy.symbols("w_1:4", real=True))
    angles = phi, theta, psi = sympy.symbols("varphi theta psi", real=True)
    rates = dphi, dtheta, dpsi = sympy.symbols("dphi dtheta dpsi", real=True)
    lines.names.update({dphi: r"\dot\varphi", dtheta: r"\dot\theta", dpsi: r"\dot\psi"})
    lines.define("The hat makes a vector into an antisymmetric matrix.", (r"\widehat{\mathbf v}", hat(v)))
    lines.equal("That matrix multiplies as the cross product does.", hat(v) * w, v.cross(w),
                shown=r"\widehat{\mathbf v}\, \mathbf w")  # fmt: skip
    R = about_z(phi) * about_x(theta) * about_z(psi)
    lines.define("Write the attitude by three turns; its columns are the body’s axes, seen from space.",
                 r"R = R_z(\varphi)\, R_x(\theta)\, R_z(\psi), \quad "
                 r"\mathbf v_{\text{space}} = R\, \mathbf v_{\text{body}}")  # fmt: skip
    speed = sum((sympy.diff(R, a) * rate for a, rate in zip(angles, rates, strict=True)), sympy.zeros(3, 3))
    lines.equal("R keeps lengths.", R.T * R, sympy.eye(3), shown=r"R^T R")
    body = Matrix([
        dphi * sin(theta) * sin(psi) + dtheta * cos(psi),
        dphi * sin(theta) * cos(psi) - dtheta * sin(psi),
        dpsi + dphi * cos(theta),
    ])  # fmt: skip
    space = Matrix([
        dtheta * cos(phi) + dpsi * sin(theta) * sin(phi),
        dtheta * sin(phi) - dpsi * sin(theta) * cos(phi),
        dphi + dpsi * cos(theta),
    ])  # fmt: skip
    lines.equal("So its rate, brought back to the body, is antisymmetric.", R.T * speed + (R.T * speed).T,
                sympy.zeros(3, 3), shown=r"R^T \dot R + (R^T \dot R)^T")  # fmt: skip
    lines.define("Its vector is Ω, the angular velocity along the body’s axes.",
                 r"R^T \dot R = \widehat{\boldsymbol\Omega}", (r"\boldsymbol\Omega", body))  # fmt: skip
    lines.equal("Check that vector against the product.", R.T * speed, hat(body), shown=r"R^T \dot R")
    lines.equal("Multiplied the other way round, it is ω, the same arrow along the axes of space.",
                speed * R.T, hat(space), shown=r"\dot R R^T = \widehat{\boldsymbol\omega}")  # fmt: skip
    lines.equal("The two are one arrow.", R * body, space, shown=r"R\, \boldsymbol\Omega = \boldsymbol\omega")
    change = Matrix(sympy.symbols("dv_1:4", real=True))
    lines.names.update({x: rf"\dot v_{k}" for k, x in enumerate(change, 1)})
    lines.equal("A vector that changes by its components and by the turn of its axes changes in space by the sum.",
                speed * v + R * change - R * (change + body.cross(v)), sympy.zeros(3, 1),
                shown=r"\frac{d}{dt}(R\,\mathbf v) - "
                      r"R\left(\dot{\mathbf v} + \boldsymbol\Omega \times \mathbf v\right)")  # fmt: skip
    lines.equal("For Ω itself the second term vanishes: seen from space and from the body, Ω changes at the same rate.",
                body.cross(body), sympy.zeros(3, 1), shown=r"\boldsymbol\Omega \times \boldsymbol\Omega")  # fmt: skip

"""The slow precession of a fast gyroscope."""

import sympy
from sympy import Matrix, cos, sin


def derive(lines):
    """Angular momentum along the axis, which goes round the vertical."""
    t, theta, p, mgl = sympy.symbols("t theta p mgl", positive=True)
    rate = sympy.Symbol("nu", positive=True)
    lines.names.update({rate: r"\dot\varphi", mgl: "m g l"})
    axis = Matrix([sin(theta) * cos(rate * t), sin(theta) * sin(rate * t), cos(theta)])
    lines.define("The axis leans by θ and goes round the vertical at the rate φ̇.", (r"\mathbf n", axis))
    lines.define("Nearly all angular momentum is along it, p = I₃ω₃. The weight acts at the distance l.",
                 r"\mathbf L = p\, \mathbf n, \qquad \boldsymbol\tau = "
                 r"l\, \mathbf n \times (-m g\, \mathbf e_z)")  # fmt: skip
    change = sympy.diff(p * axis, t)
    torque = axis.cross(Matrix([0, 0, -mgl]))
    up = Matrix([0, 0, rate])
    lines.equal("L keeps its length and is carried round.", change, up.cross(p * axis),
                shown=r"\dot{\mathbf L} = \dot\varphi\, \mathbf e_z \times \mathbf L")  # fmt: skip
    lines.equal("The torque is level, and has the direction in which L is carried.", torque * rate * p, change * mgl,
                shown=r"p\, \dot\varphi\, \boldsymbol\tau = m g l\, \dot{\mathbf L}")  # fmt: skip
    lines.solves("So the law of motion holds if the axis goes round at this rate.", sympy.Eq(change[1], torque[1]),
                 rate, mgl / p)  # fmt: skip

"""The inertia matrix of point masses: angular momentum, energy, another point, the triangle inequality."""

import sympy
from sympy import Matrix


def matrix(mass, at):
    """Return the inertia matrix of a mass."""
    return mass * (at.dot(at) * sympy.eye(3) - at * at.T)


def derive(lines):
    """One mass first: a body is a sum."""
    m, n = sympy.symbols("m n", positive=True)
    x, y, z = sympy.symbols("x y z", real=True)
    r = Matrix([x, y, z])
    w = Matrix(sympy.symbols("Omega_1:4", real=True))
    J = matrix(m, r)
    lines.define("A mass m at r in a body that turns with Ω moves with the velocity Ω × r. Its angular momentum is",
                 r"\mathbf L = m\, \mathbf r \times (\boldsymbol\Omega \times \mathbf r)")  # fmt: skip
    rows = Matrix([[y**2 + z**2, -x * y, -x * z], [-x * y, x**2 + z**2, -y * z], [-x * z, -y * z, x**2 + y**2]])
    lines.define("Define the inertia matrix of the mass.", r"J = m\,(|\mathbf r|^2\, 1 - \mathbf r\, \mathbf r^T)")
    lines.equal("Its diagonal has the squared distances from the axes; beside it stand minus the products.",
                J, m * rows, shown="J")  # fmt: skip
    lines.equal("It gives the angular momentum.", m * r.cross(w.cross(r)) - J * w, sympy.zeros(3, 1),
                shown=r"m\, \mathbf r \times (\boldsymbol\Omega \times \mathbf r) - J\, \boldsymbol\Omega")  # fmt: skip
    lines.equal("It gives the kinetic energy.", m * w.cross(r).dot(w.cross(r)) / 2 - w.dot(J * w) / 2, 0,
                shown=r"\tfrac12 m\, |\boldsymbol\Omega \times \mathbf r|^2 - "
                      r"\tfrac12\, \boldsymbol\Omega \cdot J\, \boldsymbol\Omega")  # fmt: skip
    a, b, c = sympy.symbols("a_1:4", real=True)
    d = Matrix([a, b, c])
    one, other = r, -m / n * r
    lines.define("Take two masses whose centre of mass is at the origin, and shift both by d.",
                 (r"m\, \mathbf r + n\, \mathbf s", 0), (r"\mathbf s", r"-\tfrac{m}{n}\, \mathbf r"))  # fmt: skip
    shifted = matrix(m, one + d) + matrix(n, other + d)
    lines.equal("The mixed terms cancel. This is the parallel-axis theorem, with M = m + n.",
                shifted - matrix(m, one) - matrix(n, other) - matrix(m + n, d), sympy.zeros(3, 3),
                shown=r"J_{\text{shifted}} - J - M\,(|\mathbf d|^2\, 1 - \mathbf d\, \mathbf d^T)")  # fmt: skip
    lines.equal("Two moments exceed the third by twice the squared distance along its axis, which is never negative.",
                J[0, 0] + J[1, 1] - J[2, 2], 2 * m * z**2, shown="J_{11} + J_{22} - J_{33}")  # fmt: skip

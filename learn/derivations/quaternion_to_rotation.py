"""The rotation of a unit quaternion, entry by entry."""

import sympy
from sympy import Matrix, cos, sin


def derive(lines):
    """The matrix of v → q v q̄, and that it is a rotation by twice the quaternion's angle."""
    a, b, c, d = entries = sympy.symbols("a b c d", real=True)
    x, y, z = sympy.symbols("x y z", real=True)
    alpha = sympy.symbols("alpha", real=True)
    half = alpha / 2
    norm = sum(entry**2 for entry in entries)
    matrix = Matrix([
        [a**2 + b**2 - c**2 - d**2, 2 * (b * c - a * d), 2 * (b * d + a * c)],
        [2 * (b * c + a * d), a**2 - b**2 + c**2 - d**2, 2 * (c * d - a * b)],
        [2 * (b * d - a * c), 2 * (c * d + a * b), a**2 - b**2 - c**2 + d**2],
    ])  # fmt: skip
    lines.names[norm] = "|q|^2"
    turned = _product(_product(entries, (0, x, y, z)), (a, -b, -c, -d))
    lines.equal("Multiply out q v q̄ for q = a + b i + c j + d k. The real part is zero, the other three are linear in "
                "v.", Matrix(turned), Matrix([0, *(matrix * Matrix([x, y, z]))]),
                shown=r"q\,\mathbf v\,\bar q")  # fmt: skip
    identity = norm**2 * sympy.eye(3)
    lines.equal("Its matrix R(q) is orthogonal if |q| = 1.", matrix.T * matrix, identity, shown="R^T R")
    lines.equal("Its determinant is then 1.", matrix.det(), sympy.expand(norm**3), shown=r"\det R")
    lines.equal("Since b² + c² + d² = 1 − a², the trace has only a in it.", matrix.trace(), 4 * a**2 - norm,
                shown=r"\operatorname{tr} R")  # fmt: skip
    lines.equal("With a = cos(α/2) this is the trace of a turn by α.", 4 * cos(half) ** 2 - 1, 1 + 2 * cos(alpha),
                shown=r"\operatorname{tr} R")  # fmt: skip
    about = {a: cos(half), b: 0, c: 0, d: sin(half)}
    turn = Matrix([[cos(alpha), -sin(alpha), 0], [sin(alpha), cos(alpha), 0], [0, 0, 1]])
    lines.equal("For q = cos(α/2) + k sin(α/2) it is the turn about the third axis, in the right sense.",
                matrix.subs(about), turn, shown="R")  # fmt: skip
    opposite = matrix.subs({entry: -entry for entry in entries}, simultaneous=True)
    lines.equal("q and −q give the same turn.", opposite - matrix, sympy.zeros(3), shown="R(-q) - R(q)")


def _product(p, q):
    """Return the product of two quaternions, real parts first."""
    (a, b, c, d), (e, f, g, h) = p, q
    return (a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e)  # fmt: skip

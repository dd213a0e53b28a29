"""Which axis a curve of equal energy on the sphere goes round, by arithmetic alone."""

import sympy


def derive(lines):
    """Take one surface from the other, and see which part of L can never vanish."""
    L1, _, L3 = parts = sympy.symbols("L_1:4", real=True)
    I1, x, y = sympy.symbols("I_1 x y", positive=True)
    I2, I3 = sympy.symbols("I_2 I_3", positive=True)
    length = sum(part**2 for part in parts)
    twice = sum(part**2 / moment for part, moment in zip(parts, (I1, I2, I3), strict=True))
    lines.define("The sphere, and the egg.", (r"|\mathbf L|^2", length), ("2E", twice))
    height = (1 / I1 - 1 / I2) * L1**2 - (1 / I2 - 1 / I3) * L3**2
    lines.equal("Divide the first by I₂ and take it from the second. L₂ drops out.", twice - length / I2, height,
                shown=r"2E - |\mathbf L|^2/I_2")  # fmt: skip
    order = {I3: I1 + x + y, I2: I1 + x}
    lines.holds("I₁ is the smallest moment and I₃ the largest. So a part L₁ raises the energy above that of the pass.",
                sympy.simplify((1 / I1 - 1 / I2).subs(order)) > 0,
                shown=r"\frac{1}{I_1} - \frac{1}{I_2} > 0")  # fmt: skip
    lines.holds("And a part L₃ lowers it.", sympy.simplify((1 / I2 - 1 / I3).subs(order)) > 0,
                shown=r"\frac{1}{I_2} - \frac{1}{I_3} > 0")  # fmt: skip
    lines.equal("With less energy than at the pass, the left side is negative. L₃ can then never become zero, since "
                "this would remain, which is not negative. So L stays on its side of axis 3 and goes round it.",
                height.subs(L3, 0), (1 / I1 - 1 / I2) * L1**2,
                shown=r"\left(2E - |\mathbf L|^2/I_2\right)\Big|_{L_3 = 0}")  # fmt: skip
    lines.equal("With more energy the same holds of L₁, and L goes round axis 1.", height.subs(L1, 0),
                -(1 / I2 - 1 / I3) * L3**2,
                shown=r"\left(2E - |\mathbf L|^2/I_2\right)\Big|_{L_1 = 0}")  # fmt: skip

"""What the linearised equations say about small tilts from each principal axis."""

import sympy


def derive(lines):
    """Exponents of the spin about each of the three axes."""
    L1, L2, L3 = L = sympy.symbols("L_1:4", real=True)
    I1, I2, I3 = moments = sympy.symbols("I_1:4", positive=True)
    c, a, b = sympy.symbols("Omega a b", positive=True)
    rates = sympy.Matrix([(1 / I3 - 1 / I2) * L2 * L3, (1 / I1 - 1 / I3) * L3 * L1, (1 / I2 - 1 / I1) * L1 * L2])
    lines.define("Euler's equations, along the principal axes.",
                 *((rf"\dot L_{k}", rate) for k, rate in enumerate(rates, 1)))
    matrix = rates.jacobian(L)
    about = {i: matrix.subs({x: moments[i] * c if j == i else 0 for j, x in enumerate(L)}) for i in range(3)}
    middle = about[1]
    lines.equal("Spin about axis 2: L₂ = I₂Ω. To first order L₂ does not change, and the small L₁ and L₃ drive each "
                "other.", middle * sympy.Matrix(L),
                sympy.Matrix([c * (I2 / I3 - 1) * L3, 0, c * (1 - I2 / I1) * L1]),
                shown=r"\frac{d}{dt} \begin{pmatrix} L_1 \\ \delta L_2 \\ L_3 \end{pmatrix}")
    growth = c**2 * (I2 - I1) * (I3 - I2) / (I1 * I3)
    lines.equal("Differentiate once more and put one into the other: both obey the same equation, with λ² the product "
                "of the two factors.", middle[0, 2] * middle[2, 0], growth, shown=r"\lambda^2")
    order = {I2: I1 + a, I3: I1 + a + b}
    lines.holds("For I₁ < I₂ < I₃, that is I₂ = I₁ + a and I₃ = I₂ + b with a and b positive, λ² is positive: tilts "
                "from axis 2 grow as exp(λt).", sympy.simplify(growth.subs(order)) > 0, shown=r"\lambda^2 > 0")
    for i, (j, k) in ((0, (1, 2)), (2, (0, 1))):
        square = about[i][j, k] * about[i][k, j]
        away = (moments[k] - moments[i]) * (moments[j] - moments[i])
        value = -(c**2) * away / (moments[j] * moments[k])
        lines.equal(f"The same about axis {i + 1}.", square, value, shown=r"\lambda^2")
        lines.holds("It is negative, since both differences have the same sign: tilts circle at the rate √(−λ²).",
                    sympy.factor(square.subs(order)) < 0, shown=r"\lambda^2 < 0")
    flat = sympy.sqrt((growth / c**2).subs(I3, I1 + I2))
    lines.equal("A flat body has I₃ = I₁ + I₂.", flat**2, (I2 - I1) / (I1 + I2),
                shown=r"\left(\lambda / \Omega\right)^2")

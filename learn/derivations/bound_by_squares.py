"""The two identities behind the bound of the angle between Ω and L."""

import sympy
from sympy import Matrix, sqrt


def derive(lines):
    """What is missing from equality in both steps of the proof, as products of squares."""
    I1, I2, I3 = moments = sympy.symbols("I_1:4", positive=True)
    rates = Matrix(sympy.symbols("Omega_1:4", real=True))
    momentum = Matrix([moment * rate for moment, rate in zip(moments, rates, strict=True)])
    G, W = sympy.symbols("G W", positive=True)
    mean = (I1 + I3) * rates.dot(momentum)
    missing = (I2 - I1) * (I3 - I2) * rates[1] ** 2
    lines.equal("The first step misses equality by a term that only axis 2 has, and that is not negative.",
                mean - momentum.dot(momentum) - I1 * I3 * rates.dot(rates), missing,
                shown=r"(I_1 + I_3)\,\boldsymbol\Omega\cdot\mathbf L - |\mathbf L|^2 "
                      r"- I_1 I_3 |\boldsymbol\Omega|^2")  # fmt: skip
    lines.equal("The second step, with G = |L| and W = |Ω|, misses it by a square.",
                G**2 + I1 * I3 * W**2 - 2 * sqrt(I1 * I3) * G * W, (G - sqrt(I1 * I3) * W) ** 2)  # fmt: skip
    lines.equal("From the least cosine follows the largest sine.", 1 - 4 * I1 * I3 / (I1 + I3) ** 2,
                ((I3 - I1) / (I3 + I1)) ** 2, shown=r"\sin^2\delta_{max}")  # fmt: skip
    extreme = {rates[0]: sqrt(I3), rates[1]: 0, rates[2]: sqrt(I1)}
    cosine = (rates.dot(momentum) ** 2 / (rates.dot(rates) * momentum.dot(momentum))).subs(extreme)
    lines.equal("Both are equalities for Ω = (√I₃, 0, √I₁).", cosine, 4 * I1 * I3 / (I1 + I3) ** 2,
                shown=r"\cos^2\delta")  # fmt: skip

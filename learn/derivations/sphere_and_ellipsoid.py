"""Why energy and |L| are kept, what is left of the sphere, and how long a round takes."""

import sympy


def derive(lines):
    """Two conserved functions, the curves where they meet, and the time along them."""
    L = L1, L2, L3 = sympy.symbols("L_1:4", real=True)
    moments = I1, I2, I3 = sympy.symbols("I_1:4", positive=True)
    G, e = sympy.symbols("G e", positive=True)
    lines.names[e] = "2E"
    rates = ((1 / I3 - 1 / I2) * L2 * L3, (1 / I1 - 1 / I3) * L3 * L1, (1 / I2 - 1 / I1) * L1 * L2)
    names = [rf"\dot L_{k}" for k in (1, 2, 3)]
    lines.define("Euler's equations give the rate of each component of L along the body's axes.",
                 *zip(names, rates, strict=True))  # fmt: skip
    size = sum(part**2 for part in L)
    twice = sum(part**2 / moment for part, moment in zip(L, moments, strict=True))

    def rate(f):
        return sum(sympy.diff(f, part) * v for part, v in zip(L, rates, strict=True))

    lines.equal("Multiply each by its component and add: all three terms cancel. |L|² stays.", rate(size), 0,
                shown=r"\frac{d}{dt}\left(L_1^2 + L_2^2 + L_3^2\right)")  # fmt: skip
    lines.equal("Multiply each by its component over its moment and add: they cancel again. The energy stays.",
                rate(twice), 0, shown=r"\frac{d}{dt}\sum_i \frac{L_i^2}{I_i}")  # fmt: skip
    lines.equal("Subtract the sphere over I₃ from the energy. Near axis 3 the curves are ellipses.", twice - size / I3,
                (1 / I1 - 1 / I3) * L1**2 + (1 / I2 - 1 / I3) * L2**2,
                shown=r"2E - \frac{|\mathbf L|^2}{I_3}")  # fmt: skip
    lines.equal("The same with I₁: near axis 1 they are ellipses.", size / I1 - twice,
                (1 / I1 - 1 / I2) * L2**2 + (1 / I1 - 1 / I3) * L3**2,
                shown=r"\frac{|\mathbf L|^2}{I_1} - 2E")  # fmt: skip
    lines.equal("The same with I₂: near axis 2 they are hyperbolas, as the signs differ.", twice - size / I2,
                (1 / I1 - 1 / I2) * L1**2 - (1 / I2 - 1 / I3) * L3**2,
                shown=r"2E - \frac{|\mathbf L|^2}{I_2}")  # fmt: skip
    first = (e - G**2 / I3 - (1 / I2 - 1 / I3) * L2**2) / (1 / I1 - 1 / I3)
    third = (G**2 / I1 - e - (1 / I1 - 1 / I2) * L2**2) / (1 / I1 - 1 / I3)
    lines.define("Solve the fourth and the fifth line for L₁² and L₃², with |L| = G.",
                 (r"L_1^2", first), (r"L_3^2", third))  # fmt: skip
    lines.equal("They have the right length.", first + L2**2 + third, G**2, shown="L_1^2 + L_2^2 + L_3^2")
    lines.equal("They have the right energy.", first / I1 + L2**2 / I2 + third / I3, e,
                shown=r"\sum_i \frac{L_i^2}{I_i}")  # fmt: skip
    lines.equal("So the rate of L₂ is a function of L₂ alone, and the time along the curve is an integral.",
                (rates[1] ** 2).subs({L1: sympy.sqrt(first), L3: sympy.sqrt(third)}),
                (e - G**2 / I3 - (1 / I2 - 1 / I3) * L2**2) * (G**2 / I1 - e - (1 / I1 - 1 / I2) * L2**2),
                shown=r"\dot L_2^{\,2}")  # fmt: skip

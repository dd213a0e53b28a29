"""Why energy and |L| are kept, and what is left of the sphere."""

import sympy


def derive(lines):
    """Euler's equations keep two functions."""
    L1, L2, L3 = L = sympy.symbols("L_1:4", real=True)
    I1, I2, I3 = I = sympy.symbols("I_1:4", positive=True)
    rates = ((1 / I3 - 1 / I2) * L2 * L3, (1 / I1 - 1 / I3) * L3 * L1, (1 / I2 - 1 / I1) * L1 * L2)
    names = [rf"\dot L_{k}" for k in (1, 2, 3)]
    lines.define("Euler's equations give the rate of each component of L along the body's axes.",
                 *zip(names, rates, strict=True))
    energy = sum(l**2 / (2 * i) for l, i in zip(L, I, strict=True))

    def rate(f):
        return sum(sympy.diff(f, x) * v for x, v in zip(L, rates, strict=True))

    lines.equal("Multiply each by its component and add: all three terms cancel. |L|² stays.",
                rate(L1**2 + L2**2 + L3**2), 0, shown=r"\frac{d}{dt}\left(L_1^2 + L_2^2 + L_3^2\right)")
    lines.equal("Multiply each by its component over its moment and add: they cancel again. The energy stays.",
                rate(energy), 0, shown=r"\frac{d}{dt}\sum_i \frac{L_i^2}{2 I_i}")

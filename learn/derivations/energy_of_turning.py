"""The energy of turning, by Ω, by both arrows, and by L."""

import sympy


def derive(lines):
    """Half of the sum of products, and its form on which the second surface rests."""
    m, r, w = sympy.symbols("m r Omega", positive=True)
    moments = sympy.symbols("I_1:4", positive=True)
    rates = sympy.symbols("Omega_1:4", real=True)
    parts = sympy.symbols("L_1:4", real=True)
    lines.equal("A piece of mass m at a distance r from the line has the speed rΩ and the moment of inertia m r². "
                "Twice its energy of motion, m v², is its moment times Ω².", m * (r * w) ** 2, (m * r**2) * w**2,
                shown="m v^2")  # fmt: skip
    twice = sum(moment * rate**2 for moment, rate in zip(moments, rates, strict=True))
    lines.define("About its three principal axes the body does this with three moments. For an Ω in between, the three "
                 "energies add up.", ("2E", twice))  # fmt: skip
    both = sum(part * rate for part, rate in zip(parts, rates, strict=True))
    put = {part: moment * rate for part, moment, rate in zip(parts, moments, rates, strict=True)}
    lines.equal("Write L₁ for I₁Ω₁ and so on: each part of one arrow times the same part of the other. This sum is the "
                "product of both lengths and the cosine of the angle between them.", both.subs(put), twice,
                shown=sympy.latex(both))  # fmt: skip
    by_momentum = sum(part**2 / moment for part, moment in zip(parts, moments, strict=True))
    lines.equal("Or write it with L alone: a part along an axis with a large moment costs little energy.",
                by_momentum.subs(put), twice, shown=sympy.latex(by_momentum))  # fmt: skip
    some = sympy.symbols("x y z", positive=True)
    lines.holds("No term is ever negative. So the cosine is positive, and the angle is less than 90°.",
                twice.subs(dict(zip(rates, some, strict=True))) > 0, shown=r"2E > 0")  # fmt: skip

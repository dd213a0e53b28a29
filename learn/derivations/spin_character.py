"""Kirillov's character formula for spins: a sum over states is an integral over the sphere of radius s + ½."""

import sympy


def derive(lines):
    """One line for each of the first spins; the proof in the text covers all."""
    theta, z, r = sympy.symbols("theta z r", positive=True)
    inside = sympy.integrate(sympy.cos(theta * z), (z, -r, r))
    lines.equal("The symplectic area of a strip of height dz is 2π dz on any sphere. So the integral over the sphere "
                "of radius r is this. The imaginary part vanishes by symmetry.",
                inside, 2 * sympy.sin(r * theta) / theta, shown=r"\frac{1}{2\pi}\int e^{i\theta z}\,d\varphi\,dz")
    for twice in (1, 2, 3, 4):
        s = sympy.Rational(twice, 2)
        total = sum(sympy.cos((s - k) * theta) for k in range(twice + 1))
        lines.equal(f"The trace of a turn by θ for s = {s}, times sin(θ/2), is sin of (s + ½)θ.",
                    total * sympy.sin(theta / 2), sympy.sin((s + sympy.Rational(1, 2)) * theta),
                    shown=rf"\chi_{{{sympy.latex(s)}}}(\theta)\,\sin\tfrac\theta2")
    s = sympy.symbols("s", positive=True)
    half = sympy.Rational(1, 2)
    lines.tends("At θ → 0 the formula counts: the number of states is the area over 2π, exactly, for the radius s + ½.",
                sympy.sin((s + half) * theta) / sympy.sin(theta / 2), theta, 0, 2 * s + 1)
    lines.equal("The mean of z² over the states falls short of that over the sphere of radius s + ½ by a twelfth.",
                s * (s + 1) / 3, (s + half) ** 2 / 3 - sympy.Rational(1, 12), shown=r"\frac{s(s+1)}{3}")

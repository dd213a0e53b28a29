"""The motion on the separatrix, in hyperbolic functions."""

import sympy


def derive(lines):
    """From one end of axis 2 to the other, in infinite time."""
    s = sympy.Symbol("s", real=True)
    G, I1, I2, I3 = sympy.symbols("G I_1:4", positive=True)
    a, b = sympy.symbols("a b", positive=True)
    lines.define("Abbreviate the two differences of inverse moments; both are positive for I₁ < I₂ < I₃.",
                 (r"a", 1 / I1 - 1 / I2), (r"b", 1 / I2 - 1 / I3))  # fmt: skip
    root = sympy.sqrt(a * b)
    first = G * sympy.sqrt(b / (a + b)) / sympy.cosh(s)
    second = G * sympy.tanh(s)
    third = G * sympy.sqrt(a / (a + b)) / sympy.cosh(s)
    lines.define("Try, with s = λt and λ = G√(ab):", (r"L_1", first), (r"L_2", second), (r"L_3", third))
    lines.equal("It stays on the sphere.", first**2 + second**2 + third**2, G**2, shown=r"|\mathbf L|^2")
    lines.equal("It stays in a plane through axis 2: the polhode is half of a great circle.",
                a * first**2 - b * third**2, 0, shown="a\\,L_1^2 - b\\,L_3^2")  # fmt: skip
    speed = G * root
    for name, value, field in (
        ("1", first, -b * second * third), ("2", second, (a + b) * third * first), ("3", third, -a * first * second),
    ):  # fmt: skip
        lines.equal(f"Euler's equation for component {name}:", sympy.diff(value, s) * speed, field,
                    shown=rf"\dot L_{name}")  # fmt: skip
    lines.tends("L goes from one end of axis 2 to the other, and reaches neither.", second, s, sympy.oo, G, "-")

"""The wobble of a body whose figure follows its axis of rotation in part."""

import sympy


def derive(lines):
    """Liouville's equations to first order in the tilt."""
    A, C, rate = sympy.symbols("A C Omega", positive=True)
    kappa = sympy.symbols("kappa", positive=True)
    t = sympy.symbols("t", real=True)
    x, y = (sympy.Function(name, real=True)(t) for name in ("m_1", "m_2"))
    small = sympy.symbols("epsilon")
    lines.names.update({x: "m_1", y: "m_2"})
    follow = kappa * (C - A)
    tensor = sympy.Matrix([[A, 0, small * follow * x], [0, A, small * follow * y],
                           [small * follow * x, small * follow * y, C]])
    omega = rate * sympy.Matrix([small * x, small * y, 1])
    lines.define("Angular velocity and inertia, to first order in the small m₁ and m₂.",
                 r"\boldsymbol\Omega = \Omega\,(m_1, m_2, 1), \qquad I_{13} = \kappa (C - A)\, m_1, \qquad "
                 r"I_{23} = \kappa (C - A)\, m_2")
    momentum = tensor * omega
    balance = momentum.diff(t) - momentum.cross(omega)
    first = balance.applyfunc(lambda entry: sympy.expand(entry).coeff(small, 1))
    inert = A + kappa * (C - A)
    lines.equal("Without torque dL/dt = L × Ω. Component 1, to first order:", first[0],
                rate * inert * x.diff(t) + rate**2 * (1 - kappa) * (C - A) * y, shown="0")
    lines.equal("And component 2:", first[1],
                rate * inert * y.diff(t) - rate**2 * (1 - kappa) * (C - A) * x, shown="0")
    lines.equal("Component 3 has no terms of first order: the length of the day does not change.", first[2], 0,
                shown=r"\Omega\, \dot m_3")
    wobble = rate * (1 - kappa) * (C - A) / inert
    turning = {x: sympy.cos(wobble * t), y: sympy.sin(wobble * t)}
    solved = [sympy.simplify(entry.subs(turning).doit()) for entry in first[:2]]
    lines.define("Try a pole that goes round with the spin, prograde.",
                 r"m_1 = \cos \sigma t, \quad m_2 = \sin \sigma t",
                 (r"\sigma", wobble))
    lines.equal("Both right sides vanish.", sympy.Matrix(solved), sympy.zeros(2, 1), shown=r"\text{right sides}")
    lines.equal("A rigid body has κ = 0: Euler's period.", (2 * sympy.pi / wobble).subs(kappa, 0),
                2 * sympy.pi * A / (rate * (C - A)), shown="T_E")
    ratio = sympy.simplify(wobble / wobble.subs(kappa, 0))
    lines.equal("Divide. The numerator is 1 to a part in a thousand for the Earth, and is left out: "
                "T = T_E/(1 − κ).", 1 / ratio, 1 / (1 - kappa) * (1 + kappa * (C - A) / A), shown=r"\frac{T}{T_E}")

"""The symmetric top under its weight: momenta, the cubic of the tilt, steady precession, small nutation."""

import sympy


def derive(lines):
    """From the energy in Euler's angles to the two roots of steady precession."""
    I1, I3, w = sympy.symbols("I_1 I_3 w", positive=True)
    a, b, rate, tilt = sympy.symbols("a b dphi theta", real=True)
    u, p = sympy.symbols("u p", real=True)
    dtheta, dphi, dpsi = sympy.symbols("dtheta dphi dpsi", real=True)
    lines.names.update({dtheta: r"\dot\theta", dphi: r"\dot\phi", dpsi: r"\dot\psi", w: r"mgl", a: r"p_\psi",
                        b: r"p_\phi", p: r"p_\psi"})
    turning = sympy.Matrix([dtheta, dphi * sympy.sin(tilt), dpsi + dphi * sympy.cos(tilt)])
    kinetic = I1 * (turning[0]**2 + turning[1]**2) / 2 + I3 * turning[2]**2 / 2
    lines.define("Tilt θ, azimuth φ of the axis, turn ψ about it. The kinetic energy by components along and across "
                 "the axis, and the weight's energy.", ("T", kinetic), ("U", w * sympy.cos(tilt)))
    lines.equal("φ and ψ do not occur, so their momenta are conserved. That of ψ is the spin along the axis,",
                kinetic.diff(dpsi), I3 * turning[2], shown=r"p_\psi")
    lines.equal("that of φ is the vertical component of the momentum.", kinetic.diff(dphi),
                I1 * dphi * sympy.sin(tilt)**2 + I3 * turning[2] * sympy.cos(tilt), shown=r"p_\phi")
    azimuth = (b - a * sympy.cos(tilt)) / (I1 * sympy.sin(tilt)**2)
    spin = a / I3 - azimuth * sympy.cos(tilt)
    whole = (kinetic + w * sympy.cos(tilt)).subs(dpsi, spin).subs(dphi, azimuth)
    potential = (b - a * sympy.cos(tilt))**2 / (2 * I1 * sympy.sin(tilt)**2) + w * sympy.cos(tilt)
    lines.equal("Solve for the rates and put them in. What is left is one degree of freedom, in an effective "
                "potential.", whole, I1 * dtheta**2 / 2 + potential + a**2 / (2 * I3), shown="E")
    force = sympy.diff(potential, tilt)
    steady = force.subs(b, I1 * rate * sympy.sin(tilt)**2 + a * sympy.cos(tilt))
    lines.equal("Steady precession at constant θ: the potential's slope vanishes. In terms of the rate of φ it is a "
                "quadratic.", steady, -sympy.sin(tilt) * (I1 * sympy.cos(tilt) * rate**2 - a * rate + w),
                shown=r"\frac{dU_{\mathrm{eff}}}{d\theta}")
    square = sympy.symbols("D", positive=True)
    roots = [2 * w / (a + sign * square) for sign in (1, -1)]
    for root, name in zip(roots, ("slow", "fast"), strict=True):
        value = (I1 * sympy.cos(tilt) * root**2 - a * root + w).subs(
            sympy.cos(tilt), (a**2 - square**2) / (4 * I1 * w))
        lines.equal(f"With D² = p_ψ² − 4 I₁ mgl cos θ, which must not be negative, the {name} root is this:",
                    sympy.simplify(value), 0, shown=rf"\dot\phi = {lines.latex(root)}: \quad I_1 \cos\theta\, "
                    r"\dot\phi^2 - p_\psi \dot\phi + mgl")
    second = sympy.diff(potential, tilt, 2).subs(b, I1 * rate * sympy.sin(tilt)**2 + a * sympy.cos(tilt))
    gravity = a * rate - I1 * sympy.cos(tilt) * rate**2
    lines.equal("Small nutations about it: the potential's curvature over I₁ is the square of their frequency.",
                sympy.simplify(second.subs(w, gravity) / I1),
                (a / I1 - 2 * rate * sympy.cos(tilt))**2 + (rate * sympy.sin(tilt))**2, shown=r"\nu^2")
    large = sympy.symbols("q", positive=True)
    lines.tends("A fast top: the slow root times p_ψ tends to the weight's moment,",
                (large * 2 * w / (large + sympy.sqrt(large**2 - 4 * I1 * w * u))), large, sympy.oo, w, direction="-")

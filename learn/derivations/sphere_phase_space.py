"""The momentum sphere as a phase space: longitude and height are canonical, and area is action."""

import sympy


def derive(lines):
    """Coordinates φ and z = L₃ on the sphere |L| = G."""
    phi, z = sympy.symbols("phi z", real=True)
    G, I1, I2, I3 = sympy.symbols("G I_1:4", positive=True)
    across = sympy.sqrt(G**2 - z**2)
    L1, L2, L3 = across * sympy.cos(phi), across * sympy.sin(phi), z
    lines.define("On the sphere of radius G use the longitude φ and the height z above the equator.",
                 ("L_1", L1), ("L_2", L2), ("L_3", L3))

    def bracket(f, g):
        return sympy.diff(f, z) * sympy.diff(g, phi) - sympy.diff(f, phi) * sympy.diff(g, z)

    lines.define("Try the bracket of one degree of freedom, with z as the coordinate and φ as the momentum.",
                 (r"\{f, g\}", r"\partial_z f\;\partial_\varphi g - \partial_\varphi f\;\partial_z g"))
    lines.equal("It gives the brackets of the components, with the sign of the body's axes.",
                bracket(L1, L2), -L3, shown=r"\{L_1, L_2\}")
    lines.equal("The second of them:", bracket(L2, L3), -L1, shown=r"\{L_2, L_3\}")
    lines.equal("And the third:", bracket(L3, L1), -L2, shown=r"\{L_3, L_1\}")
    H = L1**2 / (2 * I1) + L2**2 / (2 * I2) + L3**2 / (2 * I3)
    lines.define("So Hamilton's equations hold on the sphere, with the energy as the Hamiltonian.",
                 (r"\dot z", r"\partial_\varphi H"), (r"\dot\varphi", r"-\partial_z H"))
    lines.equal("The first is Euler's equation for L₃.", sympy.diff(H, phi), (1 / I2 - 1 / I1) * L1 * L2,
                shown=r"\partial_\varphi H")
    point = sympy.Matrix([L1, L2, L3])
    normal = point.diff(phi).cross(point.diff(z))
    lines.equal("The area element of the sphere is G dφ dz: Archimedes' theorem. Divided by G it is the area of the "
                "(φ, z) plane.", normal.dot(normal), G**2,
                shown=r"\left|\partial_\varphi L\times\partial_z L\right|^2")
    lines.equal("In total:", sympy.integrate(sympy.integrate(1, (phi, 0, 2 * sympy.pi)), (z, -G, G)), 4 * sympy.pi * G,
                shown=r"\int_{-G}^{G}\int_0^{2\pi} d\varphi\,dz")

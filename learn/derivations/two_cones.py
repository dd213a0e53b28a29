"""A body with an axis of symmetry: how far Ω and L can be apart."""

import sympy


def derive(lines):
    """Angles of Ω and L from the axis, and their largest difference."""
    I1, I3, x = sympy.symbols("I_1 I_3 x", positive=True)
    lines.names[x] = "x"
    lines.define("Let Ω lean by α from the axis of symmetry, and L by β. "
                 "Each component of L is that of Ω times its moment.",
                 r"\tan\beta = \frac{L_1}{L_3} = \frac{I_1 \Omega_1}{I_3 \Omega_3} = "
                 r"\frac{I_1}{I_3} \tan\alpha")  # fmt: skip
    tangent = (I3 - I1) * x / (I3 + I1 * x**2)
    lines.equal("With x = tan α, the angle between them has this tangent.",
                (x - I1 * x / I3) / (1 + I1 * x**2 / I3), tangent,
                shown=r"\tan(\alpha - \beta) = \frac{\tan\alpha - \tan\beta}{1 + \tan\alpha\tan\beta}")  # fmt: skip
    best = sympy.sqrt(I3 / I1)
    lines.equal("It is stationary where tan²α is the ratio of the moments.", sympy.diff(tangent, x).subs(x, best), 0,
                shown=r"\frac{d}{dx} \tan(\alpha-\beta)\Big|_{x = \sqrt{I_3/I_1}}")  # fmt: skip
    most = tangent.subs(x, best)
    lines.equal("There it has its largest size.", most, (I3 - I1) / (2 * sympy.sqrt(I1 * I3)),
                shown=r"\tan\delta")  # fmt: skip
    lines.equal("As a sine this is simpler.", most**2 / (1 + most**2), ((I3 - I1) / (I3 + I1)) ** 2,
                shown=r"\sin^2\delta")  # fmt: skip

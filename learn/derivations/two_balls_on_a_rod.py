"""The angular momentum of two balls on a rod, and what happens when they are pulled in."""

import sympy


def derive(lines):
    """Mass times distance times speed, for both balls."""
    m, r, n = sympy.symbols("m r n", positive=True)
    speed = 2 * sympy.pi * n * r
    lines.define("Each ball, of mass m, goes n times a second round a circle of radius r. Its speed is the way round, "
                 "n times a second.", ("v", speed))  # fmt: skip
    turning = 4 * sympy.pi * n * m * r**2
    lines.equal("It contributes m times v times r, and there are two.", 2 * m * speed * r, turning, shown="L")
    lines.equal("Now pull both balls in to half the distance. With n as before, L would be a quarter.",
                turning.subs(r, r / 2), turning / 4, shown=r"L\big|_{r/2}")  # fmt: skip
    lines.equal("But nothing inside can change L. So the rod must turn four times as often.",
                turning.subs({r: r / 2, n: 4 * n}, simultaneous=True), turning,
                shown=r"L\big|_{r/2,\;4n}")  # fmt: skip

"""Why a throw that is ten times better buys the same time again, by multiplication alone."""

import sympy


def derive(lines):
    """A tilt that is multiplied by the same factor in each step of time."""
    tilt, q = sympy.symbols("delta q", positive=True)
    n = sympy.symbols("n", positive=True)
    tenfold = sympy.log(10) / sympy.log(q)
    lines.define("A small tilt δ near the pass is multiplied by the same number q in each short step of time. After "
                 "n steps it is this.", r"\delta\, q^n")  # fmt: skip
    lines.define("Let m be the number of steps in which a tilt becomes ten times as large.", r"q^m = 10")
    lines.equal("It is the same number for every tilt.", q**tenfold, 10, shown="q^m")
    lines.equal("So a tilt that is ten times smaller needs m more steps to become as large.",
                (tilt / 10) * q ** (n + tenfold), tilt * q**n,
                shown=r"\tfrac{\delta}{10}\, q^{n+m}")  # fmt: skip
    lines.equal("One that is a hundred times smaller needs 2m more: each factor of ten costs the same.",
                (tilt / 100) * q ** (n + 2 * tenfold), tilt * q**n,
                shown=r"\tfrac{\delta}{100}\, q^{n+2m}")  # fmt: skip
    lines.define("At the other pass L arrives along a line as close to it as the one on which it left, and as slowly. "
                 "So the book needs m more steps there as well: 2m in all for each factor of ten.", r"m + m = 2m")

"""Every derivation holds; and each check fails for a page that is wrong in one place."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest
import sympy

from polhode.algebra import SO3
from polhode.errors import InvalidInput
from polhode.proving import Derivation, DerivationBroken, LiePoissonBracket, Page, SymbolicSystem, derive
from polhode.proving.symbolic.derivation import Numerical
from polhode.proving.symbolic.registry import HOME, derivation_names, describe_derivation
from polhode.proving.symbolic.rendering import Bracket, Equation, Name, Rate, Step
from polhode.systems import FreeRigidBody

QUICK = {"free-body", "lagrange-top", "kovalevskaya-top", "clebsch", "steklov-lyapunov"}
I1, I2, I3, L = sympy.symbols("I1 I2 I3 L", positive=True)
SO3_ = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3, L])
L1, L2, L3 = SO3_.coordinates
s = sympy.Symbol("s")
H = L1**2 / (2 * I1) + L2**2 / (2 * I2) + L3**2 / (2 * I3)
SAMPLES = [{"I1": 1.0, "I2": 2.0, "I3": 2.5, "L": 1.5}, {"I1": 2.0, "I2": 1.0, "I3": 2.5, "L": 0.7}]
SPIN, SQUARE = (L, 0, 0), L1**2 + L2**2 + L3**2
EXTREMAL = sympy.Or(sympy.And(I1 > I2, I1 > I3), sympy.And(I1 < I2, I1 < I3))
BETWEEN = sympy.Or(sympy.And(I2 < I1, I1 < I3), sympy.And(I3 < I1, I1 < I2))
POLYNOMIAL = s * (s**2 + L**2 * (I1 - I2) * (I1 - I3) / (I1**2 * I2 * I3))


def page(hamiltonian=H, make=lambda v: FreeRigidBody((v["I1"], v["I2"], v["I3"])), bracket=SO3_):
    return Derivation("A page", SymbolicSystem(bracket, hamiltonian), Numerical(make, SAMPLES))


def euler(sign=1):
    return {L1: sign * (1 / I3 - 1 / I2) * L2 * L3, L2: (1 / I1 - 1 / I3) * L3 * L1, L3: (1 / I2 - 1 / I1) * L1 * L2}


@pytest.mark.long_after(1)
@pytest.mark.parametrize("name", [pytest.param(n, marks=[] if n in QUICK else [pytest.mark.sweep])
                                  for n in derivation_names()])  # fmt: skip
def test_holds_in_every_form(name):
    result = derive(name)
    assert len(result.steps) >= 4 and all(step.checks for step in result.steps)
    for form in ("text", "markdown", "latex", "html"):
        assert result.title.split()[-1] in result.render(form)
    assert max(map(len, result.render("text").splitlines())) <= 100
    assert result.render("latex").count(r"\begin{aligned}") == result.render("markdown").count(r"\begin{aligned}")
    assert result.render("latex").isascii()
    for formula in re.findall(r"<math.*?</math>", result.render("html"), re.DOTALL):
        ElementTree.fromstring(formula.replace("&InvisibleTimes;", "").replace("&ApplyFunction;", ""))


def test_files_register_themselves():
    names = {path.stem.replace("_", "-") for path in HOME.glob("*.py")} - {"--init--"}
    assert set(derivation_names()) == names
    assert names >= {"free-body", "heavy-top", "gyrostat", "kirchhoff", "lagrange-top", "so4"}
    assert all(describe_derivation(name).endswith(".") for name in names)
    with pytest.raises(InvalidInput, match="Did you mean free-body"):
        derive("freebody")


BROKEN = {
    "a bracket of the wrong sign": lambda: page().brackets("B.", {(L1, L2): L3, (L2, L3): -L1, (L3, L1): -L2}),
    "a bracket left out": lambda: page().brackets("B.", {(L1, L2): -L3, (L2, L3): -L1}),
    "a table that is no Lie algebra": lambda: page(bracket=crooked()).brackets(
        "B.", {(L1, L2): -L3 - L1, (L2, L3): -L1, (L3, L1): -L2}),
    "the bracket of the other sign than the system's": lambda: page(bracket=SO3_.with_sign(1)).brackets(
        "B.", {(L1, L2): L3, (L2, L3): L1, (L3, L1): L2}),
    "an energy that is not the system's": lambda: page(H + L1**2 / 8).hamiltonian("H."),
    "an equation of the wrong sign": lambda: page().equations("E.", euler(-1)),
    "equations of another body than the system's": lambda: page(
        make=lambda v: FreeRigidBody((v["I2"], v["I1"], v["I3"]))).equations("E.", euler()),
    "a Casimir that is none": lambda: page().casimirs("C.", {Name("C", "C"): L1**2 + L2**2 + 2 * L3**2}),
    "a Casimir left out": lambda: page().casimirs("C.", {}),
    "an integral that is none": lambda: page().integral("F.", Name("F", "F"), L1**2),
    "an integral that is not found": lambda: page().further_integrals("F.", 2, [L1**2]),
    "an integral that is found and not stated": lambda: page(H.subs(I2, I1)).further_integrals("F.", 1, []),
    "a condition of stability turned round": lambda: page().stable_if("S.", SPIN, [SQUARE], BETWEEN),
    "half of the condition": lambda: page().stable_if("S.", SPIN, [SQUARE], sympy.And(I1 > I2, I1 > I3)),
    "a condition of instability turned round": lambda: page().unstable_if("U.", SPIN, EXTREMAL, POLYNOMIAL),
    "another characteristic polynomial": lambda: page().unstable_if("U.", SPIN, BETWEEN, POLYNOMIAL + s),
    "verdicts of another body": lambda: page(make=lambda v: FreeRigidBody((v["I2"], v["I1"], v["I3"]))).stable_if(
        "S.", SPIN, [SQUARE], EXTREMAL),
    "the same verdict by another energy": lambda: page(
        make=lambda v: FreeRigidBody(tuple(2 * v[k] for k in ("I1", "I2", "I3")))).stable_if(
            "S.", SPIN, [SQUARE], EXTREMAL),
    "an integral that the body does not keep": lambda: page(H.subs(I2, I1)).further_integrals("F.", 1, [L3]),
    "a condition of exponents turned round": lambda: page().exponents_if("U.", SPIN, EXTREMAL),
    "a sum that is not zero": lambda: page().vanishes("Z.", I1 - I2),
    "a sphere of another body": lambda: page(make=lambda v: FreeRigidBody((v["I2"], v["I1"], v["I3"]))).sphere("R."),
}  # fmt: skip


def crooked():
    c = np.zeros((3, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 1, 0)):
        c[i, j, k], c[j, i, k] = 1, -1
    return LiePoissonBracket(c, [L1, L2, L3], parameters=SO3_.parameters)


@pytest.mark.long_after(10)
@pytest.mark.parametrize("what", BROKEN)
def test_a_wrong_page_is_refused(what):
    with pytest.raises(DerivationBroken):
        BROKEN[what]()


def test_a_condition_that_no_sample_satisfies_is_refused():
    with pytest.raises(DerivationBroken, match="none of the sets"):
        Derivation("P", SymbolicSystem(SO3_, H), Numerical(lambda v: FreeRigidBody((1.0, 2.0, 2.5)), SAMPLES[:1])
                   ).unstable_if("U.", SPIN, BETWEEN, POLYNOMIAL)  # fmt: skip


def test_rendering():
    equations = (Equation(Rate(L1), I1 / I2), Equation(Bracket(L1, L2), -L3), Equation(None, I1 > I2),
                 Equation(Name("E", "E"), I1 < I2, "⇐"))  # fmt: skip
    step = Step("Of so(3)* & more_.", equations, ("a check",))
    one = Page("Title", (step,))
    text = one.render()
    assert "dL₁/dt = ──" in text and "{L₁, L₂} = -L₃" in text and "✓ a check" in text and "I₁ > I₂" in text
    assert r"\dot{L_{1}} &= \frac{I_{1}}{I_{2}}" in one.render("markdown")
    assert r"so(3)\* & more\_" in one.render("markdown")
    assert r"\& more\_" in one.render("latex") and r"E &\Longleftarrow I_{1} < I_{2}" in one.render("latex")
    assert "&amp; more_" in one.render("html") and "<mo>˙</mo>" in one.render("html")
    with pytest.raises(InvalidInput, match='"text", "markdown", "latex", "html"'):
        one.render("pdf")

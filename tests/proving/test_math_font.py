"""The math font that ships: its size and licence, and that it has every sign of the formulas."""

import html
import re
from importlib import resources
from pathlib import Path

import pytest

from polhode.proving import derivation_names, derive
from polhode.proving.symbolic.rendering import STRUT, Equation, Page, Step

ROOT = Path(__file__).parents[2]
ASSETS = resources.files("polhode.proving.symbolic") / "assets"
QUICK = {"free-body", "lagrange-top"}
"""Derivations of a second; the others are in the sweep."""
LARGEST = 150_000  # bytes
FORMULA = re.compile(r"\$\$(.+?)\$\$|(?<![\\$])\$([^$\n]+?)\$", re.DOTALL)
INVISIBLE = {"\u2061", "\u2062", "\u2063", "\n", "\t"}  # a function applied, a product: browsers draw nothing


def ranges():
    text = (ROOT / "docs" / "math_font.py").read_text("utf-8")
    result = re.search(r"RANGES = \((.*?)\n\)", text, re.DOTALL)[1]
    return [(int(a, 16), int(b, 16)) for a, b in re.findall(r"\((0x\w+), (0x\w+)\)", result)]


def missing(mathml):
    """Return the signs of formulas that the font lacks."""
    signs = set(html.unescape(re.sub(r"<[^>]*>", "", mathml))) - INVISIBLE
    return {sign for sign in signs if not any(a <= ord(sign) <= b for a, b in ranges())}


def test_the_font_is_small_and_has_its_licence():
    font = (ASSETS / "math.woff2").read_bytes()
    assert font[:4] == b"wOF2" and len(font) < LARGEST
    assert "SIL OPEN FONT LICENSE Version 1.1" in (ASSETS / "LICENSE.math.txt").read_text("utf-8")
    assert "proving/symbolic/assets/LICENSE.math.txt" in (ROOT / "pyproject.toml").read_text("utf-8")


@pytest.mark.long
@pytest.mark.parametrize("name", [pytest.param(n, marks=[] if n in QUICK else [pytest.mark.sweep])
                                  for n in derivation_names()])  # fmt: skip
def test_derivations_use_signs_that_the_font_has(name):
    page = derive(name).render("html")
    formulas = "".join(re.findall(r"<math.*?</math>", page, re.DOTALL))
    assert formulas and not missing(formulas)
    assert "@font-face{font-family:'polhode math';src:url(data:font/woff2;base64," in page


def test_documents_use_signs_that_the_font_has():
    converter = pytest.importorskip("latex2mathml.converter")
    for path in sorted((ROOT / "docs").rglob("*.md")):
        text = re.sub(r"```.*?```|`[^`\n]*`", "", path.read_text("utf-8"), flags=re.DOTALL)
        for result in FORMULA.finditer(text):
            latex = (result[1] or result[2]).strip()
            assert not missing(converter.convert(latex)), f"{path.name}: {latex}"


def test_a_sign_that_the_font_lacks_is_seen():
    assert missing("<math><mi>x</mi><mo>⌘</mo></math>") == {"⌘"}


def test_roots_stand_on_the_line_and_a_minus_is_no_hyphen():
    sympy = pytest.importorskip("sympy")
    a = sympy.Symbol("a")
    page = Page("t", (Step("s", (Equation(a, -sympy.sqrt(a)),), ()),)).render("html")
    assert f"<msqrt>{STRUT}" in page and "<mo>−</mo>" in page and "<mo>-</mo>" not in page

"""Pages of a derivation, as terminal text, Markdown, LaTeX or HTML."""

from __future__ import annotations

import base64
import html
import re
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from importlib import resources
from typing import Any

from polhode._base import check
from polhode.proving.symbolic._gate import PrettyPrinter, mathml, sympy

TEXT_WIDTH = 100  # of terminal text; wider formulas are written in lines
INDENT = "    "
STYLE = (
    "body{max-width:60rem;margin:2rem auto;padding:0 1rem;font-family:serif;line-height:1.5}"
    "math{display:block;margin:.5rem 0 .5rem 2rem;overflow:auto hidden;font-family:'polhode math',math}"
    "small{color:#555}"
)
STRUT = '<mspace height="0.7em" depth="0.15em"/>'
"""What keeps the root of a small letter on the line: browsers hang the sign of a root on its bar, so that it sinks."""
_PRINTER = PrettyPrinter({"use_unicode": True, "wrap_line": False})


@dataclass(frozen=True)
class Equation:
    """One line "left = right" of a page, or a statement alone.

    Attributes:
        left: what is defined or computed; None for a statement.
        right: SymPy expression, relation, matrix, or Rate, Bracket or Name.
        word: between both, "=" or, for a sufficient condition, "⇐".
    """

    left: Any
    right: Any
    word: str = "="


@dataclass(frozen=True)
class Rate:
    """The rate of a coordinate, ẋ."""

    of: Any


@dataclass(frozen=True)
class Bracket:
    """The bracket {F, G} of two expressions."""

    first: Any
    second: Any


@dataclass(frozen=True)
class Name:
    """A name for the right side, in LaTeX and in plain text."""

    latex: str
    text: str


@dataclass(frozen=True)
class Step:
    """One step of a derivation.

    Attributes:
        text: the step in words.
        equations: the results.
        checks: the checks that they passed, in words.
    """

    text: str
    equations: tuple[Equation, ...]
    checks: tuple[str, ...]


@dataclass(frozen=True)
class Page:
    """A derivation whose steps have all been checked.

    Attributes:
        title: its name.
        steps: in order.
    """

    title: str
    steps: tuple[Step, ...]

    def render(self, form: str = "text") -> str:
        """Return the page in a form: "text", "markdown", "latex" or "html".

        Raises:
            InvalidInput: for another form.
        """
        return FORMS[check.one_of("form", form, FORMS)](self)


def _text_page(page: Page) -> str:
    lines = [page.title, "=" * len(page.title)]
    for n, step in enumerate(page.steps, 1):
        lines += ["", *textwrap.wrap(f"{n}. {step.text}", TEXT_WIDTH, subsequent_indent="   ")]
        for equation in step.equations:
            lines += ["", *_text_equation(equation)]
        if step.checks:
            lines += ["", *textwrap.wrap(f"✓ {'; '.join(step.checks)}", TEXT_WIDTH, initial_indent="   ",
                                         subsequent_indent="     ")]
    return "\n".join(lines) + "\n"


def _text_equation(equation: Equation) -> list[str]:
    left = INDENT + ("" if equation.left is None else f"{_text_of(equation.left)} {equation.word} ")
    right = equation.right
    if isinstance(right, Name | Bracket | Rate):
        return [left + _text_of(right)]
    rows = _rows_of(left, right)
    if max(map(len, rows)) <= TEXT_WIDTH:
        return rows
    if isinstance(right, sympy.Add):
        return _rows_of_sum(left, right)
    return textwrap.wrap(left + str(right).replace("**", "^"), TEXT_WIDTH, subsequent_indent=2 * INDENT,
                         break_long_words=False)


def _rows_of(left: str, right: Any) -> list[str]:
    """Return a formula in two dimensions, behind its left side."""
    form = _PRINTER._print(right)
    return [((left if k == form.baseline else " " * len(left)) + row).rstrip()
            for k, row in enumerate(str(form).split("\n"))]


def _rows_of_sum(left: str, total: Any) -> list[str]:
    """Return a sum in several lines, each as long as fits."""
    rows: list[str] = []
    terms = total.as_ordered_terms()
    while terms:
        count = next((n for n in range(len(terms), 1, -1)
                      if max(map(len, _rows_of(left, sympy.Add(*terms[:n])))) <= TEXT_WIDTH), 1)
        rows += [*([""] if rows else []), *_rows_of(left, sympy.Add(*terms[:count]))]
        terms = terms[count:]
        left = " " * (len(left.rstrip()) - 1) + ("+ " if terms and not terms[0].could_extract_minus_sign() else "  ")
    return rows


def _text_of(thing: Any) -> str:
    if isinstance(thing, Rate):
        return f"d{_text_of(thing.of)}/dt"
    if isinstance(thing, Bracket):
        return f"{{{_text_of(thing.first)}, {_text_of(thing.second)}}}"
    if isinstance(thing, Name):
        return thing.text
    return sympy.pretty(thing, use_unicode=True, wrap_line=False)


def _latex_of(thing: Any) -> str:
    if isinstance(thing, Rate):
        return rf"\dot{{{_latex_of(thing.of)}}}"
    if isinstance(thing, Bracket):
        return rf"\{{{_latex_of(thing.first)}, {_latex_of(thing.second)}\}}"
    if isinstance(thing, Name):
        return thing.latex
    return sympy.latex(thing)


def _latex_equations(equations: tuple[Equation, ...]) -> str:
    words = {"=": "=", "⇐": r"\Longleftarrow"}
    lines = [f"&{_latex_of(e.right)}" if e.left is None else
             f"{_latex_of(e.left)} &{words[e.word]} {_latex_of(e.right)}" for e in equations]
    return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def _markdown_page(page: Page) -> str:
    parts = [f"# {_escape_markdown(page.title)}"]
    for n, step in enumerate(page.steps, 1):
        parts.append(f"{n}. {_escape_markdown(step.text)}")
        if step.equations:
            parts.append(f"$$\n{_latex_equations(step.equations)}\n$$")
        if step.checks:
            parts.append(f"*Checked: {_escape_markdown('; '.join(step.checks))}.*")
    return "\n\n".join(parts) + "\n"


def _escape_markdown(text: str) -> str:
    return re.sub(r"([*_|\\])", r"\\\1", text)


def _latex_page(page: Page) -> str:
    parts = [r"\documentclass{article}", r"\usepackage{amsmath,amssymb}", r"\begin{document}",
             rf"\section*{{{_escape_latex(page.title)}}}", r"\begin{enumerate}"]  # fmt: skip
    for step in page.steps:
        parts.append(rf"\item {_escape_latex(step.text)}")
        if step.equations:
            parts.append(f"\\[\n{_latex_equations(step.equations)}\n\\]")
        if step.checks:
            parts.append(rf"{{\small Checked: {_escape_latex('; '.join(step.checks))}.}}")
    return "\n".join([*parts, r"\end{enumerate}", r"\end{document}"]) + "\n"


def _escape_latex(text: str) -> str:
    text = re.sub(r"([&%$#_{}])", r"\\\1", text)
    return text.replace("–", "--").replace("’", "'").replace("²", "$^2$")


def _html_page(page: Page) -> str:
    title = html.escape(page.title)
    parts = ["<!DOCTYPE html>", '<html lang="en">', f'<head><meta charset="utf-8"><title>{title}</title>',
             f"<style>{_font_face()}{STYLE}</style></head>", f"<body><h1>{title}</h1>", "<ol>"]  # fmt: skip
    for step in page.steps:
        parts.append(f"<li><p>{html.escape(step.text)}</p>")
        parts += [f'<math display="block">{_mathml_equation(e)}</math>' for e in step.equations]
        if step.checks:
            parts.append(f"<p><small>✓ {html.escape('; '.join(step.checks))}</small></p>")
        parts.append("</li>")
    return "\n".join([*parts, "</ol></body></html>"]) + "\n"


def _font_face() -> str:
    """Return the rule that gives a page its math font: without one, browsers draw roots too short and lose dots."""
    font = (resources.files("polhode.proving.symbolic") / "assets" / "math.woff2").read_bytes()
    return (f"@font-face{{font-family:'polhode math';src:url(data:font/woff2;base64,{base64.b64encode(font).decode()})"
            " format('woff2')}")


def _mathml_equation(equation: Equation) -> str:
    right = _mathml_of(equation.right)
    if equation.left is None:
        return f"<mrow>{right}</mrow>"
    return f"<mrow>{_mathml_of(equation.left)}<mo>{equation.word}</mo>{right}</mrow>"


def _mathml_of(thing: Any) -> str:
    if isinstance(thing, Rate):
        return f"<mover>{_mathml_of(thing.of)}<mo>˙</mo></mover>"
    if isinstance(thing, Bracket):
        return f"<mrow><mo>{{</mo>{_mathml_of(thing.first)}<mo>,</mo>{_mathml_of(thing.second)}<mo>}}</mo></mrow>"
    if isinstance(thing, Name):
        return f"<mi>{html.escape(thing.text)}</mi>"
    # SymPy leaves two signs as they are, which readers reject, and writes a hyphen for a minus
    written = mathml(thing, printer="presentation").replace("<mo>-</mo>", "<mo>−</mo>")
    written = written.replace("<mo><</mo>", "<mo>&lt;</mo>").replace("<mo>></mo>", "<mo>&gt;</mo>")
    return written.replace("<msqrt>", f"<msqrt>{STRUT}")


FORMS: dict[str, Callable[[Page], str]] = {
    "text": _text_page, "markdown": _markdown_page, "latex": _latex_page, "html": _html_page,
}  # fmt: skip
ENDINGS = {".txt": "text", ".md": "markdown", ".tex": "latex", ".html": "html"}

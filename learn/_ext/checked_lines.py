"""Derivations whose every line SymPy checks: the formulas that readers see are printed from what was checked."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import sympy


class LineBroken(AssertionError):
    """A line of a derivation does not follow; the message names the line and what remains of it."""


class Line(NamedTuple):
    """A line: what is done, its formulas in LaTeX, and whether SymPy has checked them."""

    text: str
    formulas: tuple[str, ...]
    checked: bool


class Lines:
    """A derivation in the making. Each file of the folder `derivations` has a function ``derive(lines)``.

    Args:
        names: LaTeX of symbols that SymPy would print otherwise.
    """

    def __init__(self) -> None:
        self.lines: list[Line] = []
        self.names: dict[Any, str] = {}

    def latex(self, thing: Any) -> str:
        """Return text as it is, anything else as SymPy prints it."""
        return thing if isinstance(thing, str) else sympy.latex(thing, symbol_names=self.names)

    def define(self, text: str, *formulas: Any) -> None:
        """Add a definition or an assumption: nothing to check. A pair stands for "left = right"."""
        shown = (" = ".join(map(self.latex, f)) if isinstance(f, tuple) else self.latex(f) for f in formulas)
        self._add(text, shown, checked=False)

    def equal(self, text: str, left: Any, right: Any, *further: Any, shown: str | None = None) -> None:
        """Add "left = right = …" and check each equality; `shown` replaces the left side where it prints badly."""
        for value in (right, *further):
            self._vanishes(text, _difference(left, value))
        chain = [shown or self.latex(left), *(self.latex(value) for value in (right, *further))]
        self._add(text, [" = ".join(chain)])

    def holds(self, text: str, claim: Any, *, shown: str | None = None) -> None:
        """Add a statement, an equation, inequality or condition, that SymPy must find true."""
        if isinstance(claim, sympy.Equality):
            self._vanishes(text, _difference(claim.lhs, claim.rhs))
        elif sympy.simplify(claim) is not sympy.true:
            raise LineBroken(f"“{text}”: SymPy does not find {claim} true, but {sympy.simplify(claim)}.")
        self._add(text, [shown or self.latex(claim)])

    def solves(self, text: str, equation: sympy.Equality, unknown: Any, solution: Any) -> None:
        """Add "unknown = solution" and check that it solves the differential or algebraic equation."""
        put = equation.lhs.subs(unknown, solution).doit() - equation.rhs.subs(unknown, solution).doit()
        self._vanishes(text, put)
        self._add(text, [f"{self.latex(unknown)} = {self.latex(solution)}"])

    def tends(self, text: str, expression: Any, variable: Any, point: Any, limit: Any, direction: str = "+") -> None:
        """Add a limit and check it."""
        self._vanishes(text, _difference(sympy.limit(expression, variable, point, direction), limit))
        arrow = rf"\lim_{{{self.latex(variable)} \to {self.latex(point)}}} {self.latex(expression)}"
        self._add(text, [f"{arrow} = {self.latex(limit)}"])

    def expands(self, text: str, expression: Any, variable: Any, order: int, series: Any, point: Any = 0) -> None:
        """Add a series about a point up to an order, and check it."""
        computed = sympy.series(expression, variable, point, order).removeO()
        self._vanishes(text, _difference(computed, series))
        rest = rf"O({self.latex(variable)}^{{{order}}})"
        self._add(text, [f"{self.latex(expression)} = {self.latex(series)} + {rest}"])

    def _vanishes(self, text: str, difference: Any) -> None:
        entries = list(difference) if isinstance(difference, sympy.MatrixBase) else [difference]
        for entry in entries:
            rest = sympy.simplify(entry)
            if rest != 0 and sympy.simplify(sympy.expand(sympy.expand_trig(rest))) != 0:
                raise LineBroken(f"“{text}”: the sides differ by {rest}.")

    def _add(self, text: str, formulas: Iterable[str], *, checked: bool = True) -> None:
        self.lines.append(Line(text, tuple(formulas), checked))


def _difference(left: Any, right: Any) -> Any:
    if isinstance(left, sympy.MatrixBase) or isinstance(right, sympy.MatrixBase):
        return sympy.Matrix(left) - sympy.Matrix(right)
    return sympy.sympify(left) - sympy.sympify(right)

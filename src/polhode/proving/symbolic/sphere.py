"""Reduction of so(3)* to a sphere: the orbits |L| = const with their symplectic form, in the coordinates φ and z.

(L1, L2, L3) = (√(L² − z²) cos φ, √(L² − z²) sin φ, z) with L = |L|. The Kirillov–Kostant–Souriau form is ω = ± dφ ∧ dz
with the sign of the bracket: ± the area element divided by L, with the outward normal.
Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §14.4.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from polhode.errors import InvalidInput
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.brackets import LiePoissonBracket
from polhode.proving.symbolic.systems import SymbolicSystem


@dataclass(frozen=True)
class SphereReduction:
    """Hamilton's equations of one degree of freedom on an orbit |L| = const.

    Attributes:
        radius: L = |L|, a positive symbol.
        angle: φ, the angle of L about the third axis.
        height: z = L3.
        embedding: (3,) L as functions of φ and z.
        hamiltonian: H on the sphere.
        rates: φ̇ and ż by symbol.
        form: the coefficient of dφ ∧ dz in ω, ±1.
        area: the coefficient of dφ ∧ dz in the area element with outward normal, L.
    """

    radius: Any
    angle: Any
    height: Any
    embedding: tuple[Any, Any, Any]
    hamiltonian: Any
    rates: dict[Any, Any]
    form: Any
    area: Any

    def latex(self) -> str:
        """Return embedding, form and equations as LaTeX for a display."""
        L = ", ".join(sympy.latex(x) for x in self.embedding)
        phi, z = sympy.latex(self.angle), sympy.latex(self.height)
        lines = [rf"(L_1, L_2, L_3) &= \left({L}\right)", rf"\omega &= {sympy.latex(self.form)}\; d{phi} \wedge d{z}"]
        lines += [rf"\dot{{{sympy.latex(x)}}} &= {sympy.latex(rate)}" for x, rate in self.rates.items()]
        return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def reduce_to_sphere(system: SymbolicSystem) -> SphereReduction:
    """Return the motion on a sphere |L| = const of a system on so(3)*.

    {φ, z} follows from the brackets of L1 and L2 with L3; that the brackets of all coordinates restrict to the sphere
    with it is checked.

    Raises:
        InvalidInput: for another algebra than so(3) in its usual basis.
    """
    bracket = system.bracket
    if bracket.dim != 3 or any(bracket(a, b) != bracket.sign * c for a, b, c in _cyclic(bracket.coordinates)):
        raise InvalidInput(
            "only so(3) with [e_1, e_2] = e_3 and so on has these spheres; the table is another. For other algebras "
            "`kks_form` gives the form on the orbit."
        )
    radius = sympy.Symbol("L", positive=True)
    angle, height = sympy.symbols("phi z", real=True)
    width = sympy.sqrt(radius**2 - height**2)
    embedding = (width * sympy.cos(angle), width * sympy.sin(angle), height)
    place = dict(zip(bracket.coordinates, embedding, strict=True))
    L1, L2, L3 = bracket.coordinates
    # φ = arg(L1 + i L2), so that dφ = (L1 dL2 − L2 dL1)/(L1² + L2²)
    turning = (L1 * bracket(L2, L3) - L2 * bracket(L1, L3)) / (L1**2 + L2**2)
    canonical = sympy.simplify(turning.subs(place, simultaneous=True))

    def on_sphere(F: Any, G: Any) -> Any:
        return canonical * (sympy.diff(F, angle) * sympy.diff(G, height) - sympy.diff(F, height) * sympy.diff(G, angle))

    for a, b, _ in _cyclic(range(3)):
        x, y = bracket.coordinates[a], bracket.coordinates[b]
        off = on_sphere(embedding[a], embedding[b]) - bracket(x, y).subs(place, simultaneous=True)
        assert sympy.simplify(off) == 0, "the bracket restricts to orbits"
    H = sympy.simplify(system.hamiltonian.subs(place, simultaneous=True))
    rates = {angle: sympy.simplify(on_sphere(angle, H)), height: sympy.simplify(on_sphere(height, H))}
    along, up = (sympy.Matrix([sympy.diff(x, v) for x in embedding]) for v in (angle, height))
    # the form inverts the bracket: ω(X_F, X_G) = {F, G}
    area = sympy.simplify(along.cross(up).dot(sympy.Matrix(embedding)) / radius)
    return SphereReduction(radius, angle, height, embedding, H, rates, 1 / canonical, area)


def kks_form(bracket: LiePoissonBracket, x: Sequence[Any], y: Sequence[Any]) -> Any:
    """Return ω(ad*_x μ, ad*_y μ) = sign · ⟨μ, [x, y]⟩ for elements x, y (n,) of an n-dimensional algebra.

    ω(X_F, X_G) = {F, G} for either sign. Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §14.2.
    """
    pairs = ((i, j) for i in range(bracket.dim) for j in range(bracket.dim))
    tensor, x, y = bracket.tensor, [*map(bracket.read, x)], [*map(bracket.read, y)]
    return sympy.expand(sum((x[i] * y[j] * tensor[i, j] for i, j in pairs), sympy.Integer(0)))


def _cyclic(items: Sequence[Any]) -> list[tuple[Any, Any, Any]]:
    a, b, c = items
    return [(a, b, c), (b, c, a), (c, a, b)]

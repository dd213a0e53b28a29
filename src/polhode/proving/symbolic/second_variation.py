"""Equilibria in symbols: linearisation, characteristic polynomial, and the energy–Casimir method.

An equilibrium is a critical point of F = H + Σ λ C; if D²F is definite on the null space of the dC, it is stable in
Lyapunov's sense. Where gradients depend on each other a multiplier is free, and one value of it is enough.
Source: Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.sign_conditions import definite_conditions, definite_for_some, unstable_condition
from polhode.proving.symbolic.systems import SymbolicSystem

EXPONENT = sympy.Symbol("s")


@dataclass(frozen=True)
class SecondVariation:
    """The second variation of H + Σ λ C at an equilibrium, on the null space of the dC.

    Attributes:
        multipliers: λ of each conserved function.
        free: multipliers that the equilibrium leaves free, symbols; one at most.
        basis: (n, d) SymPy matrix, by columns.
        matrix: (d, d) of D²(H + Σ λ C) along the basis.
        positive: the condition for it to be positive definite, for some value of a free multiplier.
        negative: likewise for negative definite.
    """

    multipliers: tuple[Any, ...]
    free: tuple[Any, ...]
    basis: Any
    matrix: Any
    positive: Any
    negative: Any

    @property
    def definite(self) -> Any:
        """The condition under which the energy–Casimir method proves stability."""
        return sympy.Or(self.positive, self.negative)

    def latex(self) -> str:
        """Return multipliers, matrix and condition as LaTeX for a display."""
        lines = [rf"\lambda_{{{k}}} &= {sympy.latex(v)}" for k, v in enumerate(self.multipliers, 1)]
        lines.append(rf"D^2 F &= {sympy.latex(self.matrix)}")
        lines.append(rf"\text{{stable}} &\Longleftarrow {sympy.latex(self.definite)}")
        return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def linearisation(system: SymbolicSystem, equilibrium: Sequence[Any] | Mapping[Any, Any]) -> Any:
    """Return the matrix A (n, n) of δẋ = A δx at an equilibrium, with n the dimension of the algebra.

    Args:
        system: in symbols.
        equilibrium: (n,) coordinates, or by symbol.

    Raises:
        InvalidInput: for a wrong number of coordinates, or a point that is no equilibrium.
    """
    point = _point(system, equilibrium)
    rates = [system.bracket(x, system.hamiltonian) for x in system.bracket.coordinates]
    left = [sympy.simplify(rate.subs(point, simultaneous=True)) for rate in rates]
    if any(value != 0 for value in left):
        k = next(k for k, value in enumerate(left) if value != 0)
        raise InvalidInput(
            f"`equilibrium` must be at rest; the rate of {system.bracket.coordinates[k]} there is "
            f"{shown(str(left[k]))}. Choose a critical point of H on its orbit."
        )
    jacobian = sympy.Matrix(rates).jacobian(sympy.Matrix(system.bracket.coordinates))
    return jacobian.subs(point, simultaneous=True).applyfunc(sympy.factor)


def characteristic_polynomial(system: SymbolicSystem, equilibrium: Sequence[Any] | Mapping[Any, Any]) -> Any:
    """Return det(s 1 − A) at an equilibrium, factored, as an expression in ``EXPONENT``."""
    return sympy.factor(linearisation(system, equilibrium).charpoly(EXPONENT).as_expr())


def instability(system: SymbolicSystem, equilibrium: Sequence[Any] | Mapping[Any, Any]) -> Any:
    """Return the condition on the parameters under which an exponent has a positive real part.

    Raises:
        InvalidInput: for a characteristic polynomial with factors of degree above 6.
    """
    return unstable_condition(characteristic_polynomial(system, equilibrium), EXPONENT)


def second_variation(
    system: SymbolicSystem, equilibrium: Sequence[Any] | Mapping[Any, Any], conserved: Sequence[Any]
) -> SecondVariation:
    """Return the second variation of H + Σ λ C at an equilibrium, with the conditions under which it is definite.

    The conditions use the assumptions on the symbols: make moments of inertia ``positive=True``.

    Args:
        system: in symbols.
        equilibrium: (n,) coordinates, or by symbol, which may contain parameters of the bracket.
        conserved: Casimirs and integrals; each is checked to be conserved.

    Raises:
        InvalidInput: for a function that is not conserved, a point that is not critical for any multipliers, more than
            one free multiplier, or conditions beyond this method.

    >>> from polhode.algebra import SO3
    >>> from polhode.proving.symbolic.brackets import LiePoissonBracket
    >>> I1, I2, I3, L = sympy.symbols("I1 I2 I3 L", positive=True)
    >>> so3 = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3, L])
    >>> body = SymbolicSystem(so3, sum(x**2 / (2 * I) for x, I in zip(so3.coordinates, (I1, I2, I3))))
    >>> second_variation(body, (L, 0, 0), [sum(x**2 for x in so3.coordinates) / 2]).positive
    (I1 > I2) & (I1 > I3)
    """
    x = sympy.Matrix(system.bracket.coordinates)
    point = _point(system, equilibrium)
    conserved = [system.bracket.read(C) for C in conserved]
    for C in conserved:
        if not system.is_integral(C):
            raise InvalidInput(f"`conserved` must be Casimirs or integrals; {{C, H}} does not vanish for "
                               f"{shown(str(C))}.")
    names = sympy.symbols(f"lambda1:{len(conserved) + 1}", real=True)
    gradients = [sympy.Matrix([sympy.diff(C, v) for v in x]).subs(point, simultaneous=True) for C in conserved]
    energy = sympy.Matrix([sympy.diff(system.hamiltonian, v) for v in x]).subs(point, simultaneous=True)
    equations = list(energy + sum((n * g for n, g in zip(names, gradients, strict=True)), sympy.zeros(len(x), 1)))
    solutions = list(sympy.linsolve(equations, *names)) if names else ([()] if not any(equations) else [])
    if not solutions:
        raise InvalidInput(
            "`equilibrium` must be a critical point of H + Σ λ C; no multipliers make its gradient vanish. Give "
            "further conserved functions, or another point."
        )
    multipliers = tuple(sympy.simplify(value) for value in solutions[0])
    free = tuple(n for n in names if any(value.has(n) for value in multipliers))
    total = system.hamiltonian + sum(n * C for n, C in zip(multipliers, conserved, strict=True))
    hessian = sympy.hessian(total, list(x)).subs(point, simultaneous=True)
    rows = sympy.Matrix([list(g) for g in gradients if any(g)]) if any(any(g) for g in gradients) else None
    kernel = sympy.eye(len(x)) if rows is None else sympy.Matrix.hstack(sympy.zeros(len(x), 0), *rows.nullspace())
    matrix = (kernel.T * hessian * kernel).applyfunc(sympy.factor)
    if len(free) > 1:
        raise InvalidInput(f"at most one multiplier may stay free; the equilibrium leaves {', '.join(map(str, free))}. "
                           "Give fewer conserved functions.")
    conditions = definite_for_some(matrix, free[0]) if free else definite_conditions(matrix)
    return SecondVariation(multipliers, free, kernel, matrix, *conditions)


def _point(system: SymbolicSystem, equilibrium: Sequence[Any] | Mapping[Any, Any]) -> dict[Any, Any]:
    coordinates = system.bracket.coordinates
    if isinstance(equilibrium, Mapping):
        named = {str(key): value for key, value in equilibrium.items()}
        equilibrium = [named.get(str(x)) for x in coordinates]
    values = list(equilibrium)
    if len(values) != len(coordinates) or any(value is None for value in values):
        raise InvalidInput(f"`equilibrium` must have the {len(coordinates)} coordinates "
                           f"{', '.join(map(str, coordinates))}; got {shown(str(values))}.")
    return dict(zip(coordinates, map(system.bracket.read, values), strict=True))

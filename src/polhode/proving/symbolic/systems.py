"""Systems with a symbolic Hamiltonian: from a numerical system, and back to one that runs."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, partial
from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from flint import fmpq_mpoly

from polhode._base import check
from polhode._base.rational.numbers import EXACT, nearest_double, read_number
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.constants import from_structure_constants
from polhode.analysis._conserved import Energy
from polhode.certificates._exact_tracing import trace_polynomials
from polhode.errors import InvalidInput, shown
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic._polynomials import to_expression
from polhode.proving.symbolic.brackets import LiePoissonBracket, name_symbols, read_doubles
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.systems.lie_poisson import LiePoisson
from polhode.taylor.expressions import Untraceable
from polhode.types import Array, Float64


class SymbolicSystem:
    """A Hamiltonian system on the dual of a Lie algebra, in symbols: ẋ_k = {x_k, H}.

    Args:
        bracket: the Lie–Poisson bracket with its coordinates.
        hamiltonian: a SymPy expression in its coordinates and parameters.

    Attributes:
        bracket: as given.
        hamiltonian: as given, with fractions in place of doubles, as ``bracket.read_as`` says.

    Raises:
        InvalidInput: for symbols that are neither coordinates nor parameters of the bracket.

    >>> from polhode.algebra import SO3
    >>> I1, I2, I3 = sympy.symbols("I1 I2 I3", positive=True)
    >>> so3 = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3])
    >>> body = SymbolicSystem(so3, sum(L**2 / (2 * I) for L, I in zip(so3.coordinates, (I1, I2, I3))))
    >>> running = body.to_system({I1: 1, I2: 2, I3: 3})
    >>> (6.0 * running.vector_field(0.0, jnp.array([1.0, 1.0, 1.0]))).round(9).tolist()
    [-1.0, 4.0, -3.0]
    """

    def __init__(self, bracket: LiePoissonBracket, hamiltonian: Any) -> None:
        check.instance("bracket", bracket, LiePoissonBracket, "a LiePoissonBracket")
        self.bracket, self.hamiltonian = bracket, bracket.read(hamiltonian)

    @classmethod
    def from_system(
        cls, system: AbstractLiePoissonSystem, coordinates: Sequence[Any] | None = None, read_as: str = EXACT
    ) -> SymbolicSystem:
        """Return a numerical system with exact numbers.

        Its energy is computed in fractions from the numbers that the system has, so that a moment of 3 gives 1/6, as
        certificates do (docs/symbolic.md, Doubles).

        Args:
            system: of `polhode.systems`, with an energy that is a polynomial.
            coordinates: (dim,) names or symbols of ⟨μ, e_k⟩.
            read_as: "exact" or "decimal", how doubles are read.

        Raises:
            InvalidInput: for a system that loses energy, or an energy that is no polynomial.
        """
        check.instance("system", system, AbstractLiePoissonSystem, "a Lie–Poisson system")
        if not system.conserves_energy:
            raise InvalidInput(f"{type(system).__name__} loses energy, and no Hamiltonian alone gives its motion. Take "
                               "the conservative system.")
        bracket = LiePoissonBracket(system.algebra, coordinates, system.sign, read_as=read_as)
        return cls(bracket, to_expression(_exact_energy(system, read_as).terms(), bracket.coordinates))

    @property
    def parameters(self) -> tuple[Any, ...]:
        """Symbols of the Hamiltonian and of the table of constants that are not coordinates, sorted by name."""
        symbols = set(self.hamiltonian.free_symbols)
        symbols |= {s for row in self.bracket.constants for vector in row for c in vector for s in c.free_symbols}
        return tuple(sorted(symbols - set(self.bracket.coordinates), key=str))

    @property
    def equations(self) -> dict[Any, Any]:
        """Hamilton's equations: the rate of each coordinate."""
        return self.bracket.hamilton_equations(self.hamiltonian)

    def is_integral(self, F: Any) -> bool:
        """Return whether {F, H} vanishes."""
        return sympy.simplify(self.bracket(F, self.hamiltonian)) == 0

    def subs(self, values: Mapping[Any, Any]) -> SymbolicSystem:
        """Return the system with exact numbers or expressions in place of parameters.

        Args:
            values: by symbol or name; doubles become fractions as ``bracket.read_as`` says. Symbols in them become
                parameters.

        Raises:
            InvalidInput: for a name that is no parameter, or a value that is not a number.
        """
        exact = self._exact_values(values)
        old = self.bracket
        known = {str(s): s for s in (*old.coordinates, *old.parameters)}
        new = {str(s): s for value in exact.values() for s in value.free_symbols if str(s) not in known}
        exact = {s: name_symbols(value, (*known.values(), *new.values())) for s, value in exact.items()}
        table: Any = old.algebra
        if any(c.free_symbols for row in old.constants for vector in row for c in vector) or table is None:
            table = [[[c.subs(exact) for c in vector] for vector in row] for row in old.constants]
        declared = (*old.parameters, *new.values())
        bracket = LiePoissonBracket(table, old.coordinates, old.sign, declared, old.read_as)
        return SymbolicSystem(bracket, self.hamiltonian.subs(exact))

    def _exact_values(self, values: Mapping[Any, Any]) -> dict[Any, Any]:
        known = {str(s): s for s in self.parameters}
        wrong = [str(key) for key in values if str(key) not in known]
        if wrong:
            raise InvalidInput(f"{shown(wrong[0])} is no parameter of this system; it has "
                               f"{', '.join(known) or 'none'}.")
        return {known[str(key)]: read_doubles(value, self.bracket.read_as) for key, value in values.items()}

    def to_system(
        self, values: Mapping[Any, Any] | None = None, conserved: Mapping[str, Any] | None = None
    ) -> LiePoisson:
        """Return the numerical system, for ``simulate``, ``stability`` and all other functions.

        Parameters are data: with other values nothing is compiled again.

        Args:
            values: numbers of all parameters, by symbol or name.
            conserved: further integrals, SymPy expressions by name; each must commute with H.

        Raises:
            InvalidInput: for a parameter without a number, a table that is no Lie algebra, H without real values, or a
                function that is not conserved.
        """
        values = {str(key): value for key, value in (values or {}).items()}
        self._exact_values(values)
        missing = [str(s) for s in self.parameters if str(s) not in values]
        if missing:
            raise InvalidInput(f"`values` must have a number for each parameter; {', '.join(missing)} missing.")
        exact_values = self._exact_values(values)
        if symbolic := [str(s) for s, value in exact_values.items() if not value.is_number]:
            raise InvalidInput(f"`values` must have a number for each parameter; {', '.join(symbolic)} has symbols.")
        numbers = [_as_double(str(s), exact_values[s]) for s in self.parameters]
        fixed, conserved = self.subs(values), {name: self.bracket.read(F) for name, F in (conserved or {}).items()}
        for name, F in conserved.items():
            rate = sympy.simplify(fixed.bracket(F.subs(exact_values), fixed.hamiltonian))
            if rate != 0:
                raise InvalidInput(f"`conserved` must commute with the Hamiltonian; {name} = {shown(str(F))} changes "
                                   f"at the rate {shown(str(rate))}. Leave it out.")
        algebra = self.bracket.algebra
        if algebra is None:
            exact = fixed.bracket.constants
            algebra = from_structure_constants(np.array([[[float(c) for c in v] for v in row] for row in exact]))
        functions = {name: compile_expression(F, self.bracket.coordinates, algebra, self.parameters, numbers)
                     for name, F in {"": self.hamiltonian, **conserved}.items()}
        return LiePoisson(algebra, functions.pop(""), functions, self.bracket.sign)

    def latex(self) -> str:
        """Return Hamilton's equations as LaTeX for a display."""
        lines = [rf"\dot{{{sympy.latex(x)}}} &= {sympy.latex(rate)}" for x, rate in self.equations.items()]
        return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def _as_double(name: str, value: Any) -> float:
    number = float(value) if not value.is_Rational else nearest_double(read_number(value))
    if not math.isfinite(number):
        raise InvalidInput(f"`values` must be doubles; {name} is beyond 1e308. Measure in other units.")
    return number


def as_symbolic(system: SymbolicSystem | AbstractLiePoissonSystem, read_as: str = EXACT) -> SymbolicSystem:
    """Return a system in symbols; a numerical one is read by ``SymbolicSystem.from_system``."""
    return system if isinstance(system, SymbolicSystem) else SymbolicSystem.from_system(system, read_as=read_as)


class CompiledExpression(eqx.Module):
    """A SymPy expression as a function of one point of the dual, by jax.numpy."""

    parameters: Float64[Array, "p"]
    algebra: AbstractLieAlgebra
    function: Callable[..., Any] = eqx.field(static=True)

    def __call__(self, point: Array) -> Array:
        vector = self.algebra.to_dual_vector(point)
        return jnp.asarray(self.function(vector, self.parameters), dtype=jnp.float64) + 0.0 * vector[0]


def compile_expression(
    expression: Any, coordinates: Sequence[Any], algebra: AbstractLieAlgebra, parameters: Sequence[Any] = (),
    numbers: Sequence[float] = (),
) -> CompiledExpression:
    """Return an expression as a function of one point (*element_shape) of the dual, differentiable by JAX.

    Args:
        expression: of SymPy, or a number.
        coordinates: (dim,) symbols of ⟨μ, e_k⟩; a symbol of the expression with the name of one is that one.
        algebra: whose points it takes.
        parameters: (p,) further symbols; their names are matched likewise.
        numbers: (p,) their values.

    Raises:
        InvalidInput: for symbols that are neither.
    """
    if not isinstance(expression, sympy.Basic):
        expression = read_doubles(expression, EXACT)
    expression = name_symbols(expression, (*coordinates, *parameters))
    function = _jax_function(expression, tuple(coordinates), tuple(parameters))
    return CompiledExpression(jnp.asarray(np.asarray(numbers, dtype=float)), algebra, function)


@lru_cache(maxsize=256)
def _jax_function(expression: Any, coordinates: tuple[Any, ...], parameters: tuple[Any, ...]) -> Callable[..., Any]:
    """Return the expression as a function of coordinates and parameters, one object for equal expressions.

    JAX compiles a function anew for every object, so that other values of parameters would compile all again.
    """
    return sympy.lambdify([coordinates, parameters], expression, modules="jax", cse=True)


def _exact_energy(system: AbstractLiePoissonSystem, read_as: str) -> fmpq_mpoly:
    """Return H."""
    try:
        (energy,) = trace_polynomials(Energy(system), system.algebra.dim, partial(read_number, read_as=read_as))
    except Untraceable as error:
        raise InvalidInput(
            f"the energy of {type(system).__name__} must be a polynomial to be read exactly; it has {error}. Make a "
            "SymbolicSystem from the expression itself."
        ) from None
    return energy

"""Systems with a symbolic Hamiltonian: from a numerical system, and back to one that runs."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.constants import from_structure_constants
from polhode.errors import InvalidInput, shown
from polhode.rational.numbers import exact_number, exact_numbers
from polhode.symbolic._gate import sympy
from polhode.symbolic._polynomials import from_terms
from polhode.symbolic.brackets import LiePoissonBracket
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.systems.lie_poisson import LiePoisson
from polhode.types import Array, Float64

HIGHEST_DEGREE = 4  # of a Hamiltonian that is read from a numerical system
MOST_DERIVATIVES = 100_000  # dim^degree
POINTS, AGREES = 8, 1e-12  # of H, relative to its terms


class SymbolicSystem:
    """A Hamiltonian system on the dual of a Lie algebra, in symbols: ẋ_k = {x_k, H}.

    Args:
        bracket: the Lie–Poisson bracket with its coordinates.
        hamiltonian: a SymPy expression in the coordinates; other symbols are parameters.

    Attributes:
        bracket: as given.
        hamiltonian: as given, with fractions in place of doubles.

    >>> from polhode.algebra import SO3
    >>> so3 = LiePoissonBracket(SO3(), ["L1", "L2", "L3"])
    >>> I1, I2, I3 = sympy.symbols("I1 I2 I3", positive=True)
    >>> body = SymbolicSystem(so3, sum(L**2 / (2 * I) for L, I in zip(so3.coordinates, (I1, I2, I3))))
    >>> running = body.to_system({I1: 1, I2: 2, I3: 3})
    >>> (6.0 * running.vector_field(0.0, jnp.array([1.0, 1.0, 1.0]))).round(9).tolist()
    [-1.0, 4.0, -3.0]
    """

    def __init__(self, bracket: LiePoissonBracket, hamiltonian: Any) -> None:
        if not isinstance(bracket, LiePoissonBracket):
            raise InvalidInput(f"`bracket` must be a LiePoissonBracket; got {shown(bracket)}.")
        self.bracket, self.hamiltonian = bracket, exact_expression(hamiltonian)

    @classmethod
    def from_system(cls, system: AbstractLiePoissonSystem, coordinates: Sequence[Any] | None = None) -> SymbolicSystem:
        """Return a numerical system with exact numbers.

        Its energy is read from derivatives at zero up to degree 4, whose doubles become fractions as ``exact_numbers``
        says; so a moment of 3 gives 1/6, and moments in the ratio 2 : 1 keep it.

        Args:
            system: of `polhode.systems`, with an energy that is a polynomial of degree 4 or less.
            coordinates: (dim,) names or symbols of ⟨μ, e_k⟩.

        Raises:
            InvalidInput: for a system that loses energy, an energy that is no such polynomial, or one too large.
        """
        if not isinstance(system, AbstractLiePoissonSystem):
            raise InvalidInput(f"`system` must be a Lie–Poisson system; got {shown(type(system).__name__)}.")
        if not system.conserves_energy:
            raise InvalidInput(f"{type(system).__name__} loses energy, and no Hamiltonian alone gives its motion. Take "
                               "the conservative system.")  # fmt: skip
        bracket = LiePoissonBracket(system.algebra, coordinates, system.sign)
        return cls(bracket, from_terms(_exact_energy(system), bracket.coordinates))

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
            values: by symbol or name; doubles become fractions as ``exact_numbers`` says.

        Raises:
            InvalidInput: for a name that is no parameter, or a value that is not a number.
        """
        exact = self._exact_values(values)
        if not any(c.free_symbols for row in self.bracket.constants for vector in row for c in vector):
            return SymbolicSystem(self.bracket, self.hamiltonian.subs(exact))
        table = [[[c.subs(exact) for c in vector] for vector in row] for row in self.bracket.constants]
        bracket = LiePoissonBracket(table, self.bracket.coordinates, self.bracket.sign)
        return SymbolicSystem(bracket, self.hamiltonian.subs(exact))

    def _exact_values(self, values: Mapping[Any, Any]) -> dict[Any, Any]:
        known = {str(s): s for s in self.parameters}
        wrong = [str(key) for key in values if str(key) not in known]
        if wrong:
            raise InvalidInput(f"{shown(wrong[0])} is no parameter of this system; it has "
                               f"{', '.join(known) or 'none'}.")  # fmt: skip
        exact = {}
        for key, value in values.items():
            symbolic = isinstance(value, sympy.Expr) and not isinstance(value, sympy.Float)
            if not symbolic:
                fraction = exact_number(value)
                value = sympy.Rational(fraction.numerator, fraction.denominator)
            exact[known[str(key)]] = value
        return exact

    def to_system(
        self, values: Mapping[Any, Any] | None = None, conserved: Mapping[str, Any] | None = None
    ) -> LiePoisson:
        """Return the numerical system, which ``simulate``, ``stability`` and all else take.

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
        numbers = [float(values[str(s)]) for s in self.parameters]
        fixed, exact_values = self.subs(values), self._exact_values(values)
        for name, F in (conserved or {}).items():
            rate = sympy.simplify(fixed.bracket(exact_expression(F).subs(exact_values), fixed.hamiltonian))
            if rate != 0:
                raise InvalidInput(f"`conserved` must commute with the Hamiltonian; {name} = {shown(str(F))} changes "
                                   f"at the rate {shown(str(rate))}. Leave it out.")  # fmt: skip
        algebra = self.bracket.algebra
        if algebra is None:
            exact = fixed.bracket.constants
            algebra = from_structure_constants(np.array([[[float(c) for c in v] for v in row] for row in exact]))
        functions = {name: compile_expression(F, self.bracket.coordinates, algebra, self.parameters, numbers)
                     for name, F in {"": self.hamiltonian, **(conserved or {})}.items()}  # fmt: skip
        return LiePoisson(algebra, functions.pop(""), functions, self.bracket.sign)

    def latex(self) -> str:
        """Return Hamilton's equations as LaTeX for a display."""
        lines = [rf"\dot{{{sympy.latex(x)}}} &= {sympy.latex(rate)}" for x, rate in self.equations.items()]
        return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def as_symbolic(system: SymbolicSystem | AbstractLiePoissonSystem) -> SymbolicSystem:
    """Return a system in symbols; a numerical one is read by ``SymbolicSystem.from_system``."""
    return system if isinstance(system, SymbolicSystem) else SymbolicSystem.from_system(system)


def exact_expression(expression: Any) -> Any:
    """Return a SymPy expression with fractions in place of its doubles, as ``exact_numbers`` reads them.

    >>> str(exact_expression(0.5 * sympy.Symbol("x") ** 2))
    'x**2/2'
    """
    expression = sympy.sympify(expression)
    doubles = sorted(expression.atoms(sympy.Float), key=float)
    numbers = (sympy.Rational(n.numerator, n.denominator) for n in exact_numbers([float(v) for v in doubles]))
    return expression.xreplace(dict(zip(doubles, numbers, strict=True)))


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
) -> CompiledExpression:  # fmt: skip
    """Return an expression as a function of one point (*element_shape) of the dual, differentiable by JAX.

    Args:
        expression: of SymPy, or what it understands.
        coordinates: (dim,) symbols of ⟨μ, e_k⟩.
        algebra: whose points it takes.
        parameters: (p,) further symbols.
        numbers: (p,) their values.

    Raises:
        InvalidInput: for symbols that are neither.
    """
    expression = sympy.sympify(expression)
    unknown = expression.free_symbols - set(coordinates) - set(parameters)
    if unknown:
        raise InvalidInput(f"the expression has symbols without values, {', '.join(sorted(map(str, unknown)))}. Give "
                           "their numbers.")  # fmt: skip
    function = _jax_function(expression, tuple(coordinates), tuple(parameters))
    return CompiledExpression(jnp.asarray(np.asarray(numbers, dtype=float)), algebra, function)


@lru_cache(maxsize=256)
def _jax_function(expression: Any, coordinates: tuple[Any, ...], parameters: tuple[Any, ...]) -> Callable[..., Any]:
    """Return the expression as a function of coordinates and parameters, the same one for the same expression.

    JAX compiles a function anew for every object, so that other values of parameters would compile all again.
    """
    return sympy.lambdify([coordinates, parameters], expression, modules="jax", cse=True)


def _exact_energy(system: AbstractLiePoissonSystem) -> dict[tuple[int, ...], Any]:
    """Return H as {exponents: fraction}."""
    algebra = system.algebra

    def energy(z: Array) -> Array:
        return jnp.asarray(system.energy(algebra.from_dual_vector(z)))

    derivative, terms = energy, {}
    points = np.random.default_rng(0).normal(size=(POINTS, algebra.dim))
    values = np.asarray(jax.jit(jax.vmap(energy))(jnp.asarray(points)))
    for degree in range(HIGHEST_DEGREE + 1):
        if algebra.dim**degree > MOST_DERIVATIVES:
            raise InvalidInput(
                f"reading a Hamiltonian of degree {degree} in {algebra.dim} variables takes more than "
                f"{MOST_DERIVATIVES} derivatives. Make a SymbolicSystem from the expression itself."
            )
        terms |= _taylor_terms(np.asarray(jax.jit(derivative)(jnp.zeros(algebra.dim))), degree, algebra.dim)
        if degree > 1 and _agrees(terms, points, values):
            exact = exact_numbers(list(terms.values()))
            return dict(zip(terms, exact, strict=True))
        derivative = jax.jacfwd(derivative)
    raise InvalidInput(
        f"the energy of {type(system).__name__} must be a polynomial of degree {HIGHEST_DEGREE} or less to be read "
        "exactly. Make a SymbolicSystem from the expression itself."
    )


def _taylor_terms(derivative: np.ndarray, degree: int, dim: int) -> dict[tuple[int, ...], float]:
    found = {}
    for indices in itertools.combinations_with_replacement(range(dim), degree):
        if value := float(derivative[indices]):
            counts = Counter(indices)
            factor = math.prod(math.factorial(n) for n in counts.values())
            found[tuple(counts[k] for k in range(dim))] = value / factor
    return found


def _agrees(terms: dict[tuple[int, ...], float], points: np.ndarray, values: np.ndarray) -> bool:
    parts = [value * np.prod(points**np.array(powers), axis=1) for powers, value in terms.items()]
    total, size = sum(parts, np.zeros(len(points))), sum(map(np.abs, parts), np.zeros(len(points)))
    return bool((np.abs(total - values) <= AGREES * size).all())

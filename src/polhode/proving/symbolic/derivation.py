"""Derivations that check each of their steps, by symbols and against the numerical system at random points.

A step states a formula as books print it. The bracket or condition computed here must equal it, and so must the
numbers of a system of `polhode.systems`, whose equations are written independently.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.analysis.stability import stability
from polhode.errors import PolhodeError
from polhode.poisson.brackets import poisson_tensor
from polhode.poisson.orbits import kks_form
from polhode.proving.symbolic._gate import sympy
from polhode.proving.symbolic.integrals import polynomial_integrals
from polhode.proving.symbolic.rendering import Bracket, Equation, Name, Page, Rate, Step
from polhode.proving.symbolic.second_variation import (
    SecondVariation,
    characteristic_polynomial,
    instability,
    linearisation,
    second_variation,
)
from polhode.proving.symbolic.sphere import reduce_to_sphere
from polhode.proving.symbolic.systems import SymbolicSystem
from polhode.systems.base import AbstractLiePoissonSystem


class DerivationLimits(NamedTuple):
    """How a derivation is compared with numbers, and when both agree.

    Attributes:
        points: how many random states.
        trials: how many random sets of parameters, for each condition.
        free_multiplier: value of a multiplier that the equilibrium leaves free, where numbers are compared.
        min_growth: real part of an exponent; below it are rounding errors of a double exponent.
        max_difference: of numbers, over the largest of their kind: some roundings of both sides.
    """

    points: int = 6
    trials: int = 200
    free_multiplier: float = 0.3
    min_growth: float = 1e-4
    max_difference: float = 1e-11


LIMITS = DerivationLimits()


class DerivationBroken(PolhodeError, AssertionError):
    """A step of a derivation does not hold; the message names the step, the statement and the result."""


@dataclass(frozen=True)
class Numerical:
    """The numerical system that a derivation is compared with.

    Attributes:
        make: the system for numbers of the parameters, by name.
        samples: some sets of numbers; stability is judged for each of them.
    """

    make: Callable[[Mapping[str, float]], AbstractLiePoissonSystem]
    samples: Sequence[Mapping[str, float]]


class _Case(NamedTuple):
    sample: Mapping[str, float]
    values: dict[Any, float]
    system: AbstractLiePoissonSystem


class Derivation:
    """A page in the making: each method checks a step and adds it, or raises ``DerivationBroken``.

    Args:
        title: of the page.
        system: in symbols.
        numerical: the system that it is compared with.
        seed: of the random points.
    """

    def __init__(self, title: str, system: SymbolicSystem, numerical: Numerical, seed: int = 0) -> None:
        self.title, self.system, self.numerical = title, system, numerical
        self.steps: list[Step] = []
        self._points = np.random.default_rng(seed).normal(size=(LIMITS.points, system.bracket.dim))

    def page(self) -> Page:
        """Return the page with the steps so far."""
        return Page(self.title, tuple(self.steps))

    @cached_property
    def _cases(self) -> list[_Case]:
        named = {str(s): s for s in self.system.parameters}
        return [_Case(sample, {named[k]: v for k, v in sample.items() if k in named}, self.numerical.make(sample))
                for sample in self.numerical.samples]

    @property
    def _against(self) -> str:
        system = self._cases[0].system
        return f"{type(system).__name__} at {LIMITS.points} random points for {len(self._cases)} sets of parameters"

    def _said(self, verdict: str, judged: int) -> str:
        return f"stability() says {verdict} for {judged} of {len(self._cases)} sets of parameters"

    # ------------------------------------------------------------------ steps

    def say(self, text: str, *equations: Equation, checks: Sequence[str] = ()) -> None:
        """Add a step that states definitions, which leave nothing to check, or that was checked by the caller."""
        self.steps.append(Step(text, equations, tuple(checks)))

    def brackets(self, text: str, stated: Mapping[tuple[Any, Any], Any]) -> None:
        """Add brackets of coordinates as stated; all pairs that are not stated must vanish."""
        bracket, x = self.system.bracket, self.system.bracket.coordinates
        full = {**{(b, a): -sympy.sympify(v) for (a, b), v in stated.items()}, **stated}
        for i, a in enumerate(x):
            for b in x[i:]:
                self._equal(text, f"{{{a}, {b}}}", full.get((a, b), sympy.Integer(0)), bracket(a, b))
        triples = bracket.broken_triples()
        if triples:
            raise DerivationBroken(f"{text} Jacobi's identity fails for {next(iter(triples))}: the Jacobiator is "
                                   f"{next(iter(triples.values()))}.")
        shown = [full.get((a, b), 0) for a in x for b in x]
        numbers = self._evaluate(shown, {})
        system = self._cases[0].system
        tensors = poisson_tensor(system.algebra, self._states(system), system.sign)
        self._near(text, "brackets", numbers, np.asarray(tensors).reshape(LIMITS.points, -1))
        self._add(text, (Equation(Bracket(a, b), v) for (a, b), v in stated.items()),
                  "computed from the structure constants, other pairs vanish, Jacobi's identity holds",
                  f"equal to the Poisson tensor of {type(system.algebra).__name__}")

    def hamiltonian(self, text: str, name: Name | None = None) -> None:
        """Add the Hamiltonian; its numbers must be the numerical system's energy."""
        for _, values, system in self._cases:
            off = self._evaluate([self.system.hamiltonian], values)[:, 0]
            self._near(text, "H", off, np.asarray(system.energy(self._states(system))))
        self._add(text, [Equation(name or Name("H", "H"), self.system.hamiltonian)],
                  f"equal to the energy of {self._against}")

    def equations(self, text: str, stated: Mapping[Any, Any]) -> None:
        """Add the equations of motion as stated; {x, H} and the numerical vector field must equal them."""
        x = self.system.bracket.coordinates
        for coordinate in x:
            computed = self.system.bracket(coordinate, self.system.hamiltonian)
            self._equal(text, f"d{coordinate}/dt", stated[coordinate], computed)
        for _, values, system in self._cases:
            field = system.algebra.to_dual_vector(system.vector_field(0.0, self._states(system)))
            self._near(text, "rates", self._evaluate([stated[c] for c in x], values), np.asarray(field))
        self._add(text, (Equation(Rate(c), stated[c]) for c in x), "equal to the brackets with H",
                  f"equal to the vector field of {self._against}")

    def casimirs(self, text: str, stated: Mapping[Name, Any], degree: int = 2) -> None:
        """Add the polynomial Casimirs up to a degree; none may be missing, and they must give the numerical ones."""
        bracket = self.system.bracket
        for name, C in stated.items():
            if not bracket.is_casimir(C):
                raise DerivationBroken(f"{text} {name.text} = {C} is no Casimir: some bracket does not vanish.")
        generators = bracket.casimirs(degree)
        if len(generators) != len(stated):
            raise DerivationBroken(f"{text} {len(stated)} Casimirs are stated, and there are {len(generators)} up to "
                                   f"degree {degree}: {', '.join(map(str, generators))}.")
        system = self._cases[0].system
        values = np.asarray(system.algebra.casimirs(self._states(system)))
        mine = self._evaluate([*stated.values()], {})
        self._near(text, "Casimirs", mine @ np.linalg.lstsq(mine, values, rcond=None)[0], values)
        self._add(text, (Equation(name, C) for name, C in stated.items()), "brackets with all coordinates vanish",
                  f"linear algebra finds as many up to degree {degree}",
                  f"the Casimirs of {type(system.algebra).__name__} are linear combinations")

    def integral(self, text: str, name: Name, F: Any) -> None:
        """Add an integral; {F, H} must vanish, and so must its rate along the numerical vector field."""
        self._equal(text, f"the rate of {name.text}", sympy.Integer(0), self.system.bracket(F, self.system.hamiltonian))
        for _, values, system in self._cases:
            self._constant(text, name.text, F, values, system)
        self._add(text, [Equation(name, F)], "its bracket with H vanishes", f"constant along {self._against}")

    def _constant(
        self, text: str, name: str, F: Any, values: Mapping[Any, float], system: AbstractLiePoissonSystem
    ) -> None:
        field = np.asarray(system.algebra.to_dual_vector(system.vector_field(0.0, self._states(system))))
        slopes = self._evaluate([sympy.diff(F, x) for x in self.system.bracket.coordinates], values)
        size = float(np.abs(slopes).max() * np.abs(field).max())
        self._near(text, f"the rate of {name}", (slopes * field).sum(axis=1), np.zeros(LIMITS.points), size)

    def further_integrals(self, text: str, degree: int, stated: Sequence[Any]) -> None:
        """Add the integrals of ``polynomial_integrals`` for generic parameters; there must be as many as are stated.

        The stated ones must be functions of them, H and the Casimirs, by the rank of gradients.
        """
        integrals = polynomial_integrals(self.system, degree)
        x = self.system.bracket.coordinates
        base = [*self.system.bracket.casimirs(2), self.system.hamiltonian, *integrals]
        ranks = [_gradient_rank([*base, *more], x) for more in ([], stated)]
        if len(integrals) != len(stated) or ranks[0] != ranks[1]:
            raise DerivationBroken(f"{text} {len(stated)} further integrals are stated up to degree {degree}, and "
                                   f"there are {len(integrals)}: {', '.join(map(str, integrals))}.")
        for F in integrals:
            for _, place, numerical in self._cases:
                self._constant(text, "F", F, place, numerical)
        words = "computed by exact linear algebra" if integrals else "exact linear algebra finds no other"
        along = [f"constant along {self._against}"] if integrals else []
        self._add(text, [Equation(Name("F", "F"), F) for F in integrals], f"{words} up to degree {degree}", *along)

    def stable_if(self, text: str, point: Sequence[Any], conserved: Sequence[Any], condition: Any) -> None:
        """Add the condition for the second variation to be definite; where it holds, ``stability`` must say stable."""
        variation = second_variation(self.system, point, conserved)
        self._same_condition(text, condition, variation.definite)
        self._check_variation(text, point, conserved, variation)
        judged = self._judge(text, point, condition, "stable")
        names = sympy.symbols(f"lambda1:{len(conserved) + 1}")
        total = sympy.Symbol("H") + sum((n * C for n, C in zip(names, conserved, strict=True)), sympy.Integer(0))
        lines = [Equation(Name("F", "F"), total)]
        lines += [Equation(n, v) for n, v in zip(names, variation.multipliers, strict=True) if str(v) != str(n)]
        lines.append(Equation(Name(r"D^2 F", "D²F"), variation.matrix))
        self._add(text, [*lines, Equation(Name(r"\text{stable}", "stable"), condition, "⇐")],
                  f"definite by the minors exactly then, for {LIMITS.trials} random parameters",
                  "equal to derivatives of the numerical energy", self._said("stable", judged))

    def unstable_if(self, text: str, point: Sequence[Any], condition: Any, polynomial: Any) -> None:
        """Add characteristic polynomial and condition of instability; where it holds, ``stability`` must agree."""
        computed = characteristic_polynomial(self.system, point)
        self._equal(text, "det(s − A)", polynomial, computed)
        self._same_condition(text, condition, instability(self.system, point))
        judged = self._judge(text, point, condition, "unstable")
        self._add(text, [Equation(Name(r"\det(s - A)", "det(s − A)"), polynomial),
                         Equation(Name(r"\text{unstable}", "unstable"), condition, "⇐")],
                  "the polynomial is that of the linearised equations",
                  f"its roots decide the condition, for {LIMITS.trials} random parameters",
                  self._said("unstable", judged))

    def exponents_if(self, text: str, point: Sequence[Any], condition: Any) -> None:
        """Add a condition of instability; the largest real part of the numerical exponents must be positive just then.

        It is judged for many random parameters, and ``stability`` for the samples where it holds.
        """
        jacobian = linearisation(self.system, point)
        symbols = sorted(jacobian.free_symbols | condition.free_symbols, key=str)
        rng = np.random.default_rng(2)
        matrix = sympy.lambdify(symbols, jacobian, modules="numpy")
        numbers = rng.uniform(0.2, 2.0, size=(LIMITS.trials, len(symbols)))
        holds = _evaluate_condition(condition, symbols, list(numbers.T))
        for row, expected in zip(numbers, holds, strict=True):
            if (float(np.linalg.eigvals(matrix(*row)).real.max()) > LIMITS.min_growth) != expected:
                place = dict(zip(map(str, symbols), map(float, row), strict=True))
                raise DerivationBroken(f"{text} for {place} the exponents do not behave as {condition} says.")
        judged = self._judge(text, point, condition, "unstable")
        self._add(text, [Equation(Name(r"\text{unstable}", "unstable"), condition, "⇐")],
                  f"for {LIMITS.trials} random sets of parameters exponents have a positive real part exactly then",
                  self._said("unstable", judged))

    def vanishes(self, text: str, expression: Any) -> None:
        """Add an expression that is zero by algebra."""
        self._equal(text, str(expression), sympy.Integer(0), expression)
        self._add(text, [Equation(expression, sympy.Integer(0))], "by algebra")

    def sphere(self, text: str) -> None:
        """Add the reduction to a sphere |L| = const; rates and form must be those of the numerical system there."""
        reduced = reduce_to_sphere(self.system)
        x = self.system.bracket.coordinates
        planar = self._points / np.linalg.norm(self._points, axis=1, keepdims=True)
        angles, radius = np.arctan2(planar[:, 1], planar[:, 0]), 1.5
        for _, values, system in self._cases:
            field = np.asarray(system.vector_field(0.0, jnp.asarray(radius * planar)))
            x1, x2 = radius * planar[:, 0], radius * planar[:, 1]
            turning = (x1 * field[:, 1] - x2 * field[:, 0]) / (x1**2 + x2**2)
            symbols = [reduced.radius, reduced.angle, reduced.height, *values]
            rates = sympy.lambdify(symbols, [*reduced.rates.values(), reduced.hamiltonian], modules="numpy")
            stated = np.array([rates(radius, a, radius * z, *values.values())
                               for a, z in zip(angles, planar[:, 2], strict=True)])
            energy = np.asarray(system.energy(jnp.asarray(radius * planar)))
            numbers = np.stack([turning, field[:, 2], energy], axis=1)
            self._near(text, "rates and energy on the sphere", stated, numbers)
        system, e = self._cases[0].system, np.eye(3)
        # at μ = (1, 0, ½) these elements move by −∂φ and by ∂z
        form = float(kks_form(system.algebra, jnp.array([1.0, 0.0, 0.5]), e[2], e[1], system.sign))
        self._near(text, "the KKS form", np.array(-float(reduced.form)), np.array(form))
        place = sympy.Tuple(*reduced.embedding)
        named = [Equation(sympy.Tuple(*x), place), Equation(Name("H", "H"), reduced.hamiltonian),
                 Equation(Name(r"\omega", "ω"), Name(f"{'-' if reduced.form < 0 else ''}d\\varphi \\wedge dz",
                                                    f"{'−' if reduced.form < 0 else ''}dφ ∧ dz"))]  # fmt: skip
        self._add(text, [*named, *(Equation(Rate(v), rate) for v, rate in reduced.rates.items())],
                  "the brackets of coordinates restrict to the sphere",
                  f"equal to vector field and energy of {self._against}",
                  "equal to the KKS form of ad* vectors")

    # ------------------------------------------------------------------ checks

    def _add(self, text: str, equations: Iterable[Equation], *checks: str) -> None:
        self.steps.append(Step(text, tuple(equations), checks))

    def _equal(self, text: str, what: str, stated: Any, computed: Any) -> None:
        off = sympy.simplify(sympy.expand(sympy.sympify(stated) - computed))
        if off != 0:
            raise DerivationBroken(f"{text} {what} is stated as {stated}, and computed as {sympy.factor(computed)}.")

    def _states(self, system: AbstractLiePoissonSystem) -> Any:
        return system.algebra.from_dual_vector(jnp.asarray(self._points))

    def _evaluate(self, expressions: Sequence[Any], values: Mapping[Any, float]) -> np.ndarray:
        """Return the numbers (points, expressions)."""
        symbols = [*self.system.bracket.coordinates, *values]
        function = sympy.lambdify(symbols, [sympy.sympify(e) for e in expressions], modules="numpy")
        return np.array([function(*point, *values.values()) for point in self._points], dtype=float)

    def _near(self, text: str, what: str, stated: np.ndarray, numbers: np.ndarray, size: float = 0.0) -> None:
        size = max(size, float(np.abs(numbers).max(initial=0.0)))
        off = float(np.abs(stated - numbers).max(initial=0.0))
        if not off <= LIMITS.max_difference * size:
            raise DerivationBroken(f"{text} {what}: the numerical system differs from what is stated by {off:.3g}, "
                                   f"where the values are up to {size:.3g}.")

    def _same_condition(self, text: str, stated: Any, computed: Any) -> None:
        """Require two conditions to agree for random parameters, multiples of 1/8, which are exact doubles."""
        symbols = sorted(stated.free_symbols | computed.free_symbols, key=str)
        rng = np.random.default_rng(1)
        numbers = [rng.integers(1 if s.is_positive else -40, 41, size=LIMITS.trials) / 8.0 for s in symbols]
        holds = [_evaluate_condition(one, symbols, numbers) for one in (stated, computed)]
        for k in np.flatnonzero(holds[0] != holds[1])[:1]:
            place = {str(s): float(values[k]) for s, values in zip(symbols, numbers, strict=True)}
            raise DerivationBroken(f"{text} the condition is stated as {stated}, and computed as {computed}; they "
                                   f"differ at {place}.")

    def _check_variation(
        self, text: str, point: Sequence[Any], conserved: Sequence[Any], variation: SecondVariation
    ) -> None:
        """Require gradient and second variation of H + Σ λ C to be those of the numerical energy by differentiation."""
        x = self.system.bracket.coordinates
        total = sum((n * C for n, C in zip(variation.multipliers, conserved, strict=True)), sympy.Integer(0))
        for sample, _, system in self._cases:
            place = {s: sample.get(str(s), LIMITS.free_multiplier)
                     for s in (*_symbols_of(point), *_symbols_of(variation.multipliers))}
            place |= {s: sample[str(s)] for s in self.system.parameters}
            z = [float(sympy.sympify(p).subs(place)) for p in point]

            def energy(v: Any, system: AbstractLiePoissonSystem = system) -> Any:
                return jnp.asarray(system.energy(system.algebra.from_dual_vector(v)))

            slope, hessian = jax.jit(lambda v, f=energy: (jax.grad(f)(v), jax.hessian(f)(v)))(jnp.array(z))
            at = dict(zip(x, z, strict=True)) | place
            other = np.array(sympy.Matrix([total]).jacobian(x).subs(at), dtype=float)[0]
            second = np.array(sympy.hessian(total, x).subs(at), dtype=float)
            size = max(float(np.abs(slope).max()), float(np.abs(other).max()))
            self._near(text, "the gradient of H + Σ λ C", np.asarray(slope) + other, np.zeros(len(x)), size)
            basis = np.array(variation.basis.subs(place), dtype=float)
            numbers = basis.T @ (np.asarray(hessian) + second) @ basis
            self._near(text, "the second variation", np.array(variation.matrix.subs(place), dtype=float), numbers)

    def _judge(self, text: str, point: Sequence[Any], condition: Any, verdict: str) -> int:
        """Require the verdict of ``stability`` for samples that satisfy the condition; return how many do."""
        judged = 0
        for sample, _, system in self._cases:
            numbers = {s: sample[str(s)] for s in _symbols_of([*point, condition])}
            if not bool(sympy.sympify(condition).subs(numbers)):
                continue
            z = jnp.array([float(sympy.sympify(p).subs(numbers)) for p in point])
            numerical = stability(system, np.asarray(system.algebra.from_dual_vector(z))).verdict
            if numerical != verdict:
                raise DerivationBroken(f"{text} for {dict(sample)} the condition says {verdict}, and stability() "
                                       f"{numerical}.")
            judged += 1
        if not judged:
            raise DerivationBroken(f"{text} none of the sets of parameters satisfies {condition}, so nothing is "
                                   "compared with stability(). Add one.")
        return judged


def _evaluate_condition(condition: Any, symbols: Sequence[Any], numbers: Sequence[np.ndarray]) -> np.ndarray:
    """Return where a condition holds (trials,)."""
    holds = sympy.lambdify(symbols, condition, modules="numpy")(*numbers)
    return np.broadcast_to(np.asarray(holds, dtype=bool), (LIMITS.trials,))


def _symbols_of(expressions: Iterable[Any]) -> set[Any]:
    return set().union(*(sympy.sympify(e).free_symbols for e in expressions))


def _gradient_rank(functions: Sequence[Any], coordinates: Sequence[Any]) -> int:
    """Return how many functions are independent at a point without special values."""
    point = {x: sympy.Rational(3 + 7 * k * k, 11 + 2 * k) for k, x in enumerate(coordinates)}
    symbols = _symbols_of(functions) - set(coordinates)
    point |= {s: sympy.Rational(5 + 3 * k * k, 7 + 4 * k) for k, s in enumerate(sorted(symbols, key=str))}
    rows = [[sympy.diff(F, x).subs(point) for x in coordinates] for F in functions]
    return sympy.Matrix(rows).rank()

"""From a function written with JAX to its polynomials: its jaxpr evaluated in rational arithmetic.

Numbers in arrays are read by ``rational.numbers.read_number``; from there on nothing is rounded. What is no polynomial
in the point raises ``Untraceable``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from flint import fmpq_mpoly

from polhode._base.rational._polynomials import context
from polhode._base.rational._polynomials import total as sum_polynomials
from polhode._base.rational.numbers import as_fmpq, as_fraction, read_number
from polhode.taylor.expressions import Complex, Expression, Tape, Untraceable
from polhode.taylor.operations import Operation
from polhode.taylor.structure import Structure, split_numbers
from polhode.taylor.tracing import evaluate
from polhode.types import Array

Reader = Callable[[float], Fraction]


class TracingLimits(NamedTuple):
    """What may be multiplied out."""

    # of a term and a term while one function is traced: some two seconds, (x1 + x2 + x3)**83
    max_products: int = 300_000


LIMITS = TracingLimits()


class Unaffordable(Untraceable):
    """A polynomial that would take too long to multiply out."""


def trace_polynomials(
    function: Callable[[Array], Array], size: int, read: Reader = read_number, most_products: int = LIMITS.max_products
) -> list[fmpq_mpoly]:
    """Return the components of a function of points (size,), real, as polynomials.

    Args:
        function: a pytree with ``__call__``, whose real arrays are read as numbers, or any function.
        size: of the point.
        read: how a double becomes a rational number.
        most_products: of two terms, while brackets are multiplied out.

    Raises:
        Untraceable: naming the operation that makes no polynomial.
        Unaffordable: beyond the products, as (x1 + x2 + x3)**200 is.
    """
    tape = ExactTape(size, read, most_products)
    point = np.array(tape.state(), object)
    try:
        structure, leaves = split_numbers(function)  # type: ignore[arg-type]
        numbers = np.concatenate([np.zeros(0), *(np.ravel(np.asarray(x, float)) for x in leaves)])
        closed = _trace_structure(structure, size)
        given = [_exact(tape, numbers), point]
    except (TypeError, jax.errors.JAXTypeError):  # it cannot be taken apart, or branches on its own numbers
        closed = jax.make_jaxpr(function)(jnp.zeros(size))
        given = [point]
    (traced,) = evaluate(closed, *given, read=lambda x: _exact(tape, np.asarray(x)))
    return [tape.as_polynomial(x) for x in np.ravel(traced)]


@lru_cache(maxsize=64)
def _trace_structure(structure: Structure, size: int) -> Any:
    """Return the jaxpr of a function by its numbers and the point, kept: numbers alone differ from call to call."""
    numbers = jnp.zeros(structure.size)
    return jax.make_jaxpr(lambda c, x: structure.with_numbers(c)(x))(numbers, jnp.zeros(size))  # type: ignore[operator]


def _exact(tape: ExactTape, x: Array) -> Array:
    """Return an array of floating-point numbers as expressions, any other as it is."""
    if not np.issubdtype(x.dtype, np.inexact):
        return x
    traced = np.empty(x.shape, object)
    for k in np.ndindex(x.shape):
        value = x[k]
        traced[k] = (Complex(tape.constant(value.real), tape.constant(value.imag)) if np.iscomplexobj(value)
                    else tape.constant(value))
    return traced


class ExactTape(Tape):
    """A tape without nodes: expressions are polynomials in the state themselves."""

    def __init__(self, size: int, read: Reader, most_products: int) -> None:
        super().__init__(size)
        self.context = context(size)
        self.read, self.most_products, self.products = read, most_products, 0

    def multiply_out(self, a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        """Return a product, if there is enough left of the products of terms.

        Raises:
            Unaffordable: where there is not.
        """
        self.products += len(a) * len(b)
        if self.products > self.most_products:
            raise Unaffordable(f"brackets with more than {self.most_products:,} products of terms to multiply out")
        return a * b

    def state(self) -> list[Expression]:
        return [ExactExpression(self, x) for x in self.context.gens()]

    def constant(self, value: Any) -> ExactExpression:
        number = value if isinstance(value, Fraction) else self._read(value)
        return ExactExpression(self, self.context.constant(as_fmpq(number)))

    def _read(self, value: Any) -> Fraction:
        if not math.isfinite(float(value)):
            raise Untraceable(f"the number {float(value)}")
        return self.read(float(value))

    def as_polynomial(self, x: Any) -> fmpq_mpoly:
        """Return a value as a polynomial."""
        if isinstance(x, Complex):
            if self.as_polynomial(x.imag):
                raise Untraceable("a complex value")
            x = x.real
        return x.polynomial if isinstance(x, ExactExpression) else self.constant(x).polynomial

    def find_number(self, x: Any) -> float | None:
        return None if isinstance(x, Expression) and x.terms else float(self._number(x))

    def _number(self, x: Any) -> Fraction:
        if isinstance(x, Expression):
            if x.terms:
                raise Untraceable("a branch on something that moves")
            return Fraction(x.constant)
        return self._read(x)

    def at_instants(self, x: Any) -> np.ndarray:
        return np.array([self._number(x)], object)

    def decide(self, answers: np.ndarray) -> bool:
        return bool(np.all(answers))

    def total(self, summands: Iterable[Any]) -> Expression:
        return ExactExpression(self, sum_polynomials(self.size, map(self.as_polynomial, summands)))

    def unary(self, operation: Operation, x: Expression, number: float = 0.0) -> Expression:
        raise Untraceable(f"{operation.name.lower().replace('_', ' ')} of something that moves")


class ExactExpression(Expression):
    """A polynomial where tracing expects an expression."""

    __slots__ = ("polynomial",)

    def __init__(self, tape: ExactTape, polynomial: fmpq_mpoly) -> None:
        self.tape, self.polynomial = tape, polynomial

    @property
    def terms(self) -> Any:
        """What moves: terms are by monomials here, where others have nodes, and exact."""
        return {} if self.polynomial.is_constant() else self.polynomial.to_dict()

    @property
    def constant(self) -> Any:
        """The term without a variable."""
        return as_fraction(self.polynomial[(0,) * self.tape.size])

    def _of(self, polynomial: fmpq_mpoly) -> ExactExpression:
        return ExactExpression(self.tape, polynomial)  # type: ignore[arg-type]

    def _polynomial(self, other: Any) -> fmpq_mpoly:
        return self.tape.as_polynomial(other)  # type: ignore[attr-defined]

    def _times(self, other: fmpq_mpoly) -> fmpq_mpoly:
        return self.tape.multiply_out(self.polynomial, other)  # type: ignore[attr-defined]

    def scale(self, factor: Any) -> ExactExpression:
        return self._of(self._times(self._polynomial(factor)))

    def __add__(self, other: Any) -> Any:
        if isinstance(other, Complex | complex):
            return Complex.of(other) + self
        return self._of(self.polynomial + self._polynomial(other))

    __radd__ = __add__

    def __neg__(self) -> ExactExpression:
        return self._of(-self.polynomial)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Complex | complex):
            return Complex.of(other) * self
        return self._of(self._times(self._polynomial(other)))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, Complex | complex):
            return Complex.of(self) / other
        divisor = self._polynomial(other)
        if not divisor.is_constant() or not divisor:
            raise Untraceable("division by something that moves")
        return self._of(self.polynomial / divisor.leading_coefficient())

    def __rtruediv__(self, other: Any) -> Any:
        return self._of(self._polynomial(other)) / self

    def __pow__(self, exponent: float) -> ExactExpression:
        whole = int(exponent) if float(exponent).is_integer() else None
        if whole is not None and whole >= 0:
            power = self._of(self.polynomial**0)
            for _ in range(whole):
                power = self._of(power._times(self.polynomial))
            return power
        if self.terms:
            raise Untraceable(f"the power {float(exponent):g} of something that moves")
        if not self.constant:
            raise Untraceable("a power of zero that is not finite")
        if whole is not None:
            return self.tape.constant(self.constant**whole)  # type: ignore[return-value]
        # a root of parameters is a number that the code rounds, and is taken as it is rounded there
        return self.tape.constant(float(self.constant) ** float(exponent))  # type: ignore[return-value]

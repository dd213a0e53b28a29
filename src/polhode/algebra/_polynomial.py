"""Polynomials with exact rational coefficients that can be called and printed."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_jax
from polhode._base.rational._terms import show_terms
from polhode.types import Array, ArrayLike, Float64, Real


class Polynomial:
    """Σ c_m Π x_i^{e_mi} in the coordinates ⟨μ, e_i⟩, homogeneous.

    Args:
        exponents: (terms, dim) whole numbers.
        coefficients: (terms,) exact.

    >>> str(Polynomial(np.array([[2, 0], [0, 2]]), [Fraction(1), Fraction(-3)]))
    'x1² − 3 x2²'
    """

    def __init__(self, exponents: np.ndarray, coefficients: list[Fraction]) -> None:
        self.exponents = np.asarray(exponents, dtype=int)
        self.coefficients = tuple(coefficients)

    @property
    def degree(self) -> int:
        """Degree of every term."""
        return int(self.exponents[0].sum())

    def __call__(self, point: Real[ArrayLike, "*batch dim"]) -> Float64[Array, "*batch"]:
        """Return the values (…) at coordinates (…, dim), NumPy or JAX."""
        xp: Any = jnp if is_jax(point) else np
        x = xp.asarray(point)
        total = 0.0 * x[..., 0]
        for powers, coefficient in zip(self.exponents, self.coefficients, strict=True):
            term = float(coefficient)
            for i in np.flatnonzero(powers):
                term = term * x[..., i] ** int(powers[i])
            total = total + term
        return total

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Polynomial) and self._terms == other._terms

    def __hash__(self) -> int:
        return hash(self._terms)

    @property
    def _terms(self) -> tuple[Any, ...]:
        return self.exponents.tobytes(), self.exponents.shape, self.coefficients

    def __str__(self) -> str:
        return show_terms(zip(self.exponents.tolist(), self.coefficients, strict=True))

    def __repr__(self) -> str:
        return f"Polynomial({self})"

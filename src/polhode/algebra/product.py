"""Direct sums of different algebras."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode.algebra._rotations import check_rotations
from polhode.algebra.base import AbstractLieAlgebra, Operand, Vector
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Float64


class Product(AbstractLieAlgebra):
    """The direct sum of algebras; elements are their coordinates one behind the other (…, dim), likewise the dual.

    Args:
        factors: the algebras.
        rotations: components that are an so(3) and carry an attitude, as for ``from_structure_constants``.
    """

    factors: tuple[AbstractLieAlgebra, ...]
    given_rotations: tuple[int, ...] = eqx.field(static=True)

    def __init__(self, *factors: AbstractLieAlgebra, rotations: Sequence[int] = ()) -> None:
        if not factors or not all(isinstance(factor, AbstractLieAlgebra) for factor in factors):
            raise InvalidInput(f"`Product` must be given algebras, one at least; got {shown(factors)}. "
                               "Write Product(first, second), without brackets around them.")
        self.factors, self.given_rotations = factors, ()
        if not (isinstance(rotations, Sequence) and not rotations):
            self.given_rotations = check_rotations(Product(*factors).structure_constants(), rotations)

    @property
    def rotations(self) -> tuple[int, ...]:
        return self.given_rotations

    @property
    def dim(self) -> int:
        return sum(factor.dim for factor in self.factors)

    @property
    def name(self) -> str:
        return " ⊕ ".join(factor.name for factor in self.factors)

    @property
    def casimir_names(self) -> tuple[str, ...]:
        return tuple(f"{name} of {k}" for k, factor in enumerate(self.factors) for name in factor.casimir_names)

    def split(self, vector: Float64[Array, "... {self.dim}"]) -> Sequence[Float64[Array, "..."]]:
        """Return each factor's coordinates."""
        ends = np.cumsum([factor.dim for factor in self.factors])[:-1]
        return jnp.split(jnp.asarray(vector), ends, axis=-1)

    def bracket(self, x: Operand, y: Operand) -> Vector:
        def one(f: AbstractLieAlgebra, a: Array, b: Array) -> Array:
            return f.to_vector(f.bracket(f.from_vector(a), f.from_vector(b)))

        return self._each(one, x, y)

    def coadjoint(self, x: Operand, mu: Operand) -> Vector:
        def one(f: AbstractLieAlgebra, a: Array, b: Array) -> Array:
            return f.to_dual_vector(f.coadjoint(f.from_vector(a), f.from_dual_vector(b)))

        return self._each(one, x, mu)

    def casimirs(self, mu: Vector) -> Float64[Array, "*batch k"]:
        parts = zip(self.factors, self.split(mu), strict=True)
        return jnp.concatenate([f.casimirs(f.from_dual_vector(part)) for f, part in parts], axis=-1)

    def named_casimirs(self, mu: Operand) -> dict[str, Float64[Array, "..."]]:
        parts = enumerate(zip(self.factors, self.split(mu), strict=True))
        return {
            f"{name} of {k}": values
            for k, (f, part) in parts
            for name, values in f.named_casimirs(f.from_dual_vector(part)).items()
        }

    @property
    def casimirs_of_copies(self) -> tuple[str, ...]:
        return tuple(f"{name} of {k}" for k, factor in enumerate(self.factors) for name in factor.casimirs_of_copies)

    def exp_change(self, x: Operand, mu: Operand) -> Vector:
        def one(f: AbstractLieAlgebra, a: Array, b: Array) -> Array:
            return f.to_dual_vector(f.exp_change(f.from_vector(a), f.from_dual_vector(b)))

        return self._each(one, x, mu)

    def cayley_change(self, x: Operand, mu: Operand) -> Vector:
        def one(f: AbstractLieAlgebra, a: Array, b: Array) -> Array:
            return f.to_dual_vector(f.cayley_change(f.from_vector(a), f.from_dual_vector(b)))

        return self._each(one, x, mu)

    def exp(self, x: Vector) -> Any:
        """Return the factors' group elements, a tuple."""
        return tuple(f.exp(f.from_vector(part)) for f, part in zip(self.factors, self.split(x), strict=True))

    def cayley(self, x: Vector) -> Any:
        return tuple(f.cayley(f.from_vector(part)) for f, part in zip(self.factors, self.split(x), strict=True))

    def compose(self, g: Any, h: Any) -> Any:
        return tuple(f.compose(a, b) for f, a, b in zip(self.factors, g, h, strict=True))

    def coadjoint_action(self, g: Any, mu: Operand) -> Vector:
        parts = zip(self.factors, g, self.split(mu), strict=True)
        moved = [f.to_dual_vector(f.coadjoint_action(one, f.from_dual_vector(part))) for f, one, part in parts]
        return jnp.concatenate(moved, axis=-1)

    def _each(self, function: Callable[..., Array], x: Array, y: Array) -> Array:
        parts = zip(self.factors, self.split(x), self.split(y), strict=True)
        return jnp.concatenate([function(*part) for part in parts], axis=-1)

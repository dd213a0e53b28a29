"""Semidirect sums: an algebra acting on a vector space, as rotations act on a direction advected by the body."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.algebra._fixed_array import FixedArray
from polhode.algebra._functions import Function
from polhode.algebra.base import AbstractLieAlgebra, Operand, Vector
from polhode.algebra.constants import ConstantsAlgebra
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Float64, Real


class RepresentationLimits(NamedTuple):
    """What decides that matrices represent an algebra."""

    max_residual: float = 1e-12  # of the representation's identity, relative to the generators


LIMITS = RepresentationLimits()


class Semidirect(ConstantsAlgebra):
    """[(x, v), (y, w)] = ([x, y], x·w − y·v), the algebra acting on vectors by matrices.

    ad*_(x,v) (μ, a) = (ad*_x μ − v ⋄ a, ρ(x)ᵀ a) with (v ⋄ a)_i = a · ρ_i v. Elements (…, dim + m), the algebra's
    coordinates first. Source: Marsden, Ratiu & Weinstein, Trans. Amer. Math. Soc. 281 (1984) 147.

    Args:
        algebra: the algebra that acts.
        generators: (dim, m, m), the matrices ρ_i by which its basis acts.
        casimirs: functions of coordinates (dim + m,), as for ``from_structure_constants``.
        names: of these, as there.
        rotations: components that are an so(3) and carry an attitude, as there.

    Raises:
        InvalidInput: if the generators do not represent the algebra, [ρ_i, ρ_j] = Σ c_ijk ρ_k; the indices are named.
            If a function is not a Casimir, names do not fit, or components span no so(3).
    """

    algebra: AbstractLieAlgebra
    action: FixedArray = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self,
        algebra: AbstractLieAlgebra,
        generators: Real[ArrayLike, "dim m m"],
        casimirs: Iterable[Function] | None = None,
        names: Iterable[str] | None = None,
        rotations: Sequence[int] = (),
    ) -> None:
        require_doubles(generators=generators)
        rho = np.array(generators, dtype=float)
        if rho.ndim != 3 or rho.shape[0] != algebra.dim or rho.shape[1] != rho.shape[2]:
            raise InvalidInput(f"`generators` must have shape ({algebra.dim}, m, m); got {rho.shape}.")
        commutators = rho[:, None] @ rho[None] - rho[None] @ rho[:, None]
        error = np.abs(commutators - np.einsum("ijk,kab->ijab", algebra.structure_constants(), rho)).max(axis=(2, 3))
        i, j = np.unravel_index(np.argmax(error), error.shape)
        if not error[i, j] <= LIMITS.max_residual * max(1.0, np.abs(rho).max() ** 2):
            raise InvalidInput(
                f"`generators` must represent {algebra.name}: [ρ_i, ρ_j] = Σ c_ijk ρ_k fails for (i, j) = ({i}, {j}), "
                f"counted from 0, by {error[i, j]:.3g}."
            )
        super().__init__(_constants(algebra.structure_constants(), rho), casimirs, names=names, rotations=rotations)
        self.algebra, self.action = algebra, FixedArray(rho)

    @property
    def generators(self) -> Float64[Array, "dim m m"]:
        """The matrices ρ_i (dim, m, m)."""
        return self.action.values

    @property
    def name(self) -> str:
        return f"{self.algebra.name} ⋉ R^{self.generators.shape[1]}"

    def bracket(self, x: Operand, y: Operand) -> Vector:
        (a, v), (b, w) = self._parts(x), self._parts(y)
        f = self.algebra
        first = f.to_vector(f.bracket(f.from_vector(a), f.from_vector(b)))
        second = self._act(a, w) - self._act(b, v)
        return jnp.concatenate([first, second], axis=-1)

    def coadjoint(self, x: Operand, mu: Operand) -> Vector:
        (a, v), (m, p) = self._parts(x), self._parts(mu)
        f = self.algebra
        first = f.to_dual_vector(f.coadjoint(f.from_vector(a), f.from_dual_vector(m)))
        # ⟨ad*_(x,v) (μ, a), (y, w)⟩ = ⟨μ, [x, y]⟩ + a·ρ(x)w − a·ρ(y)v
        diamond = jnp.einsum("...p,ipq,...q->...i", p, self.generators, v)
        second = jnp.einsum("...i,ipq,...p->...q", a, self.generators, p)
        return jnp.concatenate([first - diamond, second], axis=-1)

    def _act(self, a: Array, v: Array) -> Array:
        return jnp.einsum("...i,ipq,...q->...p", a, self.generators, v)

    def _parts(self, x: Array) -> tuple[Array, Array]:
        x = jnp.asarray(x)
        return x[..., : self.algebra.dim], x[..., self.algebra.dim :]


def _constants(own: Float64[Array, "dim dim dim"], rho: Float64[Array, "dim m m"]) -> Float64[Array, "n n n"]:
    """Return the structure constants: [e_i, e_j] of the algebra, and [e_i, v_a] = ρ_i v_a."""
    n, m = rho.shape[:2]
    constants = np.zeros((n + m, n + m, n + m))
    constants[:n, :n, :n] = own
    acted = rho.transpose(0, 2, 1)
    constants[:n, n:, n:], constants[n:, :n, n:] = acted, -acted.transpose(1, 0, 2)
    return constants

"""A rigid body in an ideal fluid at rest at infinity, on se(3)*."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.se3 import SE3
from polhode.errors import InvalidInput
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, components
from polhode.systems.free_rigid_body import axis_flows
from polhode.types import Array, ArrayLike, Float64, Real


class Kirchhoff(AbstractLiePoissonSystem):
    """H = ½ (Π, P)·M⁻¹(Π, P): Π̇ = Π × Ω + P × U, Ṗ = P × Ω with (Ω, U) = M⁻¹(Π, P).

    Π and P are the impulses of body and fluid. State (Π, P) (…, 6), or with the attitude (…, 10). Where M is diagonal
    the flows are rotation about each axis and the part of P, which kicks Π.

    Args:
        inertia: M (6, 6), symmetric positive definite, or its diagonal (6,): moments and masses with what the fluid
            adds [kg m², kg].

    Raises:
        InvalidInput: for a matrix that is not symmetric positive definite.

    Source: Lamb, *Hydrodynamics*, ch. VI; Leonard, Automatica 33 (1997) 331.
    """

    algebra: AbstractLieAlgebra
    inverse: Float64[Array, "6 6"]
    diagonal: bool

    @known_numbers_only
    def __init__(self, inertia: Real[ArrayLike, "..."]) -> None:
        require_doubles(inertia=inertia)
        matrix = np.asarray(inertia, dtype=float)
        matrix = np.diag(matrix) if matrix.shape == (6,) else matrix
        if matrix.shape != (6, 6) or not np.isfinite(matrix).all():
            raise InvalidInput(f"`inertia` must be finite, (6, 6) or its diagonal (6,); got shape {matrix.shape}.")
        if np.abs(matrix - matrix.T).max() > 1e-12 * np.abs(matrix).max() or np.linalg.eigvalsh(matrix)[0] <= 0:
            raise InvalidInput("`inertia` must be symmetric and positive definite: kinetic energy is never negative.")
        inverse = np.linalg.inv(matrix)
        self.algebra, self.inverse = SE3(), jnp.asarray(0.5 * (inverse + inverse.T))
        self.diagonal = bool((matrix == np.diag(np.diag(matrix))).all())

    @property
    def moments(self) -> Float64[Array, "3"]:
        """1/M⁻¹_ii for the angular part."""
        return 1.0 / jnp.diag(self.inverse)[:3]

    def energy(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(point * self.velocity(point), axis=-1)

    def velocity(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch 6"]:
        # (Ω, U) = M⁻¹ (Π, P), M symmetric
        return point @ self.inverse

    @property
    def flows(self) -> dict[str, Flow]:
        if not self.diagonal:
            return {}
        return axis_flows(self.moments, vectors=2) | {"drift": self._drift}

    def _drift(self, time: Array, state: Components) -> Components:
        linear = jnp.stack(state[-3:], axis=-1)
        # under ½ P·M⁻¹P alone P stays, and Π̇ = P × U is constant
        kick = time * jnp.cross(linear, linear * jnp.diag(self.inverse)[3:])
        still = jnp.zeros_like(state[0])
        return (*[still] * (len(state) - 6), *components(kick), still, still, still)

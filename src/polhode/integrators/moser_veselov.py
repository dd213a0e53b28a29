"""The discrete Moser–Veselov algorithm for the free rigid body."""

from __future__ import annotations

from typing import Any, ClassVar

import equinox as eqx
import jax.numpy as jnp

from polhode.errors import InvalidInput, shown
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar
from polhode.integrators.fixed_point import fixed_point
from polhode.systems.base import AbstractLiePoissonSystem, attitude_change, joined
from polhode.systems.free_rigid_body import FreeRigidBody
from polhode.systems.moser_veselov_table import corrections
from polhode.types import Array, Double, Float64

ORDERS = (2, 4, 6, 8, 10)


class MoserVeselov(AbstractOrbitSolver):
    """h hat(L₀) = ω D − D ωᵀ, L₁ = ωᵀ L₀, R₁ = R₀ ω, with moments corrected for order 4 to 10; implicit.

    ω is sought as a unit quaternion (w, v): h L_i = 2 w v_i I_i + 2 v_j v_k (I_k − I_j), cyclically; then
    h L_i' is the same with the other sign of the second term. Integrable, like the body itself.

    Args:
        system: a free rigid body.
        step_size: largest step [s].
        order: 2, 4, 6, 8 or 10; above 2 by correcting the moments, which costs no further solves.

    Source: Moser & Veselov, Comm. Math. Phys. 139 (1991) 217; Hairer & Vilmart, J. Phys. A 39 (2006) 13225.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    own_order: int = eqx.field(static=True)
    keeps: ClassVar[str] = "|L|², the energy, the momentum in space; time reversal"

    def __init__(self, system: AbstractLiePoissonSystem, step_size: Scalar, order: int = 2) -> None:
        if not _moves_freely(system):
            raise InvalidInput(
                f"`MoserVeselov` moves a FreeRigidBody with the free body's energy; got {type(system).__name__}. "
                "Take Splitting or LieMidpoint."
            )
        if order not in ORDERS:
            raise InvalidInput(f"`order` of MoserVeselov must be one of {ORDERS}; got {shown(order)}.")
        self.system, self.step_size, self.own_order = system, step_size, order

    def order(self, terms: Any) -> int:
        return self.own_order

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        attitude, L = self.system.parts(state)
        moments = self._corrected(h, L)
        following, last = jnp.roll(moments, -1, axis=-1), jnp.roll(moments, -2, axis=-1)
        gap = last - following

        def improved(v: Array) -> Array:
            w = jnp.sqrt(jnp.maximum(1.0 - jnp.sum(v * v, axis=-1, keepdims=True), 0.0))
            product = jnp.roll(v, -1, axis=-1) * jnp.roll(v, -2, axis=-1)
            return (h * L - 2.0 * product * gap) / (2.0 * jnp.where(w > 0.0, w, jnp.nan) * moments)

        start = 0.5 * h * L / moments
        found = fixed_point(improved, start, jnp.max(jnp.abs(start)))
        v = found.value
        square = jnp.sum(v * v, axis=-1, keepdims=True)
        w = jnp.sqrt(1.0 - square)
        product = jnp.roll(v, -1, axis=-1) * jnp.roll(v, -2, axis=-1)
        turned = attitude_change(attitude, v, -square / (1.0 + w))
        return Change(joined(turned, -4.0 * product * gap / h), found.iterations, found.converged)

    def _corrected(self, h: Array, L: Array) -> Array:
        """Return the moments (…, 3) with which the algorithm has its order."""
        a = jnp.broadcast_to(1.0 / self.system.moments, L.shape)  # type: ignore[attr-defined]
        if self.own_order == 2:
            return 1.0 / a
        square = h * L * (h * L)
        energy, casimir = 0.5 * jnp.sum(square * a, axis=-1), 0.5 * jnp.sum(square, axis=-1)
        scale, shift = corrections(self.own_order, (a[..., 0], a[..., 1], a[..., 2]), energy, casimir)
        return 1.0 / (a * (1.0 + scale[..., None]) + shift[..., None])


def _moves_freely(system: AbstractLiePoissonSystem) -> bool:
    """Whether a system is a free rigid body, not a subclass that moves otherwise."""
    own = ("energy", "velocity", "generator", "sign")
    kind = type(system)
    return isinstance(system, FreeRigidBody) and all(getattr(kind, n) is getattr(FreeRigidBody, n) for n in own)

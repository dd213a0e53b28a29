"""The symmetric midpoint method that moves along any coadjoint orbit by construction."""

from __future__ import annotations

from typing import Any, ClassVar

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode.errors import InvalidInput, shown
from polhode.integrators._composition import DEFAULT_ORDER, compose, stages
from polhode.integrators._fixed_point import fixed_point
from polhode.integrators._group import attitude_by_cayley, attitude_by_exp
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar
from polhode.systems.base import AbstractLiePoissonSystem, join_state
from polhode.types import Array, Double, Float64


class LieMidpoint(AbstractOrbitSolver):
    """μ₁ = Ad*_{τ(x)} μ₀ with x = h ξ(μ_middle), composed to order 2, 4, 6 or 8; implicit.

    With τ = exp the middle is Ad*_{exp(x/2)} μ₀; with τ = Cayley's map it is (μ₀ + μ₁)/2, which on so(3) is the
    implicit midpoint rule. For any algebra with exp, for quadratic groups with Cayley.

    Args:
        system: any Lie–Poisson system.
        step_size: largest step [s].
        order: 2, 4, 6 or 8.
        coordinates: "cayley", "exp", or None for Cayley where the group has it.

    Source: Engø & Faltinsen, SIAM J. Numer. Anal. 39 (2001) 128; Bogfjellmo & Marthinsen, Found. Comput. Math. 16
    (2016) 493.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    own_order: int = eqx.field(static=True)
    coordinates: str = eqx.field(static=True)
    keeps: ClassVar[str] = "the coadjoint orbit, and so every Casimir; time reversal"

    def __init__(
        self,
        system: AbstractLiePoissonSystem,
        step_size: Scalar,
        order: int = DEFAULT_ORDER,
        coordinates: str | None = None,
    ) -> None:
        stages(order)
        if coordinates is None:
            coordinates = "cayley" if has_cayley(system) else "exp"
        if coordinates not in ("cayley", "exp"):
            raise InvalidInput(f"`coordinates` must be 'cayley' or 'exp'; got {shown(coordinates)}.")
        if coordinates == "cayley" and not has_cayley(system):
            system.algebra.cayley(jnp.zeros(system.algebra.element_shape, system.algebra.dtype))
        self.system, self.step_size, self.own_order, self.coordinates = system, step_size, order, coordinates

    def order(self, terms: Any) -> int:
        return self.own_order

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        return compose(self._stage, self.own_order, t, h, state, self.beside_jumps(t, h))

    def _stage(self, t: Array, h: Array, state: Array) -> Change:
        algebra, (attitude, point) = self.system.algebra, self.system.parts(state)

        def middle(x: Array) -> Array:
            if self.coordinates == "cayley":
                return point + 0.5 * algebra.cayley_change(x, point)
            return point + algebra.exp_change(0.5 * x, point)

        half_way = t + 0.5 * h
        start = h * self.system.generator(half_way, point)
        scale = jnp.max(jnp.abs(start), axis=tuple(range(-len(algebra.element_shape), 0)))
        solution = fixed_point(lambda x: h * self.system.generator(half_way, middle(x)), start, scale)
        x = solution.value
        if self.coordinates == "cayley":
            moved = join_state(attitude_by_cayley(algebra, attitude, x), algebra.cayley_change(x, point))
        else:
            moved = join_state(attitude_by_exp(algebra, attitude, x), algebra.exp_change(x, point))
        return Change(moved, solution.iterations, solution.converged)


def has_cayley(system: AbstractLiePoissonSystem) -> bool:
    """Whether the system's group has Cayley's map."""
    algebra = system.algebra
    zero = jax.ShapeDtypeStruct(algebra.element_shape, algebra.dtype)
    try:
        jax.eval_shape(algebra.cayley, zero)
    except InvalidInput:
        return False
    return True

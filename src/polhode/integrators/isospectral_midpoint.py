"""The symmetric midpoint method of matrix algebras, which keeps the spectrum, by products of matrices."""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode.errors import InvalidInput
from polhode.integrators._composition import DEFAULT_ORDER, compose_with_hints, stages
from polhode.integrators._fixed_point import fixed_point
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, Double, Float64, Integer

EXTRAPOLATION = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, -1.0, 0.0), (3.0, -3.0, 1.0))
"""Weights of past values, the last first, by how many there are: none, constant, linear, quadratic."""


class Past(NamedTuple):
    """(W̃ − W)/h of the last steps (stages, 3, …), the last first, and how many of them there are (stages,)."""

    rates: Double[Array, "..."]
    known: Integer[Array, "..."]


class IsospectralMidpoint(AbstractOrbitSolver):
    """W̃ = W₀ + [y, W̃] + y W̃ y, W₁ = W₀ + 2[y, W̃], y = h ξ(W̃)†/2, composed to order 2, 4, 6 or 8; implicit.

    W₀ = (1 − y) W̃ (1 + y) and W₁ = (1 + y) W̃ (1 − y) have one spectrum. For matrices of quadratic groups, so(n),
    so(p, q), u(n), su(n), sp(n), and dual numbers over them; symplectic on the orbit.

    W̃ is computed by iteration to rounding, with two products of matrices an iteration, from W̃ − W of the last three
    steps, extrapolated. That converges for steps in which the fastest rotation turns by less than about 1.5 rad: with
    some 7 iterations at 1/4 rad, 10 at 1/2, 14 at 1. Where it does not, W̃ follows from y by two linear systems an
    iteration, which take longer and converge for longer steps where ξ changes little.

    Source: Modin & Viviani, Found. Comput. Math. 20 (2020) 889; J. Fluid Mech. 884 (2020) A22.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    own_order: int = eqx.field(static=True)
    keeps: ClassVar[str] = "the spectrum, and so every Casimir; the Poisson structure; time reversal"

    def __init__(self, system: AbstractLiePoissonSystem, step_size: Scalar, order: int = DEFAULT_ORDER) -> None:
        stages(order)
        if not has_cayley_terms(system):
            raise InvalidInput(
                "`IsospectralMidpoint` needs so(n), su(n) or sp(n) as matrices, or dual numbers over them; "
                f"got {system.algebra.name}. Take LieMidpoint."
            )
        self.system, self.step_size, self.own_order = system, step_size, order

    def order(self, terms: Any) -> int:
        return self.own_order

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        return self.change_with_hint(t, h, state, self.no_hint(state))[0]

    def change_with_hint(self, t: Scalar, h: Scalar, state: Double[Array, "..."], hint: Any) -> tuple[Change, Any]:
        return compose_with_hints(self._stage, self.own_order, t, h, state, hint, self.beside_jumps(t, h))

    def no_hint(self, state: Double[Array, "..."]) -> Past:
        count = len(stages(self.own_order))
        return Past(jnp.zeros((count, len(EXTRAPOLATION[0]), *jnp.shape(state)), state.dtype), jnp.zeros(count, int))

    def _stage(self, t: Array, h: Array, state: Array, past: Past) -> tuple[Change, Past]:
        algebra: Any = self.system.algebra
        half_way = t + 0.5 * h
        # a state's own part in the algebra, which is all of it but for directions of derivatives
        point = algebra.odd_part(state)

        def turn(ahead: Array) -> Array:
            return h * self.system.generator(half_way, algebra.project(point + ahead))

        def terms(ahead: Array) -> tuple[Array, Array, Array]:
            return algebra.cayley_terms(turn(ahead), point + ahead)

        def by_products(ahead: Array) -> Array:
            _, commutator, rest = terms(ahead)
            return commutator + rest

        def solve_change(ahead: Array) -> Array:
            return algebra.cayley_middle(turn(ahead), point) - point

        guess = h * jnp.tensordot(jnp.asarray(EXTRAPOLATION)[past.known], past.rates, 1)
        one_sided, commutator, rest = jax.lax.stop_gradient(terms(guess))
        # of the terms of W̃ − W, which do not vanish where it does
        scale = jnp.max(jnp.abs(one_sided), axis=tuple(range(-len(algebra.element_shape), 0)))
        solution = fixed_point(solve_change, commutator + rest, scale, quick=by_products)
        change = Change(2.0 * terms(solution.value)[1], solution.iterations + 2, solution.converged)
        rates = jnp.concatenate([(solution.value / h)[None], past.rates[:-1]])
        return change, Past(rates, jnp.minimum(past.known + 1, len(EXTRAPOLATION[0])))


def has_cayley_terms(system: AbstractLiePoissonSystem) -> bool:
    """Whether the system's algebra has the products by which the method iterates."""
    algebra: Any = system.algebra
    if not hasattr(algebra, "cayley_terms"):
        return False
    zero = jax.ShapeDtypeStruct(algebra.element_shape, algebra.dtype)
    try:
        jax.eval_shape(algebra.cayley_terms, zero, zero)
    except InvalidInput:
        return False
    return True

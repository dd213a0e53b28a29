"""Fixed points to rounding, with a count and an honest verdict; derivatives of either mode by the implicit rule.

Optimistix finds the same ones, but its derivatives take from 1.3 times the time to compile with GMRES to 300 times the
time to run with a dense matrix of 3000 unknowns.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp

from polhode.types import Array, Bool, Double, Float64, Integer

MOST = 100
ROUNDING = 4e-16  # of the unknown's size: a change below it is none
NEAR = 1e-11  # of the unknown's size: below it, a change that no longer shrinks is rounding too
NOTHING = 1e-15  # rad: where the group hardly moves, changes below it that no longer shrink are rounding as well


class Found(NamedTuple):
    """The last iterate, how many were needed, and whether they settled."""

    value: Double[Array, "*shape"]
    iterations: Integer[Array, ""]
    converged: Bool[Array, ""]


def fixed_point(function: Callable[[Array], Array], start: Double[Array, "..."], scale: Float64[Array, ""]) -> Found:
    """Iterate x = function(x) until the changes are negligible in ``scale``, or are rounding and shrink no more.

    Args:
        function: a contraction for steps that are short enough.
        start: first guess.
        scale: size of the unknown, so that the tolerance goes with the state.

    Its derivative solves dx = (∂f/∂x) dx + df by the same iteration, whatever the loop to the point itself did.
    """

    def settled(change: Array, last: Array) -> Array:
        return (change <= ROUNDING * scale) | ((change <= NEAR * scale + NOTHING) & (change >= last))

    def unfinished(carried: tuple[Array, ...]) -> Array:
        count, _, change, last = carried
        return (count < MOST) & ~settled(change, last) & jnp.isfinite(change)

    def improve(carried: tuple[Array, ...]) -> tuple[Array, ...]:
        count, x, change, _ = carried
        better = function(x)
        return count + 1, better, jnp.max(jnp.abs(better - x)), change

    def iterated(_: Callable[[Array], Array], start: Array) -> tuple[Array, tuple[Array, Array]]:
        first = function(start)
        state = (jnp.ones((), int), first, jnp.max(jnp.abs(first - start)), jnp.asarray(jnp.inf))
        count, x, change, last = jax.lax.while_loop(unfinished, improve, state)
        # as floats, since custom_root has no derivatives of whole numbers
        return x, (count.astype(float), settled(change, last).astype(float))

    x, (count, converged) = jax.lax.custom_root(lambda x: function(x) - x, start, iterated, _linear, has_aux=True)
    return Found(x, count.astype(int), converged > 0.5)


def _linear(residual: Callable[[Array], Array], wanted: Array) -> Array:
    """Return v with J v − v = wanted, forward, or with Jᵀ in its transpose."""
    return jax.lax.custom_linear_solve(residual, wanted, _by_iteration, _by_iteration)


def _by_iteration(residual: Callable[[Array], Array], wanted: Array) -> Array:
    """Return v with J v − v = wanted, by v ← J v − wanted."""

    def unfinished(carried: tuple[Array, ...]) -> Array:
        count, v, change, last = carried
        size = jnp.max(jnp.abs(v))
        moving = (change > ROUNDING * size) & ((change > NEAR * size) | (change < last))
        return (count < MOST) & moving & jnp.isfinite(change)

    def improve(carried: tuple[Array, ...]) -> tuple[Array, ...]:
        count, v, change, _ = carried
        better = v + residual(v) - wanted
        return count + 1, better, jnp.max(jnp.abs(better - v)), change

    start = (jnp.zeros((), int), -wanted, jnp.max(jnp.abs(wanted)), jnp.asarray(jnp.inf))
    return jax.lax.while_loop(unfinished, improve, start)[1]

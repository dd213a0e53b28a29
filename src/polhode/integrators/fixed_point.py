"""Fixed points to rounding, with a count and an honest verdict."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp

from polhode.systems.forward_only import forward_only

Array = Any
MOST = 100
ROUNDING = 4e-16  # of the unknown's size: a change below it is none
NEAR = 1e-11  # of the unknown's size: below it, a change that no longer shrinks is rounding too
NOTHING = 1e-15  # rad: where the group hardly moves, changes below it that no longer shrink are rounding as well


class Found(NamedTuple):
    """The last iterate, how many were needed, and whether they settled."""

    value: Array
    iterations: Array
    converged: Array


def fixed_point(function: Callable[[Array], Array], start: Array, scale: Array) -> Found:
    """Iterate x = function(x) until the changes vanish beside ``scale`` or are at their rounding and shrink no more.

    Args:
        function: a contraction for steps that are short enough.
        start: first guess.
        scale: size of the unknown, so that the tolerance goes with the state.
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

    first = function(start)
    state = (jnp.ones((), int), first, jnp.max(jnp.abs(first - start)), jnp.asarray(jnp.inf))
    count, x, change, last = jax.lax.while_loop(unfinished, improve, state)
    return Found(forward_only(x, "an implicit step"), count, settled(change, last))

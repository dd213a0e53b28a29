"""Fixed-point iteration to rounding, with a count and a convergence test; derivatives by the implicit function rule.

Optimistix solves these too, but its derivatives take from 1.3 times the time to compile with GMRES to 300 times the
time to run with a dense matrix of 3000 unknowns.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp

from polhode.types import Array, Bool, Double, Float64, Integer


class IterationLimits(NamedTuple):
    """When an iteration has converged, and when it is given up."""

    max_iterations: int = 100
    relative_rounding: float = 4e-16  # of the unknown's size: a change below it is none
    # of the unknown's size, and rad where the group hardly moves: below them, a change that no longer shrinks is
    # rounding too
    max_stalled_change: float = 1e-11
    max_stalled_angle: float = 1e-15
    min_ratio: float = 0.1  # of two changes: a smaller one may be chance, and is not extrapolated
    max_growth: float = 10.0  # over the first change: beyond, a quick map diverges


LIMITS = IterationLimits()
Map = Callable[[Array], Array]


class FixedPoint(NamedTuple):
    """The last iterate, how many were needed, and whether they settled; of a batch, by the copy that needed most."""

    value: Double[Array, "*shape"]
    iterations: Integer[Array, ""]
    converged: Bool[Array, ""]


class _Run(NamedTuple):
    """An iteration: how many iterates and the last; of each copy its change, the bound of that, and its status."""

    iterations: Array
    value: Array
    change: Array
    limit: Array
    settled: Array
    active: Array


def fixed_point(
    function: Map, start: Double[Array, "..."], scale: Float64[Array, "*batch"], quick: Map | None = None
) -> FixedPoint:
    """Iterate x = function(x) until changes are negligible against ``scale``, or are rounding and shrink no more.

    Args:
        function: a contraction for steps that are short enough.
        start: (batch…, …) first guesses.
        scale: (batch…) sizes of the unknowns, so that the tolerance goes with the state. Every copy of the batch ends
            by its own, and stays as it is then.
        quick: a cheaper map with the same fixed points, iterated first; copies where that fails go on by ``function``.

    Its derivative solves dx = (∂f/∂x) dx + df by the same iteration, whatever the loop to the point itself did.
    """
    everyone = jnp.ones(jnp.shape(scale), bool)

    def iterate(_: Map, start: Array) -> tuple[Array, tuple[Array, Array]]:
        if quick is None:
            run = _iterate(function, start, scale, everyone)
            count, settled = run.iterations, run.settled
        else:
            first = _iterate(quick, start, scale, everyone, LIMITS.max_growth, ahead=True)
            # from where the quick map began, as it may have gone far
            again = jnp.where(_wide(first.settled, start), first.value, start)
            run = _iterate(function, again, scale, ~first.settled)
            count, settled = first.iterations + run.iterations, jnp.logical_or(first.settled, run.settled)
        # as floats, since custom_root has no derivatives of whole numbers
        return run.value, (count.astype(float), jnp.all(settled).astype(float))

    root = jax.lax.custom_root(
        lambda x: function(x) - x, start, iterate, partial(_linear, jnp.ndim(scale)), has_aux=True)
    x, (count, converged) = root
    return FixedPoint(x, count.astype(int), converged > 0.5)


def _iterate(
    function: Map, start: Array, scale: Array, active: Array, most: float = jnp.inf, ahead: bool = False
) -> _Run:
    """Iterate in the active copies (batch…), as long as changes are within so many times the first.

    With ``ahead`` they end where the next change would be negligible, if changes go on shrinking in proportion.
    """
    batch = jnp.ndim(scale)

    def has_settled(change: Array, last: Array) -> Array:
        small = change <= LIMITS.relative_rounding * scale
        if ahead:
            # changes that shrink in proportion: the next one is change²/last
            next_one = change * jnp.maximum(change / jnp.where(last > 0.0, last, 1.0), LIMITS.min_ratio)
            small |= (change < 0.5 * last) & (next_one <= LIMITS.relative_rounding * scale)
        return small | ((change <= LIMITS.max_stalled_change * scale + LIMITS.max_stalled_angle) & (change >= last))

    def improve(run: _Run) -> _Run:
        better = function(run.value)
        change = _size(better - run.value, batch)
        if batch:
            better = jnp.where(_wide(run.active, better), better, run.value)
            change = jnp.where(run.active, change, run.change)
        done = has_settled(change, run.change)
        limit = jnp.where(run.iterations == 0, most * change, run.limit)
        going = run.active & ~done & jnp.isfinite(change) & (change <= limit)
        return _Run(run.iterations + 1, better, change, limit, jnp.where(run.active, done, run.settled), going)

    def unfinished(run: _Run) -> Array:
        return jnp.any(run.active) & (run.iterations < LIMITS.max_iterations)

    endless = jnp.full(jnp.shape(scale), jnp.inf)
    begun = _Run(jnp.zeros((), int), start, endless, endless, jnp.zeros(jnp.shape(scale), bool), active)
    return jax.lax.while_loop(unfinished, improve, begun)


def _size(x: Array, batch: int) -> Array:
    """Return the largest absolute value of each copy (batch…)."""
    own = tuple(range(batch, jnp.ndim(x)))
    if jnp.iscomplexobj(x):  # real and imaginary parts by themselves, without a root for every entry
        return jnp.maximum(*(jnp.max(jnp.abs(part), axis=own, initial=0.0) for part in (x.real, x.imag)))
    return jnp.max(jnp.abs(x), axis=own, initial=0.0)


def _wide(of_copies: Array, like: Array) -> Array:
    """Return a property of each copy (batch…) with the axes of an array (batch…, …)."""
    return of_copies.reshape(*of_copies.shape, *[1] * (jnp.ndim(like) - of_copies.ndim))


def _linear(batch: int, residual: Map, wanted: Array) -> Array:
    """Return v with J v − v = wanted, forward, or with Jᵀ in its transpose."""
    solve = partial(_by_iteration, batch)
    return jax.lax.custom_linear_solve(residual, wanted, solve, solve)


def _by_iteration(batch: int, residual: Map, wanted: Array) -> Array:
    """Return v with J v − v = wanted, by v ← J v − wanted, until each copy has converged."""

    def unfinished(carried: tuple[Array, ...]) -> Array:
        count, v, change, last = carried
        size = _size(v, batch)
        large = change > LIMITS.max_stalled_change * size
        moving = (change > LIMITS.relative_rounding * size) & (large | (change < last))
        return (count < LIMITS.max_iterations) & jnp.any(moving & jnp.isfinite(change))

    def improve(carried: tuple[Array, ...]) -> tuple[Array, ...]:
        count, v, change, _ = carried
        better = v + residual(v) - wanted
        return count + 1, better, _size(better - v, batch), change

    size = _size(wanted, batch)
    start = (jnp.zeros((), int), -wanted, size, jnp.full(jnp.shape(size), jnp.inf))
    return jax.lax.while_loop(unfinished, improve, start)[1]

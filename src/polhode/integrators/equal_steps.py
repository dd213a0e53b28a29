"""A whole run by equal steps: one compiled scan over the samples, and every copy of a batch by itself.

Copies are run in blocks, each a ``vmap`` of the run of one: step size, iterations of implicit steps, pieces of flows
and failures are a copy's own, so that its result is that of the copy alone but for the rounding of another vector
length. A block is as slow as its fastest copy; copies are sorted by their rates, so that like ones stand together.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.integrators.base import AbstractOrbitSolver, step_count

Array = Any
BLOCK = 64  # copies: enough that a step's fixed costs do not count, few enough that a fast copy slows few others


class Run(NamedTuple):
    """What came out of one state or a batch.

    Attributes:
        states: (batch…, T, …); infinite from the step on that failed.
        iterations: (batch…) evaluations in implicit steps.
        fine: (batch…) whether the end was reached.
    """

    states: np.ndarray
    iterations: np.ndarray
    fine: np.ndarray


def run_by_equal_steps(
    solver: AbstractOrbitSolver, state: Array, times: np.ndarray, sizes: Array, rates: Array, meter: Any
) -> Run:
    """Return the motion at times.

    Args:
        solver: of which the step size is replaced.
        state: (batch…, …) to start from.
        times: (T,) [s], in one direction.
        sizes: (batch…) largest steps [s].
        rates: (batch…) of the copies, by which they are sorted.
        meter: of diffrax, for progress.
    """
    grid = jnp.asarray(times[:-1]), jnp.asarray(np.diff(times))
    own = solver.system.state_axes
    batch = jnp.shape(state)[: jnp.ndim(state) - own]
    if not batch:
        return Run(*(np.asarray(x) for x in _run_one(solver, jnp.asarray(sizes), state, grid, meter)))
    flat = np.asarray(state).reshape(-1, *jnp.shape(state)[len(batch) :])
    order = np.argsort(np.ravel(rates), kind="stable")
    flat, ordered = flat[order], np.ravel(sizes)[order]
    width = min(BLOCK, 1 << (len(flat) - 1).bit_length())
    found, shown = [], meter.init()
    for first in range(0, len(flat), width):
        # the last block is filled up with its last copy, so that one compiled function serves every number of copies
        chosen = np.minimum(np.arange(first, first + width), len(flat) - 1)
        block = _run_block(solver, jnp.asarray(ordered[chosen]), jnp.asarray(flat[chosen]), grid)
        found.append([np.asarray(x)[: len(flat) - first] for x in block])
        shown = meter.step(shown, jnp.asarray(min(1.0, (first + width) / len(flat))))
    meter.close(shown)
    back = np.argsort(order)
    return Run(*(np.concatenate(x)[back].reshape(*batch, *x[0].shape[1:]) for x in zip(*found, strict=True)))


def step_counts(times: np.ndarray, sizes: Array) -> Array:
    """Return how many steps go from each time to the next (batch…, T − 1)."""
    return np.asarray(step_count(np, np.diff(times), np.asarray(sizes)[..., None]))


def _run(solver: Any, size: Array, state: Array, grid: tuple[Array, Array], meter: Any) -> tuple[Array, ...]:
    solver = eqx.tree_at(lambda s: s.step_size, solver, size)
    begin, spans = grid
    whole = jnp.sum(spans)

    def advance(carried: tuple[Any, ...], interval: tuple[Array, Array]) -> tuple[tuple[Any, ...], Array]:
        now, memory, shown = carried
        start, span = interval
        now, memory = solver.advance(start, span, now, memory)
        shown = meter.step(shown, (start + span - begin[0]) / whole)
        return (now, memory, shown), now

    carried = state, solver.memory(state), meter.init()
    (_, memory, shown), states = jax.lax.scan(advance, carried, (begin, spans))
    meter.close(shown)
    states = jnp.concatenate([state[None], states])
    return states, memory.iterations, memory.fine


_run_one = eqx.filter_jit(_run)


@eqx.filter_jit
def _run_block(solver: Any, sizes: Array, states: Array, grid: tuple[Array, Array]) -> tuple[Array, ...]:
    silent = diffrax.NoProgressMeter()
    return jax.vmap(lambda size, state: _run(solver, size, state, grid, silent))(sizes, states)

"""A whole run by equal steps: one compiled loop over the samples, and every copy of a batch by itself.

Copies are run in blocks, each a ``vmap`` of the run of one: step size, iterations of implicit steps, pieces of flows
and failures are a copy's own, so that its result equals that of the copy alone, up to the rounding of another vector
length. A block is as slow as its fastest copy; copies are sorted by their rates, so that similar ones share a block.

The loop is called for one part of the time after another, always as one compiled function: Python acts on
Ctrl-C, and progress is shown, only between two calls.
"""

from __future__ import annotations

import itertools
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._interrupts import keep_interrupts
from polhode.integrators._windows import split_into_windows
from polhode.integrators.base import AbstractOrbitSolver, Memory, step_count
from polhode.types import Array, Bool, Double, Float64, Integer


class RunLimits(NamedTuple):
    """Bounds of a run by equal steps."""

    max_steps: float = 1e10  # which take hours
    steps_in_call: int = 50_000  # which take from a quarter of a second to a few seconds
    copies_in_block: int = 64  # enough that fixed costs do not count, few enough that a fast copy slows few others


LIMITS = RunLimits()


class Run(NamedTuple):
    """The result for one state or a batch.

    Attributes:
        states: (batch…, T, …); infinite from the step on that failed.
        iterations: (batch…) evaluations in implicit steps.
        fine: (batch…) whether the end was reached.
        last: (batch…, …) the state at the last time.
        memory: of the solver at the last time, with the batch in front of each array.
    """

    states: Double[np.ndarray, "..."]
    iterations: Integer[np.ndarray, "*batch"]
    fine: Bool[np.ndarray, "*batch"]
    last: Double[np.ndarray, "..."]
    memory: Memory


def run_by_equal_steps(
    solver: AbstractOrbitSolver, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    sizes: Float64[Array, "*batch"], rates: Float64[Array, "*batch"], meter: Any, every: int = 1,
    memory: Memory | None = None,
) -> Run:
    """Return the motion at times.

    Args:
        solver: of which the step size is replaced.
        state: (batch…, …) to start from.
        times: (T,) [s], in one direction.
        sizes: (batch…) largest steps [s].
        rates: (batch…) of the copies, by which they are sorted.
        meter: of diffrax, for progress; None for none.
        every: which of the times are saved.
        memory: of a run that ended at this start; without it the run begins afresh.

    Raises:
        InvalidInput: for a run of too many steps.
    """
    wanted = float(step_counts(times, sizes).sum(axis=-1).max())
    if not wanted <= LIMITS.max_steps:
        raise InvalidInput(
            f"the run would take {wanted:.1e} steps of {float(np.min(sizes)):.3g} s, and at most "
            f"{LIMITS.max_steps:.0e} are taken. Check `times` and `step` and their units, or follow the motion in "
            "parts."
        )
    own = solver.system.state_axes
    batch = jnp.shape(state)[: jnp.ndim(state) - own]
    meter = diffrax.NoProgressMeter() if meter is None else meter
    shown = meter.init()

    def show(share: float) -> None:
        nonlocal shown
        shown = meter.step(shown, jnp.asarray(share))

    if not batch:
        run = _run_block(_go_one, solver, state, times, np.asarray(sizes), show, every, memory)
        meter.close(shown)
        return run
    flat = np.asarray(state).reshape(-1, *jnp.shape(state)[len(batch) :])
    order = np.argsort(np.ravel(rates), kind="stable")
    flat, ordered = flat[order], np.ravel(sizes)[order]
    kept = jax.tree.map(lambda x: np.asarray(x).reshape(-1, *np.shape(x)[len(batch) :])[order], memory)
    width = min(LIMITS.copies_in_block, 1 << (len(flat) - 1).bit_length())
    blocks = []
    for first in range(0, len(flat), width):
        # the last block is filled up with its last copy, so that one compiled function serves every number of copies
        chosen = np.minimum(np.arange(first, first + width), len(flat) - 1)
        before, share = first / len(flat), width / len(flat)
        show_block = lambda x, a=before, b=share: show(min(1.0, a + b * x))  # noqa: E731
        begun = jax.tree.map(lambda x, k=chosen: x[k], kept)
        block = _run_block(_go_block, solver, flat[chosen], times, ordered[chosen], show_block, every, begun)
        rest = len(flat) - first
        blocks.append(jax.tree.map(lambda x, n=rest: x[:n], block))
    meter.close(shown)
    back = np.argsort(order)
    return jax.tree.map(lambda *x: np.concatenate(x)[back].reshape(*batch, *x[0].shape[1:]), *blocks)


def run_through_windows(
    solver: AbstractOrbitSolver, state: Double[Array, "..."], times: Float64[np.ndarray, "time"],
    sizes: Float64[Array, "*batch"], rates: Float64[Array, "*batch"], meter: Any, windows: int,
) -> Run:
    """Return the motion at the times and between them, by one run after the other: nothing more is compiled."""
    first, *others = split_into_windows(times, windows)
    run = run_by_equal_steps(solver, state, first, sizes, rates, meter)
    axis, states = np.ndim(sizes), [run.states]
    for part in others:
        run = run_by_equal_steps(solver, jnp.asarray(run.last), part, sizes, rates, meter, 1, run.memory)
        states.append(np.take(run.states, np.arange(1, len(part)), axis=axis))
    return run._replace(states=np.concatenate(states, axis=axis))


def step_counts(
    times: Float64[np.ndarray, "time"], sizes: Float64[Array, "*batch"]
) -> Float64[Array, "*batch intervals"]:
    """Return how many steps go from each time to the next (batch…, T − 1)."""
    return np.asarray(step_count(np, np.diff(times), np.asarray(sizes)[..., None]))


def _run_block(
    go: Any, solver: Any, state: Array, times: np.ndarray, sizes: Array, show: Any, every: int, memory: Memory | None
) -> Run:
    """Return the motion of one copy or of a block of them, call by call."""
    longest = LIMITS.steps_in_call // -(-sizes.size // 8)  # eight copies cost about as much as one
    parts = int(np.ceil(step_counts(times, sizes).max() / longest))  # of every interval between samples
    fine = np.append(np.linspace(times[:-1], times[1:], parts, endpoint=False, axis=1), times[-1])
    stretches = _stretches(step_counts(fine, sizes).reshape(-1, len(fine) - 1).max(axis=0), longest)
    state, grid = jnp.asarray(state), (jnp.asarray(fine[:-1]), jnp.asarray(np.diff(fine)))
    start, axis = state, sizes.ndim
    if memory is None:
        memory = jax.vmap(solver.memory)(state) if axis else solver.memory(state)
    carried: Any = jax.tree.map(jnp.asarray, memory)
    # a place for every n-th sample, which those before it hold until it comes, and one for the samples behind the last
    places = -(-(len(times) - 1) // every)
    saved = jnp.zeros((*sizes.shape, places, *state.shape[axis:]), state.dtype)
    with keep_interrupts() as check:
        for first, last in stretches:
            limits = jnp.asarray(first), jnp.asarray(last), jnp.asarray(parts * every)
            state, carried, saved = go(solver, jnp.asarray(sizes), state, carried, saved, grid, limits)
            jax.block_until_ready(state)
            check()
            show(last / (len(fine) - 1))
    whole = np.take(np.asarray(saved), np.arange((len(times) - 1) // every), axis=axis)
    states = np.concatenate([np.expand_dims(start, axis), whole], axis=axis)
    carried = jax.tree.map(np.asarray, carried)
    return Run(states, carried.iterations, carried.fine, np.asarray(state), carried)


def _stretches(counts: Array, longest: int) -> list[tuple[int, int]]:
    """Return from which to which interval each call goes, by the steps (n,) that every interval takes."""
    borders = np.flatnonzero(np.diff(np.cumsum(counts) // longest)) + 1
    return list(itertools.pairwise([0, *borders.tolist(), len(counts)]))


def _go(
    solver: Any, size: Array, state: Array, memory: Memory, saved: Array, grid: tuple[Array, Array],
    limits: tuple[Array, Array, Array],
) -> tuple[Array, Memory, Array]:
    """Go from one interval up to another, and save the state at the end of so many intervals each."""
    solver = eqx.tree_at(lambda s: s.step_size, solver, size)
    (begin, spans), (first, last, together) = grid, limits

    def over(k: Array, carried: tuple[Array, Memory, jax.Array]) -> tuple[Array, Memory, jax.Array]:
        now, memory, saved = carried
        now, memory = solver.advance(begin[k], spans[k], now, memory)
        return now, memory, saved.at[k // together].set(now)

    return jax.lax.fori_loop(first, last, over, (state, memory, saved))


_go_one = eqx.filter_jit(_go)


@eqx.filter_jit
def _go_block(
    solver: Any, sizes: Array, states: Array, memory: Memory, saved: Array, grid: tuple[Array, Array],
    limits: tuple[Array, Array, Array],
) -> tuple[Array, Memory, Array]:
    def one(size: Array, state: Array, memory: Memory, saved: Array) -> tuple[Array, Memory, Array]:
        return _go(solver, size, state, memory, saved, grid, limits)

    return jax.vmap(one)(sizes, states, memory, saved)

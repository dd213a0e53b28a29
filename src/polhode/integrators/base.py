"""The frame of every integrator: inner steps, compensated sums, counting, and honest failure.

From sample to sample a solver takes ⌈Δt/step⌉ equal steps, for one state at a time: a batch is a ``vmap``. A method
gives the *change* of the state over a step, computed without cancellation; changes are added by compensated sums, so
that what a method keeps drifts by the rounding of small changes, not of whole states. Source: Higham, *Accuracy and
Stability of Numerical Algorithms*, §4.3; Hairer, McLachlan & Razakarivony, BIT 48 (2008) 231.
"""

from __future__ import annotations

import abc
from typing import Any, ClassVar, NamedTuple

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp

from polhode.systems.agreement import check_generated
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.systems.forward_only import forward_only
from polhode.types import Array, ArrayLike, ArrayOrFloat, Bool, Double, Float64, Integer, Real

Scalar = Float64[ArrayOrFloat, ""]


class Change(NamedTuple):
    """What a step does.

    Attributes:
        state: the state's change.
        iterations: how often an implicit step evaluated the system; 0 for explicit ones.
        converged: whether it solved its equation.
    """

    state: Double[Array, "*shape"]
    iterations: Integer[Array, ""]
    converged: Bool[Array, ""]


class Memory(NamedTuple):
    """What a solver carries along: what the last sums lost, steps and iterations so far, whether all went well."""

    lost: Double[Array, "*shape"]
    steps: Integer[Array, ""]
    iterations: Integer[Array, ""]
    fine: Bool[Array, ""]


class AbstractOrbitSolver(diffrax.AbstractSolver):
    """A one-step method for Lie–Poisson systems.

    Attributes:
        system: what moves; diffrax hides a term's attributes, so the solver holds it.
        step_size: the largest step [s].
        keeps: what the method keeps, in words.
    """

    system: eqx.AbstractVar[AbstractLiePoissonSystem]
    step_size: eqx.AbstractVar[Float64[Array, ""]]
    keeps: eqx.AbstractClassVar[str]

    def __check_init__(self) -> None:
        check_generated(self.system, type(self).__name__)

    term_structure: ClassVar[Any] = diffrax.ODETerm
    interpolation_cls: ClassVar[Any] = diffrax.LocalLinearInterpolation

    @abc.abstractmethod
    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        """Return what a step of length h from time t does to the state."""

    @abc.abstractmethod
    def order(self, terms: Any) -> int:
        """Return the order of convergence."""

    def memory(self, state: Double[Array, "..."]) -> Memory:
        """Return what is carried along from a start."""
        return Memory(jnp.zeros_like(state), jnp.zeros((), int), jnp.zeros((), int), jnp.asarray(True))

    def advance(
        self, start: Scalar, span: Scalar, state: Double[Array, "*shape"], memory: Memory
    ) -> tuple[Double[Array, "*shape"], Memory]:
        """Return the state a span after the start, by equal steps of at most ``step_size``; infinite if one failed."""
        count = step_count(jnp, span, self.step_size).astype(int)
        h = span / count

        def unfinished(carried: tuple[Array, ...]) -> Array:
            return (carried[0] < count) & carried[-1]

        def step(carried: tuple[Array, ...]) -> tuple[Array, ...]:
            return carried[0] + 1, *self._stepped(start + carried[0] * h, h, *carried[1:])

        first = (jnp.zeros((), int), state, memory.lost, memory.iterations, memory.fine)
        steps, end, lost, iterations, fine = jax.lax.while_loop(unfinished, step, first)
        end, lost = forward_only((end, lost), type(self).__name__)
        return _ended(end, lost, memory.steps + steps, iterations, fine)

    def advance_by(
        self,
        count: Real[ArrayLike, ""],
        most: int,
        start: Scalar,
        span: Scalar,
        state: Double[Array, "*shape"],
        memory: Memory,
    ) -> tuple[Double[Array, "*shape"], Memory]:
        """Return what ``advance`` does by so many steps, of which the most is known when it is compiled.

        Such a loop has reverse-mode derivatives too. They hold the states of all of its steps.
        """
        h = span / count

        def step(carried: tuple[Array, ...], k: Array) -> tuple[tuple[Array, ...], None]:
            def taken(carried: tuple[Array, ...]) -> tuple[Array, ...]:
                now, lost, steps, iterations, fine = carried
                found = self._stepped(start + k * h, h, now, lost, iterations, fine)
                moved = found[0], found[1], steps + 1, found[2], found[3]
                return jax.tree.map(lambda new, old: jnp.where(fine, new, old), moved, carried)

            return jax.lax.cond(k < count, taken, lambda carried: carried, carried), None

        first = (state, memory.lost, memory.steps, memory.iterations, memory.fine)
        end, lost, steps, iterations, fine = jax.lax.scan(jax.checkpoint(step), first, jnp.arange(most))[0]
        return _ended(end, lost, steps, iterations, fine)

    def _stepped(
        self, t: Array, h: Array, now: Array, lost: Array, iterations: Array, fine: Array
    ) -> tuple[Array, Array, Array, Array]:
        """Return state, what the sum lost, iterations and whether it went well after one step."""
        found = self.change(t, h, now)
        wanted = found.state + lost
        later = now + wanted
        lost = (now - later) + wanted
        return later, lost, iterations + found.iterations, found.converged

    def init(self, terms: Any, t0: Scalar, t1: Scalar, y0: Double[Array, "..."], args: Any) -> Memory:
        return self.memory(y0)

    def step(
        self,
        terms: Any,
        t0: Scalar,
        t1: Scalar,
        y0: Double[Array, "*shape"],
        args: Any,
        solver_state: Memory,
        made_jump: Any,
    ) -> tuple[Double[Array, "*shape"], None, dict[str, Double[Array, "*shape"]], Memory, Any]:
        span = terms.contr(t0, t1)
        # diffrax runs backwards in the negative of the time
        y1, memory = self.advance(jnp.sign(span) * t0, span, y0, solver_state)
        results: Any = diffrax.RESULTS
        result = results.where(memory.fine, results.successful, results.nonlinear_divergence)
        return y1, None, {"y0": y0, "y1": y1}, memory, result

    def func(self, terms: Any, t0: Scalar, y0: Double[Array, "*shape"], args: Any) -> Double[Array, "*shape"]:
        return terms.vf(t0, y0, args)


def _ended(end: Array, lost: Array, steps: Array, iterations: Array, fine: Array) -> tuple[Array, Memory]:
    fine = fine & jnp.all(jnp.isfinite(end))
    return jnp.where(fine, end, jnp.inf), Memory(lost, steps, iterations, fine)


def explicit(state: Double[Array, "..."]) -> Change:
    """Return the change of a step that solves nothing."""
    return Change(state, jnp.zeros((), int), jnp.asarray(True))


def step_count(
    xp: Any, span: Float64[ArrayOrFloat, "*#shape"], step_size: Float64[ArrayOrFloat, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return how many steps of at most a size make a span; one that fits but for rounding is not halved."""
    return xp.maximum(xp.ceil(xp.abs(span) / step_size * (1.0 - 1e-12)), 1.0)

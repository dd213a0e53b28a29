"""Shared by all integrators: inner steps, compensated sums, counts, and reports of failure.

From sample to sample a solver takes ⌈Δt/step⌉ equal steps, for one state at a time: a batch is a ``vmap``. A method
gives the *change* of the state over a step, computed without cancellation; changes are added by compensated sums, so
that a conserved quantity drifts by the rounding of small changes, not of whole states. Source: Higham, *Accuracy and
Stability of Numerical Algorithms*, §4.3; Hairer, McLachlan & Razakarivony, BIT 48 (2008) 231.
"""

from __future__ import annotations

import abc
from collections.abc import Callable
from typing import Any, ClassVar

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp

from polhode.integrators._difference import parts_with_units
from polhode.integrators._reversal import Given, repeat_steps
from polhode.integrators._step_results import Change as Change
from polhode.integrators._step_results import Memory as Memory
from polhode.integrators._step_results import Scalar as Scalar
from polhode.systems._agreement import check_generated
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, ArrayOrFloat, Double, Float64


class AbstractOrbitSolver(diffrax.AbstractSolver):
    """A one-step method for Lie–Poisson systems.

    Attributes:
        system: which the solver holds, as diffrax hides a term's attributes.
        step_size: the largest step [s].
        keeps: the quantities that the method conserves, in words.
        symmetric: whether a step of length −h undoes one of length h, so that reverse-mode derivatives can go back by
            steps instead of from checkpoints. They check it, and a wrong one costs time only.
        rounds_each_number: whether a step computes each number of the state to roundings of its own size, however small
            it is beside the others; else to roundings of the largest, as implicit steps do.
    """

    system: eqx.AbstractVar[AbstractLiePoissonSystem]
    step_size: eqx.AbstractVar[Float64[Array, ""]]
    keeps: eqx.AbstractClassVar[str]
    symmetric: ClassVar[bool] = True
    rounds_each_number: ClassVar[bool] = False

    def __check_init__(self) -> None:
        check_generated(self.system, type(self).__name__)

    term_structure: ClassVar[Any] = diffrax.ODETerm
    interpolation_cls: ClassVar[Any] = diffrax.LocalLinearInterpolation

    @abc.abstractmethod
    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        """Return the change of the state in a step of length h from time t."""

    def change_with_hint(self, t: Scalar, h: Scalar, state: Double[Array, "..."], hint: Any) -> tuple[Change, Any]:
        """Return the result of a step, and the hint for the next one, where the method has hints."""
        return self.change(t, h, state), hint

    def no_hint(self, state: Double[Array, "..."]) -> Any:
        """Return the hint of a first step, a nest of arrays; empty for methods without hints."""
        return ()

    @abc.abstractmethod
    def order(self, terms: Any) -> int:
        """Return the order of convergence."""

    def memory(self, state: Double[Array, "..."]) -> Memory:
        """Return the memory at a start."""
        zero = jnp.zeros((), int)
        return Memory(jnp.zeros_like(state), zero, zero, jnp.asarray(True), self.no_hint(state))

    def beside_jumps(self, t: Scalar, h: Scalar) -> Callable[[Scalar], Scalar] | None:
        """Return a function that keeps times of a step's stages on the step's side of each jump; None without jumps.

        Composed steps go beyond their end and come back.
        """
        jumps = jnp.asarray(self.system.jumps, float)
        if not jumps.size:
            return None
        middle, rounding = t + 0.5 * h, 2e-15  # of a time
        low = jnp.max(jnp.where(jumps <= middle, jumps + rounding * jnp.abs(jumps), -jnp.inf))
        high = jnp.min(jnp.where(jumps > middle, jumps - rounding * jnp.abs(jumps), jnp.inf))
        return lambda time: jnp.clip(time, low, high)

    def advance(
        self, start: Scalar, span: Scalar, state: Double[Array, "*shape"], memory: Memory
    ) -> tuple[Double[Array, "*shape"], Memory]:
        """Return the state a span after the start, by equal steps of at most ``step_size``; infinite if one failed.

        It has derivatives of either mode, of which the memory does not grow with the steps.
        """
        jumps = jnp.asarray(self.system.jumps, float)
        if not jumps.size:
            return self._smoothly(start, span, state, memory)
        forth = jnp.where(span < 0.0, -1.0, 1.0)
        inside = jnp.sort(jnp.clip(forth * (jumps - start), 0.0, forth * span))
        ends = jnp.concatenate([jnp.zeros(1), inside, jnp.ravel(forth * span)])

        def over(carried: tuple[Array, Memory], piece: tuple[Array, Array]) -> tuple[tuple[Array, Memory], None]:
            return self._smoothly(start + forth * piece[0], forth * (piece[1] - piece[0]), *carried), None

        return jax.lax.scan(over, (state, memory), (ends[:-1], ends[1:]))[0]

    def _smoothly(
        self, start: Scalar, span: Scalar, state: Double[Array, "*shape"], memory: Memory
    ) -> tuple[Double[Array, "*shape"], Memory]:
        """Return the state a span after the start, in which nothing jumps; no steps if there is no time between."""
        count = jnp.where(span == 0.0, 0.0, step_count(jnp, span, self.step_size)).astype(int)

        def step(t: Array, h: Array, now: Array, lost: Array, hint: Any) -> tuple[Array, Array, Array, Array, Any]:
            change, hint = self.change_with_hint(t, h, now, hint)
            wanted = change.state + lost
            later = now + wanted
            return later, (now - later) + wanted, change.iterations, change.converged, hint

        length = jnp.asarray(span / jnp.maximum(count, 1))
        inputs = Given([], count, jnp.asarray(start, float), length, state, memory.lost,
                      memory.iterations, memory.fine, memory.hint)
        parts = parts_with_units(self.system, state)
        reached = repeat_steps(step, inputs, parts, self.symmetric, type(self).__name__)
        fine = reached.fine & jnp.all(jnp.isfinite(reached.state))
        later = Memory(reached.lost, memory.steps + reached.steps, reached.iterations, fine, reached.hint)
        return jnp.where(fine, reached.state, jnp.inf), later

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


def explicit(state: Double[Array, "..."]) -> Change:
    """Return the change of a step that solves nothing."""
    return Change(state, jnp.zeros((), int), jnp.asarray(True))


def step_count(
    xp: Any, span: Float64[ArrayOrFloat, "*#shape"], step_size: Float64[ArrayOrFloat, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return how many steps of at most a size make a span; one that fits but for rounding is not halved."""
    return xp.maximum(xp.ceil(xp.abs(span) / step_size * (1.0 - 1e-12)), 1.0)

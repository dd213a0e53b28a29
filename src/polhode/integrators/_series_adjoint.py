"""Gradients of motions by Taylor series: one pass of the adjoint equations for any number of parameters.

Weights λ of the state move against time by λ̇ = −(∂f/∂x)ᵀ λ, and those of the numbers in f by μ̇ = −(∂f/∂p)ᵀ λ. The
series of the motion itself goes back beside them, from one known state to the one before it.

Source: Pontryagin et al., *The Mathematical Theory of Optimal Processes*, §3; Cao, Li, Petzold & Serban, SIAM J. Sci.
Comput. 24 (2003) 1076.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.systems.base import AbstractSystem
from polhode.taylor.runs import Precision, run_copies, runs_back
from polhode.types import Array, Bool, Float64


class ReturnLimits(NamedTuple):
    """How well the way back has to follow the motion, and between how many times at most it is corrected."""

    max_miss: float = 1e-10  # of the state's size
    parts: tuple[int, ...] = (1, 8, 64)  # of each interval between samples, tried one after the other


LIMITS = ReturnLimits()


class Returning(AbstractSystem):
    """The motion of state x, weights λ of it and of integrals of balances, numbers p of the system, and their weights.

    Attributes:
        flow: (t, x, p) → rates of change of x and of integrals of balances; comparable, as a jitted function is not.
        sizes: how many numbers x, balances and p are.
    """

    flow: Any = eqx.field(static=True)
    sizes: tuple[int, int, int] = eqx.field(static=True)

    def vector_field(self, t: Any, state: Any) -> Any:
        n, received, count = self.sizes
        x, weights, numbers, _ = jnp.split(state, np.cumsum([n, n + received, count]))
        rates, pull = jax.vjp(lambda x, p: self.flow(t, x, p), x, numbers)
        of_state, of_numbers = pull(weights)
        still = jnp.zeros(received), jnp.zeros(count)
        return jnp.concatenate([rates[:n], -of_state, *still, -of_numbers])

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}


def weights_back(
    motion: AbstractSystem, back: Returning, inputs: tuple[Array, Array, Array], times: Float64[np.ndarray, "time"],
    weights: Float64[Array, "copies time rows"], precision: Precision, longest: float,
) -> tuple[Float64[Array, "copies n"], Float64[Array, "copies m"], Bool[Array, "copies"]]:
    """Return the weights of starts and numbers, from those of the states at times, and which of them are valid.

    Args:
        motion: of state, integrals of balances, and numbers.
        back: ``motion`` with weights.
        inputs: starts (C, n), numbers (C, m) and sizes of the state's components (C, n).
        times: (T,) [s].
        weights: of state and integrals of balances.
        precision, longest: of the steps.
    """
    n, received, count = back.sizes
    copies = len(weights)
    of_start, of_numbers = np.zeros((copies, n)), np.zeros((copies, count))
    good = np.zeros(copies, bool)
    for parts in LIMITS.parts:
        left = np.flatnonzero(~good)
        if not left.size:
            break
        start, numbers, sizes = (x[left] for x in inputs)
        fine = np.append(np.linspace(times[:-1], times[1:], parts, endpoint=False, axis=1), times[-1])
        none, scales = np.zeros((left.size, received)), np.full((left.size, n + received + count), np.inf)
        scales[:, :n] = sizes
        states = np.concatenate([start, none, numbers], axis=1)
        known = run_copies(motion, states, fine, precision, longest, scales=scales).states[..., :n]
        kicks = np.zeros((left.size, len(fine), 2 * n + received + 2 * count))
        kicks[:, ::parts, n : 2 * n + received] = weights[left]
        kicks[:, -1, 2 * n + received : 2 * n + received + count] = numbers
        scales = np.full((left.size, kicks.shape[2]), np.inf)
        scales[:, :n] = sizes
        with np.errstate(invalid="ignore"):
            ends, missed = runs_back(back, known, kicks, fine, precision, longest, scales)
        near = missed <= LIMITS.max_miss
        good[left] = near
        of_start[left], of_numbers[left] = ends[:, n : 2 * n], ends[:, 2 * n + received + count :]
    return of_start, of_numbers, good

"""Derivatives of a heavy top's motion by its start and by all numbers in it, against those of diffrax's steps"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from measure import Row, compared

import polhode as ph
from polhode.integrators import Taylor

TOLERANCE = 1e-12  # of the peer's steps
TOP = ph.systems.HeavyTop((1.0, 2.0, 3.5), 1.3, (0.6, 0.0, 0.8))
START = jnp.asarray(TOP.pack(attitude=(1.0, 0.0, 0.0, 0.0), angular_velocity=(0.3, 1.0, 0.1)))
WEIGHTS = jnp.asarray(np.random.default_rng(0).normal(size=10))


def rows(quick: bool) -> Iterator[Row]:
    """Yield the time of diffrax's derivatives over ours, and of a motion of ours over our derivatives."""
    repeats = 3 if quick else 15
    numbers, rest = eqx.partition(TOP, eqx.is_inexact_array)
    for count in (2, 11):
        times = jnp.linspace(0.0, 10.0, count)
        ours = lambda a, x, t=times: _weighed(ph.solve(eqx.combine(a, rest), x, t, Taylor).saved)  # noqa: E731
        theirs = lambda a, x, t=times: _weighed(_dopri8(eqx.combine(a, rest), x, t))  # noqa: E731
        value = _timed(jax.jit(ours), numbers, START)
        for name, derivative in DERIVATIVES.items():
            mine, peer = jax.jit(derivative(ours)), jax.jit(derivative(theirs))
            work = f"{name}, {count} times"
            first, second = _flat(mine(numbers, START)), _flat(peer(numbers, START))
            apart = float(np.abs(first - second).max() / np.abs(first).max())
            found = compared(_timed(mine, numbers, START), _timed(peer, numbers, START), repeats)
            yield Row(work, f"diffrax Dopri8, {TOLERANCE:g}", None, None, *found, f"apart by {apart:.1e}")
            yield Row(work, "one motion of ours", None, None, *compared(_timed(mine, numbers, START), value, repeats))


def _gradient(function: Callable[..., Any]) -> Callable[..., Any]:
    return jax.grad(function, argnums=(0, 1))


def _jacobian(function: Callable[..., Any]) -> Callable[..., Any]:
    return jax.jacfwd(function, argnums=(0, 1))


def _one_direction(function: Callable[..., Any]) -> Callable[..., Any]:
    def change(numbers: Any, start: Any) -> Any:
        heavier = lambda mgl: eqx.tree_at(lambda top: top.mgl, numbers, mgl)  # noqa: E731
        return jax.jvp(lambda mgl: function(heavier(mgl), start), (numbers.mgl,), (1.0,))[1]

    return change


DERIVATIVES = {"gradient by 26 numbers": _gradient, "by one number": _one_direction, "26 tangents": _jacobian}


def _weighed(states: Any) -> Any:
    return jnp.sum(states @ WEIGHTS)


def _dopri8(system: Any, start: Any, times: Any) -> Any:
    return diffrax.diffeqsolve(
        diffrax.ODETerm(lambda t, y, args: system.vector_field(t, y)), diffrax.Dopri8(), times[0], times[-1], 0.01,
        start, saveat=diffrax.SaveAt(ts=times), max_steps=4096, adjoint=diffrax.DirectAdjoint(),
        stepsize_controller=diffrax.PIDController(rtol=TOLERANCE, atol=TOLERANCE),
    ).ys  # fmt: skip


def _timed(function: Callable[..., Any], *given: Any) -> Callable[[], Any]:
    return lambda: jax.block_until_ready(function(*given))


def _flat(found: Any) -> np.ndarray:
    return np.concatenate([np.ravel(x) for x in jax.tree.leaves(found)])

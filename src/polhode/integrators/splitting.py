"""Splitting into exact flows."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, ClassVar

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode.errors import InvalidInput
from polhode.integrators._composition import DEFAULT_ORDER, NYSTROM, compose, stages
from polhode.integrators.base import AbstractOrbitSolver, Change, Scalar, explicit
from polhode.systems._agreement import has_own_flows
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, Kick, Round, components
from polhode.types import Array, Double, Float64


class Splitting(AbstractOrbitSolver):
    """The system's exact flows in a symmetric product, composed to order 2, 4, 6 or 8; explicit.

    Where the first of two flows only kicks, as a plasma's field does, orders 4 and 6 are Runge–Kutta–Nyström
    splittings.

    Args:
        system: with ``flows``.
        step_size: largest step [s].
        order: 2, 4, 6 or 8.

    Raises:
        InvalidInput: if the system names no flows.

    Source: McLachlan, Phys. Rev. Lett. 71 (1993) 3043; Blanes & Moan,
    J. Comput. Appl. Math. 142 (2002) 313; Hairer, Lubich & Wanner, *Geometric Numerical
    Integration*, VII.5.
    """

    system: AbstractLiePoissonSystem
    step_size: Float64[Array, ""]
    own_order: int = eqx.field(static=True)
    rounds_each_number: ClassVar[bool] = True
    keeps: ClassVar[str] = "every Casimir, the orbit, the Poisson structure; time reversal"

    def __init__(self, system: AbstractLiePoissonSystem, step_size: Scalar, order: int = DEFAULT_ORDER) -> None:
        stages(order)
        if not system.flows:
            raise InvalidInput(
                f"`Splitting` needs exact flows, and {type(system).__name__} names none; take LieMidpoint."
            )
        if not has_own_flows(system):
            raise InvalidInput(
                f"`Splitting` goes by the flows that {type(system).__name__} inherits, and not by the `generator` that "
                "it overrides. Override `flows` too, with {} where no exact flows are known, or take LieMidpoint."
            )
        self.system, self.step_size, self.own_order = system, step_size, order

    def order(self, terms: Any) -> int:
        return self.own_order

    def change(self, t: Scalar, h: Scalar, state: Double[Array, "..."]) -> Change:
        flows = list(self.system.flows.values())
        if len(flows) == 2 and isinstance(flows[0], Kick) and self.own_order in NYSTROM:
            return _kicks_and_drifts(flows[0], flows[1], self.own_order, h, state)
        rounds = [flow for flow in flows if isinstance(flow, Round)]
        # more than three are a loop, as 32 vortices one after another take a minute to compile
        if 3 < len(rounds) == len(flows):
            return compose(partial(_rounds, rounds[0].flow, len(rounds)), self.own_order, t, h, state)
        parts = [(flow, 0.5) for flow in flows[:-1]]
        parts = [*parts, (flows[-1], 1.0), *parts[::-1]]

        def stage(_: Array, h: Array, state: Array) -> Change:
            now, total = components(state), (jnp.zeros_like(state[..., 0]),) * state.shape[-1]
            for flow, share in parts:
                now, total = _apply_flow(flow, share * h, now, total)
            return _stack(total)

        return compose(stage, self.own_order, t, h, state)


def _rounds(flow: Callable[..., Components], count: int, _: Scalar, h: Scalar, state: Array) -> Change:
    """Return the change by rounds forth and back, the last of them once."""
    numbers = jnp.asarray([*range(count), *reversed(range(count - 1))])

    def add(k: Array, carried: tuple[Array, Array]) -> tuple[Array, Array]:
        now, total = carried
        share = jnp.where(k == count - 1, 1.0, 0.5)
        change = jnp.stack(flow(numbers[k], share * h, components(now)), axis=-1)
        return now + change, total + change

    return explicit(jax.lax.fori_loop(0, len(numbers), add, (state, jnp.zeros_like(state)))[1])


def _kicks_and_drifts(kick: Flow, drift: Flow, order: int, h: Scalar, state: Array) -> Change:
    """Return the change by a kick, then drifts and kicks in turn."""
    kicks, drifts = (jnp.asarray(shares) for shares in NYSTROM[order])

    def add(k: Array, carried: tuple[Array, Array]) -> tuple[Array, Array]:
        now, total = carried
        moved = _apply_flow(drift, drifts[k] * h, components(now), (jnp.zeros_like(now[..., 0]),) * now.shape[-1])
        change = _stack(_apply_flow(kick, kicks[k + 1] * h, *moved)[1]).state
        return now + change, total + change

    first = jnp.stack(kick(kicks[0] * h, components(state)), axis=-1)
    return explicit(jax.lax.fori_loop(0, len(drifts), add, (state + first, first))[1])


def _apply_flow(flow: Flow, time: Scalar, now: Components, total: Components) -> tuple[Components, Components]:
    """Return components and their whole change after one more flow."""
    moved = flow(time, now)
    after = tuple(x + d for x, d in zip(now, moved, strict=True))
    return after, tuple(x + d for x, d in zip(total, moved, strict=True))


def _stack(total: Components) -> Change:
    # XLA would compute the whole stage again for each use of the sum
    return explicit(jax.lax.optimization_barrier(jnp.stack(total, axis=-1)))

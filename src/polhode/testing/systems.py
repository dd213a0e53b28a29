"""Laws of a Lie–Poisson system, at random states."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from polhode.systems.base import AbstractLiePoissonSystem, components
from polhode.testing.laws import hold
from polhode.types import Array

EXACT = 1e-11  # relative; derivatives of polynomials of a few degrees
FLOWS = 1e-5  # of the flows' sum over a short time, whose commutators are of second order in it
SHORT, LONG = 1e-7, 0.3
POINTS = 3


def check_system(system: AbstractLiePoissonSystem, seed: int = 0, size: float = 1.0) -> None:
    """Check velocity = ∇H, dH·ẋ = 0, dC·ẋ = 0, other invariants, exact flows, and batch = loop.

    Args:
        system: any Lie–Poisson system.
        seed: of the random states.
        size: of these, where H has a scale.

    Raises:
        LawBroken: naming the first law that fails.
    """
    algebra = system.algebra
    rng = np.random.default_rng(seed)
    point = algebra.from_dual_vector(jnp.asarray(size * rng.normal(size=(POINTS, algebra.dim))))
    gradient = jax.grad(lambda m: jnp.sum(system.energy(m)))(point)
    hold("velocity = ∇H", system.velocity(point), algebra.from_gradient(gradient), EXACT)
    states = [point]
    if system.carries_attitude:
        q = rng.normal(size=(POINTS, 4))
        states.append(jnp.concatenate([q / np.linalg.norm(q, axis=1, keepdims=True), point], axis=-1))
    for state in states:
        flow = system.vector_field(jnp.asarray(0.0), state)
        loop = jnp.stack([system.vector_field(jnp.asarray(0.0), one) for one in state])
        hold("vector field: batch = loop", flow, loop, EXACT)
        values, rates = jax.jvp(system.invariants, (state,), (flow,))
        known = {"energy", *algebra.named_casimirs(point), *system.extra_invariants}
        for name, rate in rates.items():
            if name not in known and bool(jnp.isnan(values[name]).all()):
                continue  # holds on other leaves only
            scale = jnp.maximum(jnp.max(jnp.abs(values[name])), 1.0)
            hold(f"{name} is constant along the motion", rate / scale, jnp.zeros_like(rate), EXACT)
        _check_flows(system, state, flow)


def _check_flows(system: AbstractLiePoissonSystem, state: Array, field: Array) -> None:
    if not system.flows:
        return
    def compiled(flow: Any) -> Any:
        moved = jax.jit(lambda time, now: jnp.stack(flow(time, components(now)), axis=-1))
        return lambda time, now: moved(jnp.asarray(time), now)

    flows = {name: compiled(flow) for name, flow in system.flows.items()}
    total = sum(moved(SHORT, state) for moved in flows.values())
    hold("flows of the parts add up to the field", total / SHORT, field, FLOWS)
    casimirs = system.algebra.casimirs
    before = casimirs(system.parts(state).point)
    for name, moved in flows.items():
        once, half = moved(LONG, state), moved(0.5 * LONG, state)
        rest = moved(0.5 * LONG, state + half)
        hold(f"flow of {name}: two halves make a whole", half + rest, once, EXACT)
        hold(f"flow of {name} keeps the Casimirs", casimirs(system.parts(state + once).point), before, EXACT)

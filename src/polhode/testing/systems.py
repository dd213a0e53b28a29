"""Laws of a system, at random states or given ones."""

from __future__ import annotations

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays.traced_checks import check_function
from polhode.errors import InvalidInput
from polhode.systems._forms import refuse_other_objects
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem, components
from polhode.testing.laws import hold
from polhode.types import Array, ArrayLike, Real

TIME = 0.3  # at which quantities that depend on time are checked


class SystemLimits(NamedTuple):
    """Tolerances of these checks."""

    rounding: float = 1e-11  # relative; derivatives of polynomials of a few degrees
    flow_residual: float = 1e-5  # of the flows' sum over a short time, whose commutators are of second order in it


LIMITS = SystemLimits()


def check_system(
    system: AbstractSystem, seed: int = 0, size: float = 1.0, states: Real[ArrayLike, "m ..."] | None = None
) -> None:
    """Check batch = loop, that invariants are constant along the field, and that balances change at their rates.

    Of a Lie–Poisson system also velocity = ∇H and exact flows.

    Args:
        system: any.
        seed: of random states.
        size: of these, where H has a scale.
        states: (m, …) states to check at, as ``simulate`` takes them. By default random ones, of a Lie–Poisson system;
            of others it is not known which make sense, so that they must be given.

    Raises:
        LawBroken: naming the first law that fails.
        InvalidInput: for what is not a system, a seed that is no whole number, states that the system refuses, and
            where states must be given.

    >>> from polhode.celestial import SpinOrbit
    >>> check_system(SpinOrbit(0.89, 0.1), states=[[0.3, 1.0], [1.0, -0.5]])
    """
    refuse_other_objects(system)
    seed = check.whole("seed", seed, 0, remedy="Give states by `states=`.")
    for batch in _draw_states(system, seed, size) if states is None else [_check_states(system, states)]:
        one = batch[0]
        check_function(f"`vector_field` of {type(system).__name__}", system.vector_field, jnp.asarray(TIME), one)
        check_function(f"`invariants` of {type(system).__name__}", system.invariants, one)
        if isinstance(system, AbstractLiePoissonSystem):
            point = system.parts(batch).point
            gradient = jax.grad(lambda m: jnp.sum(system.energy(m)))(point)
            hold("velocity = ∇H", system.velocity(point), system.algebra.from_gradient(gradient), LIMITS.rounding)
        _check_laws(system, batch)
        if isinstance(system, AbstractLiePoissonSystem):
            _check_flows(system, batch, system.vector_field(jnp.asarray(0.0), batch))


def _draw_states(system: AbstractSystem, seed: int, size: float) -> list[Array]:
    """Return random states, with and without an attitude where they may have one."""
    points = 3
    if not isinstance(system, AbstractLiePoissonSystem):
        name = type(system).__name__
        raise InvalidInput(
            f"`states` must be given for {name}, as it is not a Lie–Poisson system and which of its states make sense "
            f"is not known: check_system({name}(…), states=[…]), as `simulate` takes them, (m, …)."
        )
    algebra, rng = system.algebra, np.random.default_rng(seed)
    point = algebra.from_dual_vector(jnp.asarray(size * rng.normal(size=(points, algebra.dim))))
    if not system.carries_attitude:
        return [point]
    q = rng.normal(size=(points, 4))
    return [point, jnp.concatenate([q / np.linalg.norm(q, axis=1, keepdims=True), point], axis=-1)]


def _check_states(system: AbstractSystem, states: Any) -> Array:
    checked = system.check_state(states)
    if checked.ndim != system.state_axes + 1 or not len(checked):
        raise InvalidInput(f"`states` must be several states, (m, …); got shape {checked.shape}. Put one in brackets.")
    return checked


def _check_laws(system: AbstractSystem, state: Array) -> None:
    time = jnp.asarray(TIME)
    flow = system.vector_field(time, state)
    loop = jnp.stack([system.vector_field(time, one) for one in state])
    hold("vector field: batch = loop", flow, loop, LIMITS.rounding)
    values, rates = jax.jvp(system.invariants, (state,), (flow,))
    known = {"energy"}
    if isinstance(system, AbstractLiePoissonSystem):
        known |= {*system.algebra.named_casimirs(system.parts(state).point), *system.extra_invariants}
    for name, rate in rates.items():
        if name not in known and bool(jnp.isnan(values[name]).all()):
            continue  # holds on other leaves only
        scale = jnp.maximum(jnp.max(jnp.abs(values[name])), 1.0)
        hold(f"{name} is constant along the motion", rate / scale, jnp.zeros_like(rate), LIMITS.rounding)

    values_alone, changes = jax.jvp(system.balance_values, (time, state), (jnp.ones_like(time), flow))
    balances = system.balances(time, state)
    hold("balance_values names the balances", len({*values_alone} ^ {*balances}), 0, 0.0)
    for name, balance in balances.items():
        hold(f"{name} is the value of its balance", values_alone[name], balance.value, LIMITS.rounding)
        hold(f"{name} changes at the rate that its balance tells", changes[name], balance.rate, LIMITS.rounding)


def _check_flows(system: AbstractLiePoissonSystem, state: Array, field: Array) -> None:
    short, long = 1e-7, 0.3
    if not system.flows:
        return
    def compile_flow(flow: Any) -> Any:
        moved = jax.jit(lambda time, now: jnp.stack(flow(time, components(now)), axis=-1))
        return lambda time, now: moved(jnp.asarray(time), now)

    flows = {name: compile_flow(flow) for name, flow in system.flows.items()}
    total = sum(moved(short, state) for moved in flows.values())
    hold("flows of the parts add up to the field", total / short, field, LIMITS.flow_residual)
    casimirs = system.algebra.casimirs
    before = casimirs(system.parts(state).point)
    for name, moved in flows.items():
        once, half = moved(long, state), moved(0.5 * long, state)
        rest = moved(0.5 * long, state + half)
        hold(f"flow of {name}: two halves make a whole", half + rest, once, LIMITS.rounding)
        hold(f"flow of {name} keeps the Casimirs", casimirs(system.parts(state + once).point), before, LIMITS.rounding)

"""Checks that a system's energy, velocity, generator, vector field and flows agree.

They describe one motion, and a subclass that changes one of them inherits the others. Where they
disagree it would move by one and be judged by another, so it is refused. ``polhode.testing.check_system`` checks more,
at more points; the systems of this package pass it.
"""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import in_jax_numpy
from polhode._base.arrays.traced_checks import check_function
from polhode.errors import InvalidInput
from polhode.systems._forms import facts_of
from polhode.systems.base import AbstractLiePoissonSystem, components, join_state
from polhode.types import Array, ArrayLike, Double, Real

PAIRS = (("velocity", "energy"), ("flows", "generator"), ("generator", "energy"))  # the likeliest slip first
MOMENTS_OF_TIME = (0.0, 0.276, 0.618, 1.0)  # of the span; round fractions would hit the zeros of periodic drives


class AgreementLimits(NamedTuple):
    """Numbers that decide whether the parts of a system agree."""

    # of rates, relative to the largest of each component; a changed model differs by far more
    max_difference: float = 1e-5
    rounding: float = 1e-9  # of the largest rate: components below it are rounding of the others
    flow_rounding: float = 1e-6  # of the largest rate, likewise, of differences of flows


LIMITS = AgreementLimits()


def moves_by_generator(system: AbstractLiePoissonSystem) -> bool:
    """Return whether a system moves by its ``generator``, the only description that orbit methods use."""
    return type(system).vector_field is AbstractLiePoissonSystem.vector_field


def has_own_flows(system: AbstractLiePoissonSystem) -> bool:
    """Return whether the flows were written for the generator: no class that inherits them overrides it."""
    order = type(system).__mro__
    place = {name: next(k for k, base in enumerate(order) if name in vars(base)) for name in ("flows", "generator")}
    return bool(system.flows) and place["flows"] <= place["generator"]


def check_generated(system: AbstractLiePoissonSystem, method: str) -> None:
    """Refuse a system that overrides its vector field.

    Raises:
        InvalidInput: with the remedy.
    """
    if not moves_by_generator(system):
        name = type(system).__name__
        raise InvalidInput(
            f"`{method}` moves along the orbit by `generator`, but {name} overrides `vector_field`, which it does not "
            "see. Override `generator(t, point)` instead, or simulate with a diffrax solver such as diffrax.Dopri8()."
        )


def check_agreement(
    system: AbstractLiePoissonSystem, state: Double[Array, "..."], times: Real[ArrayLike, "time"], by_flows: bool
) -> None:
    """Refuse a system whose descriptions disagree at a state or elsewhere on its orbit.

    Args:
        system: systems of this package are taken to agree, as its tests check them.
        state: one packed state or a batch, of which the first is used.
        times: of which the first and the last count [s].
        by_flows: whether the flows are used.

    Raises:
        InvalidInput: naming what disagrees with what.
    """
    if facts_of(system).is_of_package:
        return
    while jnp.ndim(state) > system.state_axes:
        state = state[0]
    first, last = float(times[0]), float(times[-1])
    moments = jnp.asarray([first + share * (last - first) for share in MOMENTS_OF_TIME])
    try:
        with in_jax_numpy(f"the methods of {type(system).__name__}"):
            # first, as an element that is not there makes descriptions disagree too
            check_function(f"`vector_field` of {type(system).__name__}", system.vector_field, moments[0], state)
            misfits = _misfits(system, state, moments, by_flows)
    except TypeError as error:
        raise InvalidInput(
            f"{type(system).__name__} cannot be evaluated: {error}. Its methods are energy(point), velocity(point), "
            "generator(t, point), and flows of (time, components)."
        ) from error
    for pair in PAIRS:
        if float(misfits.get(pair, 0.0)) > LIMITS.max_difference:
            raise InvalidInput(_message(system, *pair, float(misfits[pair])))


def _message(system: AbstractLiePoissonSystem, one: str, other: str, misfit: float) -> str:
    kind = type(system)
    owners = ", ".join(f"`{name}` is from {_owner(kind, name)}" for name in (one, other))
    remedies = {
        "velocity": "`velocity` must be the gradient of `energy`. Override both, or neither of them and give H to "
        "systems.LiePoisson.",
        "generator": "`generator` must keep `energy`. Where it does not, let `conserves_energy` be False.",
        "flows": "`flows` must add up to the motion at all times. Override `flows`, with {} where no exact flows are "
        "known, or give another method, such as LieMidpoint.",
    }
    return f"{kind.__name__} disagrees with itself by {misfit:.2g} ({owners}): {remedies[one]}"


def _owner(kind: type, name: str) -> str:
    return next(base.__name__ for base in kind.__mro__ if name in vars(base))


@eqx.filter_jit
def _misfits(
    system: AbstractLiePoissonSystem, state: Array, times: Array, by_flows: bool
) -> dict[tuple[str, str], Array]:
    """Return the largest relative differences of descriptions at a state and two others on its orbit."""
    flow_angle = 1e-3  # rad by which the fastest rotation turns in a difference of fourth order: its error is 1e-12
    algebra, (attitude, point) = system.algebra, system.parts(state)
    rng = np.random.default_rng(1)
    turns = [algebra.from_vector(jnp.asarray(rng.normal(size=algebra.dim))) for _ in range(2)]
    turns = [x / jnp.maximum(algebra.rate(x), 1.0) for x in turns]
    points = jnp.stack([point, *(point + algebra.exp_change(x, point) for x in turns)])
    gradient = algebra.from_gradient(jax.grad(lambda mu: jnp.sum(system.energy(mu)))(points))
    as_vector = algebra.to_vector
    velocity = as_vector(system.velocity(points))
    misfits = {("velocity", "energy"): _misfit(velocity, as_vector(gradient), LIMITS.rounding)}
    generators = jnp.stack([jnp.broadcast_to(system.generator(t, points), points.shape) for t in times])
    if system.conserves_energy:
        field = algebra.to_dual_vector(algebra.coadjoint(generators, points))
        terms = field * as_vector(gradient)
        # Ḣ = ⟨ad*_ξ μ, dH⟩ relative to the sum of its terms, which cancel where the energy is kept
        power, size = jnp.abs(jnp.sum(terms, axis=-1)), jnp.sum(jnp.abs(terms), axis=-1)
        # where a rate is rounding of larger terms of ad*, so is its power
        size = size + LIMITS.rounding * jnp.linalg.norm(field, axis=-1) * jnp.linalg.norm(as_vector(gradient), axis=-1)
        misfits["generator", "energy"] = _largest(power / jnp.where(size > 0, size, 1.0))
    if by_flows:
        states = points if attitude is None else jax.vmap(lambda mu: join_state(attitude, mu))(points)
        fields = jnp.stack([AbstractLiePoissonSystem.vector_field(system, t, states) for t in times])
        rate = jnp.max(jnp.nan_to_num(algebra.rate(generators)))
        step = flow_angle / jnp.where(rate > 0, rate, 1.0)
        own = system.state_axes
        summed = jax.vmap(lambda one: _first_order(system, step, one))(states)
        flat = lambda x: x.reshape(*x.shape[: x.ndim - own], -1)  # noqa: E731
        summed = flat(jnp.broadcast_to(summed, fields.shape))
        misfits["flows", "generator"] = _misfit(summed, flat(fields), LIMITS.flow_rounding)
    return misfits


def _first_order(system: AbstractLiePoissonSystem, step: Array, state: Array) -> Array:
    """Return the rate of change at time zero of all flows together, by a difference of fourth order."""

    def change(time: Array) -> Array:
        return sum((jnp.stack(flow(time, components(state)), axis=-1) for flow in system.flows.values()), 0.0 * state)

    # f′(0) = (8(f(h) − f(−h)) − (f(2h) − f(−2h)))/12h, the error h⁴ f⁽⁵⁾/30
    near, far, back, far_back = jax.vmap(change)(step * jnp.array([1.0, 2.0, -1.0, -2.0]))
    return (8.0 * (near - back) - (far - far_back)) / (12.0 * step)


def _misfit(one: Array, other: Array, noise: float) -> Array:
    """Return the largest difference of vectors (…, n) relative to the largest value of that component."""
    size = jnp.nan_to_num(jnp.maximum(jnp.abs(one), jnp.abs(other)))
    size = jnp.max(size, axis=tuple(range(size.ndim - 1)))
    size = size + noise * jnp.max(size)
    return _largest(jnp.abs(one - other) / jnp.where(size > 0, size, 1.0))


def _largest(values: Array) -> Array:
    return jnp.max(jnp.where(jnp.isfinite(values), values, 0.0))

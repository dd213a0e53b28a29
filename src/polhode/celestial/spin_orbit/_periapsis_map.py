"""The motion of a spin from one periapsis to the next, as a symplectic composition of drifts and kicks.

Times and strengths of the kicks do not depend on the spin, so they are tabulated once for an orbit. Time
is the mean anomaly here, and p = θ̇/n. The steps are equal in eccentric anomaly, which crowds them where the torque is
strong; as they do not depend on the state either, unequal steps leave each one symplectic and of its order.
"""

from __future__ import annotations

import math
from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import compiled_for_few_calls
from polhode.celestial.spin_orbit.system import SpinOrbit
from polhode.integrators._composition import stages
from polhode.systems.kepler_orbit import ratio_from_eccentric, solve_kepler, true_from_eccentric
from polhode.types import Array, Float64

TURN = 2.0 * math.pi


class Kicks(NamedTuple):
    """One orbit: drift, kick, drift, kick, …, and a last drift.

    Attributes:
        drifts: (K,) lengths before each kick [rad of mean anomaly].
        kicks: (K,) ½ ω0² (a/r)³ times the kick's length.
        phases: (K,) 2f at the kicks.
        last_drift: after the last kick.
    """

    drifts: Float64[Array, "kicks"]
    kicks: Float64[Array, "kicks"]
    phases: Float64[Array, "kicks"]
    last_drift: Float64[Array, ""]


def tabulate(system: SpinOrbit, steps: int) -> Kicks:
    """Return the orbit in a number of steps, each of nine kicks."""
    order = 6  # of the composition
    e = system.eccentricity
    edges = TURN * np.arange(steps + 1) / steps
    # M = E − e sin E at equal steps of E
    edges -= float(e) * np.sin(edges)
    # stages of a symmetric composition of leapfrog steps; a stage kicks in its middle, and drifts of neighbours join
    sizes = np.diff(edges)[:, None] * stages(order)
    middles = edges[:-1, None] + np.cumsum(sizes, axis=1) - 0.5 * sizes
    sizes, middles = sizes.ravel(), middles.ravel()
    kicks, phases = _kicks(middles - TURN * np.round(middles / TURN), sizes, e, system.asphericity)
    drifts = 0.5 * (np.append(0.0, sizes) + np.append(sizes, 0.0))
    return Kicks(jnp.asarray(drifts[:-1]), kicks, phases, jnp.asarray(drifts[-1]))


@compiled_for_few_calls
def _kicks(anomalies: Array, sizes: Array, e: Array, asphericity: Array) -> tuple[Array, Array]:
    """Return strengths and phases of kicks at mean anomalies."""
    eccentric = solve_kepler(anomalies, e)
    # dp/dM = −½ ω0² (a/r)³ sin(2θ − 2f), at fixed θ during a kick
    strength = 0.5 * asphericity**2 / ratio_from_eccentric(eccentric, e) ** 3
    return strength * sizes, 2.0 * true_from_eccentric(eccentric, e)


@partial(jax.jit, static_argnames="periods")
def section(kicks: Kicks, states: Float64[Array, "*batch 2"], periods: int) -> Float64[Array, "{periods} *batch 3"]:
    """Return (θ, p) after each period and the whole turns taken out of θ since the last (periods, …, 3), |θ| ≤ π."""

    def kick(state: tuple[Array, Array], row: tuple[Array, ...]) -> tuple[tuple[Array, Array], None]:
        (q, p), (drift, strength, phase) = state, row
        q = q + drift * p
        return (q, p - strength * jnp.sin(2.0 * q - phase)), None

    def orbit(state: tuple[Array, Array], _: None) -> tuple[tuple[Array, Array], Array]:
        (q, p), _ = jax.lax.scan(kick, state, kicks[:3])
        point = _point(q + kicks.last_drift * p, p)
        return (point[..., 0], p), point

    return jax.lax.scan(orbit, (states[..., 0], states[..., 1]), None, length=periods)[1]


@partial(jax.jit, static_argnames=("periods", "renormalise"))
def carry_neighbours(
    kicks: Kicks,
    states: Float64[Array, "*batch 2"],
    neighbours: Float64[Array, "*batch 2 k"],
    periods: int,
    renormalise: bool,
) -> tuple[Float64[Array, "{periods} *batch 3"], Float64[Array, "*batch 2 k"], Float64[Array, "{periods} *batch k"]]:
    """Return a section, neighbours at its end, and the logarithms of their growth in each period.

    The section (periods, …, 3) is as in ``section``, the neighbours are (…, 2, k), and the logarithms (periods, …, k).

    Args:
        kicks: of the orbit.
        states: (…, 2) angle θ and p.
        neighbours: (…, 2, k) small differences from the states.
        periods: number of orbits.
        renormalise: whether to bring them back to length one after each period.
    """

    def kick(state: tuple[Array, ...], row: tuple[Array, ...]) -> tuple[tuple[Array, ...], None]:
        (q, p, dq, dp), (drift, strength, phase) = state, row
        q, dq = q + drift * p, dq + drift * dp
        # the derivative of p ↦ p − strength sin(2q − phase)
        angle = 2.0 * q - phase
        dp = dp - (2.0 * strength * jnp.cos(angle))[..., None] * dq
        return (q, p - strength * jnp.sin(angle), dq, dp), None

    def orbit(state: tuple[Array, ...], _: None) -> tuple[tuple[Array, ...], tuple[Array, Array]]:
        before = jnp.hypot(state[2], state[3])
        (q, p, dq, dp), _ = jax.lax.scan(kick, state, kicks[:3])
        point, dq = _point(q + kicks.last_drift * p, p), dq + kicks.last_drift * dp
        growth = jnp.hypot(dq, dp) / before
        if renormalise:
            length = jnp.hypot(dq, dp)
            dq, dp = dq / length, dp / length
        return (point[..., 0], p, dq, dp), (point, jnp.log(growth))

    start = (states[..., 0], states[..., 1], neighbours[..., 0, :], neighbours[..., 1, :])
    (_, _, dq, dp), (points, growth) = jax.lax.scan(orbit, start, None, length=periods)
    return points, jnp.stack([dq, dp], axis=-2), growth


def _point(angle: Array, p: Array) -> Float64[Array, "*batch 3"]:
    """Return the angle within ±π, p, and the whole turns taken out."""
    within = angle - TURN * jnp.round(angle / TURN)
    return jnp.stack([within, p, jnp.round((angle - within) / TURN)], axis=-1)

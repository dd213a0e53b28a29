"""Reconstructs the attitude from a reduced trajectory on so(3)*, with its dynamic and geometric phase.

Source: Montgomery, Am. J. Phys. 59 (1991) 394; Marsden, Montgomery & Ratiu, Mem. Amer. Math. Soc. 436 (1990); Magnus'
expansion of order 4 at Gauss's points: Blanes, Casas, Oteo & Ros, Phys. Rep. 470 (2009) 151.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base.arrays import known_false, require_doubles
from polhode.errors import InvalidInput
from polhode.types import Array, ArrayLike, Double, Float64, Real

NODES = 0.5 + np.array([-1.0, 1.0]) * math.sqrt(3.0) / 6.0


class Reconstruction(NamedTuple):
    """The attitude along a reduced trajectory.

    Attributes:
        attitude: (T, 4) unit quaternions wxyz, body → space.
        dynamic_phase: (T,) ∫ L·Ω/|L| dt [rad], twice the energy times t over |L| for a free body.
        geometric_phase: (T,) minus the solid angle swept on the momentum sphere by the great circle from the first
            momentum to the present one [rad]. When L is back, the body has rotated about the space momentum by the sum
            of the two phases.
    """

    attitude: Float64[Array, "time 4"]
    dynamic_phase: Float64[Array, "time"]
    geometric_phase: Float64[Array, "time"]


def reconstruct(
    times: Real[ArrayLike, "time"],
    momentum: Real[ArrayLike, "time 3"],
    velocity: Callable[[Array], Array],
    attitude: Real[ArrayLike, "4"] = (1.0, 0.0, 0.0, 0.0),
) -> Reconstruction:
    """Return the attitude of a motion L̇ = L × Ω(L) from samples of L; the space momentum R L is kept to rounding.

    Between samples L is a cubic through values and slopes; errors are of fourth order in the spacing of the samples.

    Args:
        times: (T,) [s], monotonic.
        momentum: (T, 3) along the body's axes at these times.
        velocity: Ω = dH(L), from points (…, 3) to (…, 3), as a system's ``velocity``.
        attitude: (4,) at the first time.

    Raises:
        InvalidInput: for shapes that do not match, fewer than two samples, times that do not advance, or L = 0.
    """
    require_doubles(times=times, momentum=momentum, attitude=attitude)
    t, L = jnp.asarray(times, dtype=jnp.float64), jnp.asarray(momentum, dtype=jnp.float64)
    if t.ndim != 1 or len(t) < 2 or L.shape != (len(t), 3):
        raise InvalidInput(f"`times` (T,) and `momentum` (T, 3) must match, T at least 2; got {t.shape} and {L.shape}.")
    steps = jnp.diff(t)
    if known_false(jnp.all(jnp.isfinite(steps) & (steps * steps[0] > 0))):
        raise InvalidInput("`times` must be finite and advance in one direction, without repetitions.")
    norm = jnp.linalg.norm(L[0])
    if known_false(jnp.isfinite(L).all() & (norm > 0)):
        raise InvalidInput("`momentum` must be finite and not zero: at rest it does not determine the attitude.")
    h = steps[:, None]
    slopes = jnp.cross(L, velocity(L))
    # Magnus' expansion of order 4 for Ṙ = R hat(Ω): a turn by ½h(Ω₁ + Ω₂) + (√3/12)h² Ω₁ × Ω₂, with Ω at Gauss's points
    # of Hermite's cubic through L and its slopes L̇ = L × Ω
    middle = [hermite(c, h, L[:-1], L[1:], slopes[:-1], slopes[1:]) for c in NODES]
    spin = [velocity(m) for m in middle]
    turn = 0.5 * h * (spin[0] + spin[1]) + math.sqrt(3.0) / 12.0 * h * h * jnp.cross(spin[0], spin[1])
    moves = rotation.from_rotation_vector(turn)
    start = rotation.normalize(jnp.asarray(attitude, dtype=jnp.float64))

    def advance(q: Array, move: Array) -> tuple[Array, Array]:
        q = rotation.normalize(rotation.multiply(q, move))
        return q, q

    _, path = jax.lax.scan(advance, start, moves)
    path = jnp.concatenate([start[None], path])
    # the exact motion keeps R L: the shortest turn that takes R(t) L(t) back to it removes the error across that
    # direction and leaves the one along it, the phase, as it is
    wanted = rotation.rotate(start, L[0])
    path = rotation.multiply(rotation.shortest_between(rotation.rotate(path, L), wanted), path)
    # ∫ L·Ω/|L| dt and the solid angle by Gauss's two points, as accurate as the cubic
    dynamic = sum(0.5 * h[:, 0] * jnp.sum(m * w, axis=-1) / norm for m, w in zip(middle, spin, strict=True))
    swept = sum(0.5 * h[:, 0] * _sweep(L[0], m, jnp.cross(m, w)) for m, w in zip(middle, spin, strict=True))
    total = lambda rates: jnp.concatenate([jnp.zeros(1), jnp.cumsum(rates)])  # noqa: E731
    return Reconstruction(path, total(dynamic), -total(swept))


def hermite(
    c: float, h: Float64[Array, "..."], a: Double[Array, "..."], b: Double[Array, "..."],
    slope_a: Double[Array, "..."], slope_b: Double[Array, "..."],
) -> Double[Array, "..."]:
    """Return the cubic through values and slopes at both ends of intervals of length h, at the fraction c of them."""
    own, other = (1 + 2 * c) * (1 - c) ** 2, c * c * (3 - 2 * c)
    return own * a + other * b + h * (c * (1 - c) ** 2 * slope_a + c * c * (c - 1) * slope_b)


def _sweep(first: Array, now: Array, slope: Array) -> Array:
    """Return the rate of the solid angle swept by the great circle from the first direction to the present one."""
    # about n₀, with colatitude θ and azimuth φ of n: (1 − cos θ) φ̇ = sin²θ φ̇/(1 + cos θ), and n₀·(n × ṅ) = sin²θ φ̇
    n0, n = first / jnp.linalg.norm(first), now / jnp.linalg.norm(now, axis=-1, keepdims=True)
    rate = slope / jnp.linalg.norm(now, axis=-1, keepdims=True)
    return jnp.sum(n0 * jnp.cross(n, rate), axis=-1) / (1.0 + jnp.sum(n0 * n, axis=-1))

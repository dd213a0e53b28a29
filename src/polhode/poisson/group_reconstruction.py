"""Reconstructs the motion on the group from a trajectory on the dual of its algebra.

Source: Marsden, Montgomery & Ratiu, Mem. Amer. Math. Soc. 436 (1990); Magnus' expansion of order 4 at Gauss's points:
Blanes, Casas, Oteo & Ros, Phys. Rep. 470 (2009) 151, §5.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp

from polhode._base.arrays import known_false, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, shown
from polhode.poisson.reconstruction import NODES, hermite
from polhode.types import Array, ArrayLike, Float64, Real


class GroupPath(NamedTuple):
    """The motion on the group.

    Attributes:
        elements: group elements as the algebra's ``exp`` gives them, with an axis of time in front: (T, …).
        misfit: (T,) difference between the momentum in space, which the exact motion keeps, and its first value,
            relative to its size: a measure of the error of interpolation between the samples.
    """

    elements: Any
    misfit: Float64[Array, "time"]


def reconstruct_group(
    algebra: AbstractLieAlgebra,
    times: Real[ArrayLike, "time"],
    points: Real[ArrayLike, "..."],
    velocity: Callable[[Array], Array],
    sign: int = -1,
) -> GroupPath:
    """Return g(t) with g = e at the first time of a motion on the dual, from samples of the point μ.

    For left-invariant systems (sign −1) ġ = g dH, and Ad*_{g⁻¹} μ is constant, as a body's momentum is in space; for
    right-invariant ones (sign +1) ġ = dH g, and Ad*_g μ is constant. Between samples μ is a cubic through values and
    slopes; errors are of fourth order in the spacing. ``reconstruct`` does this for rigid bodies, with their phases.

    Args:
        algebra: of the system.
        times: (T,) [s], monotonic.
        points: (T, …) on the dual at these times.
        velocity: dH, from points (…) to elements (…), as a system's ``velocity``.
        sign: −1 or +1, as the system's.

    Raises:
        InvalidInput: for shapes that do not match, fewer than two samples, times that do not advance, another sign.

    >>> from polhode.algebra import SE2
    >>> times = jnp.linspace(0.0, 1.0, 11)
    >>> resting = jnp.ones((11, 1)) * jnp.array([1.0, 0.0, 0.0])
    >>> path = reconstruct_group(SE2(), times, resting, lambda m: m * jnp.array([0.5, 0.0, 0.0]))
    >>> print(path.elements[-1].round(6))  # cosine and sine of half a radian, and no shift
    [0.877583 0.479426 0.       0.      ]
    """
    require_doubles(times=times, points=points)
    t, mu = jnp.asarray(times, dtype=jnp.float64), jnp.asarray(points, dtype=algebra.dtype)
    if t.ndim != 1 or len(t) < 2 or algebra.batch_shape(mu) != t.shape:
        raise InvalidInput(
            f"`times` (T,) and `points` (T, …) of {algebra.name} must match, T at least 2; got shapes {t.shape} and "
            f"{mu.shape}."
        )
    if sign not in (-1, 1):
        raise InvalidInput(f"`sign` must be −1 (left-invariant) or +1 (right-invariant); got {shown(sign)}.")
    gaps = jnp.diff(t)
    if known_false(jnp.all(jnp.isfinite(gaps) & (gaps * gaps[0] > 0))):
        raise InvalidInput("`times` must be finite and advance in one direction, without repetitions.")
    # Magnus' expansion of order 4 with ξ = dH at Gauss's two points: g moves by the exponential of
    # ½h(ξ₁ + ξ₂) ± (√3/12)h² [ξ₁, ξ₂], plus for ġ = gξ, minus for ġ = ξg. Between samples μ is Hermite's cubic with
    # slopes μ̇ = −sign ad*_ξ μ.
    h = gaps.reshape(-1, *(1,) * len(algebra.element_shape))
    slopes = -sign * algebra.coadjoint(velocity(mu), mu)
    first, second = (velocity(hermite(c, h, mu[:-1], mu[1:], slopes[:-1], slopes[1:])) for c in NODES)
    steps = 0.5 * h * (first + second) - sign * (math.sqrt(3.0) / 12.0) * h * h * algebra.bracket(first, second)
    moves = algebra.exp(steps)
    start = algebra.exp(jnp.zeros(algebra.element_shape, algebra.dtype))

    def advance(g: Any, move: Any) -> tuple[Any, Any]:
        g = algebra.compose(g, move) if sign == -1 else algebra.compose(move, g)
        return g, g

    _, path = jax.lax.scan(advance, start, moves)
    path = jax.tree.map(lambda one, more: jnp.concatenate([one[None], more]), start, path)
    # left: μ = Ad*_g μ₀; right: μ₀ = Ad*_g μ
    fixed, other = (mu[:1], mu) if sign == -1 else (mu, mu[:1])
    off = jax.vmap(algebra.coadjoint_action)(path, jnp.broadcast_to(fixed, mu.shape)) - other
    size = jnp.max(jnp.abs(mu[0]))
    misfit = jnp.max(jnp.abs(off).reshape(len(t), -1), axis=-1) / jnp.where(size > 0, size, 1.0)
    return GroupPath(path, misfit)

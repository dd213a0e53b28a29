"""The free body's exact flow over one step, as systems with a potential need it between kicks.

``FreeMotion`` is exact over any time, but prepares for all of time. Over a step the Taylor series of quaternion and
momentum ends at rounding after a few terms: the nearest singularity in complex time is K'/λ ≥ π/2 over the fastest
rate away. Longer steps are taken in pieces.
"""

from __future__ import annotations

import jax
import jax.numpy as jnp

from polhode.rotation import cross_of_parts, product_of_parts, product_with_vector
from polhode.systems.base import Components
from polhode.systems.forward_only import forward_only
from polhode.types import Array, ArrayOrFloat, Float64

ORDER = 8
ANGLE = 0.02  # rad of the fastest rotation in a piece: (0.02/1.57)⁹ is below rounding; higher orders compile long
MOST_PIECES = 1_000_000


def free_flow(
    moments: Float64[Array, "3"], time: Float64[ArrayOrFloat, ""], state: Components, vectors: int
) -> Components:
    """Return the changes of attitude, if there in front, and of momentum and direction, or momentum alone.

    Args:
        moments: (3,) [kg m²].
        time: () [s].
        state: the components of packed states; vectors after the momentum are fixed in space.
        vectors: how many of three components a point has; a quaternion may stand in front of them.
    """
    start = len(state) - 3 * vectors
    turn = free_turn(moments, time, state[start : start + 3])
    changes = turned_attitude(turn, state[:4]) if start else ()
    for k in range(start, len(state), 3):
        changes += turned_back(turn, state[k : k + 3])
    return changes


def free_turn(moments: Float64[Array, "3"], time: Float64[ArrayOrFloat, ""], momentum: Components) -> Components:
    """Return p − 1 (4 components) of the unit quaternion p by which a free body turns in its own axes.

    The momentum along the body's axes is turned by the inverse; so is every direction fixed in space, whatever the
    series leaves out, so that lengths and angles between them stay.

    Args:
        moments: (3,) [kg m²].
        time: () [s].
        momentum: three components (…) at the start.
    """
    inverse = tuple(1.0 / moments[k] for k in range(3))
    # the rates' size, as squares of momenta may overflow
    x, y, z = (jnp.abs(time) * momentum[k] * jnp.max(1.0 / moments) for k in range(3))
    angle = jnp.sqrt(x * x + y * y + z * z)
    pieces = jnp.clip(jnp.nan_to_num(jnp.ceil(angle / ANGLE), nan=1.0), 1, MOST_PIECES).astype(int)
    share = time / pieces

    def piece(k: Array, carried: tuple[Components, Components]) -> tuple[Components, Components]:
        total, now = carried
        # each copy has pieces of its own; one that is through stays as it is
        turn = tuple(jnp.where(k < pieces, x, 0.0) for x in _series(inverse, share, now))
        moved = turned_back(turn, now)
        return composed(total, turn), tuple(x + d for x, d in zip(now, moved, strict=True))

    still = (jnp.zeros_like(angle),) * 4
    turn = jax.lax.fori_loop(0, jnp.max(pieces), piece, (still, momentum))[0]
    return forward_only(turn, "the free body's flow")


def turned_back(turn: Components, vector: Components) -> Components:
    """Return p⁻¹ v p − v for p − 1, without cancellation."""
    w, x, y, z = turn
    excess = _excess(turn)
    u, v = (x, y, z), vector
    across = cross_of_parts(v, u)
    twice = cross_of_parts(across, u)
    scale = 2.0 / (1.0 + excess)
    return tuple(scale * ((1.0 + w) * a + b) for a, b in zip(across, twice, strict=True))


def turned_attitude(turn: Components, attitude: Components) -> Components:
    """Return q p − q for p − 1, p brought to unit length."""
    correction = -0.5 * _excess(turn)
    w, *rest = turn
    unit = (w + correction * (1.0 + w), *(x + correction * x for x in rest))
    return product_of_parts(attitude, unit)


def composed(first: Components, second: Components) -> Components:
    """Return p q − 1 from p − 1 and q − 1."""
    return tuple(a + b + c for a, b, c in zip(first, second, product_of_parts(first, second), strict=True))


def _series(inverse: tuple[Array, ...], time: Array, momentum: Components) -> Components:
    """Return Σ_{k ≥ 1} of the quaternion's Taylor terms: q' = ½ q Ω, L' = L × Ω."""
    zero = jnp.zeros_like(momentum[0])
    L: list[Components] = [momentum]
    turn: list[Components] = [(zero + 1.0, zero, zero, zero)]
    velocity = [tuple(time * i * x for i, x in zip(inverse, momentum, strict=True))]
    for k in range(ORDER):
        if k + 1 < ORDER:
            terms = [cross_of_parts(L[j], velocity[k - j]) for j in range(k + 1)]
            L.append(tuple(sum(t[n] for t in terms) * (1.0 / (k + 1)) for n in range(3)))
            velocity.append(tuple(time * i * x for i, x in zip(inverse, L[-1], strict=True)))
        terms = [product_with_vector(turn[j], velocity[k - j]) for j in range(k + 1)]
        turn.append(tuple(sum(t[n] for t in terms) * (0.5 / (k + 1)) for n in range(4)))
    # from the smallest term up
    return tuple(sum(term[n] for term in turn[:0:-1]) for n in range(4))


def _excess(turn: Components) -> Array:
    """Return |p|² − 1."""
    w, x, y, z = turn
    return 2.0 * w + ((w * w + x * x) + (y * y + z * z))

"""The free body's exact flow over one step, as systems with a potential need it between kicks.

``FreeMotion`` is exact over any time, but prepares for all of time. Over a turn of ``ANGLE`` the discrete Moser–Veselov
algorithm of order 10 misses the flow by no more than rounding, for a tenth of the cost of a Taylor series. Longer steps
are taken in pieces. Source: Hairer & Vilmart, J. Phys. A 39 (2006) 13225.
"""

from __future__ import annotations

import jax
import jax.numpy as jnp

from polhode.rotation import cross_of_parts, product_of_parts
from polhode.systems.base import Components
from polhode.systems.forward_only import forward_only
from polhode.systems.moser_veselov_table import corrections
from polhode.types import Array, ArrayOrFloat, Float64

ORDER = 10
ANGLE = 0.2  # rad, above that of the fastest rotation in a piece; a body's flow is missed by 3e-16 rad at most
ITERATIONS = 9  # after which the unknown is off by 2e-16 of its size
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
    least = jnp.min(moments)
    inverse = tuple(least / moments[k] for k in range(3))
    # angles, as squares of momenta may overflow
    x, y, z = (time * (momentum[k] / least) for k in range(3))
    angle = jnp.sqrt(x * x + y * y + z * z)
    pieces = jnp.clip(jnp.nan_to_num(jnp.ceil(angle / ANGLE), nan=1.0), 1, MOST_PIECES).astype(int)
    share = time / pieces
    # both stay as they are from piece to piece
    squares = [(share * (x / least)) ** 2 for x in momentum]
    energy, casimir = 0.5 * sum(a * x for a, x in zip(inverse, squares, strict=True)), 0.5 * sum(squares)
    scale, shift = corrections(ORDER, inverse, energy, casimir)
    corrected = tuple(a + (a * scale + shift) for a in inverse)

    def piece(k: Array, carried: tuple[Components, Components]) -> tuple[Components, Components]:
        total, now = carried
        # each copy has pieces of its own; one that is through stays as it is
        angles = tuple(jnp.where(k < pieces, share * (x / least), 0.0) for x in now)
        turn = _moser_veselov(corrected, angles)
        moved = turned_back(turn, now)
        return composed(total, turn), tuple(x + d for x, d in zip(now, moved, strict=True))

    # most steps are one piece, and one outside the loop saves a sixth of their time
    still = (jnp.zeros_like(angle),) * 4
    first = piece(jnp.zeros((), int), (still, momentum))
    turn = jax.lax.fori_loop(1, jnp.max(pieces), piece, first)[0]
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


def _moser_veselov(b: Components, angles: Components) -> Components:
    """Return p − 1 of the unit quaternion p along (1, y), y_i = b_i u_i, u_i = ½ m_i (1 + |y|²) − u_j u_k (b_j − b_k).

    These are the algorithm's equations hat(m) = ω D − D ωᵀ, written without a division by the b_i.

    Args:
        b: the smallest moment over each of the moments, corrected to give the algorithm its order.
        angles: m_i = L_i t over the smallest moment.
    """
    gaps = [b[1] - b[2], b[2] - b[0], b[0] - b[1]]
    u = [0.5 * m for m in angles]
    for _ in range(ITERATIONS):
        y = [b[k] * u[k] for k in range(3)]
        half = 0.5 + 0.5 * (y[0] * y[0] + y[1] * y[1] + y[2] * y[2])
        for k in range(3):  # each with those just found, which doubles the digits gained
            u[k] = half * angles[k] - u[(k + 1) % 3] * u[(k + 2) % 3] * gaps[k]
    y = [b[k] * u[k] for k in range(3)]
    square = y[0] * y[0] + y[1] * y[1] + y[2] * y[2]
    root = jnp.sqrt(1.0 + square)
    return -square / (root * (1.0 + root)), *(x / root for x in y)


def _excess(turn: Components) -> Array:
    """Return |p|² − 1."""
    w, x, y, z = turn
    return 2.0 * w + ((w * w + x * x) + (y * y + z * z))

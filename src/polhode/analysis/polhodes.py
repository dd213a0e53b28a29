"""Curves on the unit momentum sphere: polhodes, the separatrix, and levels of any energy, for pictures.

On |L| = const a free body's L runs along a level of Σ L_i²/2I_i. The separatrix A L1² = B L3², A = (I2 − I1) I3,
B = (I3 − I2) I1, is two great circles. A gyrostat's levels are those of ½ Σ (L_i − h_i)²/I_i, whose saddles have
separatrices of their own. Source: Landau & Lifshitz, *Mechanics*, §37; Hughes,
*Spacecraft Attitude Dynamics*, §6.2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.exact.free_body import FreeMotion
from polhode.motion._inputs import finite
from polhode.types import Array, ArrayLike, Float64, Real

Energy = Callable[[Float64[Array, "*batch 3"]], Float64[Array, "*batch"]]
POINTS = 400  # of a curve


@known_numbers_only
def polhode_family(moments: Real[ArrayLike, "3"]) -> list[Float64[Array, "points 3"]]:
    """Return unit polhodes (T, 3) around both stable axes, at given fractions of the way to the separatrix.

    Args:
        moments: (3,) ascending.
    """
    parts = (0.08, 0.25, 0.5, 0.75)  # of the way from an axis to the separatrix
    I1, I2, I3 = moments
    curves = []
    if I1 == I3:
        return curves
    for axis in (0, 2):
        # on the great circle through axes 1 and 3 the separatrix has this angle from axis 3
        # A L1² = B L3²
        saddle = np.arctan2(np.sqrt((I3 - I2) * I1), np.sqrt((I2 - I1) * I3))
        reach = saddle if axis == 2 else 0.5 * np.pi - saddle
        for part in parts if reach > 1e-9 else ():
            angle = part * reach
            near, far = np.cos(angle), np.sin(angle)
            start = (far, 0.0, near) if axis == 2 else (near, 0.0, far)
            motion = FreeMotion(moments, momentum=start)
            period = finite(motion.period)
            if period is None:
                continue
            curve = motion.momentum(np.linspace(0.0, period, POINTS))
            curves += [curve, -curve]
    return curves


@known_numbers_only
def polhode(motion: FreeMotion, points: int) -> Float64[Array, "{points}+1 3"] | None:
    """Return one body's unit polhode (points + 1, 3) along the motion's axes, its ends equal; None without period.

    Points are spread half by length, half by time: by time alone they would be far apart where L is fast, between its
    long stays near a separatrix, and by length alone in the bends where it stays.
    """
    period = finite(motion.period)
    if period is None or not motion.momentum_norm:
        return None
    epoch = float(motion.epoch)
    times = epoch + np.linspace(0.0, period, 4 * points + 1)
    steps = np.linalg.norm(np.diff(motion.momentum(times), axis=0), axis=-1)
    share = np.concatenate([[0.0], np.cumsum(steps / steps.sum())]) + np.linspace(0.0, 1.0, len(times))
    spread = np.interp(np.linspace(0.0, share[-1], points + 1), share, times)
    return motion.momentum(spread) / motion.momentum_norm


@known_numbers_only
def separatrix(moments: Real[ArrayLike, "3"]) -> list[Float64[Array, "points 3"]]:
    """Return the two unit great circles (T, 3) on which A L1² = B L3²; none unless the moments (3,) ascend strictly."""
    I1, I2, I3 = moments
    if not I1 < I2 < I3:
        return []
    a, b = np.sqrt((I2 - I1) * I3), np.sqrt((I3 - I2) * I1)
    size = np.hypot(a, b)
    turn = np.linspace(0.0, 2.0 * np.pi, POINTS)
    return [
        np.stack([np.cos(turn) * b / size, np.sin(turn), side * np.cos(turn) * a / size], axis=-1) for side in (1, -1)
    ]


@known_numbers_only
def level_segments(energy: Energy, values: Sequence[float] | None = None) -> Float64[np.ndarray, "pieces 2 3"]:
    """Return where a function of unit vectors (…, 3) has the values, as short pieces (n, 2, 3) on the unit sphere.

    Args:
        energy: the function.
        values: its levels; by default nine, evenly spread over its range.
    """
    count = 9  # levels of any energy
    corners = _octahedron()
    heights = energy(corners)
    low, high = float(heights.min()), float(heights.max())
    if not high - low > 1e-12 * max(abs(low), abs(high)):
        return np.empty((0, 2, 3))
    spread = low + (high - low) * (np.arange(count) + 0.5) / count
    return np.concatenate([np.empty((0, 2, 3)), *(_cut_triangles(energy, corners, heights, v)
                                                  for v in (spread if values is None else values))])


@known_numbers_only
def saddle_energies(moments: Real[ArrayLike, "3"], rotor: Real[ArrayLike, "3"], norm: float) -> list[float]:
    """Return the energies of a gyrostat's saddles on |L| = norm, by Newton's method on Ω = λ u from many directions.

    Args:
        moments: (3,) [kg m²].
        rotor: (3,) h [kg m²/s].
        norm: |L| [kg m²/s], positive.
    """
    newton_steps = 40
    starts = 200
    settled = 1e-10  # relative, of a root's residual and of curvatures that vanish
    I, h = np.asarray(moments, dtype=float), np.asarray(rotor, dtype=float) / norm  # noqa: E741
    I = I / I.max()  # noqa: E741  energies are scaled back below
    turn = np.pi * (3.0 - np.sqrt(5.0)) * np.arange(starts)
    z = 1.0 - 2.0 * (np.arange(starts) + 0.5) / starts
    u = np.stack([np.sqrt(1.0 - z * z) * np.cos(turn), np.sqrt(1.0 - z * z) * np.sin(turn), z], axis=-1)
    rate = np.sum(u * (u - h) / I, axis=-1)
    for _ in range(newton_steps):
        # u (1 − λ I) = h and u·u = 1, in the unknowns u and λ
        # the derivative of (u (1 − λI) − h, u·u − 1) by (u, λ)
        slope = np.zeros((starts, 4, 4))
        slope[:, [0, 1, 2], [0, 1, 2]] = 1.0 - rate[:, None] * I
        slope[:, :3, 3], slope[:, 3, :3] = -I * u, 2.0 * u
        miss = np.concatenate([u * (1.0 - rate[:, None] * I) - h, (np.sum(u * u, axis=-1) - 1.0)[:, None]], axis=-1)
        change = np.linalg.pinv(slope) @ miss[..., None]
        u, rate = u - change[:, :3, 0], rate - change[:, 3, 0]
    missed = np.abs(u * (1.0 - rate[:, None] * I) - h).max(axis=-1) + np.abs(np.sum(u * u, axis=-1) - 1.0)
    energies: list[float] = []
    for direction, spin in zip(u[missed < settled], rate[missed < settled], strict=True):
        across = np.linalg.svd(direction[None])[2][1:]
        bends = np.linalg.eigvalsh(across @ np.diag(1.0 / I - spin) @ across.T)
        value = 0.5 * float(np.sum((direction - h) ** 2 / I)) * norm**2 / float(np.max(moments))
        flat = settled * np.max(1.0 / I)
        if bends[0] < -flat and bends[1] > flat and not any(abs(value - other) <= 1e-9 * value for other in energies):
            energies.append(value)
    return sorted(energies)


def _octahedron() -> Array:
    """Return the corners (n, 3, 3) of small triangles that cover the unit sphere."""
    mesh = 28  # pieces of an octahedron's edge
    i, j = np.meshgrid(np.arange(mesh), np.arange(mesh), indexing="ij")
    upright, inverted = (i + j < mesh), (i + j < mesh - 1)

    def point(a: Array, b: Array) -> Array:
        return np.stack([a, b, mesh - a - b], axis=-1) / mesh

    first = np.stack([point(i, j), point(i + 1, j), point(i, j + 1)], axis=-2)[upright]
    second = np.stack([point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)], axis=-2)[inverted]
    octant = np.concatenate([first, second])
    signs = np.array([[x, y, z] for x in (1, -1) for y in (1, -1) for z in (1, -1)])
    corners = (signs[:, None, None, :] * octant).reshape(-1, 3, 3)
    return corners / np.linalg.norm(corners, axis=-1, keepdims=True)


def _cut_triangles(energy: Energy, corners: Array, heights: Array, value: float) -> Array:
    """Return the pieces of one level in the triangles that it crosses."""
    above = heights >= value
    crossed = above.any(axis=-1) & ~above.all(axis=-1)
    corners, above = corners[crossed], above[crossed]
    # the corner that is alone on its side; the level leaves through its two edges
    single = np.where(above.sum(axis=-1) == 1, above.argmax(axis=-1), (~above).argmax(axis=-1))
    rows = np.arange(len(corners))
    apex = corners[rows, single]
    ends = [_root(energy, apex, corners[rows, (single + k) % 3], above[rows, single], value) for k in (1, 2)]
    return np.stack(ends, axis=1)


def _root(energy: Energy, start: Array, end: Array, above: Array, value: float) -> Array:
    bisections = 12  # each halves the error of a crossing, which starts at an edge of 0.06 rad
    for _ in range(bisections):
        # the middle of an arc of a great circle
        middle = start + end
        middle = middle / np.linalg.norm(middle, axis=-1, keepdims=True)
        same = ((energy(middle) >= value) == above)[:, None]
        start, end = np.where(same, middle, start), np.where(same, end, middle)
    middle = start + end
    return middle / np.linalg.norm(middle, axis=-1, keepdims=True)

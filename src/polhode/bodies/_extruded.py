"""Surfaces of prisms, as triangles for drawing."""

from __future__ import annotations

import numpy as np

from polhode.bodies.surface import Surface
from polhode.types import Array, Integer, Real


def extrude(outline: Real[Array, "n 2"], height: float) -> Surface:
    """Return the prism on a simple polygon (n, 2) [m], its middle at z = 0."""
    corners = np.asarray(outline, dtype=float)
    following = np.roll(corners, -1, axis=0)
    if (corners[:, 0] * following[:, 1] - corners[:, 1] * following[:, 0]).sum() < 0.0:
        corners = corners[::-1]
    n, top = len(corners), triangulate(corners)
    vertices = np.vstack([np.column_stack([corners, np.full(n, side * height)]) for side in (-0.5, 0.5)])
    k = np.arange(n)
    after = np.roll(k, -1)
    walls = np.vstack([np.column_stack([k, after, after + n]), np.column_stack([k, after + n, k + n])])
    return Surface(vertices, np.vstack([top[:, ::-1], top + n, walls]))


def regular_outline(sides: int, radius: float) -> Real[Array, "sides 2"]:
    """Return a regular polygon's corners (sides, 2), one of them on the x axis."""
    angles = 2.0 * np.pi / sides * np.arange(sides)
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def triangulate(corners: Real[Array, "n 2"]) -> Integer[Array, "m 3"]:
    """Return triangles (n − 2, 3) of a simple polygon that runs counterclockwise, by cutting off ears.

    Source: Meisters, Amer. Math. Monthly 82 (1975) 648: every simple polygon has two ears.
    """
    left = list(range(len(corners)))
    triangles: list[tuple[int, int, int]] = []
    k = 0
    while len(left) > 3:
        turns = (k + np.arange(len(left))) % len(left)
        # without an ear, which rounding may hide, any corner
        k = next((int(turn) for turn in turns if _is_ear(corners, left, int(turn))), k)
        triangles.append((left[k - 1], left[k], left[(k + 1) % len(left)]))
        del left[k]
        k %= len(left)
    return np.array([*triangles, tuple(left)], dtype=np.int64)


def _is_ear(corners: Array, left: list[int], k: int) -> bool:
    """Whether the triangle of a corner and its neighbours lies inside, with no other corner in it."""
    three = (left[k - 1], left[k], left[(k + 1) % len(left)])
    a, b, c = corners[list(three)]
    others = corners[[i for i in left if i not in three]]
    if not _turn(a, b, c) > 0.0:
        return False
    inside = (_turn(a, b, others) >= 0.0) & (_turn(b, c, others) >= 0.0) & (_turn(c, a, others) >= 0.0)
    return not inside.any()


def _turn(a: Array, b: Array, c: Array) -> Array:
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])

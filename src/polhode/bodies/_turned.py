"""Surfaces of revolution about z, as triangles for drawing."""

from __future__ import annotations

import math

import numpy as np

from polhode import rotation
from polhode.bodies.surface import Surface
from polhode.types import ArrayLike, Real

SECTIONS = 64  # of a full turn; an inscribed polygon of so many has 0.16 % less area than its circle


def revolve(profile: Real[ArrayLike, "k 2"], sections: int = SECTIONS, closed: bool = False) -> Surface:
    """Return the surface that a line swings out about z.

    Args:
        profile: (k, 2) radii and heights [m], upward on the outside; an open one begins and ends on the axis, so that
            the surface is closed.
        sections: flat faces of a full turn.
        closed: whether the line runs back to where it began.

    >>> cone = revolve([(0.0, 0.0), (1.0, 0.0), (0.0, 2.0)], sections=4)
    >>> cone.vertices.shape, cone.faces.shape
    ((6, 3), (8, 3))
    """
    radii, heights = np.asarray(profile, dtype=float).T
    angles = 2.0 * math.pi / sections * np.arange(sections)
    across = np.outer(radii, np.cos(angles)), np.outer(radii, np.sin(angles))
    vertices = np.dstack([*across, np.repeat(heights[:, None], sections, axis=1)])
    index = np.arange(len(radii) * sections).reshape(-1, sections)
    index[radii == 0.0] = index[radii == 0.0, :1]  # on the axis the ring is one point
    index = np.vstack([index, index[:1]]) if closed else index
    # each cell of the grid is two triangles
    a, d = index[:-1].ravel(), index[1:].ravel()
    b, c = np.roll(index[:-1], -1, axis=1).ravel(), np.roll(index[1:], -1, axis=1).ravel()
    faces = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    used = np.unique(faces)
    return Surface(vertices.reshape(-1, 3)[used], np.searchsorted(used, faces))


def tube(radius: float, height: float, inner_radius: float = 0.0, sections: int = SECTIONS) -> Surface:
    """Return a cylinder about z with its middle at the origin, hollow if ``inner_radius`` is given [m]."""
    top, bottom = 0.5 * height, -0.5 * height
    profile = [(inner_radius, bottom), (radius, bottom), (radius, top), (inner_radius, top)]
    return revolve(profile, sections, closed=inner_radius > 0.0)


def cone(radius: float, height: float, sections: int = SECTIONS) -> Surface:
    """Return a cone about z, apex up, its centre of mass at the origin, h/4 above the base [m]."""
    return revolve([(0.0, -0.25 * height), (radius, -0.25 * height), (0.0, 0.75 * height)], sections)


def ball(sections: int = SECTIONS) -> Surface:
    """Return the ball of radius 1 m about the origin."""
    heights = np.linspace(-0.5 * math.pi, 0.5 * math.pi, sections // 2 + 1)
    profile = np.column_stack([np.cos(heights), np.sin(heights)])
    profile[[0, -1], 0] = 0.0  # cos(π/2) of the float nearest to π/2 is not
    return revolve(profile, sections)


def capsule(radius: float, length: float, sections: int = SECTIONS) -> Surface:
    """Return a cylinder of this length about z with half a ball on each end [m]."""
    heights = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 2 * (sections // 4) + 1)
    heights = np.insert(heights, len(heights) // 2, 0.0)  # the equator twice, half of the length up and down
    lift = np.where(np.arange(len(heights)) < len(heights) // 2, -0.5, 0.5) * length
    profile = np.column_stack([radius * np.cos(heights), radius * np.sin(heights) + lift])
    profile[[0, -1], 0] = 0.0
    return revolve(profile, sections)


def torus(major_radius: float, minor_radius: float, sections: int = SECTIONS) -> Surface:
    """Return a ring torus about z [m]."""
    angles = 4.0 * math.pi / sections * np.arange(sections // 2)
    profile = np.column_stack([major_radius + minor_radius * np.cos(angles), minor_radius * np.sin(angles)])
    return revolve(np.maximum(profile, [0.0, -np.inf]), sections, closed=True)


def bar(start: Real[ArrayLike, "3"], end: Real[ArrayLike, "3"], radius: float, sections: int = 12) -> Surface:
    """Return a round bar from one point (3,) to another [m]."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    straight = tube(radius, float(np.linalg.norm(end - start)), sections=sections)
    turn = rotation.shortest_between((0.0, 0.0, 1.0), end - start)
    return Surface(rotation.rotate(turn, straight.vertices) + 0.5 * (start + end), straight.faces)

"""The drawn shape of the body: its own surface, coarse enough, or a shape with the same inertia."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode.bodies._turned import tube
from polhode.bodies.surface import Surface, box_of_same_inertia, join_surfaces, weld_corners
from polhode.types import Array, ArrayLike, Float64, Real


class ShapeLimits(NamedTuple):
    """Numbers that decide which shape is drawn."""

    max_faces: int = 8000  # about 0.15 MB
    max_lean: float = 0.05  # rad from a principal axis to the centre of mass; a stem along that axis looks right
    max_moment: float = 1e12  # kg m², beyond which a body is celestial; the largest spacecraft have 1e8


LIMITS = ShapeLimits()


def body_shape(moments: Real[ArrayLike, "3"] | None, surface: Surface | None) -> tuple[Surface | None, str]:
    """Return the surface to draw and what it is, None where only the inertia ellipsoid, or nothing, can be drawn.

    Args:
        moments: (3,) along the axes that the surface is in, or None.
        surface: of the body, if known.
    """
    if surface is not None:
        whole = surface if surface.paint is not None else weld_corners(surface)  # colours may change where pieces meet
        small = whole.coarsened(LIMITS.max_faces)
        return small, "" if small is whole else "its mesh, coarsened"
    if moments is None:
        return None, "axes only, as nothing is known of the body's shape"
    if is_celestial(moments):
        return None, "ellipsoid of the same inertia"
    box = box_of_same_inertia(moments)
    return box, "inertia ellipsoid, as no solid body has these moments" if box is None else "box of the same inertia"


def is_celestial(moments: Real[ArrayLike, "3"]) -> bool:
    """Whether a body of unknown shape is so large that it is round, and not a box: a planet, a moon, an asteroid."""
    return bool(np.max(moments) > LIMITS.max_moment and np.all(semi_axes_squared(moments) > 0.0))


def semi_axes_squared(moments: Real[ArrayLike, "3"]) -> Float64[Array, "3"]:
    """Return the squared semi-axes (3,) of the homogeneous ellipsoid with these moments, times 2m/5."""
    values = np.asarray(moments, dtype=float)
    return 0.5 * values.sum() - values


def top_shape(
    moments: Real[ArrayLike, "3"], axis: Real[ArrayLike, "3"], surface: Surface | None
) -> tuple[Surface | None, str]:
    """Return a top's surface, or an elliptic disk on a massless stem with these moments about the pivot.

    With the disk's centre at h and its semi-axes a, b along two principal axes: I_k = m(a²+b²)/4 along the stem,
    I_i = m(b²/4 + h²), I_j = m(a²/4 + h²).

    Args:
        moments: (3,) about the pivot, which is the origin.
        axis: (3,) from pivot to centre of mass.
        surface: of the body, if known.
    """
    rim = 48  # corners of the disk's rim
    along = np.abs(np.asarray(axis, dtype=float))
    if surface is not None or np.sort(along)[1] > LIMITS.max_lean * along.max():
        return body_shape(moments, surface)
    k = int(along.argmax())
    i, j = (k + 1) % 3, (k + 2) % 3
    I = np.asarray(moments, dtype=float)  # noqa: E741
    height = 0.5 * (I[i] + I[j] - I[k])
    across = np.array([2.0 * (I[k] + I[j] - I[i]), 2.0 * (I[k] + I[i] - I[j])])  # a² along i, b² along j
    if height < 0 or (across < 0).any():
        return body_shape(moments, None)
    h, (a, b) = np.sqrt(height) * np.sign(np.asarray(axis)[k]), np.sqrt(across)
    size = max(abs(h), a, b)
    disk, stem = tube(1.0, 0.06 * size, sections=rim), tube(0.035 * size, abs(h), sections=rim)
    middle = np.array([0.0, 0.0, h])
    solid = join_surfaces([Surface(disk.vertices * [a, b, 1.0] + middle, disk.faces),
                   Surface(stem.vertices + 0.5 * middle, stem.faces)])  # fmt: skip
    order = np.empty(3, dtype=int)
    order[[i, j, k]] = 0, 1, 2
    return Surface(solid.vertices[:, order] / size, solid.faces), "disk on a stem, of the same inertia about the pivot"

"""The surface of a body, as triangles for drawing only."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.bodies._inertia import point_inertia, principal_axes
from polhode.motion.frame import BodyFrame
from polhode.types import Array, ArrayLike, Float64, Integer, Real

_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                   [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


@dataclass(frozen=True, eq=False)
class Paint:
    """How a page draws a surface, beyond the colours of its corners.

    Attributes:
        lines: on the surface: points (k, 3) [m] in its axes, a colour as 0xRRGGBB and a width [pixels] each.
        shiny: whether it looks like metal.
        cage: centre (3,) and radius [m] of a frame that leans with a top's axis and does not spin; None without one.
    """

    lines: tuple[tuple[Array, int, float], ...] = ()
    shiny: bool = False
    cage: tuple[Real[ArrayLike, "3"], float] | None = None


@dataclass(frozen=True, eq=False)
class Surface:
    """A triangle mesh to draw, which need not be closed.

    ``vertices, faces = surface`` unpacks it; ``Body.from_mesh(*surface, …)`` takes it where it is closed.

    Attributes:
        vertices: (n, 3) [m].
        faces: (m, 3) indices of corners, counterclockwise from outside.
        colors: (n,) of corners, as 0xRRGGBB, where parts have colours of their own; None elsewhere.
        paint: further features for a page; None without any.
    """

    vertices: Float64[Array, "n 3"]
    faces: Integer[Array, "m 3"]
    colors: Integer[Array, "n"] | None = None
    paint: Paint | None = None

    def __iter__(self) -> Iterator[Array]:
        return iter((self.vertices, self.faces))

    def along(self, frame: BodyFrame) -> Surface:
        """Return a surface of given axes along a trajectory's axes, from the point that the body turns about."""

        def moved(points: Real[ArrayLike, "... 3"]) -> Float64[Array, "... 3"]:
            return (np.asarray(points, dtype=float) - frame.origin) @ np.asarray(frame.axes)

        paint = self.paint
        if paint is not None:
            lines = tuple((moved(points), *drawn) for points, *drawn in paint.lines)
            paint = replace(paint, lines=lines, cage=paint.cage and (moved(paint.cage[0]), paint.cage[1]))
        return replace(self, vertices=moved(self.vertices), paint=paint)

    def coarsened(self, most: int) -> Surface:
        """Return a surface of at most ``most`` triangles, itself if it has no more: near corners are merged.

        Corners in one cell of a cubic grid become their mean, and triangles that this closes up are dropped. The
        grid is the finest of those tried that leaves few enough; thin walls may close. The result is for drawing, not
        for integration.

        Args:
            most: number of triangles, at least 12.

        Raises:
            InvalidInput: for fewer than 12 triangles, which show no shape.

        Source: Rossignac & Borrel, in *Modeling in Computer Graphics* (1993) 455.
        """
        finest = 1 << 20  # cells along an edge; their number still fits into 64 bits
        most = check.whole("most", most, 12, what="triangles", remedy="Fewer show no shape.")
        if len(self.faces) <= most:
            return self
        # fast-simplification's quadrics take a minute for a thin tube, and leave 50 % more or other shapes below 3 %
        coarse, fine = 1, 2  # cells along the longest edge
        best = _cluster_corners(self, coarse)
        while fine < finest and len((coarser := _cluster_corners(self, fine)).faces) <= most:
            coarse, fine, best = fine, 2 * fine, coarser
        while fine - coarse > 1:
            middle = (coarse + fine) // 2
            coarser = _cluster_corners(self, middle)
            coarse, fine, best = (middle, fine, coarser) if len(coarser.faces) <= most else (coarse, middle, best)
        return best


@known_numbers_only
def cuboid(edges: Real[ArrayLike, "3"]) -> Surface:
    """Return the block with these edges (3,) [m] along x, y, z about the origin."""
    return Surface(_CORNERS * np.asarray(edges, dtype=float), _FACES)


def join_surfaces(surfaces: Sequence[Surface]) -> Surface:
    """Return several surfaces as one; it has colours if all of them do."""
    starts = np.cumsum([0, *(len(surface.vertices) for surface in surfaces[:-1])])
    faces = [np.asarray(surface.faces) + start for surface, start in zip(surfaces, starts, strict=True)]
    colors = [surface.colors for surface in surfaces if surface.colors is not None]
    whole = Surface(np.vstack([surface.vertices for surface in surfaces]), np.vstack(faces))
    return replace(whole, colors=np.concatenate(colors)) if len(colors) == len(surfaces) else whole


def _cluster_corners(surface: Surface, cells: int) -> Surface:
    """Return the surface with the corners in each cell of a grid as one, ``cells`` of them along its longest edge."""
    vertices = np.asarray(surface.vertices, dtype=float)
    low = vertices.min(axis=0)
    size = np.ptp(vertices, axis=0).max() or 1.0  # all corners in one place
    place = np.minimum(((vertices - low) * (cells / size)).astype(np.int64), cells - 1)
    return _with_one_corner_each(surface, place @ np.array([cells * cells, cells, 1]))


def weld_corners(surface: Surface) -> Surface:
    """Return the surface with coincident corners merged."""
    return _with_one_corner_each(surface, places(surface.vertices))


def places(vertices: Real[ArrayLike, "n 3"]) -> Integer[np.ndarray, "n"]:
    """Return numbers (n,) of corners, equal where corners coincide to 1e-6 of the size."""
    cells = 10**6  # along the longest edge: corners closer than one are in one place
    vertices = np.asarray(vertices, dtype=float)
    size = np.ptp(vertices, axis=0).max() or 1.0
    grid = np.rint((vertices - vertices.min(axis=0)) * (cells / size)).astype(np.int64)
    return np.unique(grid @ (cells + 1) ** np.array([2, 1, 0]), return_inverse=True)[1]


def _with_one_corner_each(surface: Surface, numbers: Array) -> Surface:
    """Return the surface with corners (n,) of equal number merged at their mean, and each triangle once.

    A corner made of several has the colour of the first.
    """
    _, first, index = np.unique(numbers, return_index=True, return_inverse=True)
    count = np.bincount(index)
    means = np.column_stack([np.bincount(index, column) / count for column in np.asarray(surface.vertices, float).T])
    kept = index[np.asarray(surface.faces)]
    a, b, c = kept.T
    kept = kept[(a != b) & (b != c) & (c != a)]
    # each triangle from its smallest corner, for comparison
    rows = np.take_along_axis(kept, (kept.argmin(axis=1)[:, None] + np.arange(3)) % 3, axis=1)
    rows = rows[np.lexsort(rows.T[::-1])]  # np.unique of rows takes up to five times as long
    kept = rows[np.diff(rows, axis=0, prepend=-1).any(axis=1)]
    used = np.unique(kept)
    colors = None if surface.colors is None else np.asarray(surface.colors)[first][used]
    return Surface(means[used], np.searchsorted(used, kept), colors, surface.paint)


@known_numbers_only
def box_of_same_inertia(moments: Real[ArrayLike, "3"], mass: float | None = None) -> Surface | None:
    """Return the solid box with these moments about its centre: edge_i² = 6 (I_j + I_k − I_i)/m.

    Args:
        moments: (3,) principal moments [kg m²], along the box's edges.
        mass: [kg]; None for a box whose longest edge is 1 m, as moments alone have no size.

    Returns:
        The box along the principal axes, flat where a moment is the sum of the others; None for moments that no body
        has.
    """
    I = np.asarray(moments, dtype=float)  # noqa: E741
    # I_j + I_k − I_i = 2m ⟨x_i²⟩ = m e_i²/6
    squares = I.sum() - 2.0 * I
    if not (squares >= -4.0 * np.finfo(float).eps * I.sum()).all() or not squares.max() > 0:
        return None
    edges = np.sqrt(np.maximum(squares, 0.0))
    scale = 1.0 / edges.max() if mass is None else np.sqrt(6.0) / np.sqrt(mass)
    return cuboid(edges * scale)


@known_numbers_only
def box_in_place(frame: BodyFrame) -> Surface | None:
    """Return the box of the same inertia where the body is, in the given axes; None for moments that no body has.

    About a fixed point the moments are taken back to the centre of mass first, J = J_pivot − m (|d|² 1 − d dᵀ), which
    needs the mass: without it None.
    """
    moments, axes = np.asarray(frame.moments, dtype=float), np.asarray(frame.axes, dtype=float)
    center = np.asarray(frame.center_of_mass, dtype=float)
    if frame.pivot is not None:
        if frame.mass is None:
            return None
        offset = center - np.asarray(frame.pivot, dtype=float)
        moments, axes = principal_axes(axes * moments @ axes.T - frame.mass * point_inertia(offset))
    box = box_of_same_inertia(moments, frame.mass)
    return None if box is None else Surface(box.vertices @ axes.T + center, box.faces)

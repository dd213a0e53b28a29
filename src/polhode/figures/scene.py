"""Solids in a view from one side, shaded, and curves about them, dimmed where a solid hides them.

Solids are an image, computed pixel by pixel with a depth each, so that they may cut each other; lines, arrows and words
stay vectors. Source: Catmull, *A Subdivision Algorithm for Computer Display of Curved Surfaces* (1974), for the depth
buffer; Gouraud, IEEE Trans. Comput. C-20 (1971) 623, for the shading.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from polhode import rotation
from polhode.bodies.surface import Surface, places
from polhode.figures import style
from polhode.types import Array, ArrayLike, Bool, Float64, Integer, Real

CREASE = np.cos(np.radians(40.0))  # edges sharper than this stay sharp
LIGHT = np.array([-0.45, 0.62, 0.64])  # right, up, towards the viewer
UNSEEN = -np.inf


class Scene:
    """A window onto space.

    Args:
        axes: of matplotlib, empty.
        frame: (3, 3) rows right, up, towards the viewer.
        window: left, right, bottom, top, in the units of the solids.
        eye: distance of the eye from the origin for perspective, None for parallel rays.
    """

    def __init__(
        self,
        axes: Any,
        frame: Float64[Array, "3 3"],
        window: tuple[float, float, float, float],
        eye: float | None = None,
    ) -> None:
        pixels = 720  # of the image's longer side, each the mean of four
        left, right, bottom, top = window
        self.axes, self.frame, self.window, self.eye = axes, frame, window, eye
        self.size = max(right - left, top - bottom)
        self.pixel = self.size / (2 * pixels)
        shape = (2 * int(np.ceil((top - bottom) / self.pixel / 2)), 2 * int(np.ceil((right - left) / self.pixel / 2)))
        self.depth = np.full(shape, UNSEEN)
        self.colour = np.zeros((*shape, 4))
        self._covered = np.array([[*shape], [0, 0]])  # the first row and column with a solid, and those after the last
        axes.set_aspect("equal")
        axes.set_xlim(left, right)
        axes.set_ylim(bottom, top)
        axes.axis("off")

    def project(
        self, points: Real[ArrayLike, "*shape 3"]
    ) -> tuple[Float64[Array, "*shape"], Float64[Array, "*shape"], Float64[Array, "*shape"]]:
        """Return right and up on the page, and a height towards the viewer, linear along straight lines on the page."""
        x, y, depth = np.moveaxis(np.asarray(points) @ self.frame.T, -1, 0)
        if self.eye is None:
            return x, y, depth
        scale = self.eye / (self.eye - depth)
        return x * scale, y * scale, scale * self.eye

    def solid(self, surface: Surface, colour: str, ambient: float = 0.62) -> None:
        """Add a surface, shaded down to this brightness."""
        most_faces = 12_000  # drawn; finer surfaces are coarsened first
        at_once = 300_000  # pixels of the boxes round triangles, so that their arrays stay in the processor's cache
        shown = surface.coarsened(most_faces)
        vertices, faces = np.asarray(shown.vertices), np.asarray(shown.faces)
        x, y, depth = self.project(vertices)
        left, _, bottom, _ = self.window
        corners = np.stack([(x - left) / self.pixel, (y - bottom) / self.pixel, depth], axis=-1)[faces]
        shades = self._shades(corner_normals(vertices, faces), ambient)
        rgb = np.array([int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)])
        lowest, highest = self._pixels(corners)
        (ax, ay), (bx, by), (cx, cy) = np.moveaxis(corners[..., :2], 0, -1)
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        drawn = (lowest < highest).all(axis=-1) & (np.abs(area) > 1e-12)
        if _is_closed(vertices, faces):
            drawn &= area > 0.0  # the rest is on the far side, behind these
        if not drawn.any():
            return
        lowest, highest = lowest[drawn], highest[drawn]
        self._covered[0] = np.minimum(self._covered[0], lowest.min(axis=0)[::-1])
        self._covered[1] = np.maximum(self._covered[1], highest.max(axis=0)[::-1])
        pixels = np.cumsum((highest - lowest).prod(axis=-1))
        for part in np.split(np.arange(len(pixels)), np.flatnonzero(np.diff(pixels // at_once)) + 1):
            which = np.flatnonzero(drawn)[part]
            rows = _rows(corners[which], lowest[part], highest[part])
            self._fill(corners[which], area[which], shades[which], rgb, rows)

    def _pixels(self, corners: Array) -> tuple[Array, Array]:
        """Return the first pixels (m, 2) that triangles (m, 3, 3) may cover, and those after the last."""
        rows, columns = self.depth.shape
        low = np.maximum(np.floor(corners[..., :2].min(axis=1)), 0).astype(int)
        high = np.minimum(np.ceil(corners[..., :2].max(axis=1)) + 1, (columns, rows)).astype(int)
        return low, high

    def _shades(self, normals: Array, ambient: float) -> Array:
        """Return brightness from 0 to about 1.1 by normals (…, 3), either side lit."""
        facing = normals @ self.frame.T
        facing = facing * np.where(facing[..., 2:] < 0.0, -1.0, 1.0)
        lit = np.clip(facing @ (LIGHT / np.linalg.norm(LIGHT)), 0.0, 1.0)
        return ambient + (1.0 - ambient) * lit + 0.12 * lit**8

    def _fill(self, corners: np.ndarray, area: Array, shades: Array, colour: Array, rows: tuple[Array, ...]) -> None:
        """Draw triangles, given the rows of pixels that each may cover, those of each triangle together."""
        owner, y, start, end = rows
        count = end - start
        owner, y = np.repeat(owner, count), np.repeat(y, count)
        column = np.repeat(start - np.cumsum(count) + count, count) + np.arange(len(owner))
        x, height = column + 0.5, y + 0.5
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = np.moveaxis(corners, 0, -1)
        # how much of each corner is in a pixel: affine functions of its place
        second = np.stack([cy - ay, ax - cx, (cx - ax) * ay - (cy - ay) * ax]) / area
        third = np.stack([ay - by, bx - ax, (by - ay) * ax - (bx - ax) * ay]) / area
        part = lambda weights: weights[0][owner] * x + weights[1][owner] * height + weights[2][owner]  # noqa: E731
        second, third = part(second), part(third)
        depth = az[owner] + second * (bz - az)[owner] + third * (cz - az)[owner]
        before, place = self.depth.reshape(-1), y * self.depth.shape[1] + column
        inside = (second >= -1e-9) & (third >= -1e-9) & (second + third <= 1.0 + 1e-9)
        won = np.flatnonzero(inside & (depth > before[place]))
        if not len(won):
            return
        lowest = place[won].min()
        nearest = np.full(place[won].max() - lowest + 1, UNSEEN)
        np.maximum.at(nearest, place[won] - lowest, depth[won])
        # of triangles at equal depth the first wins, being written last
        won = won[depth[won] == nearest[place[won] - lowest]][::-1]
        shade, place, second, third = shades[owner[won]], place[won], second[won], third[won]
        bright = shade[:, 0] + second * (shade[:, 1] - shade[:, 0]) + third * (shade[:, 2] - shade[:, 0])
        before[place] = depth[won]
        image = self.colour.reshape(-1, 4)
        image[place, :3] = np.clip(bright[:, None] * colour, 0.0, 1.0)
        image[place, 3] = 1.0

    def finish(self, strength: float = 1.0, order: float = 0.0) -> None:
        """Put the image of the solids so far onto the page."""
        rows, columns = self.depth.shape
        image = np.ones((rows // 2, columns // 2, 4)) * [1.0, 1.0, 1.0, 0.0]
        (top, left), (bottom, right) = self._covered // 2 + [[0, 0], [1, 1]]
        four = self.colour.reshape(rows // 2, 2, columns // 2, 2, 4)[top:bottom, :, left:right]
        light = four[:, 0, :, 0] + four[:, 0, :, 1] + four[:, 1, :, 0] + four[:, 1, :, 1]
        cover = light[..., 3:]
        light = np.where(cover > 0, light[..., :3] / np.maximum(cover, 1.0), 1.0)
        image[top:bottom, left:right] = np.concatenate([light, strength * cover / 4.0], axis=-1)
        left, _, bottom, _ = self.window
        extent = (left, left + columns * self.pixel, bottom, bottom + rows * self.pixel)
        self.axes.imshow(image, origin="lower", extent=extent, zorder=order, interpolation="antialiased")
        self.axes.set_xlim(*self.window[:2])
        self.axes.set_ylim(*self.window[2:])

    def is_visible(self, points: Real[ArrayLike, "*shape 3"]) -> Bool[Array, "*shape"]:
        """Return whether points (…, 3) are hidden by no solid."""
        near = 0.012  # of the window: a curve so close before a surface lies on it
        x, y, depth = self.project(points)
        rows, columns = self.depth.shape
        j = np.clip(((x - self.window[0]) / self.pixel).astype(int), 0, columns - 1)
        i = np.clip(((y - self.window[2]) / self.pixel).astype(int), 0, rows - 1)
        return depth >= self.depth[i, j] - near * self.size

    def line(
        self,
        points: Real[ArrayLike, "time 3"],
        colour: str,
        width: float,
        *,
        form: Any = "-",
        dim: float = 0.25,
        over: float = 3.0,
    ) -> None:
        """Draw a curve (T, 3), dimmed where it is hidden."""
        x, y, _ = self.project(points)
        visible = self.is_visible(points)
        for front in (False, True):
            wide = visible == front
            wide = wide | np.roll(wide, 1) if front else wide
            self.axes.plot(np.where(wide, x, np.nan), np.where(wide, y, np.nan), color=colour, lw=width, ls=form,
                           alpha=1.0 if front else dim, zorder=over if front else over - 0.5,
                           solid_capstyle="round")

    def arrow(
        self,
        start: Real[ArrayLike, "3"],
        end: Real[ArrayLike, "3"],
        colour: str,
        name: str,
        *,
        side: Real[ArrayLike, "2"] = (0.0, 0.0),
    ) -> None:
        """Draw an arrow, always in front, with its name beyond its tip and this far (2,) [points] to the side."""
        (x0, x1), (y0, y1), _ = self.project(np.stack([start, end]))
        long = float(np.hypot(x1 - x0, y1 - y0))
        if long > 0.02 * self.size:
            self.axes.annotate("", (x1, y1), (x0, y0), zorder=6, arrowprops={
                "arrowstyle": "-|>,head_width=0.22,head_length=0.5", "color": colour, "lw": 1.5, "shrinkA": 0,
                "shrinkB": 0, "mutation_scale": 9, "capstyle": "round"})
        away = np.array([x1 - x0, y1 - y0]) / (long or 1.0)
        self.axes.annotate(name, (x1, y1), tuple(7.0 * away + np.asarray(side)), textcoords="offset points", zorder=7,
                           ha="center", va="center", color=colour, fontsize=style.FONT + 1, fontweight="bold",
                           bbox={"fc": "white", "ec": "none", "pad": 0.4, "alpha": 0.75})


def _rows(corners: Array, lowest: Array, highest: Array) -> tuple[Array, Array, Array, Array]:
    """Return (n,) rows of pixels that triangles (m, 3, 3) may cover: whose, which, the first pixel, after the last."""
    tall = highest[:, 1] - lowest[:, 1]
    owner = np.repeat(np.arange(len(tall)), tall)
    y = np.repeat(lowest[:, 1] - np.cumsum(tall) + tall, tall) + np.arange(len(owner))
    flat = corners[..., :2]
    # at the middle of the row, or the corner next to it
    height = np.clip(y + 0.5, flat[..., 1].min(axis=1)[owner], flat[..., 1].max(axis=1)[owner])
    least, most = np.full(len(owner), np.inf), np.full(len(owner), -np.inf)
    for k in range(3):
        begin, rise = flat[:, k], flat[:, (k + 1) % 3] - flat[:, k]
        with np.errstate(divide="ignore", invalid="ignore"):
            along = (height - begin[owner, 1]) / rise[owner, 1]
        crossed = (along > -1e-9) & (along < 1.0 + 1e-9)
        x = begin[owner, 0] + np.where(crossed, along, 0.0) * rise[owner, 0]
        least, most = np.where(crossed, np.minimum(least, x), least), np.where(crossed, np.maximum(most, x), most)
    crossed = least <= most
    owner, y, least, most = owner[crossed], y[crossed], least[crossed], most[crossed]
    # a pixel more on either side, for rounding
    start = np.maximum(np.floor(least).astype(int) - 1, lowest[owner, 0])
    end = np.minimum(np.ceil(most).astype(int) + 1, highest[owner, 0])
    return owner, y, start, np.maximum(end, start)


def corner_normals(vertices: Float64[Array, "n 3"], faces: Integer[Array, "m 3"]) -> Float64[Array, "m 3 3"]:
    """Return unit normals (m, 3, 3) at the corners of triangles, smooth but across creases."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    areas = np.cross(b - a, c - a)
    flat = areas / np.maximum(np.linalg.norm(areas, axis=-1, keepdims=True), 1e-300)
    place = places(vertices)[faces]
    normals = np.repeat(flat[:, None, :], 3, axis=1)
    order = np.argsort(place, axis=None, kind="stable")
    starts = np.flatnonzero(np.diff(place.reshape(-1)[order], prepend=-1))
    for group in np.split(order, starts[1:]):
        near = flat[group // 3]
        mean = (near @ near.T > CREASE) @ areas[group // 3]
        normals[group // 3, group % 3] = mean / np.maximum(np.linalg.norm(mean, axis=-1, keepdims=True), 1e-300)
    return normals


def _is_closed(vertices: Array, faces: Array) -> bool:
    """Return whether triangles bound a volume, outside out: every edge is used once each way."""
    place = places(vertices)[faces]
    edges = place[:, ((0, 1), (1, 2), (2, 0))].reshape(-1, 2)
    edges = edges[edges[:, 0] != edges[:, 1]]  # at a pole of a ball, corners of a triangle may meet
    count = int(place.max()) + 1
    there, back = (np.sort(edges @ weights) for weights in ((count, 1), (1, count)))
    if not (np.array_equal(there, back) and (np.diff(there) > 0).all()):
        return False
    a, b, c = ((vertices - vertices.mean(axis=0))[faces[:, k]] for k in range(3))
    return bool(np.sum(a * np.cross(b, c)) > 0.0)


def circle_about(
    axis: Real[ArrayLike, "3"], half_angle: float, length: float, count: int = 241
) -> Float64[Array, "{count} 3"]:
    """Return the rim (count, 3) of the cone about a unit axis with its apex at the origin, slant sides this long."""
    first = rotation.perpendicular(axis)
    turn = np.linspace(0.0, 2.0 * np.pi, count)[:, None]
    around = np.cos(turn) * first + np.sin(turn) * np.cross(axis, first)
    return length * (np.cos(half_angle) * np.asarray(axis) + np.sin(half_angle) * around)


def draw_cone(
    scene: Scene, axis: Real[ArrayLike, "3"], half_angle: float, length: float, colour: str, strength: float = 0.14
) -> None:
    """Draw a cone from the origin: its outline filled faintly, and its rim."""
    rim = circle_about(axis, half_angle, length)
    x, y, _ = scene.project(np.vstack([rim, np.zeros((1, 3))]))
    outline = convex_outline(np.stack([x, y], axis=-1))
    scene.axes.fill(*outline.T, color=colour, alpha=strength, lw=0, zorder=1.0)
    scene.axes.plot(*np.vstack([outline, outline[:1]]).T, color=colour, lw=0.5, alpha=0.6, zorder=1.1)
    scene.line(rim, colour, 0.9, over=2.5)


def convex_outline(points: Float64[Array, "m 2"]) -> Float64[Array, "n 2"]:
    """Return the corners (n, 2) of the convex hull of points (m, 2), counterclockwise."""
    points = np.unique(points, axis=0)

    def half(ordered: Array) -> list[Array]:
        kept: list[Array] = []
        for p in ordered:
            while len(kept) > 1:
                (ax, ay), (bx, by) = kept[-2], kept[-1]
                if (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) > 0:
                    break
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return np.array(half(points) + half(points[::-1]))

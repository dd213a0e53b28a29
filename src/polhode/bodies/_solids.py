"""Volumes and mean squares of homogeneous shapes, solid and as walls, which ``shapes`` and specs give a mass.

Every shape has its axis along z. Formulas give ⟨x²⟩, ⟨y²⟩, ⟨z²⟩ over the shape, about its centroid.

Source: Beer & Johnston, *Vector Mechanics for Engineers: Dynamics*, appendix B; hollow ones by subtraction.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Float64


class SolidLimits(NamedTuple):
    """Numbers beyond which a solid is refused."""

    smallest: float = 1e-60  # m or kg; no body is near
    largest: float = 1e60  # m or kg
    max_corners: int = 2000  # of an outline; its sides are compared in pairs


LIMITS = SolidLimits()


class Solid(NamedTuple):
    """A homogeneous shape.

    Attributes:
        volume: [m³]; None of shapes without thickness.
        second: (3, 3) mean of r rᵀ about the centroid [m²].
        centroid: (3,) [m]; the origin, but for an outline that is elsewhere.
    """

    volume: float | None
    second: Float64[Array, "3 3"]
    centroid: Float64[Array, "3"] = np.zeros(3)


def box(size: Any) -> Solid:
    """Return a block: ⟨x²⟩ = size_x²/12."""
    edges = lengths("size", size)
    return _solid(float(edges.prod()), edges**2 / 12.0)


def cylinder(radius: float, height: float, inner_radius: float = 0.0) -> Solid:
    """Return a cylinder or a tube: ⟨x²⟩ = (R² + r²)/4, ⟨z²⟩ = h²/12."""
    radius, height = positive(radius=radius, height=height)
    inner = _inner_radius(inner_radius, radius)
    across = (radius**2 + inner**2) / 4.0
    volume = math.pi * (radius - inner) * (radius + inner) * height
    return _solid(volume or None, (across, across, height**2 / 12.0))


def ellipsoid(semi_axes: Any) -> Solid:
    """Return an ellipsoid: ⟨x²⟩ = a²/5."""
    axes = lengths("semi_axes", semi_axes)
    return _solid(4.0 / 3.0 * math.pi * axes.prod(), axes**2 / 5.0)


def sphere(radius: float, inner_radius: float = 0.0) -> Solid:
    """Return a ball or a shell: ⟨x²⟩ = (R⁵ − r⁵)/(R³ − r³)/5."""
    (radius,) = positive(radius=radius)
    ratio = _inner_radius(inner_radius, radius) / radius
    # (1 − r⁵)/(1 − r³) without the common factor 1 − r, which cancels for thin shells
    third = 1 + ratio + ratio**2
    share = (third + ratio**3 + ratio**4) / third
    volume = 4.0 / 3.0 * math.pi * radius**3 * (1.0 - ratio) * third
    return _solid(volume or None, (radius**2 * share / 5.0,) * 3)


def cone(radius: float, height: float) -> Solid:
    """Return a cone, apex up, its base h/4 below the centroid: ⟨x²⟩ = 3R²/20, ⟨z²⟩ = 3h²/80."""
    radius, height = positive(radius=radius, height=height)
    volume = math.pi * radius**2 * height / 3.0
    return _solid(volume, (0.15 * radius**2, 0.15 * radius**2, 0.0375 * height**2))


def disk(radius: float, inner_radius: float = 0.0) -> Solid:
    """Return a flat disk or ring: ⟨x²⟩ = (R² + r²)/4."""
    (radius,) = positive(radius=radius)
    across = (radius**2 + _inner_radius(inner_radius, radius) ** 2) / 4.0
    return _solid(None, (across, across, 0.0))


def rod(length: float) -> Solid:
    """Return a thin rod: ⟨z²⟩ = length²/12."""
    (length,) = positive(length=length)
    return _solid(None, (0.0, 0.0, length**2 / 12.0))


def torus(major_radius: float, minor_radius: float) -> Solid:
    """Return a ring torus: ⟨x²⟩ = a²/2 + 3b²/8, ⟨z²⟩ = b²/4."""
    major, minor = positive(major_radius=major_radius, minor_radius=minor_radius)
    if minor > major:
        raise InvalidInput(f"`minor_radius` must not exceed `major_radius`; got {minor:g} m and {major:g} m.")
    # ⟨ρ²⟩ = a² + 3b²/4 about the axis, over a tube whose volume element grows as ρ; half of it across
    across = major**2 / 2.0 + 3.0 * minor**2 / 8.0
    return _solid(2.0 * math.pi**2 * major * minor**2, (across, across, minor**2 / 4.0))


def capsule(radius: float, length: float) -> Solid:
    """Return a cylinder of this length with half a ball on each end, of shares h : 4r/3 of the volume.

    ⟨x²⟩ = r²/4 and r²/5 over the two. A half ball at ±h/2 reaches outward by u with ⟨u⟩ = 3r/8 and ⟨u²⟩ = r²/5, so
    that ⟨(h/2 + u)²⟩ = h²/4 + 3hr/8 + r²/5.
    """
    radius, length = positive(radius=radius, length=length)
    balls = 4.0 * radius / 3.0
    middle, ends = length / (length + balls), balls / (length + balls)
    across = radius**2 * (middle / 4.0 + ends / 5.0)
    along = middle * length**2 / 12.0 + ends * (length**2 / 4.0 + 0.375 * length * radius + radius**2 / 5.0)
    return _solid(math.pi * radius**2 * (length + balls), (across, across, along))


def prism(height: float, sides: int | None = None, radius: float | None = None, outline: Any = None) -> Solid:
    """Return a prism on a regular polygon of circumradius R: ⟨x²⟩ = R²(2 + cos 2π/n)/12; or on any simple outline.

    Source: Green's theorem; Steger, *On the calculation of moments of polygons*, TU München FGBV-96-04 (1996).
    """
    (height,) = positive(height=height)
    if (outline is None) == (sides is None and radius is None):
        raise InvalidInput("a prism needs either `sides` and `radius` or an `outline`; got both or neither.")
    if outline is not None:
        return _on_outline(height, _corners(outline))
    if sides is None or radius is None:
        raise InvalidInput("a prism on a regular polygon needs both `sides` and `radius`.")
    (radius,) = positive(radius=radius)
    if isinstance(sides, bool) or int(sides) != sides or not 3 <= sides <= 10**6:
        raise InvalidInput(f"`sides` must be a whole number from 3 to 1000000; got {shown(sides)}.")
    turn = 2.0 * math.pi / sides
    across = radius**2 * (2.0 + math.cos(turn)) / 12.0
    return _solid(0.5 * sides * radius**2 * math.sin(turn) * height, (across, across, height**2 / 12.0))


def box_shell(size: Any, thickness: float = 0.0) -> Solid:
    """Return six walls whose middle planes form a box with these edges."""
    edges = lengths("size", size)
    scale = float(edges.max())
    outer = [[edge / scale, 2.0] for edge in edges]  # polynomials in half of the thickness
    volume = _product(*outer)
    seconds = [_product(volume, edge, edge) / 12.0 for edge in outer]
    return _wall(volume, seconds, scale, _thickness(thickness, float(edges.min())))


def cylinder_shell(radius: float, height: float, thickness: float = 0.0, open_ends: bool = False) -> Solid:
    """Return the wall of a cylinder, with its two ends unless they are open; measures to the middle of the wall."""
    radius, height = positive(radius=radius, height=height)
    scale = max(radius, height)
    r, h = [radius / scale, 1.0], [height / scale, 0.0 if open_ends else 2.0]
    volume = math.pi * _product(r, r, h)
    across, along = _product(volume, r, r) / 4.0, _product(volume, h, h) / 12.0
    most = 2.0 * radius if open_ends else min(2.0 * radius, height)
    return _wall(volume, [across, across, along], scale, _thickness(thickness, most))


def sphere_shell(radius: float, thickness: float = 0.0) -> Solid:
    """Return the wall of a hollow ball; the radius is that of its middle."""
    (radius,) = positive(radius=radius)
    r = [1.0, 1.0]
    volume = 4.0 / 3.0 * math.pi * _product(r, r, r)
    return _wall(volume, [_product(volume, r, r) / 5.0] * 3, radius, _thickness(thickness, 2.0 * radius))


def _wall(volume: Array, seconds: list[Array], scale: float, thickness: float) -> Solid:
    """Return the wall between a shape grown and shrunk by half of the thickness s.

    Volume and ∫ x² dV are polynomials F(s) of the shape; F(s) − F(−s) is twice their odd part, a sum of positive terms
    in which nothing cancels. Over s it is that of a surface in the limit of no thickness.
    """
    s = 0.5 * thickness / scale

    def odd(polynomial: Array) -> float:
        terms = polynomial[1::2]
        return float(terms @ s ** (2.0 * np.arange(len(terms))))

    whole = odd(volume)
    squares = [scale**2 * (odd(second) / whole) for second in seconds]
    return _solid(2.0 * s * whole * scale**3 or None, squares)


def _product(*factors: Any) -> Array:
    product = np.ones(1)
    for factor in factors:
        product = np.convolve(product, factor)
    return product


def _thickness(thickness: Any, most: float) -> float:
    return check.number("thickness", thickness, "m", least=0, most=most, remedy="There the wall fills the shape.")


def _corners(outline: Any) -> Float64[Array, "n 2"]:
    corners = check.array("outline", outline, ("n", 2), "m", remedy="Give corners [x, y] in order.")
    if not 3 <= len(corners) <= LIMITS.max_corners:
        check.refuse("outline", f"3 to {LIMITS.max_corners} corners", len(corners))
    if not (np.abs(corners) < LIMITS.largest).all():
        check.refuse("outline", "within 1e60 m", float(np.abs(corners).max()), "Check its unit.")
    return corners


def _on_outline(height: float, corners: Float64[Array, "n 2"]) -> Solid:
    origin = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
    scale = float(np.ptp(corners, axis=0).max())
    p = (corners - origin) / (scale or 1.0)
    if (crossed := _find_crossed_sides(p)) is not None:
        one, other = (shown(corners[k].tolist()) for k in crossed)
        raise InvalidInput(f"`outline` must not cross or touch itself; its sides from {one} and {other} m do.")
    centroid, _, area = _polygon(p)
    _, second, _ = _polygon(p - centroid)
    whole = np.zeros((3, 3))
    whole[:2, :2] = scale**2 * second
    whole[2, 2] = height**2 / 12.0
    return Solid(abs(area) * scale**2 * height, whole, np.append(scale * centroid + origin, 0.0))


def _polygon(p: Array) -> tuple[Array, Array, float]:
    """Return centroid (2,), mean of r rᵀ (2, 2) and signed area of a polygon with corners (n, 2)."""
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]
    area = 0.5 * cross.sum()
    centroid = cross @ (p + q) / (6.0 * area)
    pairs = np.einsum("n,ni,nj->ij", cross, p + q, p + q) + np.einsum("n,ni,nj->ij", cross, p, p)
    second = (pairs + np.einsum("n,ni,nj->ij", cross, q, q)) / (24.0 * area)
    return centroid, second, float(area)


def _find_crossed_sides(p: Array) -> tuple[int, int] | None:
    """Return the numbers of two sides that meet elsewhere than at a corner they share, None if there are none."""
    n, q = len(p), np.roll(p, -1, axis=0)

    def side(a: Array, b: Array, c: Array) -> Array:
        turn = (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])
        return np.where(np.abs(turn) <= 1e-14, 0.0, np.sign(turn))  # of the extent, squared

    if (flat := np.flatnonzero((p == q).all(axis=1))).size:
        return int(flat[0]), int((flat[0] + 1) % n)
    # a corner at which the outline runs straight back covers no area, and is a mistake
    back = (side(p, q, np.roll(q, -1, axis=0)) == 0.0) & (((q - p) * (np.roll(q, -1, axis=0) - q)).sum(axis=1) < 0.0)
    if back.any():
        k = int(np.flatnonzero(back)[0])
        return k, (k + 1) % n
    i, j = np.triu_indices(n, 2)
    apart = ~((i == 0) & (j == n - 1))
    i, j = i[apart], j[apart]
    a, b, c, d = p[i], q[i], p[j], q[j]
    low, high = np.maximum(np.minimum(a, b), np.minimum(c, d)), np.minimum(np.maximum(a, b), np.maximum(c, d))
    boxes = (low <= high).all(axis=1)
    straddle = (side(a, b, c) * side(a, b, d) <= 0.0) & (side(c, d, a) * side(c, d, b) <= 0.0)
    hit = np.flatnonzero(boxes & straddle)
    return (int(i[hit[0]]), int(j[hit[0]])) if hit.size else None


def _solid(volume: Any, squares: Any) -> Solid:
    return Solid(None if volume is None else float(volume), np.diag(np.asarray(squares, dtype=float)))


def positive(**named: Any) -> list[float]:
    """Return single numbers, each positive and finite."""
    rule = "positive and finite, within 1e±60"
    return [check.number(name, value, above=LIMITS.smallest, below=LIMITS.largest, rule=rule, remedy="Check its unit.")
            for name, value in named.items()]  # fmt: skip


def lengths(name: str, value: Any) -> Float64[Array, "3"]:
    """Return three lengths, each positive and finite."""
    array = check.array(name, value, (3,), "m", above=0)
    positive(**{f"{name}[{k}]": x for k, x in enumerate(array.tolist())})
    return array


def _inner_radius(inner: Any, outer: float) -> float:
    return check.number("inner_radius", inner, "m", least=0, most=outer, rule=f"from 0 to the radius {outer:g}")

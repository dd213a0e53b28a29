"""Looks of a spec's body on a page: painted so that people recognise it, with the size and place of the body.

A look changes pictures only. Moments, and with them the motion, are those of the body as it is given.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib import resources

import numpy as np

from polhode.bodies.surface import Paint, Surface, cuboid, join_surfaces
from polhode.spec.assembly import turn_of
from polhode.spec.models import BodyTable, PartTable
from polhode.spec.surfaces import color_surface, surface_of_part
from polhode.types import Array, Bool, Float64

OCEAN, LAND = 0x5B8DB8, 0x8FAE7B
WHITE = 0xE9ECEF
BORDER = 0.03  # of a book's edges: by which its cover projects
LIFT = 0.004  # of the size: the distance of paint above a face


def paint_body(table: BodyTable, surface: Surface | None) -> Surface | None:
    """Return the surface that a page draws: painted if the table names a look, else as it is.

    Args:
        table: of the body; its look, if any, fits its source.
        surface: of the body along its given axes.
    """
    return surface if table.look is None else LOOKS[table.look](table, surface)


def _book(table: BodyTable, surface: Surface | None) -> Surface:
    """Return covers, a spine and pages; the spine is on the first of the two larger axes' sides."""
    paper, covers, title, leaf = 0xF3ECD8, 0x8C2F39, 0xE8C872, 0xB9AD8F
    edges = np.asarray(_parts(table)[0].size)
    thin, wide, long = (int(k) for k in np.argsort(edges))
    cover = 0.08 * edges[thin]
    pieces = []
    inner = edges * (1.0 - BORDER)
    inner[thin] = edges[thin] - 2.0 * cover
    shift = np.zeros(3)
    shift[wide] = -0.25 * BORDER * edges[wide]
    pieces.append(_block(inner, paper, shift))
    for side in (1.0, -1.0):
        pieces.append(_block(_with(edges, thin, cover), covers, _unit(thin) * side * 0.5 * (edges[thin] - cover)))
    pieces.append(_block(_with(edges, wide, cover), covers, -_unit(wide) * 0.5 * (edges[wide] - cover)))
    label = _with(_with(_with(edges, thin, 0.0), wide, 0.6 * edges[wide]), long, 0.16 * edges[long])
    place = _unit(thin) * 0.5 * edges[thin] + _unit(long) * 0.2 * edges[long]
    pieces.append(_plate(label, title, place, thin, edges))
    lines = [(_edge_line(edges, thin, wide, long, share), leaf, 1.0) for share in (-0.5, -0.25, 0.0, 0.25, 0.5)]
    return _paint(pieces, table, lines)


def _edge_line(edges: Array, thin: int, wide: int, long: int, share: float) -> Float64[Array, "2 3"]:
    """Return a line along the pages, on the side away from the spine."""
    ends = np.zeros((2, 3))
    ends[:, thin] = 0.8 * share * edges[thin]
    ends[:, wide] = 0.5 * edges[wide] * (1.0 - 1.3 * BORDER)
    ends[:, long] = [-0.48 * edges[long], 0.48 * edges[long]]
    return ends


def _phone(table: BodyTable, surface: Surface | None) -> Surface:
    """Return a case with a screen on its positive thin side, and cameras near its upper end on the other."""
    case, glass, lens_color, speaker_color = 0x2B2E33, 0x0F5D8C, 0x101215, 0x8C9299
    edges = np.asarray(_parts(table)[0].size)
    thin, wide, long = (int(k) for k in np.argsort(edges))
    front, back = 0.5 * edges[thin] * _unit(thin), -0.5 * edges[thin] * _unit(thin)
    screen = _with(_with(_with(edges, thin, 0.0), wide, 0.92 * edges[wide]), long, 0.88 * edges[long])
    pieces = [_block(edges, case), _plate(screen, glass, front, thin, edges)]
    speaker = _with(_with(_with(edges, thin, 0.0), wide, 0.2 * edges[wide]), long, 0.012 * edges[long])
    pieces.append(_plate(speaker, speaker_color, front + 0.465 * edges[long] * _unit(long), thin, edges))
    size = 0.18 * edges[wide]
    for k in range(2):
        place = back + (0.42 - 0.1 * k) * edges[long] * _unit(long) + 0.3 * edges[wide] * _unit(wide)
        for share, color, depth in ((1.0, speaker_color, 2.0), (0.7, lens_color, 4.0)):
            square = _with(_with(np.zeros(3), wide, share * size), long, share * size)
            lens = _with(square, thin, depth * LIFT * edges[long])
            pieces.append(_block(lens, color, place))
    return _paint(pieces, table)


def _earth(table: BodyTable, surface: Surface | None) -> Surface:
    """Return an ellipsoid of the body's moments with land and sea, and lines of latitude and longitude.

    The axis of the largest moment is the pole, and the prime meridian goes through the axis after it.

    Source: Natural Earth (public domain), land at 1:110 million, simplified to 0.6°.
    """
    shore = 0x2F3B2F
    rows, columns = 43, 88  # of the Earth's triangles: two less than 8000 in all, which a page draws without coarsening
    moments = np.asarray(table.moments, dtype=float)
    pole = int(moments.argmax())
    order = [(pole + 1) % 3, (pole + 2) % 3, pole]
    axes = np.sqrt(np.maximum(0.5 * moments.sum() - moments, 0.0))[order]
    axes /= axes.max()

    def place(longitude: Array, latitude: Array, lift: float = 0.0) -> Array:
        flat = np.cos(latitude)
        local = np.stack([flat * np.cos(longitude), flat * np.sin(longitude), np.sin(latitude)], axis=-1)
        point = np.empty_like(local)
        point[..., order] = (1.0 + lift) * axes * local
        return point

    heights, turns = np.linspace(-0.5, 0.5, rows + 1) * math.pi, np.linspace(-1.0, 1.0, columns + 1) * math.pi
    down, around = np.meshgrid(heights, turns, indexing="ij")
    index = np.arange(down.size).reshape(down.shape)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    faces = np.vstack([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    shores = [np.radians(0.1 * np.asarray(ring, dtype=float)) for ring in coastlines()]
    land = _is_inside(around.ravel(), down.ravel(), shores)
    globe = Surface(place(around, down).reshape(-1, 3), faces, np.where(land, LAND, OCEAN))
    lines = [(place(*ring.T, lift=LIFT), shore, 1.0) for ring in shores]
    turn, half = np.linspace(-math.pi, math.pi, 97), np.linspace(-0.5 * math.pi, 0.5 * math.pi, 49)
    for latitude in np.radians([-60.0, -30.0, 0.0, 30.0, 60.0]):
        lines.append((place(turn, np.full_like(turn, latitude), LIFT), *_drawn(latitude)))
    for longitude in np.radians(np.arange(-180.0, 180.0, 30.0)):
        lines.append((place(np.full_like(half, longitude), half, LIFT), *_drawn(longitude)))
    return replace(globe, paint=Paint(tuple(lines)))


def _drawn(angle: float) -> tuple[int, float]:
    """Return colour and width of a line of the graticule: the equator and the prime meridian stand out."""
    named, graticule = 0xC23B22, 0xC9D6E0
    return (named, 2.0) if angle == 0.0 else (graticule, 1.0)


def coastlines() -> list[list[list[int]]]:
    """Return the shores of continents and larger islands: rings of longitude and latitude in tenths of a degree."""
    return json.loads((resources.files("polhode.spec") / "coastlines.json").read_text("utf-8"))


def _is_inside(x: Array, y: Array, rings: Sequence[Array]) -> Bool[Array, "n"]:
    """Whether points lie inside an odd number of rings (k, 2): a ray to the east crosses them so often."""
    crossed = np.zeros(len(x), dtype=int)
    for ring in rings:
        (x0, y0), (x1, y1) = ring.T, np.roll(ring, -1, axis=0).T
        spans = (y0 > y[:, None]) != (y1 > y[:, None])
        with np.errstate(divide="ignore", invalid="ignore"):
            meets = x0 + (y[:, None] - y0) * (x1 - x0) / (y1 - y0) > x[:, None]
        crossed += np.count_nonzero(spans & meets, axis=1)
    return crossed % 2 == 1


def _metal(table: BodyTable, surface: Surface | None) -> Surface:
    """Return the surface as polished metal."""
    aluminium = 0xDCE3EA
    assert surface is not None, "the rules let metal go with a mesh or parts only"
    return replace(color_surface(surface, aluminium), paint=Paint(shiny=True))


def _gyroscope(table: BodyTable, surface: Surface | None) -> Surface:
    """Return a brass wheel with a red weight on a steel axle, in a frame of two rings that lean with it."""
    brass, steel, rivet = 0xC9A24B, 0xA9B2BC, 0xC23B22
    parts = _parts(table)
    colors = [rivet if part.shape == "box" else steel if _is_slender(part) else brass for part in parts]
    pieces = [color_surface(_drawn_part(part), color) for part, color in zip(parts, colors, strict=True)]
    widest = max((part.radius or 0.0) for part in parts)
    wheel = max((part for part in parts if part.shape in ("cylinder", "disk")), key=lambda part: part.radius or 0.0)
    return replace(_paint(pieces, None), paint=Paint(shiny=True, cage=(tuple(wheel.at), 1.12 * widest)))


def _satellite(table: BodyTable, surface: Surface | None) -> Surface:
    """Return the heaviest cylinder clad in solar cells, other cylinders white, and boxes in gold foil."""
    cells, seam, foil = 0x20386B, 0xC9A24B, 0xC9A24B
    parts = _parts(table)
    clad = max((part for part in parts if part.shape == "cylinder"), key=lambda part: part.mass or 0.0, default=None)
    pieces, lines = [], []
    for part in parts:
        color = cells if part is clad else foil if part.shape == "box" else WHITE
        pieces.append(color_surface(_drawn_part(part), color))
        if part is clad:
            lines += [(line, seam, 1.0) for line in _grid_on(part)]
    return _paint(pieces, None, lines)


def _rocket(table: BodyTable, surface: Surface | None) -> Surface:
    """Return a white cylinder with dark stripes along it, and four whip antennas about its middle."""
    stripe, whip = 0x2B2E33, 0x7A828A
    count = 4  # antennas of Explorer 1
    (part,) = _parts(table)
    radius, half = part.radius or 0.0, 0.5 * (part.height or 0.0)
    hull = _undo_placement(part, _drawn_part(part))
    angle = np.arctan2(hull.vertices[:, 1], hull.vertices[:, 0])
    striped = (np.floor(angle / (math.pi / 4.0) + 1e-9).astype(int) % 2 == 0) & (hull.vertices[:, 2] > 0.0)
    painted = Surface(hull.vertices, hull.faces, np.where(striped, stripe, WHITE))
    ends = [2.0 * math.pi * k / count for k in range(count)]
    reach = np.array([radius, 0.5 * half])  # from the hull to the end of a whip
    whips = [(np.outer(reach, [math.cos(a), math.sin(a), 0.0]), whip, 2.0) for a in ends]
    return _place(replace(painted, paint=Paint(tuple(whips))), part)


def _top(table: BodyTable, surface: Surface | None) -> Surface:
    """Return a wooden top with sectors of two shades, which show its spin."""
    wood, band = 0xC79A5B, 0x8C4A2F
    pieces = []
    for part in _parts(table):
        local = _undo_placement(part, _drawn_part(part))
        angle = np.arctan2(local.vertices[:, 1], local.vertices[:, 0])
        sector = np.floor(angle / (math.pi / 3.0) + 1e-9).astype(int)
        shade = (sector % 2 == 0) & (np.hypot(*local.vertices.T[:2]) > 0.0)
        pieces.append(_place(Surface(local.vertices, local.faces, np.where(shade, band, wood)), part))
    return _paint(pieces, None)


def _drawn_part(part: PartTable) -> Surface:
    drawn = surface_of_part(part)
    assert drawn is not None, "the rules let looks that paint parts go with shapes only"
    return drawn


def _parts(table: BodyTable) -> list[PartTable]:
    assert table.part is not None, "the rules let this look go with parts only"
    return table.part


def _is_slender(part: PartTable) -> bool:
    return part.shape == "rod" or (part.height or 0.0) > 4.0 * (part.radius or math.inf)


def _undo_placement(part: PartTable, surface: Surface) -> Surface:
    """Return a part's surface about its own place and axis z."""
    return Surface((np.asarray(surface.vertices) - np.asarray(part.at)) @ _turn(part), surface.faces)


def _place(surface: Surface, part: PartTable) -> Surface:
    """Return a surface about the origin and the axis z where a part is."""
    turn, place = _turn(part), np.asarray(part.at)
    paint = surface.paint
    if paint is not None:
        paint = replace(paint, lines=tuple((points @ turn.T + place, *drawn) for points, *drawn in paint.lines))
    return replace(surface, vertices=surface.vertices @ turn.T + place, paint=paint)


def _turn(part: PartTable) -> Float64[Array, "3 3"]:
    return turn_of(part)


def _grid_on(part: PartTable) -> list[Float64[Array, "k 3"]]:
    """Return the seams of solar cells round a cylinder, along its given axes."""
    sectors = 16  # seams of solar cells round a drum
    radius, height = (1.0 + LIFT) * (part.radius or 0.0), part.height or 0.0
    turn = np.linspace(0.0, 2.0 * math.pi, 65)
    rings = [np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full_like(turn, z)], axis=1)
             for z in height * np.linspace(-0.5, 0.5, 6)]
    ribs = [np.array([[radius * math.cos(a), radius * math.sin(a), z] for z in (-0.5 * height, 0.5 * height)])
            for a in 2.0 * math.pi / sectors * np.arange(sectors)]
    return [line @ _turn(part).T + np.asarray(part.at) for line in [*rings, *ribs]]


def _block(edges: Array, color: int, place: Array | float = 0.0) -> Surface:
    block = cuboid(edges)
    return color_surface(Surface(block.vertices + place, block.faces), color)


def _plate(edges: Array, color: int, place: Array, thin: int, size: Array) -> Surface:
    """Return a plate on a face, thick enough to be drawn apart from it."""
    return _block(_with(edges, thin, 2.0 * LIFT * float(np.max(size))), color, place)


def _with(values: Array, k: int, value: float) -> Float64[Array, "3"]:
    changed = np.array(values, dtype=float)
    changed[k] = value
    return changed


def _unit(k: int) -> Float64[Array, "3"]:
    return np.eye(3)[k]


def _paint(
    pieces: Sequence[Surface], table: BodyTable | None, lines: Sequence[tuple[Array, int, float]] = ()
) -> Surface:
    """Return pieces as one painted surface; those of a body of one box, drawn about its middle, where that box is."""
    whole = replace(join_surfaces(pieces), paint=Paint(tuple(lines)))
    return whole if table is None else _place(whole, _parts(table)[0])


LOOKS: dict[str, Callable[[BodyTable, Surface | None], Surface]] = {
    "book": _book, "phone": _phone, "earth": _earth, "metal": _metal,
    "gyroscope": _gyroscope, "satellite": _satellite, "rocket": _rocket, "top": _top,
}  # fmt: skip
"""The painters of the looks that a spec can name."""

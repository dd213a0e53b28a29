"""Write t_handle.stl: a T cut from a 10 mm aluminium plate, crossbar 80 mm and stem 40 mm, as one closed surface.

Run it as ``python examples/build_t_handle.py``. The outline is extruded; both end caps are fanned from the corners
where crossbar and stem meet, so that no triangle leaves the T.
"""

from pathlib import Path

THICKNESS = 10.0
# counterclockwise, in mm; the crossbar's centre is the origin, the stem points along −y
OUTLINE = [(-40, 5), (-40, -5), (-5, -5), (-5, -45), (5, -45), (5, -5), (40, -5), (40, 5)]
CAP = [(0, 1, 2), (0, 2, 5), (0, 5, 7), (5, 6, 7), (2, 3, 4), (2, 4, 5)]


def triangles() -> list[tuple[tuple[float, float, float], ...]]:
    """Return the surface's triangles, counterclockwise seen from outside."""
    low = [(float(x), float(y), -THICKNESS / 2) for x, y in OUTLINE]
    high = [(x, y, THICKNESS / 2) for x, y, _ in low]
    surface = [(high[a], high[b], high[c]) for a, b, c in CAP]
    surface += [(low[a], low[c], low[b]) for a, b, c in CAP]
    for k in range(len(OUTLINE)):
        n = (k + 1) % len(OUTLINE)
        surface += [(low[k], low[n], high[n]), (low[k], high[n], high[k])]
    return surface


def main() -> None:
    """Write the file next to this script."""
    lines = ["solid t_handle"]
    for corners in triangles():
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x:g} {y:g} {z:g}" for x, y, z in corners]
        lines += ["endloop", "endfacet"]
    lines.append("endsolid t_handle")
    Path(__file__).with_name("t_handle.stl").write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()

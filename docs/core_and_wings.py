"""Core, application and wings in one picture, from the import contracts: ``python docs/core_and_wings.py``.

It draws docs/images/core_and_wings.svg, which docs/data_flow.md shows; a test compares it with the present contracts. A
page shows it as an image, which knows only whether the reader's system is dark, not what the page was switched to, so
the picture has a ground of its own.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[1]
PICTURE = ROOT / "docs" / "images" / "core_and_wings.svg"
TITLE = "Core, application and wings of polhode: who may import whom"

Layers = list[list[str]]


class Group(NamedTuple):
    """Rooms of one kind, by layers from above, and what the picture says of them."""

    name: str
    words: Sequence[str]
    layers: Layers


WINGS = "Wings", ("one subject each; import", "application and core,", "but no other wing")
APPLICATION = "Application", ("specs, files, reports,", "figures, the command;", "imports the core,", "but no wing")
CORE = "Core", ("bodies, brackets,", "systems, motions;", "imports neither", "application nor wing")

# Lengths are in pixels at full size.
MARGIN, PADDING, BETWEEN = 20, 14, 34  # of the picture, inside a group, from group to group
HEADING, HEIGHT, GAP, LINE = 180, 26, 6, 18  # width beside the rooms, height of a room, gap, line of text
ROOMS, SIDE = 500, 44  # width of all rooms of a layer, and of the space for the arrow that passes the application
LETTER = 8.0  # the widest advance of the monospaced fonts named below, at 13 px
NOTE = "In application and core a room imports only from rows below its own; rooms of one row do not import each other."

STYLE = """
.name { font: 600 17px system-ui, sans-serif } .words { font: 13px system-ui, sans-serif }
.note { font: 12px system-ui, sans-serif }
.room { font: 13px ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; text-anchor: middle }
.end { text-anchor: end } .arrow { stroke-width: 1.6; fill: none }
.ground { fill: #ffffff; stroke: #d5dbe1 } .box { fill: #ffffff }
.name, .room { fill: #1b232b } .words, .note, .tip { fill: #4a5560 } .arrow { stroke: #4a5560 }
.panel.wings { fill: #f6ecd9 } .panel.application { fill: #e3edf8 } .panel.core { fill: #e2f1e7 }
.box.wings { stroke: #b98a2f } .box.application { stroke: #4f7fb5 } .box.core { stroke: #4a946a }
@media (prefers-color-scheme: dark) {
.ground { fill: #15191e; stroke: #38424c } .box { fill: #15191e }
.name, .room { fill: #eef2f5 } .words, .note, .tip { fill: #b4bfca } .arrow { stroke: #b4bfca }
.panel.wings { fill: #3a301c } .panel.application { fill: #1d2f43 } .panel.core { fill: #1c3527 }
}
"""


def read_contracts(path: Path = ROOT / "pyproject.toml") -> list[dict[str, Any]]:
    """Return the import contracts of the settings."""
    return tomllib.loads(path.read_text("utf-8"))["tool"]["importlinter"]["contracts"]


def groups_of(contracts: Sequence[Mapping[str, Any]]) -> list[Group]:
    """Return wings, application and core with their layers.

    Raises:
        ValueError: a listed room is in no layer, or a group lies not whole above the next.
    """
    (layered,), (listed,) = ([one for one in contracts if one["type"] == kind] for kind in ("layers", "wings"))
    layers = [[room.strip() for room in layer.split("|")] for layer in layered["layers"]]
    rooms = {room for layer in layers for room in layer}
    if strange := {room for room in rooms if not room.isidentifier()}:
        raise ValueError(f"rooms of a layer are names with | between them; got {sorted(strange)}")
    wings, application = set(listed["wings"]), set(listed["application"]) - set(layered["exhaustive_ignores"])
    if lost := (wings | application) - rooms:
        raise ValueError(f"each room of the contract of wings needs a layer; {sorted(lost)} have none")
    order = [{0 if room in wings else 1 if room in application else 2 for room in layer} for layer in layers]
    ranks = [next(iter(ranks)) for ranks in order if len(ranks) == 1]
    if len(ranks) < len(layers) or ranks != sorted(ranks):
        raise ValueError("layers of wings must be above those of the application, and these above those of the core")
    return [Group(*said, [layer for layer, rank in zip(layers, ranks, strict=True) if rank == k])
            for k, said in enumerate((WINGS, APPLICATION, CORE))]  # fmt: skip


def rows_of(layer: Sequence[str]) -> Layers:
    """Return a layer in as few rows as its longest name allows, of nearly equal length."""
    width = max(map(len, layer)) * LETTER + 2 * GAP
    most = max(1, int((ROOMS + GAP) / (width + GAP)))
    rows = -(-len(layer) // most)
    ends = [len(layer) * k // rows for k in range(rows + 1)]
    return [list(layer[start:end]) for start, end in pairwise(ends)]


def height_of(group: Group) -> int:
    """Return the height of a group: of its rooms, or of its words if these need more."""
    rows = sum(len(rows_of(layer)) for layer in group.layers)
    return 2 * PADDING + max(rows * (HEIGHT + GAP) - GAP, (1 + len(group.words)) * LINE)


def group_lines(group: Group, top: int) -> list[str]:
    """Return a group's elements, the upper edge at a given height."""
    look, left = group.name.lower(), MARGIN + PADDING + HEADING
    width, height = HEADING + ROOMS + 2 * PADDING, height_of(group)
    drawn = [f'<rect class="panel {look}" x="{MARGIN}" y="{top}" width="{width}" height="{height}" rx="8"/>',
             f'<text class="name" x="{MARGIN + PADDING}" y="{top + PADDING + 15}">{group.name}</text>']  # fmt: skip
    drawn += [f'<text class="words" x="{MARGIN + PADDING}" y="{top + PADDING + 19 + k * LINE}">{words}</text>'
              for k, words in enumerate(group.words, 1)]  # fmt: skip
    rows = [row for layer in group.layers for row in rows_of(layer)]
    for k, row in enumerate(rows):
        y, width = top + PADDING + k * (HEIGHT + GAP), (ROOMS + GAP) / len(row) - GAP
        for n, room in enumerate(row):
            x = left + n * (width + GAP)
            drawn += [f'<rect class="box {look}" x="{x:.1f}" y="{y}" width="{width:.1f}" height="{HEIGHT}" rx="4"/>',
                      f'<text class="room" x="{x + width / 2:.1f}" y="{y + 18}">{room}</text>']  # fmt: skip
    return drawn


def arrow_lines(path: str, x: float, y: float, towards: str) -> list[str]:
    """Return a line along a path with its tip at a point, downwards or to the left."""
    tip = "l-5 -9 h10 z" if towards == "down" else "l9 -5 v10 z"
    return [f'<path class="arrow" d="{path}"/>', f'<path class="tip" d="M{x} {y} {tip}"/>']


def description_of(groups: Sequence[Group]) -> str:
    """Return the picture in words, for those who hear it."""
    said = ["Imports go downwards only: from wings to application and core, from the application to the core.", NOTE]
    for group in groups:
        order = ", rows from above" if len(group.layers) > 1 else ""
        said.append(f"{group.name}{order}: {'; '.join(', '.join(layer) for layer in group.layers)}.")
    return " ".join(said)


def draw(contracts: Sequence[Mapping[str, Any]]) -> str:
    """Return the picture of contracts as SVG."""
    groups = groups_of(contracts)
    heights = [height_of(group) for group in groups]
    tops = [MARGIN + sum(heights[:k]) + k * BETWEEN for k in range(len(groups))]
    right, bottom = MARGIN + HEADING + ROOMS + 2 * PADDING, tops[-1] + heights[-1]
    width, height, middle = right + SIDE, bottom + BETWEEN + MARGIN, MARGIN + PADDING + HEADING + ROOMS // 2
    drawn = [line for group, top in zip(groups, tops, strict=True) for line in group_lines(group, top)]
    for k in (1, 2):
        drawn += arrow_lines(f"M{middle} {tops[k] - BETWEEN} V{tops[k] - 8}", middle, tops[k] - 1, "down")
        drawn.append(f'<text class="words" x="{middle + 12}" y="{tops[k] - BETWEEN // 2 + 4}">imports</text>')
    start, end, side = tops[0] + heights[0] // 2, tops[2] + PADDING + HEIGHT // 2, right + SIDE // 2
    drawn += arrow_lines(f"M{right} {start} H{side} V{end} H{right + 8}", right + 1, end, "left")
    drawn.append(f'<text class="words end" x="{side - 8}" y="{tops[1] - BETWEEN // 2 + 4}">imports</text>')
    drawn.append(f'<text class="note" x="{MARGIN + PADDING}" y="{bottom + BETWEEN - 6}">{NOTE}</text>')
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img" aria-labelledby="title" aria-describedby="desc">',
        f'<title id="title">{TITLE}</title>', f'<desc id="desc">{description_of(groups)}</desc>',
        f"<style>{STYLE}</style>",
        f'<rect class="ground" x="0.5" y="0.5" width="{width - 1}" height="{height - 1}" rx="10"/>', *drawn, "</svg>\n",
    ])  # fmt: skip


if __name__ == "__main__":
    PICTURE.write_text(draw(read_contracts()), "utf-8", newline="\n")

"""Figures as files, with equal bytes for equal figures."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from polhode.errors import InvalidInput, shown
from polhode.formats.paths import as_path

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DOTS_PER_INCH = 200
SETTINGS: Any = {
    "pdf.fonttype": 42,  # TrueType, embedded: publishers refuse type 3
    # text stays text, so that it can be searched, read aloud and set again; among the fonts named for where DejaVu is
    # missing, Verdana has nearly its widths
    "svg.fonttype": "none",
    "svg.hashsalt": "polhode",  # names of clips and markers, otherwise drawn by chance
}
# metadata without a date, so that equal motions give equal files
METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": "polhode"},
    "svg": {"Creator": "polhode", "Date": None},
    "pdf": {"Creator": "polhode", "CreationDate": None},
}
_MARKS = {"png": b"Software\0polhode", "svg": b"<dc:title>polhode</dc:title>", "pdf": b"/Creator (polhode)"}


def save_figure(figure: Figure, path: str | Path) -> Path:
    """Write the figure in the form its ending names: png, svg or pdf.

    Raises:
        InvalidInput: for another ending.
    """
    path = as_path("path", path)
    kind = path.suffix.removeprefix(".").lower()
    if kind not in METADATA:
        raise InvalidInput(f"`path` must end in .png, .svg or .pdf; got {shown(path.name)}.")
    import matplotlib

    drawn = BytesIO()  # so that the bytes are written here, where a full disk is noticed
    with matplotlib.rc_context(SETTINGS):
        if (layout := figure.get_layout_engine()) is not None:
            # places everything once; savefig would draw the whole figure for it
            layout.execute(figure)
            figure.set_layout_engine(None)
        figure.savefig(drawn, format=kind, dpi=DOTS_PER_INCH, facecolor="white", metadata=METADATA[kind])
    path.write_bytes(drawn.getvalue())
    return path


def is_ours(path: Path) -> bool:
    """Whether a file is a figure that `save_figure` wrote, by its metadata."""
    mark = _MARKS.get(path.suffix.removeprefix("."))
    return mark is not None and path.is_file() and mark in path.read_bytes()

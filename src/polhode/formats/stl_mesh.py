"""STL, binary and text, read without trimesh, whose import takes longer than most reports.

Source: 3D Systems, *StereoLithography Interface Specification* (1988).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NoReturn

import numpy as np

from polhode.errors import FormatError, shown
from polhode.formats.numerals import read_number
from polhode.types import Array, Float64, Integer

TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_WORDS = re.compile(r"^[ \t]*(vertex|endfacet|endsolid)\b([^\r\n]*)", re.MULTILINE | re.IGNORECASE)


def read_stl(path: Path, content: bytes) -> tuple[Float64[Array, "n 3"], Integer[Array, "m 3"]]:
    """Return the corners of each triangle (n, 3), in single precision where the file is binary, and faces (m, 3).

    Raises:
        FormatError: for a number of triangles that does not fit the bytes, triangles without three corners each,
            corners that are not numbers, and text without an end.
    """
    header = 84  # bytes: a comment, then the number of triangles
    count = int.from_bytes(content[header - 4 : header], "little")
    if len(content) >= header and len(content) == header + TRIANGLE.itemsize * count:
        with np.errstate(invalid="ignore"):  # bytes that are a NaN of the signalling kind
            corners = np.frombuffer(content, TRIANGLE, offset=header)["corners"].reshape(-1, 3).astype(float)
    elif b"\0" in content or content.lstrip()[:5].lower() != b"solid":
        held = max(0, len(content) - header) / TRIANGLE.itemsize
        _refuse(path, f"it claims {count} triangles, and has bytes for {held:.6g}")
    else:
        corners = _corners_of_text(path, content.decode("latin-1"))  # beyond ASCII there are only names
    return corners, np.arange(len(corners)).reshape(-1, 3)


def _refuse(path: Path, what: str) -> NoReturn:
    raise FormatError(f"{path}: cannot be read as a mesh: {what}. Export it again.")


def _corners_of_text(path: Path, text: str) -> Array:
    matches = _WORDS.findall(text)
    order = "".join(word[3].lower() for word, _ in matches)  # t of vertex, f of endfacet, s of endsolid
    if not order.endswith("s"):
        _refuse(path, "it has no endsolid; it may be cut short")
    if order.replace("tttf", "").strip("s"):
        _refuse(path, "its triangles do not have three corners each; it may be cut short")
    words = [rest.split() for word, rest in matches if word[3] in "tT"]
    if any(len(three) != 3 for three in words):
        _refuse_corner(path, text)
    try:
        return np.array([[read_number(word) for word in three] for three in words]).reshape(-1, 3)
    except ValueError:
        _refuse_corner(path, text)


def _refuse_corner(path: Path, text: str) -> NoReturn:
    """Name the first line whose corner is not three numbers."""
    for match in _WORDS.finditer(text):
        if match[1].lower() == "vertex":
            three = match[2].split()
            try:
                good = len([read_number(word) for word in three]) == 3
            except ValueError:
                good = False
            if not good:
                number = text.count("\n", 0, match.start(1)) + 1
                what = f"a corner must be three finite numbers in decimal digits; got {shown(' '.join(three))}"
                raise FormatError(f"{path}, line {number}: {what}. Export it again.")
    raise AssertionError("every corner is three numbers")

"""Wavefront OBJ: vertices and faces; materials, groups and textures are ignored.

Source: Wavefront, *Advanced Visualizer Manual*, appendix B1, "Object files".
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import numpy as np

from polhode.errors import FormatError, shown
from polhode.formats.numerals import read_number
from polhode.types import Array, Float64, Integer


def read_obj(path: Path, text: str) -> tuple[Float64[Array, "n 3"], Integer[Array, "m 3"]]:
    """Return vertices (n, 3) and faces (m, 3); faces of more corners become a fan.

    Corners count from 1, or backwards from the last one above the face.

    Raises:
        FormatError: naming the line, where there are not three numbers, or no corner of that index.
    """
    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    for number, words in _lines(text):
        if words[0] == "v":
            vertices.append(_corner(path, number, words[1:]))
        elif words[0] == "f":
            corners = [_index(path, number, word, len(vertices)) for word in words[1:]]
            if len(corners) < 3:
                _refuse(path, number, f"a face must have three corners or more; got {len(corners)}")
            faces += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
    triangles = np.array(faces, dtype=np.int64).reshape(-1, 3)
    if len(triangles) and triangles.max() >= len(vertices):
        why = f"a face has corner {triangles.max() + 1}, and there are {len(vertices)}"
        raise FormatError(f"{path}: {why}. Export it again.")
    return np.array(vertices, dtype=float).reshape(-1, 3), triangles


def _refuse(path: Path, number: int, what: str) -> NoReturn:
    raise FormatError(f"{path}, line {number}: {what}. Export it again.")


def _lines(text: str) -> Iterator[tuple[int, list[str]]]:
    """Yield numbered words of lines that have any; a backslash at its end joins a line to the next."""
    held: list[str] = []
    for number, line in enumerate(text.splitlines(), 1):
        if line.endswith("\\"):
            held.append(line[:-1])
            continue
        whole = " ".join([*held, line]) if held else line
        held = []
        if words := whole.partition("#")[0].split():
            yield number, words


def _corner(path: Path, number: int, words: list[str]) -> list[float]:
    try:
        coordinates = [read_number(word) for word in words[:3]]  # a weight or a colour may follow
    except ValueError:
        coordinates = []
    if len(coordinates) != 3:
        _refuse(path, number, f"a corner must be three finite numbers in decimal digits; got {shown(' '.join(words))}")
    return coordinates


def _index(path: Path, number: int, word: str, count: int) -> int:
    """Return the index of a corner like 7, 7/2/3 or -1."""
    first = word.partition("/")[0]
    digits = first.removeprefix("-")
    if not (digits.isascii() and digits.isdigit() and len(digits) < 12 and int(digits) > 0):
        _refuse(path, number, f"a face must be of whole numbers of corners; got {shown(word)}")
    index = int(digits) - 1 if first == digits else count - int(digits)
    if index < 0:
        _refuse(path, number, f"a face must be of corners that are there; got {shown(word)} after {count}")
    return index

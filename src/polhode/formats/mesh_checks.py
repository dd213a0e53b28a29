"""Checks of mesh files before trimesh reads them: counts that the bytes can hold, text that is text.

Source: the formats' own: PLY (Turk, 1994), OFF (Geomview), glTF 2.0 (Khronos).
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from polhode.errors import FormatError, shown
from polhode.formats.numerals import is_misread

_PLY_COUNT = re.compile(r"element[ \t]+\S+[ \t]+(\S+)", re.ASCII)


class SceneLimits(NamedTuple):
    """Numbers beyond which a scene of meshes is refused."""

    max_triangles: int = 5_000_000  # after meshes have been put where the scene shows them
    max_parts: int = 1000  # nodes of a scene; trimesh takes a millisecond for each
    max_repetitions: int = 16  # of one mesh in a scene, on average by size


LIMITS = SceneLimits()


def check_content(path: Path, ending: str, content: bytes) -> bytes:
    """Return a file's bytes as trimesh can read them: text in UTF-8, scenes without materials.

    Raises:
        FormatError: for counts that do not fit the bytes, words that are not numbers, and scenes that lead to other
            files, are compressed, or repeat themselves without bound.
    """
    return {"ply": _ply, "off": _off, "glb": _glb, "gltf": _gltf}[ending](path, content)


def as_text(path: Path, content: bytes) -> str:
    """Return text in UTF-8, or in Latin-1 where it is not that; names in mesh files are of any encoding.

    Raises:
        FormatError: for bytes that are not text.
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    if "\0" in text:
        _refuse(path, "is not text, as its ending says")
    return text


def _refuse(path: Path, what: str) -> NoReturn:
    raise FormatError(f"{path}: {what}. Export it again.")


def _ply(path: Path, content: bytes) -> bytes:
    begun, end, body = content.partition(b"end_header")
    if not end or len(begun) > 1_000_000:
        _refuse(path, "cannot be read as a mesh: it has no end_header")
    for counted in _PLY_COUNT.findall(as_text(path, begun)):
        _check_count(path, counted, len(content))
    if b"format ascii" in begun:
        _check_words(path, as_text(path, body))
    return content


def _off(path: Path, content: bytes) -> bytes:
    text = as_text(path, content)
    _check_words(path, text)
    lines = [words for line in text.splitlines() if (words := line.partition("#")[0].split())]
    counts = lines[0][1:] or (lines[1] if len(lines) > 1 else []) if lines else []
    if len(counts) < 2:
        _refuse(path, "cannot be read as a mesh: it does not say how many corners and faces it has")
    for counted in counts[:2]:
        _check_count(path, counted, len(content))
    if len(lines) < 1 + (not lines[0][1:]) + int(counts[0]) + int(counts[1]):
        claimed = f"it claims {counts[0]} corners and {counts[1]} faces"
        _refuse(path, f"cannot be read as a mesh: it is cut short, as {claimed}")
    return text.encode()


def _check_count(path: Path, counted: str, most: int) -> None:
    if not (counted.isascii() and counted.isdigit() and len(counted) < 12 and int(counted) <= most):
        _refuse(path, f"cannot be read as a mesh: it claims {shown(counted)} parts, and has {most} bytes")


def _check_words(path: Path, text: str) -> None:
    """Refuse words that Python takes for numbers and other programs do not, outside names and comments."""
    if not ("_" in text or not text.isascii() or re.search(r"nan|inf|e[+-]?\d{3}", text, re.IGNORECASE)):
        return
    for number, line in enumerate(text.splitlines(), 1):
        words = line.partition("#")[0].split()
        if words and words[0] in ("solid", "endsolid", "comment", "obj_info"):
            continue
        for word in words:
            if is_misread(word):
                why = f"a corner must be finite numbers in decimal digits; got {shown(word)}"
                raise FormatError(f"{path}, line {number}: {why}. Export it again.")


def _glb(path: Path, content: bytes) -> bytes:
    size = int.from_bytes(content[12:16], "little")
    if content[:4] != b"glTF" or content[16:20] != b"JSON" or size > len(content) - 20:
        _refuse(path, "cannot be read as a mesh: it does not begin as GLB does")
    _check_scene(path, _json(path, content[20 : 20 + size]), len(content))
    return content


def _gltf(path: Path, content: bytes) -> bytes:
    _check_scene(path, _json(path, content), len(content), alone=False)
    return content


def _json(path: Path, content: bytes) -> dict[str, Any]:
    try:
        document = json.loads(content.rstrip(b"\0 "))
    except (ValueError, RecursionError):
        document = None
    if not isinstance(document, dict):
        _refuse(path, "cannot be read as a mesh: its description is not JSON")
    return document


def _check_scene(path: Path, scene: dict[str, Any], size: int, alone: bool = True) -> None:
    """Refuse scenes that are larger than their bytes, or a graph in which a node is its own descendant."""
    try:
        buffers = scene.get("buffers", [])
        if any("uri" in buffer and (alone or not buffer["uri"].startswith("data:")) for buffer in buffers):
            _refuse(path, "keeps its mesh in another file. Export it as GLB, which is one file")
        if any("compression" in name for name in scene.get("extensionsUsed", [])):
            _refuse(path, "is compressed, which is not read. Export it without compression")
        counts = [accessor["count"] for accessor in scene.get("accessors", [])]
        if any("bufferView" not in accessor or "sparse" in accessor for accessor in scene.get("accessors", [])):
            _refuse(path, "has sparse arrays, which are not read")
        if any(type(count) is not int or not 0 <= count <= size for count in counts):
            _refuse(path, f"claims {shown(counts)} entries of its arrays, and has {size} bytes")
        sizes = [sum(_entries(part, counts) for part in mesh["primitives"]) for mesh in scene.get("meshes", [])]
        nodes = scene.get("nodes", [])
        if len(nodes) > LIMITS.max_parts:
            _refuse(path, f"has {len(nodes)} parts in its scene, and may have {LIMITS.max_parts}. Join them")
        children = [child for node in nodes for child in node.get("children", [])]
        if len(set(children)) != len(children):
            _refuse(path, "has a part in two places of its scene, which glTF does not allow")
        shown_size = sum(sizes[node["mesh"]] for node in nodes if "mesh" in node)
        if shown_size > min(3 * LIMITS.max_triangles, LIMITS.max_repetitions * size):
            _refuse(path, f"shows {shown_size} corners in its scene, of {size} bytes")
    except (AttributeError, TypeError, KeyError, IndexError, ValueError) as error:
        if isinstance(error, FormatError):
            raise
        _refuse(path, "cannot be read as a mesh: its description is not one of glTF")


def _entries(part: dict[str, Any], counts: list[int]) -> int:
    return counts[part["indices"]] if "indices" in part else counts[part["attributes"]["POSITION"]]

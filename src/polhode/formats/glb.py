"""The container of glTF 2.0 in one binary file: a JSON document and the numbers it refers to.

Source: Khronos, *glTF 2.0 Specification* (ISO/IEC 12113:2022), §3.6 accessors, §3.7 meshes, §4.4 GLB.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from typing import Any

import numpy as np

from polhode.bodies.surface import Surface
from polhode.types import Array, ArrayLike, Float64, Real

FLOAT, TRIANGLES, FOR_VERTICES = 5126, 4, 34962
KINDS = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}


class Glb:
    """A document in the making.

    >>> glb = Glb({"asset": {"version": "2.0"}})
    >>> glb.numbers([[0.0, 1.0, 2.0]])
    0
    >>> glb.as_bytes()[:4]
    b'glTF'
    """

    def __init__(self, document: dict[str, Any]) -> None:
        self.document = document
        self._blob = bytearray()

    def add(self, section: str, entry: dict[str, Any]) -> int:
        """Append to one of the document's lists and return the entry's index."""
        entries = self.document.setdefault(section, [])
        entries.append(entry)
        return len(entries) - 1

    def numbers(self, values: Real[ArrayLike, "n ..."], bounds: bool = False, for_vertices: bool = False) -> int:
        """Store numbers (n,) or (n, k) in single precision and return the index of their accessor.

        Args:
            values: in double precision.
            bounds: whether to state the least and the greatest, which positions and times of keys must.
            for_vertices: whether they are attributes of vertices.
        """
        array = np.ascontiguousarray(values, dtype="<f4")
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self._blob), "byteLength": array.nbytes}
        self._blob += array.tobytes()
        columns = array.reshape(len(array), -1)
        entry: dict[str, Any] = {
            "bufferView": self.add("bufferViews", view | ({"target": FOR_VERTICES} if for_vertices else {})),
            "componentType": FLOAT,
            "count": len(array),
            "type": KINDS[columns.shape[1]],
        }
        if bounds:
            entry |= {"min": columns.min(axis=0).tolist(), "max": columns.max(axis=0).tolist()}
        return self.add("accessors", entry)

    def node(self, name: str, parent: int | None = None, **content: Any) -> int:
        """Add a node below another one, or to the scene, and return its index."""
        index = self.add("nodes", {"name": name, **content})
        if parent is None:
            self.add("scenes", {"nodes": [index]})
        else:
            self.document["nodes"][parent].setdefault("children", []).append(index)
        return index

    def mesh(self, *pieces: tuple[Surface, tuple[float, float, float]]) -> dict[str, int]:
        """Add surfaces, each in its colour, sRGB from 0 to 1, as one mesh; return the node property for it.

        Triangles have sharp edges. Those without area, which face nowhere, are left out, and without any there is no
        mesh.
        """
        primitives = [self._primitive(*piece) for piece in pieces]
        kept = [primitive for primitive in primitives if primitive is not None]
        return {"mesh": self.add("meshes", {"primitives": kept})} if kept else {}

    def _primitive(self, surface: Surface, color: tuple[float, float, float]) -> dict[str, Any] | None:
        corners = np.asarray(surface.vertices, dtype=float)[np.asarray(surface.faces)]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(normals, axis=1)
        with_area = size > 0
        if not with_area.any():
            return None
        attributes = {
            "POSITION": self.numbers(corners[with_area].reshape(-1, 3), bounds=True, for_vertices=True),
            "NORMAL": self.numbers(np.repeat(normals[with_area] / size[with_area, None], 3, axis=0), for_vertices=True),
        }
        linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in color]
        look = {"baseColorFactor": [*linear, 1.0], "metallicFactor": 0.1, "roughnessFactor": 0.6}
        # surfaces to draw need not be closed
        material = self.add("materials", {"pbrMetallicRoughness": look, "doubleSided": True})
        return {"attributes": attributes, "material": material, "mode": TRIANGLES}

    def animate(
        self, name: str, clock: Float64[Array, "keys"], tracks: Sequence[tuple[int, str, Float64[Array, "keys _"]]]
    ) -> None:
        """Add an animation that moves nodes by keys.

        Args:
            name: of the animation.
            clock: (K,) times of keys [s].
            tracks: node, "rotation" or "translation", and the values (K, 4) xyzw or (K, 3).
        """
        times = self.numbers(clock, bounds=True)
        samplers = [{"input": times, "output": self.numbers(keys), "interpolation": "LINEAR"} for _, _, keys in tracks]
        channels = [{"sampler": k, "target": {"node": node, "path": what}} for k, (node, what, _) in enumerate(tracks)]
        self.add("animations", {"name": name, "samplers": samplers, "channels": channels})

    def as_bytes(self) -> bytes:
        """Return the file."""
        document = self.document | {"buffers": [{"byteLength": len(self._blob)}]}
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        blob = bytes(self._blob)  # single precision: a multiple of four bytes already
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

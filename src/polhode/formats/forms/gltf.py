"""The format ``gltf``: glTF animations."""

from __future__ import annotations

from pathlib import Path

from polhode.formats.form import Content, Form


def write(content: Content, path: Path) -> Path:
    """Write the motion as an animation of the body's surface, or of a box with its inertia."""
    from polhode.formats.gltf import write_gltf

    shown = content.trajectory if content.part is None else content.part
    return write_gltf(shown, path, labels=content.labels, surface=content.surface())


FORM = Form(
    "gltf", "glTF animation", ".glb", "glTF 2.0 animation of the body; angles to 1e-7, as it holds single precision",
    write, sampled=False,
)

"""The format ``urdf``: the mass properties of a robot's link."""

from __future__ import annotations

from pathlib import Path

from polhode.errors import InvalidInput
from polhode.formats.form import Content, Form


def write(content: Content, path: Path) -> Path:
    """Write the body's mass properties."""
    from polhode.spacecraft.formats.urdf import write_urdf_inertial

    if content.body is None:
        raise InvalidInput("a URDF link needs a body, and this spec has no [body]. Give one, or choose another form.")
    return write_urdf_inertial(content.body, path, content.name)


FORM = Form("urdf", "URDF link", ".urdf", "mass, centre of mass and inertia along the given axes; every digit", write,
            of_motion=False, sampled=False)

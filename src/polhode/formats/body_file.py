"""The description of a format of files that hold a body, such as a robot's, which the table [body] may name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from polhode.bodies.body import Body

Pose = Mapping[str, tuple[float, str]]
"""Positions of joints by name: a number in SI and its unit, rad or m."""


@dataclass(frozen=True)
class BodyFile:
    """A format of files that hold a body.

    A wing offers it under [bodies] of its ``plugin.toml``, another package in the entry-point group ``polhode.bodies``.
    Its name there is the key of [body] that names such a file.

    Attributes:
        read: returns the body in a file, along the file's axes, from its path, the name of one link that the spec
            gives, or None, and the digits to which the file's entries are rounded, or None.
        read_at_pose: returns all links as one body, from the path, the positions of joints, and the digits; None for a
            format without joints.
    """

    read: Callable[[Path, str | None, int | None], Body]
    read_at_pose: Callable[[Path, Pose, int | None], Body] | None = None

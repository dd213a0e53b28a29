"""The rigid body with wheels, other mounts and torques, on an orbit and under control."""

from __future__ import annotations

from typing import ClassVar

from polhode.kinds.base import AbstractKind
from polhode.spacecraft.rigid_body.table import RigidBodyTable
from polhode.spec.models import SystemTable


class RigidBodyKind(AbstractKind[RigidBodyTable]):
    """The rigid body with wheels, other mounts and torques, on an orbit and under control."""

    name: ClassVar[str] = "rigid-body"
    table: ClassVar[type[SystemTable]] = RigidBodyTable
    figure_names: ClassVar[tuple[str, ...]] = ("rates", "pointing", "wheels")


KIND = RigidBodyKind()

"""Euler's disk: a disk that rolls on a plane until it lies flat."""

from __future__ import annotations

from typing import ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.rolling.euler_disk.table import EulerDiskTable
from polhode.spec.models import SystemTable
from polhode.spec.surfaces import surface_of_disk


class EulerDiskKind(AbstractKind[EulerDiskTable]):
    """Euler's disk: a disk that rolls on a plane until it lies flat."""

    name: ClassVar[str] = "euler-disk"
    table: ClassVar[type[SystemTable]] = EulerDiskTable
    figure_names: ClassVar[tuple[str, ...]] = ("rolling_disk", "tilt", "contact_path")

    def surface(self, spec: Spec) -> Surface | None:
        return surface_of_disk(spec.system.radius, spec.system.thickness)


KIND = EulerDiskKind()

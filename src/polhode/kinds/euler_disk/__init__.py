"""Euler's disk: a disk that rolls on a plane until it lies flat."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.euler_disk.table import EulerDiskTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake
from polhode.spec.surfaces import surface_of_disk


class EulerDiskKind(AbstractKind):
    """Euler's disk: a disk that rolls on a plane until it lies flat."""

    name: ClassVar[str] = "euler-disk"
    table: ClassVar[type[SystemTable]] = EulerDiskTable
    figure_names: ClassVar[tuple[str, ...]] = ("rolling_disk", "tilt", "contact_path")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.euler_disk.EulerDisk",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.euler_disk.rules import disk_rules

        return disk_rules(tables["system"])

    def surface(self, spec: Spec) -> Surface | None:
        return surface_of_disk(spec.system.radius, spec.system.thickness)


KIND = EulerDiskKind()

"""Euler's disk: a disk that rolls on a plane until it lies flat."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.rolling.euler_disk.table import EulerDiskTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake
from polhode.spec.surfaces import surface_of_disk

if TYPE_CHECKING:
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table
    from polhode.rolling.euler_disk.panel import EulerDiskPanel
    from polhode.rolling.euler_disk.report import EulerDiskReport


class EulerDiskKind(AbstractKind[EulerDiskTable]):
    """Euler's disk: a disk that rolls on a plane until it lies flat."""

    name: ClassVar[str] = "euler-disk"
    table: ClassVar[type[SystemTable]] = EulerDiskTable
    figure_names: ClassVar[tuple[str, ...]] = ("rolling_disk", "tilt", "contact_path")

    def report(self, spec: Spec[EulerDiskTable]) -> EulerDiskReport:
        from polhode.rolling.euler_disk.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[EulerDiskTable]) -> Iterator[Group | Table]:
        from polhode.rolling.euler_disk.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.rolling.euler_disk.figures import FIGURES

        return FIGURES

    def panel(self) -> EulerDiskPanel:
        from polhode.rolling.euler_disk.panel import EulerDiskPanel

        return EulerDiskPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.rolling.euler_disk.rules import disk_rules

        return disk_rules(tables["system"])

    def surface(self, spec: Spec) -> Surface | None:
        return surface_of_disk(spec.system.radius, spec.system.thickness)


KIND = EulerDiskKind()

"""Euler's disk: a disk that rolls on a plane until it lies flat."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.euler_disk.table import EulerDiskTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake
from polhode.spec.surfaces import surface_of_disk

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.viewer.panels import Content
    from polhode.viewer.samples import Samples


class EulerDiskKind(AbstractKind):
    """Euler's disk: a disk that rolls on a plane until it lies flat."""

    name: ClassVar[str] = "euler-disk"
    figure_names: ClassVar[tuple[str, ...]] = ("rolling_disk", "tilt", "contact_path")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.euler_disk.EulerDisk",)

    @property
    def table(self) -> type[EulerDiskTable]:
        return EulerDiskTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.euler_disk.rules import disk_rules

        return disk_rules(tables["system"])

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.euler_disk.build import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.kinds.euler_disk.figures import FIGURES

        return FIGURES

    def surface(self, spec: Spec) -> Surface | None:
        return surface_of_disk(spec.system.radius, spec.system.thickness)

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> Content | None:
        from polhode.kinds.euler_disk.panel import content_of

        return content_of(trajectory, samples, self.script())


KIND = EulerDiskKind()

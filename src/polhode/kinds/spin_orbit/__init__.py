"""The spin of a moon or planet on its orbit."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.spin_orbit.table import SpinOrbitTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.viewer.panels import Content
    from polhode.viewer.samples import Samples


class SpinOrbitKind(AbstractKind):
    """The spin of a moon or planet on its orbit."""

    name: ClassVar[str] = "spin-orbit"
    figure_names: ClassVar[tuple[str, ...]] = ("section", "motion")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.spin_orbit.SpinOrbit",)

    @property
    def table(self) -> type[SpinOrbitTable]:
        return SpinOrbitTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.spin_orbit.rules import spin_orbit_rules

        return spin_orbit_rules(tables["system"], "body" in tables)

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.spin_orbit.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.kinds.spin_orbit.figures import FIGURES

        return FIGURES

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> Content | None:
        from polhode.kinds.spin_orbit.panel import content_of

        return content_of(trajectory.source, samples, self.script())


KIND = SpinOrbitKind()

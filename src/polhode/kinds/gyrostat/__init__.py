"""The gyrostat: a body with a rotor inside."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.viewer.panels import Content
    from polhode.viewer.samples import Samples


class GyrostatKind(AbstractKind):
    """The gyrostat: a body with a rotor inside."""

    name: ClassVar[str] = "gyrostat"
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")
    sources: ClassVar[tuple[str, ...]] = (
        "polhode.systems.gyrostat.Gyrostat",
        "polhode.systems.gyrostat.TorquedGyrostat",
    )

    @property
    def table(self) -> type[GyrostatTable]:
        return GyrostatTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.gyrostat.rules import gyrostat_rules

        return gyrostat_rules(tables["system"])

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.gyrostat.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.kinds.gyrostat.figures import FIGURES

        return FIGURES

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> Content | None:
        from polhode.kinds.gyrostat.panel import content_of

        return content_of(trajectory, samples, surface)


KIND = GyrostatKind()

"""A kind of another package: a mass on a rod that swings any way under its weight."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.bodies.surface import Surface
from polhode.kinds.base import AbstractKind, Spec
from polhode.motion.trajectory import Trajectory
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake
from spherical_pendulum.table import PendulumTable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from polhode.viewer.panels import Content
    from polhode.viewer.samples import Samples


class SphericalPendulumKind(AbstractKind):
    """A mass on a rod that swings any way under its weight."""

    name: ClassVar[str] = "spherical-pendulum"
    figure_names: ClassVar[tuple[str, ...]] = ("path",)
    sources: ClassVar[tuple[str, ...]] = ("spherical_pendulum.system.SphericalPendulum",)

    @property
    def table(self) -> type[PendulumTable]:
        return PendulumTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        if "lean" not in tables["system"] and "rate" not in tables["system"]:
            yield ("system",), 'needs lean, like "30 deg", or rate, like "2 rad/s", for it hangs at rest without'

    def report(self, spec: Spec) -> AbstractReport:
        from spherical_pendulum.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from spherical_pendulum.figures import FIGURES

        return FIGURES

    def content(self, trajectory: Trajectory, samples: Samples, surface: Surface | None) -> Content | None:
        from spherical_pendulum.panel import content_of

        return content_of(trajectory, samples, self.script())


KIND = SphericalPendulumKind()

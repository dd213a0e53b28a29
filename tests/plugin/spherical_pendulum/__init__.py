"""A kind of another package: a mass on a rod that swings any way under its weight."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds import AbstractKind, Mistake, SystemTable
from spherical_pendulum.table import PendulumTable

if TYPE_CHECKING:
    from polhode.kinds import Figures, Spec
    from spherical_pendulum.answers import PendulumReport
    from spherical_pendulum.panel import PendulumPanel


class SphericalPendulumKind(AbstractKind[PendulumTable]):
    """A mass on a rod that swings any way under its weight."""

    name: ClassVar[str] = "spherical-pendulum"
    table: ClassVar[type[SystemTable]] = PendulumTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("path",)

    def report(self, spec: Spec[PendulumTable]) -> PendulumReport:
        from spherical_pendulum.answers import report_of

        return report_of(spec)

    def figures(self) -> Figures:
        from spherical_pendulum.figures import FIGURES

        return FIGURES

    def panel(self) -> PendulumPanel:
        from spherical_pendulum.panel import PendulumPanel

        return PendulumPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        if "lean" not in tables["system"] and "rate" not in tables["system"]:
            yield ("system",), 'needs lean, like "30 deg", or rate, like "2 rad/s", for it hangs at rest without'


KIND = SphericalPendulumKind()

"""Point vortices in a plane or on a sphere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.fields.point_vortices.table import VorticesTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.fields.point_vortices.answers import VorticesReport
    from polhode.fields.point_vortices.panel import PointVorticesPanel
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table


class PointVorticesKind(AbstractKind[VorticesTable]):
    """Point vortices in a plane or on a sphere."""

    name: ClassVar[str] = "point-vortices"
    table: ClassVar[type[SystemTable]] = VorticesTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("tracks", "streamlines")

    def report(self, spec: Spec[VorticesTable]) -> VorticesReport:
        from polhode.fields.point_vortices.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[VorticesTable]) -> Iterator[Group | Table]:
        from polhode.fields.point_vortices.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.fields.point_vortices.figures import FIGURES

        return FIGURES

    def panel(self) -> PointVorticesPanel:
        from polhode.fields.point_vortices.panel import PointVorticesPanel

        return PointVorticesPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.fields.point_vortices.rules import vortex_rules

        return vortex_rules(tables["system"])


KIND = PointVorticesKind()

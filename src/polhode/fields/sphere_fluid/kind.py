"""An ideal fluid on a sphere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.fields.sphere_fluid.table import FluidTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.fields.sphere_fluid.answers import FluidReport
    from polhode.fields.sphere_fluid.panel import SphereFluidPanel
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table


class SphereFluidKind(AbstractKind[FluidTable]):
    """An ideal fluid on a sphere, which may rotate."""

    name: ClassVar[str] = "sphere-fluid"
    table: ClassVar[type[SystemTable]] = FluidTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("vorticity", "globe", "spectrum", "zonal")

    def report(self, spec: Spec[FluidTable]) -> FluidReport:
        from polhode.fields.sphere_fluid.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[FluidTable]) -> Iterator[Group | Table]:
        from polhode.fields.sphere_fluid.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.fields.sphere_fluid.figures import FIGURES

        return FIGURES

    def panel(self) -> SphereFluidPanel:
        from polhode.fields.sphere_fluid.panel import SphereFluidPanel

        return SphereFluidPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.fields.sphere_fluid.rules import fluid_rules

        return fluid_rules(tables["system"])


KIND = SphereFluidKind()

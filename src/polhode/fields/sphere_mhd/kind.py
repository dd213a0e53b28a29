"""An ideal conducting fluid on a sphere, with its magnetic field."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.fields.sphere_mhd.table import MagneticFluidTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.fields.sphere_mhd.answers import MagneticReport
    from polhode.fields.sphere_mhd.panel import SphereMHDPanel
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table


class SphereMHDKind(AbstractKind[MagneticFluidTable]):
    """An ideal conducting fluid on a sphere, which may rotate."""

    name: ClassVar[str] = "sphere-mhd"
    table: ClassVar[type[SystemTable]] = MagneticFluidTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("maps", "globe", "energies", "spectrum")

    def report(self, spec: Spec[MagneticFluidTable]) -> MagneticReport:
        from polhode.fields.sphere_mhd.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[MagneticFluidTable]) -> Iterator[Group | Table]:
        from polhode.fields.sphere_mhd.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.fields.sphere_mhd.figures import FIGURES

        return FIGURES

    def panel(self) -> SphereMHDPanel:
        from polhode.fields.sphere_mhd.panel import SphereMHDPanel

        return SphereMHDPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.fields.sphere_mhd.rules import magnetic_rules

        return magnetic_rules(tables["system"])


KIND = SphereMHDKind()

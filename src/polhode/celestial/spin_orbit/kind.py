"""The spin of a moon or planet on its orbit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.celestial.spin_orbit.table import SpinOrbitTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.celestial.spin_orbit.answers import SpinOrbitReport
    from polhode.celestial.spin_orbit.panel import SpinOrbitPanel
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table


class SpinOrbitKind(AbstractKind[SpinOrbitTable]):
    """The spin of a moon or planet on its orbit."""

    name: ClassVar[str] = "spin-orbit"
    table: ClassVar[type[SystemTable]] = SpinOrbitTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("section", "motion")

    def report(self, spec: Spec[SpinOrbitTable]) -> SpinOrbitReport:
        from polhode.celestial.spin_orbit.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[SpinOrbitTable]) -> Iterator[Group | Table]:
        from polhode.celestial.spin_orbit.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.celestial.spin_orbit.figures import FIGURES

        return FIGURES

    def panel(self) -> SpinOrbitPanel:
        from polhode.celestial.spin_orbit.panel import SpinOrbitPanel

        return SpinOrbitPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.celestial.spin_orbit.rules import spin_orbit_rules

        return spin_orbit_rules(tables["system"], "body" in tables)


KIND = SpinOrbitKind()

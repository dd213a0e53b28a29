"""The heavy top: any body about a fixed point, under its weight."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.heavy_top.table import HeavyTopTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.kinds.base import Figures, Overview, Spec, SpecMotion
    from polhode.kinds.heavy_top.answers import HeavyTopReport
    from polhode.kinds.heavy_top.panel import HeavyTopPanel
    from polhode.reports.answer import Group, Table


class HeavyTopKind(AbstractKind[HeavyTopTable]):
    """The heavy top: any body about a fixed point, under its weight."""

    name: ClassVar[str] = "heavy-top"
    table: ClassVar[type[SystemTable]] = HeavyTopTable
    subject: ClassVar[str] = "top"
    figure_names: ClassVar[tuple[str, ...]] = ("spinning_top", "axis_locus", "motion")

    def report(self, spec: Spec[HeavyTopTable]) -> HeavyTopReport:
        from polhode.kinds.heavy_top.answers import make_report

        return make_report(spec)

    def motion(self, spec: Spec[HeavyTopTable]) -> SpecMotion:
        from polhode.kinds.heavy_top.answers import simulate_motion

        return simulate_motion(spec)

    def answers_without_motion(self, spec: Spec[HeavyTopTable]) -> Iterator[Group | Table]:
        from polhode.kinds.heavy_top.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.kinds.heavy_top.figures import FIGURES

        return FIGURES

    def overview(self) -> Overview:
        from polhode.kinds.heavy_top.figures import OVERVIEW

        return OVERVIEW

    def panel(self) -> HeavyTopPanel:
        from polhode.kinds.heavy_top.panel import HeavyTopPanel

        return HeavyTopPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spec.top_rules import top_rules

        return top_rules(tables, self.name)


KIND = HeavyTopKind()

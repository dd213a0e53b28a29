"""The heavy top: any body about a fixed point, under its weight."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.heavy_top.table import HeavyTopTable
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class HeavyTopKind(AbstractKind):
    """The heavy top: any body about a fixed point, under its weight."""

    name: ClassVar[str] = "heavy-top"
    figure_names: ClassVar[tuple[str, ...]] = ("spinning_top", "axis_locus", "motion")

    @property
    def table(self) -> type[HeavyTopTable]:
        return HeavyTopTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spec.top_rules import top_rules

        return top_rules(tables, self.name)

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.heavy_top.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.figures.top import FIGURES

        return FIGURES


KIND = HeavyTopKind()

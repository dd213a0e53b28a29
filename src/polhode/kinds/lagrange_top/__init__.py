"""The Lagrange top: a symmetric body about a point of its axis, exactly."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.lagrange_top.table import LagrangeTopTable
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class LagrangeTopKind(AbstractKind):
    """The Lagrange top: a symmetric body about a point of its axis, exactly."""

    name: ClassVar[str] = "lagrange-top"
    figure_names: ClassVar[tuple[str, ...]] = ("spinning_top", "axis_locus", "motion")

    @property
    def table(self) -> type[LagrangeTopTable]:
        return LagrangeTopTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spec.top_rules import top_rules

        return top_rules(tables, self.name)

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.lagrange_top.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.figures.top import FIGURES

        return FIGURES


KIND = LagrangeTopKind()

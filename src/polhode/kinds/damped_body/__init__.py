"""A body that loses energy, inside or by drag."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.damped_body.table import DampedBodyTable
from polhode.reports.base import AbstractReport
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class DampedBodyKind(AbstractKind):
    """A body that loses energy, inside or by drag."""

    name: ClassVar[str] = "damped-body"
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")

    @property
    def table(self) -> type[DampedBodyTable]:
        return DampedBodyTable

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.damped_body.rules import damped_rules

        return damped_rules(tables["system"])

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.damped_body.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.kinds.damped_body.figures import FIGURES

        return FIGURES


KIND = DampedBodyKind()

"""A body that loses energy, inside or by drag."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.spacecraft.damped_body.table import DampedBodyTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.kinds.base import Figures, Spec, SpecMotion
    from polhode.reports.answer import Group, Table
    from polhode.spacecraft.damped_body.answers import DampedBodyReport
    from polhode.spacecraft.damped_body.panel import DampedBodyPanel


class DampedBodyKind(AbstractKind[DampedBodyTable]):
    """A body that loses energy, inside or by drag."""

    name: ClassVar[str] = "damped-body"
    table: ClassVar[type[SystemTable]] = DampedBodyTable
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")

    def report(self, spec: Spec[DampedBodyTable]) -> DampedBodyReport:
        from polhode.spacecraft.damped_body.answers import make_report

        return make_report(spec)

    def motion(self, spec: Spec[DampedBodyTable]) -> SpecMotion:
        from polhode.spacecraft.damped_body.answers import simulate_motion

        return simulate_motion(spec)

    def answers_without_motion(self, spec: Spec[DampedBodyTable]) -> Iterator[Group | Table]:
        from polhode.spacecraft.damped_body.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.spacecraft.damped_body.figures import FIGURES

        return FIGURES

    def panel(self) -> DampedBodyPanel:
        from polhode.spacecraft.damped_body.panel import DampedBodyPanel

        return DampedBodyPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spacecraft.damped_body.rules import find_broken_rules

        return find_broken_rules(tables["system"])


KIND = DampedBodyKind()

"""The gyrostat: a body with a rotor inside."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.kinds.base import Figures, Spec, SpecMotion
    from polhode.kinds.gyrostat.answers import GyrostatReport
    from polhode.kinds.gyrostat.panel import GyrostatPanel
    from polhode.reports.answer import Group, Table


class GyrostatKind(AbstractKind[GyrostatTable]):
    """The gyrostat: a body with a rotor inside."""

    name: ClassVar[str] = "gyrostat"
    table: ClassVar[type[SystemTable]] = GyrostatTable
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")

    def report(self, spec: Spec[GyrostatTable]) -> GyrostatReport:
        from polhode.kinds.gyrostat.answers import make_report

        return make_report(spec)

    def motion(self, spec: Spec[GyrostatTable]) -> SpecMotion:
        from polhode.kinds.gyrostat.answers import simulate_motion

        return simulate_motion(spec)

    def answers_without_motion(self, spec: Spec[GyrostatTable]) -> Iterator[Group | Table]:
        from polhode.kinds.gyrostat.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.kinds.gyrostat.figures import FIGURES

        return FIGURES

    def panel(self) -> GyrostatPanel:
        from polhode.kinds.gyrostat.panel import GyrostatPanel

        return GyrostatPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.gyrostat.rules import gyrostat_rules

        return gyrostat_rules(tables["system"])


KIND = GyrostatKind()

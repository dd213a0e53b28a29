"""A plasma of electrons that moves in its own field."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.fields.vlasov_poisson.table import PlasmaTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.fields.vlasov_poisson.answers import PlasmaReport
    from polhode.fields.vlasov_poisson.panel import VlasovPoissonPanel
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table


class VlasovPoissonKind(AbstractKind[PlasmaTable]):
    """A plasma of electrons that moves by its own field."""

    name: ClassVar[str] = "vlasov-poisson"
    table: ClassVar[type[SystemTable]] = PlasmaTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("field", "phase_space")

    def report(self, spec: Spec[PlasmaTable]) -> PlasmaReport:
        from polhode.fields.vlasov_poisson.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[PlasmaTable]) -> Iterator[Group | Table]:
        from polhode.fields.vlasov_poisson.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.fields.vlasov_poisson.figures import FIGURES

        return FIGURES

    def panel(self) -> VlasovPoissonPanel:
        from polhode.fields.vlasov_poisson.panel import VlasovPoissonPanel

        return VlasovPoissonPanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.fields.vlasov_poisson.rules import plasma_rules

        return plasma_rules(tables["system"])


KIND = VlasovPoissonKind()

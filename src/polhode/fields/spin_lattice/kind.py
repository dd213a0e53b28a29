"""Classical spins on a lattice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.fields.spin_lattice.table import SpinLatticeTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake

if TYPE_CHECKING:
    from polhode.fields.spin_lattice.answers import SpinLatticeReport
    from polhode.fields.spin_lattice.panel import SpinLatticePanel
    from polhode.kinds.base import Figures, Spec
    from polhode.reports.answer import Group, Table


class SpinLatticeKind(AbstractKind[SpinLatticeTable]):
    """Classical spins on a lattice, with exchange, damping and heat."""

    name: ClassVar[str] = "spin-lattice"
    table: ClassVar[type[SystemTable]] = SpinLatticeTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("spins", "energy", "waves")

    def report(self, spec: Spec[SpinLatticeTable]) -> SpinLatticeReport:
        from polhode.fields.spin_lattice.answers import make_report

        return make_report(spec)

    def answers_without_motion(self, spec: Spec[SpinLatticeTable]) -> Iterator[Group | Table]:
        from polhode.fields.spin_lattice.answers import answers_without_motion

        return answers_without_motion(spec)

    def figures(self) -> Figures:
        from polhode.fields.spin_lattice.figures import FIGURES

        return FIGURES

    def panel(self) -> SpinLatticePanel:
        from polhode.fields.spin_lattice.panel import SpinLatticePanel

        return SpinLatticePanel()

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.fields.spin_lattice.rules import spin_rules

        return spin_rules(tables["system"])


KIND = SpinLatticeKind()

"""Classical spins on a lattice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.spin_lattice.table import SpinLatticeTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class SpinLatticeKind(AbstractKind):
    """Classical spins on a lattice, with exchange, damping and heat."""

    name: ClassVar[str] = "spin-lattice"
    table: ClassVar[type[SystemTable]] = SpinLatticeTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("spins", "energy", "waves")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.spin_lattice.SpinLattice",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.spin_lattice.rules import spin_rules

        return spin_rules(tables["system"])


KIND = SpinLatticeKind()

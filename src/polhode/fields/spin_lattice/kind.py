"""Classical spins on a lattice."""

from __future__ import annotations

from typing import ClassVar

from polhode.fields.spin_lattice.table import SpinLatticeTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable


class SpinLatticeKind(AbstractKind[SpinLatticeTable]):
    """Classical spins on a lattice, with exchange, damping and heat."""

    name: ClassVar[str] = "spin-lattice"
    table: ClassVar[type[SystemTable]] = SpinLatticeTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("spins", "energy", "waves")


KIND = SpinLatticeKind()

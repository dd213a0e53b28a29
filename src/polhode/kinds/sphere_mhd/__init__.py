"""An ideal conducting fluid on a sphere, with its magnetic field."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.sphere_mhd.table import MagneticFluidTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class SphereMHDKind(AbstractKind):
    """An ideal conducting fluid on a sphere, which may rotate."""

    name: ClassVar[str] = "sphere-mhd"
    table: ClassVar[type[SystemTable]] = MagneticFluidTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("maps", "globe", "energies", "spectrum")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.sphere_mhd.SphereMHD",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.sphere_mhd.rules import magnetic_rules

        return magnetic_rules(tables["system"])


KIND = SphereMHDKind()

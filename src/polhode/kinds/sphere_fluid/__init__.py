"""An ideal fluid on a sphere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.sphere_fluid.table import FluidTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class SphereFluidKind(AbstractKind):
    """An ideal fluid on a sphere, which may rotate."""

    name: ClassVar[str] = "sphere-fluid"
    table: ClassVar[type[SystemTable]] = FluidTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("vorticity", "globe", "spectrum", "zonal")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.sphere_fluid.SphereFluid",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.sphere_fluid.rules import fluid_rules

        return fluid_rules(tables["system"])


KIND = SphereFluidKind()

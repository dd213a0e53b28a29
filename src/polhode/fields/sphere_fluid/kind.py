"""An ideal fluid on a sphere."""

from __future__ import annotations

from typing import ClassVar

from polhode.fields.sphere_fluid.table import FluidTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable


class SphereFluidKind(AbstractKind[FluidTable]):
    """An ideal fluid on a sphere, which may rotate."""

    name: ClassVar[str] = "sphere-fluid"
    table: ClassVar[type[SystemTable]] = FluidTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("vorticity", "globe", "spectrum", "zonal")


KIND = SphereFluidKind()

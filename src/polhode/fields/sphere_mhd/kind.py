"""An ideal conducting fluid on a sphere, with its magnetic field."""

from __future__ import annotations

from typing import ClassVar

from polhode.fields.sphere_mhd.table import MagneticFluidTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable


class SphereMHDKind(AbstractKind[MagneticFluidTable]):
    """An ideal conducting fluid on a sphere, which may rotate."""

    name: ClassVar[str] = "sphere-mhd"
    table: ClassVar[type[SystemTable]] = MagneticFluidTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("maps", "globe", "energies", "spectrum")


KIND = SphereMHDKind()

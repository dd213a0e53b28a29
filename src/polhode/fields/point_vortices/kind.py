"""Point vortices in a plane or on a sphere."""

from __future__ import annotations

from typing import ClassVar

from polhode.fields.point_vortices.table import VorticesTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable


class PointVorticesKind(AbstractKind[VorticesTable]):
    """Point vortices in a plane or on a sphere."""

    name: ClassVar[str] = "point-vortices"
    table: ClassVar[type[SystemTable]] = VorticesTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("tracks", "streamlines")


KIND = PointVorticesKind()

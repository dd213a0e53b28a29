"""Point vortices in a plane or on a sphere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.point_vortices.table import VorticesTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class PointVorticesKind(AbstractKind):
    """Point vortices in a plane or on a sphere."""

    name: ClassVar[str] = "point-vortices"
    table: ClassVar[type[SystemTable]] = VorticesTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("tracks", "streamlines")
    sources: ClassVar[tuple[str, ...]] = (
        "polhode.systems.point_vortices.SphereVortices",
        "polhode.systems.point_vortices.PlaneVortices",
    )

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.point_vortices.rules import vortex_rules

        return vortex_rules(tables["system"])


KIND = PointVorticesKind()

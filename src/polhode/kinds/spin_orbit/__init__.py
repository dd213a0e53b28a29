"""The spin of a moon or planet on its orbit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.spin_orbit.table import SpinOrbitTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class SpinOrbitKind(AbstractKind):
    """The spin of a moon or planet on its orbit."""

    name: ClassVar[str] = "spin-orbit"
    table: ClassVar[type[SystemTable]] = SpinOrbitTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("section", "motion")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.spin_orbit.SpinOrbit",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.spin_orbit.rules import spin_orbit_rules

        return spin_orbit_rules(tables["system"], "body" in tables)


KIND = SpinOrbitKind()

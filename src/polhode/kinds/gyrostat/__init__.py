"""The gyrostat: a body with a rotor inside."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class GyrostatKind(AbstractKind):
    """The gyrostat: a body with a rotor inside."""

    name: ClassVar[str] = "gyrostat"
    table: ClassVar[type[SystemTable]] = GyrostatTable
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")
    sources: ClassVar[tuple[str, ...]] = (
        "polhode.systems.gyrostat.Gyrostat",
        "polhode.systems.gyrostat.TorquedGyrostat",
    )

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.gyrostat.rules import gyrostat_rules

        return gyrostat_rules(tables["system"])


KIND = GyrostatKind()

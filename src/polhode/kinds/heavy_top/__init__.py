"""The heavy top: any body about a fixed point, under its weight."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.heavy_top.table import HeavyTopTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class HeavyTopKind(AbstractKind[HeavyTopTable]):
    """The heavy top: any body about a fixed point, under its weight."""

    name: ClassVar[str] = "heavy-top"
    table: ClassVar[type[SystemTable]] = HeavyTopTable
    subject: ClassVar[str] = "top"
    figure_names: ClassVar[tuple[str, ...]] = ("spinning_top", "axis_locus", "motion")

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spec.top_rules import top_rules

        return top_rules(tables, self.name)


KIND = HeavyTopKind()

"""A body that loses energy, inside or by drag."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.damped_body.table import DampedBodyTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class DampedBodyKind(AbstractKind):
    """A body that loses energy, inside or by drag."""

    name: ClassVar[str] = "damped-body"
    table: ClassVar[type[SystemTable]] = DampedBodyTable
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.double_bracket.DoubleBracket",)
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.damped_body.rules import damped_rules

        return damped_rules(tables["system"])


KIND = DampedBodyKind()

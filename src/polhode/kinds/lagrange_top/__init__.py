"""The Lagrange top: a symmetric body about a point of its axis, exactly."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.lagrange_top.table import LagrangeTopTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class LagrangeTopKind(AbstractKind[LagrangeTopTable]):
    """The Lagrange top: a symmetric body about a point of its axis, exactly."""

    name: ClassVar[str] = "lagrange-top"
    table: ClassVar[type[SystemTable]] = LagrangeTopTable
    subject: ClassVar[str] = "top"
    in_closed_form: ClassVar[bool] = True
    reach: ClassVar[float] = math.inf  # closed forms are computed at any size
    figure_names: ClassVar[tuple[str, ...]] = ("spinning_top", "axis_locus", "motion")

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spec.top_rules import top_rules

        return top_rules(tables, self.name)


KIND = LagrangeTopKind()

"""The Lagrange top: a symmetric body about a point of its axis, exactly."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.lagrange_top.table import LagrangeTopTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from collections.abc import Sequence

    from polhode.exact.lagrange_top import LagrangeMotion
    from polhode.kinds.base import Figures, Overview, Spec, SpecMotion
    from polhode.kinds.ensembles import Ensemble, ManySpecs
    from polhode.kinds.lagrange_top.answers import LagrangeTopReport


class LagrangeTopKind(AbstractKind[LagrangeTopTable]):
    """The Lagrange top: a symmetric body about a point of its axis, exactly."""

    name: ClassVar[str] = "lagrange-top"
    table: ClassVar[type[SystemTable]] = LagrangeTopTable
    subject: ClassVar[str] = "top"
    in_closed_form: ClassVar[bool] = True
    reach: ClassVar[float] = math.inf  # closed forms are computed at any size
    figure_names: ClassVar[tuple[str, ...]] = ("spinning_top", "axis_locus", "motion")

    def report(self, spec: Spec[LagrangeTopTable]) -> LagrangeTopReport:
        from polhode.kinds.lagrange_top.answers import make_report

        return make_report(spec)

    def closed_form(self, spec: Spec[LagrangeTopTable]) -> LagrangeMotion:
        from polhode.kinds.lagrange_top.answers import make_motion

        return make_motion(spec)

    def motion(self, spec: Spec[LagrangeTopTable]) -> SpecMotion:
        from polhode.kinds.lagrange_top.answers import simulate_motion

        return simulate_motion(spec)

    def figures(self) -> Figures:
        from polhode.kinds.lagrange_top.figures import FIGURES

        return FIGURES

    def overview(self) -> Overview:
        from polhode.kinds.lagrange_top.figures import OVERVIEW

        return OVERVIEW

    def ensemble(
        self, samples: ManySpecs, names: Sequence[str], times: Float64[Array, "time"]
    ) -> Ensemble | None:
        from polhode.kinds.lagrange_top.ensemble import evaluate_ensemble

        return evaluate_ensemble(samples, names, times)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.spec.top_rules import top_rules

        return top_rules(tables, self.name)


KIND = LagrangeTopKind()

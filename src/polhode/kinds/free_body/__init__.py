"""The free body, on which nothing acts."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.free_body.table import FreeBodyTable
from polhode.spec.models import SystemTable
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from collections.abc import Sequence

    from polhode.exact.free_body import FreeMotion
    from polhode.kinds.base import Figures, Overview, Spec
    from polhode.kinds.ensembles import Ensemble, ManySpecs
    from polhode.kinds.free_body.answers import FreeBodyReport


class FreeBody(AbstractKind[FreeBodyTable]):
    """The free rigid body."""

    name: ClassVar[str] = "free-body"
    table: ClassVar[type[SystemTable]] = FreeBodyTable
    in_closed_form: ClassVar[bool] = True
    reach: ClassVar[float] = math.inf  # closed forms are computed at any size
    is_default: ClassVar[bool] = True
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "inertia_ellipsoid", "components", "herpolhode")

    def report(self, spec: Spec[FreeBodyTable]) -> FreeBodyReport:
        from polhode.kinds.free_body.answers import make_report

        return make_report(spec)

    def closed_form(self, spec: Spec[FreeBodyTable]) -> FreeMotion:
        from polhode.kinds.free_body.answers import make_motion

        return make_motion(spec)

    def figures(self) -> Figures:
        from polhode.kinds.free_body.figures import FIGURES

        return FIGURES

    def overview(self) -> Overview:
        from polhode.kinds.free_body.figures import OVERVIEW

        return OVERVIEW

    def ensemble(
        self, samples: ManySpecs, names: Sequence[str], times: Float64[Array, "time"]
    ) -> Ensemble | None:
        from polhode.kinds.free_body.ensemble import evaluate_ensemble

        return evaluate_ensemble(samples, names, times)


KIND = FreeBody()

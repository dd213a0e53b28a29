"""The body that nothing acts on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.free_body.table import FreeBodyTable
from polhode.reports.base import AbstractReport

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class FreeBody(AbstractKind):
    """The body that nothing acts on."""

    name: ClassVar[str] = "free-body"
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "inertia_ellipsoid", "components", "herpolhode")

    @property
    def table(self) -> type[FreeBodyTable]:
        return FreeBodyTable

    def report(self, spec: Spec) -> AbstractReport:
        from polhode.kinds.free_body.answers import report_of

        return report_of(spec)

    def figures(self) -> Mapping[str, Callable[[Any], Figure | None]]:
        from polhode.kinds.free_body.figures import FIGURES

        return FIGURES


KIND = FreeBody()

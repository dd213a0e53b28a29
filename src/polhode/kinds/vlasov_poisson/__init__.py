"""A plasma of electrons that moves by its own field."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.vlasov_poisson.table import PlasmaTable
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake


class VlasovPoissonKind(AbstractKind):
    """A plasma of electrons that moves by its own field."""

    name: ClassVar[str] = "vlasov-poisson"
    table: ClassVar[type[SystemTable]] = PlasmaTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("field", "phase_space")
    sources: ClassVar[tuple[str, ...]] = ("polhode.systems.vlasov_poisson.VlasovPoisson",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        from polhode.kinds.vlasov_poisson.rules import plasma_rules

        return plasma_rules(tables["system"])


KIND = VlasovPoissonKind()

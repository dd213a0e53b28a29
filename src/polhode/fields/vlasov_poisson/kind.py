"""A plasma of electrons that moves in its own field."""

from __future__ import annotations

from typing import ClassVar

from polhode.fields.vlasov_poisson.table import PlasmaTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable


class VlasovPoissonKind(AbstractKind[PlasmaTable]):
    """A plasma of electrons that moves by its own field."""

    name: ClassVar[str] = "vlasov-poisson"
    table: ClassVar[type[SystemTable]] = PlasmaTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("field", "phase_space")


KIND = VlasovPoissonKind()

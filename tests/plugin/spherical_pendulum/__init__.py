"""A kind of another package: a mass on a rod that swings any way under its weight."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable
from polhode.spec.rules import Mistake
from spherical_pendulum.table import PendulumTable


class SphericalPendulumKind(AbstractKind):
    """A mass on a rod that swings any way under its weight."""

    name: ClassVar[str] = "spherical-pendulum"
    table: ClassVar[type[SystemTable]] = PendulumTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("path",)
    sources: ClassVar[tuple[str, ...]] = ("spherical_pendulum.system.SphericalPendulum",)

    def rules(self, tables: dict[str, Any]) -> Iterator[Mistake]:
        if "lean" not in tables["system"] and "rate" not in tables["system"]:
            yield ("system",), 'needs lean, like "30 deg", or rate, like "2 rad/s", for it hangs at rest without'


KIND = SphericalPendulumKind()

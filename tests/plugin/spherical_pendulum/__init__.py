"""A kind of another package: a mass on a rod that swings any way under its weight."""

from __future__ import annotations

from typing import ClassVar

from polhode.kinds import AbstractKind, SystemTable
from spherical_pendulum.table import PendulumTable


class SphericalPendulumKind(AbstractKind[PendulumTable]):
    """A mass on a rod that swings any way under its weight."""

    name: ClassVar[str] = "spherical-pendulum"
    table: ClassVar[type[SystemTable]] = PendulumTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("path",)


KIND = SphericalPendulumKind()

"""The spin of a moon or planet on its orbit."""

from __future__ import annotations

from typing import ClassVar

from polhode.celestial.spin_orbit.table import SpinOrbitTable
from polhode.kinds.base import AbstractKind
from polhode.spec.models import SystemTable


class SpinOrbitKind(AbstractKind[SpinOrbitTable]):
    """The spin of a moon or planet on its orbit."""

    name: ClassVar[str] = "spin-orbit"
    table: ClassVar[type[SystemTable]] = SpinOrbitTable
    has_attitude: ClassVar[bool] = False
    figure_names: ClassVar[tuple[str, ...]] = ("section", "motion")


KIND = SpinOrbitKind()

"""The gyrostat: a body with a rotor inside."""

from __future__ import annotations

from typing import ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.spec.models import SystemTable


class GyrostatKind(AbstractKind[GyrostatTable]):
    """The gyrostat: a body with a rotor inside."""

    name: ClassVar[str] = "gyrostat"
    table: ClassVar[type[SystemTable]] = GyrostatTable
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")


KIND = GyrostatKind()

"""A body that loses energy, inside or by drag."""

from __future__ import annotations

from typing import ClassVar

from polhode.kinds.base import AbstractKind
from polhode.spacecraft.damped_body.table import DampedBodyTable
from polhode.spec.models import SystemTable


class DampedBodyKind(AbstractKind[DampedBodyTable]):
    """A body that loses energy, inside or by drag."""

    name: ClassVar[str] = "damped-body"
    table: ClassVar[type[SystemTable]] = DampedBodyTable
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "motion")


KIND = DampedBodyKind()

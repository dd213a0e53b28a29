"""The free body, on which nothing acts."""

from __future__ import annotations

import math
from typing import ClassVar

from polhode.kinds.base import AbstractKind
from polhode.kinds.free_body.table import FreeBodyTable
from polhode.spec.models import SystemTable


class FreeBody(AbstractKind[FreeBodyTable]):
    """The free rigid body."""

    name: ClassVar[str] = "free-body"
    table: ClassVar[type[SystemTable]] = FreeBodyTable
    in_closed_form: ClassVar[bool] = True
    reach: ClassVar[float] = math.inf  # closed forms are computed at any size
    is_default: ClassVar[bool] = True
    figure_names: ClassVar[tuple[str, ...]] = ("momentum_sphere", "inertia_ellipsoid", "components", "herpolhode")


KIND = FreeBody()

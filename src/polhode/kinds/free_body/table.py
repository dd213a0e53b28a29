"""The table [system] of a free body, which has no keys of its own."""

from __future__ import annotations

from typing import ClassVar

from polhode.spec.models import SystemTable


class FreeBodyTable(SystemTable):
    """A body without torques; the default of a spec without [system]."""

    cones: ClassVar[bool] = True
    kind: str = "free-body"

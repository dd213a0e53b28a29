"""The table [system] of a free body, which has no keys of its own."""

from __future__ import annotations

from polhode.spec.models import SystemTable


class FreeBodyTable(SystemTable):
    """A body that nothing acts on; a spec without [system] means it."""

    kind: str = "free-body"

"""diffrax, imported when something of it is first used: Taylor series need none of it, and it takes 0.4 CPU seconds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from diffrax import *  # noqa: F403  # pyright: ignore[reportWildcardImportFromLibrary]


def __getattr__(name: str) -> Any:
    import diffrax

    return getattr(diffrax, name)

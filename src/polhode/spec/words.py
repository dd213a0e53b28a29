"""Lists of keys as text, for messages."""

from __future__ import annotations

from collections.abc import Sequence


def list_words(keys: Sequence[str], last: str = "and") -> str:
    """Return keys as a phrase.

    >>> list_words(["a", "b", "c"]), list_words(["a", "b"], "or"), list_words([])
    ('a, b and c', 'a or b', 'none')
    """
    return f" {last} ".join(filter(None, (", ".join(keys[:-1]), *keys[-1:]))) or "none"

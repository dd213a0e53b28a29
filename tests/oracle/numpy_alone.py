"""Closed forms of any size by NumPy, as small ones are."""

import sys

import pytest

from polhode.exact import blocks


def numpy_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave all bodies and times to NumPy, which compiled kernels would take where they are many."""
    for name in ("MANY", "MANY_BODIES"):
        monkeypatch.setattr(blocks, name, sys.maxsize)

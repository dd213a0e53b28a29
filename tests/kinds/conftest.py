"""A package of somebody else's that brings a kind, found as an installed one is."""

import sys
from pathlib import Path

import pytest

from polhode.kinds import registry

PLUGIN = Path(__file__).resolve().parents[1] / "plugin"


@pytest.fixture(scope="session")
def plugin():
    """Have the spherical pendulum's package, with its entry point, on the path."""
    sys.path.insert(0, str(PLUGIN))
    registry._others.cache_clear()
    yield PLUGIN
    sys.path.remove(str(PLUGIN))
    registry._others.cache_clear()

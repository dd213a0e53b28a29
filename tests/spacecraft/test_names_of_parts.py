"""Torques, mounts and control laws that specs name: the wing's table has each under the name of its class."""

import importlib
import inspect
import pkgutil

import pytest

from polhode import spacecraft
from polhode._base.plugins.wings import wing_points
from polhode.spacecraft.rigid_body.named import LAWS, MOUNTS, TORQUES


def named_classes(base):
    """Return the classes of the wing with a name that derive from one, by walking it."""
    for found in pkgutil.walk_packages(spacecraft.__path__, "polhode.spacecraft."):
        module = importlib.import_module(found.name)
        for kind in vars(module).values():
            if inspect.isclass(kind) and issubclass(kind, base) and kind.__module__ == found.name and kind.name:
                yield kind


@pytest.mark.parametrize("family", [TORQUES, MOUNTS, LAWS], ids=lambda family: family.word)
def test_the_table_has_all_under_their_names(family):
    module, name = family.base
    base = getattr(importlib.import_module(module), name)
    listed = {point.name: point.load() for point in wing_points(family.group).values()}
    assert listed == {kind.name: kind for kind in named_classes(base)} and listed

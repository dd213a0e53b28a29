"""What ``dir`` shows of the package and of its rooms is what a user is meant to see."""

import inspect
import json
from types import ModuleType
from typing import Annotated, get_origin

import pytest

import polhode as ph

MOST = 50
"""Names at the top: what a user types in the first week."""
ROOMS = [name for name in dir(ph) if inspect.ismodule(getattr(ph, name))]


def strangers(room: ModuleType) -> list[str]:
    """Return the names in a room's ``dir`` that are modules, private, or another package's.

    Types of a spec's fields are annotated numbers, which say ``builtins``, from Python 3.12 on ``typing``.
    """
    found = []
    for name in dir(room):
        thing = getattr(room, name)
        annotated = get_origin(thing) is Annotated
        home = "polhode" if annotated else getattr(thing, "__module__", None) or "polhode"
        if inspect.ismodule(thing) or name.startswith("_") or not home.startswith("polhode"):
            found.append(name)
    return found


def test_the_top_has_few_names():
    assert len(dir(ph)) <= MOST and dir(ph) == sorted(ph.__all__)


@pytest.mark.parametrize("name", ROOMS)
def test_a_room_shows_what_is_meant(name):
    room = getattr(ph, name)
    assert sorted(dir(room)) == sorted(room.__all__)
    assert not strangers(room)


def test_a_leak_is_noticed():
    leaking = ModuleType("leaking")
    leaking.__dir__ = lambda: ["hat", "json", "loads"]
    leaking.hat, leaking.json, leaking.loads = ph.rotation.hat, json, json.loads
    assert strangers(leaking) == ["json", "loads"]

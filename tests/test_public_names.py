"""What ``dir`` shows of the package and of its rooms is what a user is meant to see."""

import ast
import importlib
import inspect
import json
from pathlib import Path
from types import ModuleType
from typing import get_origin

import pytest

import polhode as ph

MOST = 50
"""Names at the top: what a user types in the first week."""
ROOMS = [name for name in dir(ph) if inspect.ismodule(getattr(ph, name))]


def strangers(room: ModuleType) -> list[str]:
    """Return the names in a room's ``dir`` that are modules, private, or another package's.

    Types of a spec's fields and other aliases say ``builtins``, ``typing`` or ``collections.abc``.
    """
    found = []
    for name in dir(room):
        thing = getattr(room, name)
        alias = get_origin(thing) is not None
        home = "polhode" if alias else getattr(thing, "__module__", None) or "polhode"
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


# ---------------------------------------------------------------- packages of others, which see no more

PLUGIN = Path(__file__).parent / "plugin"


def hidden(source: str) -> list[str]:
    """Return what a file of another package imports of polhode that is no public name of a room, or of the top."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found += [one.name for one in node.names if one.name.startswith("polhode.")]
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "polhode":
            public = importlib.import_module(node.module).__all__ if node.module.count(".") < 2 else []
            found += [f"{node.module}.{one.name}" for one in node.names if one.name not in public]
    return found


@pytest.mark.parametrize("file", sorted(PLUGIN.rglob("*.py")), ids=lambda file: f"{file.parent.name}/{file.name}")
def test_packages_of_others_need_public_names_only(file):
    assert hidden(file.read_text("utf-8")) == []


def test_a_private_import_is_noticed():
    wrong = "import polhode.spec\nfrom polhode.motion._layout import ATTITUDE\nfrom polhode.kinds import Spec, registry"
    assert hidden(wrong) == ["polhode.spec", "polhode.motion._layout.ATTITUDE", "polhode.kinds.registry"]

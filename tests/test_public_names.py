"""No public name is lost: each that there was is there, or the changelog's table says what it is called now."""

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
NAMES = [line for line in (ROOT / "tests" / "public_names.txt").read_text().splitlines() if not line.startswith("#")]
ROW = re.compile(r"^\| `(ph\.[\w.]+)` \| `(ph\.[\w.]+)` \|$", re.MULTILINE)
MANY = re.compile(r"^\| (.+) of `(ph(?:\.\w+)*)` \| of `(ph(?:\.\w+)*)` \|$", re.MULTILINE)  # which keep their names


def moves(text):
    """Return {old: new} of the rows that have one name on either side, or list names by their packages."""
    pairs = [*ROW.findall(text), *((f"{old}.{name}", f"{new}.{name}") for names, old, new in MANY.findall(text)
                                   for name in re.findall(r"`(\w+)`", names))]  # fmt: skip
    return {old.replace("ph", "polhode", 1): new.replace("ph", "polhode", 1) for old, new in pairs}


def resolves(name):
    package, _, attribute = name.rpartition(".")
    try:
        return hasattr(importlib.import_module(package), attribute) or importlib.util.find_spec(name) is not None
    except ModuleNotFoundError:
        return False


def lost(names, table):
    """Return the names that are neither where they were nor where the table has them or their package."""
    def now(name):
        package, _, attribute = name.rpartition(".")
        return table.get(name, f"{table.get(package, package)}.{attribute}")

    return [name for name in names if not resolves(name) and not resolves(now(name))]


@pytest.mark.long
def test_each_is_there_or_its_new_name_is_told():
    assert len(NAMES) > 600
    assert lost(NAMES, moves((ROOT / "CHANGELOG.md").read_text("utf-8"))) == []


@pytest.mark.parametrize(("table", "gone"), [
    ("", ["polhode.systems.KeplerOrbits"]),
    ("| `ph.systems.KeplerOrbits` | `ph.systems.KeplerOrbit` |", []),
    ("| `ph.systems.KeplerOrbits` | `ph.spacecrafts.KeplerOrbit` |", ["polhode.systems.KeplerOrbits"]),
    ("| `KeplerOrbit`, `KeplerOrbits` of `ph.systems` | of `ph.spacecrafts` |", ["polhode.systems.KeplerOrbits"]),
])  # fmt: skip
def test_a_name_that_went_without_a_word_is_found(table, gone):
    assert lost(["polhode.systems.KeplerOrbits", "polhode.systems.KeplerOrbit"], moves(table)) == gone

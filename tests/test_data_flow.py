"""The page on the code's structure: its lists of files come from docstrings, and name every module of every room."""

import importlib.util
import re
import tomllib
from pathlib import Path

from kinds_contract import KindsAreBlindToEachOther

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "data_flow.md").read_text("utf-8")
SPEC = importlib.util.spec_from_file_location("module_lists", ROOT / "docs" / "module_lists.py")
assert SPEC and SPEC.loader
module_lists = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(module_lists)
OWN = {ROOT / "src" / "polhode" / name for name in ("__init__.py", "__main__.py")}  # the package's, of no room
MODULES = sorted(set((ROOT / "src" / "polhode").rglob("*.py")) - OWN)


def listed_rooms():
    return [room for names in re.findall(r"^```\{files\} (.+)$", PAGE, re.MULTILINE) for room in names.split()]


def test_every_room_has_a_paragraph_and_a_list():
    assert sorted(listed_rooms()) == sorted(module_lists.rooms())
    for heading, text in re.findall(r"^### ([^\n]+)\n\n(.+?)```\{files\}", PAGE, re.MULTILINE | re.DOTALL):
        assert len(text.strip().split("\n\n")) == 1, heading
        assert all(room in listed_rooms() for room in re.findall(r"`(\w+)`", heading))


def test_every_module_is_listed():
    lines = "\n".join(module_lists.markdown_list(room) for room in listed_rooms()).splitlines()
    named = [re.match(r"- `([^`]+)`: ", line)[1] for line in lines]
    assert sorted(named) == sorted(path.relative_to(module_lists.PACKAGE).as_posix() for path in MODULES)


def test_the_first_line_of_a_module_stands_alone():
    """It is an entry of a list: a sentence or phrase on one line, which says more than the file's name."""
    words = {path: module_lists.purpose(path) for path in MODULES}
    poor = [path for path, said in words.items() if not said.endswith((".", "!", "?")) or len(said.split()) < 3]
    split = [path for path, said in words.items() if said.count("`") % 2 or said.count("(") != said.count(")")]
    assert not poor and not split


def test_the_layers_are_those_that_are_checked():
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]["contracts"]
    (layers,) = (contract["layers"] for contract in contracts if contract["type"] == "layers")
    assert PAGE.split("```")[1].split("\n")[1:-1] == layers


def test_files_that_the_page_names_are_there():
    for name in re.findall(r"`(?:(\w+)/)?(\w+\.py)`", re.sub(r"```.*?```", "", PAGE, flags=re.DOTALL)):
        found = [path for path in MODULES if path.name == name[1] and (not name[0] or path.parent.name == name[0])]
        assert found, "/".join(name)


class Graph:
    """Imports between the modules of a package, as import-linter has them."""

    def __init__(self, **imports):
        self.imports = {f"p.{name}".replace("__", "."): {f"p.{x}" for x in others} for name, others in imports.items()}

    def find_descendants(self, module):
        return {x for x in self.imports if x.startswith(f"{module}.")}

    def find_children(self, module):
        return {x for x in self.find_descendants(module) if x.count(".") == module.count(".") + 1}

    def find_modules_directly_imported_by(self, module):
        return self.imports[module]


def test_a_kind_that_imports_another_is_seen():
    contract = KindsAreBlindToEachOther("kinds", {}, {"packages": ["p", "p.wing"]})
    beside = {"base": (), "one": ("base",), "one__table": ("base", "one"), "two": (), "wing": ()}
    assert contract.check(Graph(**beside, two__table=("base", "two")), False).kept
    broken = contract.check(Graph(**beside, two__table=("base", "one.table")), False)
    assert not broken.kept and broken.metadata["wrong"] == [("p.two.table", "p.one.table")]
    wing = {"wing__three": ("two",), "wing__three__table": (), "wing__shared": (), "wing__shared__start": ("two",)}
    broken = contract.check(Graph(**beside, two__table=(), **wing), False)
    assert not broken.kept and broken.metadata["wrong"] == [("p.wing.three", "p.two")]
    assert not contract.check(Graph(base=()), False).kept  # where there are no kinds, nothing is checked

"""The contract between core, application and wings finds what crosses; lists and docstrings of wings are true."""

import ast
import re
import tomllib
from pathlib import Path

import pytest

from polhode._base.plugins.wings import wing_names
from wings_contract import WingsAreBlindToEachOther

ROOT = Path(__file__).parents[1]
ROOMS = {"application": ["formats"], "wings": ["spacecraft", "spectra"]}
GOOD = {"formats.form": {"core"}, "spectra.rotor": {"core", "formats.form", "spectra.spin"}, "spectra.spin": set(),
        "core": set(), "spacecraft.aem": {"formats.form"}}  # fmt: skip


class Graph:
    """Modules of a package p with what they import, as import-linter asks for them."""

    def __init__(self, imports):
        self.imports = {f"p.{one}": {f"p.{other}" for other in others} | {"numpy"} for one, others in imports.items()}
        self.modules = set(self.imports)

    def find_modules_directly_imported_by(self, module):
        return self.imports[module]


@pytest.mark.parametrize("changed", [
    {}, {"core": {"formats.form"}}, {"core": {"spectra.rotor"}}, {"formats.form": {"spectra.rotor"}},
    {"spacecraft.aem": {"spectra.rotor"}},
])  # fmt: skip
def test_what_crosses_is_found(changed):
    contract = WingsAreBlindToEachOther("wings", {}, {"package": "p", **ROOMS})
    check = contract.check(Graph(GOOD | changed), False)
    assert check.metadata["breaches"] == [(one, *others) for one, others in changed.items()]
    assert check.kept == (not changed)


def test_rooms_of_the_settings_are_there():
    """A wing without a table, or a table in a room that the settings have for another, would be seen by nobody."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]["contracts"]
    rooms = next(one for one in settings if one["type"] == "wings")
    assert sorted(rooms["wings"]) == sorted(wing_names())
    for room in rooms["application"]:
        assert any((ROOT / "src" / "polhode" / name).exists() for name in (room, f"{room}.py")), room


WING_NAMES = sorted(wing_names())
CITED = r"((?:(?:[A-Z][\w'’]+)(?:, | and | et al\. | ))+)(?:on [a-z ]+)?\((\d{4})\)"  # "Moffatt (2000)"
OWN = "no formulas of its own"


def read_wing(wing):
    """Return the docstring of a wing's package, and the texts of its other modules."""
    folder = ROOT / "src" / "polhode" / wing
    package = folder / "__init__.py"
    texts = [path.read_text("utf-8") for path in sorted(folder.rglob("*.py")) if path != package]
    return ast.get_docstring(ast.parse(package.read_text("utf-8"))), texts


def taken_rooms(texts):
    """Return the rooms of the package that modules import, at any depth of their code."""
    rooms = set()
    for node in (node for text in texts for node in ast.walk(ast.parse(text))):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("polhode."):
            rooms.add(node.module.split(".")[1])
        elif isinstance(node, ast.ImportFrom) and node.module == "polhode":
            rooms |= {name.name for name in node.names}
    return rooms


def untrue_words(said, texts):
    """Return what a wing's docstring cites or takes, and its modules do not; all of it if one of three parts lacks."""
    said = " ".join(said.split())
    answers, _, taken = said.partition("From the core it takes ")
    sources = re.findall(CITED, answers)
    if "It answers " not in answers or not (sources or OWN in answers) or not re.search(r"``\w+``", taken):
        return [said]
    wrong = [room for room in re.findall(r"``(\w+)``", taken) if room not in {"ph", *taken_rooms(texts)}]
    for names, year in sources:
        authors = set(re.findall(r"[A-Z][\w'’]+", names)) - {"Sources"}
        if not any(year in text and all(author in text for author in authors) for text in texts):
            wrong.append(f"{names}({year})")
    return wrong


@pytest.mark.parametrize("wing", WING_NAMES)
def test_what_a_wing_says_of_itself_is_so(wing):
    """A stranger begins there: the authors are cited in a module of the wing, and it imports the rooms it names.

    `rolling` said that it takes certificates, and `spacecraft` integrators, which they do not import.
    """
    assert untrue_words(*read_wing(wing)) == []


@pytest.mark.parametrize(("said", "wrong"), [
    ("It answers all. Sources: Euler and Poinsot (1834). From the core it takes motions (``exact``).", []),
    ("It answers all. Sources: Euler and Poinsot (1835). From the core it takes motions (``exact``).",
     ["Euler and Poinsot (1835)"]),
    ("It answers all. Sources: Jacobi (1834). From the core it takes motions (``exact``).", ["Jacobi (1834)"]),
    ("It answers all, by Poinsot (1834). From the core it takes ``exact`` and ``taylor``.", ["taylor"]),
    ("It answers all. It has no formulas of its own. From the core it takes ``exact``.", []),
    *((said, [said]) for said in (
        "It answers all, by Poinsot (1834).", "By Poinsot (1834). From the core it takes ``exact``.",
        "It answers all. From the core it takes ``exact``.")),
])  # fmt: skip
def test_untrue_words_are_found(said, wrong):
    text = '"""Source: Euler & Poinsot, Théorie nouvelle (1834)."""\nfrom polhode.exact.free_body import FreeMotion\n'
    assert untrue_words(said, [text]) == wrong

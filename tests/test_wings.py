"""The contract between core, application and wings finds what crosses, and its lists are those of the package."""

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

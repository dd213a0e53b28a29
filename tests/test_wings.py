"""The table of subjects says of every module whose it is, and the contract by it finds what crosses."""

import re
from pathlib import Path

import pytest

from wings_contract import Wings, WingsAreBlindToEachOther

ROOT = Path(__file__).parents[1]
TABLE = ROOT / "tests" / "wings.toml"
WINGS = Wings.read(TABLE)
MODULES = [path.relative_to(ROOT / "src" / "polhode").with_suffix("").as_posix()
           for path in (ROOT / "src" / "polhode").rglob("*.py")]  # fmt: skip
SMALL = """
between = [{ from = "judging", to = "spacecraft", reason = "attitude files" }]
[[subject]]
name = "spectra"
modules = ["quantum(/|$)"]
[[subject]]
name = "spacecraft"
modules = ["formats/aem"]
[[subject]]
name = "judging"
modules = ["judge"]
[[subject]]
name = "app"
modules = ["formats"]
[[subject]]
name = "core"
modules = [""]
[tolerated]
"formats.form" = ["quantum.rotor"]
"""


def test_every_pattern_has_a_module():
    for name, pattern in WINGS.subjects:
        for one in pattern.pattern.split("|") if name != "core" and "(" not in pattern.pattern else [pattern.pattern]:
            assert any(re.match(one, module) for module in MODULES), (name, one)


class Graph:
    """Modules of a package p with what they import, as import-linter asks for them."""

    def __init__(self, **imports):
        self.imports = {f"p.{name.replace('__', '.')}": {f"p.{other}" for other in others} | {"numpy"}
                        for name, others in imports.items()}  # fmt: skip
        self.modules = set(self.imports)

    def find_modules_directly_imported_by(self, module):
        return self.imports[module]


GOOD = {"formats__form": {"quantum.rotor", "core"}, "quantum__rotor": {"core", "formats.form"}, "core": set(),
        "judge": {"formats.aem", "formats.form"}, "formats__aem": {"formats.form"}}  # fmt: skip


@pytest.mark.parametrize(("changed", "new", "gone"), [
    ({}, [], []),
    ({"core": {"formats.form"}}, [("core", "formats.form")], []),
    ({"core": {"quantum.rotor"}}, [("core", "quantum.rotor")], []),
    ({"formats__aem": {"quantum.rotor"}}, [("formats.aem", "quantum.rotor")], []),
    ({"quantum__rotor": {"formats.aem"}}, [("quantum.rotor", "formats.aem")], []),
    ({"formats__form": {"core"}}, [], [("formats.form", "quantum.rotor")]),
])  # fmt: skip
def test_what_crosses_is_found(changed, new, gone, tmp_path):
    (tmp_path / "wings.toml").write_text(SMALL)
    contract = WingsAreBlindToEachOther("wings", {}, {"package": "p", "table": str(tmp_path / "wings.toml")})
    check = contract.check(Graph(**GOOD | changed), False)
    assert (check.kept, check.metadata["new"], check.metadata["gone"]) == (not new and not gone, new, gone)

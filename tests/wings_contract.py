"""The contract of ``lint-imports`` between core, application and wings, by ``wings.toml``."""

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from importlinter import Contract, ContractCheck, fields, output

Import = tuple[str, str]
JOINS = {"core": {"core"}, "app": {"core", "app"}}  # of the two subjects that are no wings, what they may import


class Wings(NamedTuple):
    """What a table of subjects says.

    Attributes:
        subjects: names with the patterns of their modules; the first that matches decides.
        between: pairs of wings of which the first may import the second.
        tolerated: imports that should not be, and have not gone yet.
    """

    subjects: tuple[tuple[str, re.Pattern[str]], ...]
    between: frozenset[Import]
    tolerated: frozenset[Import]

    @classmethod
    def read(cls, path: Path) -> "Wings":
        table = tomllib.loads(path.read_text("utf-8"))
        return cls(
            tuple((one["name"], re.compile("|".join(one["modules"]))) for one in table["subject"]),
            frozenset((one["from"], one["to"]) for one in table["between"]),
            frozenset((one, other) for one, others in table.get("tolerated", {}).items() for other in others),
        )

    def subject(self, module: str) -> str:
        """Return the subject of a module by its dotted name below the package."""
        return next(name for name, pattern in self.subjects if pattern.match(module.replace(".", "/")))

    def may_import(self, one: str, other: str) -> bool:
        """Whether a module of one subject may import one of another."""
        return other in JOINS.get(one, {"core", "app", one}) or (one, other) in self.between

    def breaches(self, imports: Mapping[str, set[str]]) -> set[Import]:
        """Return the imports, by modules below the package, that should not be."""
        return {(one, other) for one, others in imports.items() for other in others
                if not self.may_import(self.subject(one), self.subject(other))}  # fmt: skip


class WingsAreBlindToEachOther(Contract):
    """The core imports no application, the application no wing, a wing no other, but for what a table names.

    Attributes:
        package: the whole.
        table: TOML, from the folder of the settings.
    """

    type_name = "wings"
    package = fields.StringField()
    table = fields.StringField()

    def check(self, graph: Any, verbose: bool) -> ContractCheck:
        wings, top = Wings.read(Path(self.table)), f"{self.package}."
        below = [module for module in graph.modules if module.startswith(top)]
        direct = {module: graph.find_modules_directly_imported_by(module) for module in below}
        imports = {module.removeprefix(top): {other.removeprefix(top) for other in others if other.startswith(top)}
                   for module, others in direct.items()}  # fmt: skip
        found = wings.breaches(imports)
        new, gone = sorted(found - wings.tolerated), sorted(wings.tolerated - found)
        return ContractCheck(kept=bool(imports) and not new and not gone, metadata={"new": new, "gone": gone})

    def render_broken_contract(self, check: ContractCheck) -> None:
        for one, other in check.metadata["new"]:
            output.print_error(f"{one} imports {other}, of another subject. Move what both need, or {other} there.")
        for one, other in check.metadata["gone"]:
            output.print_error(f"{one} does not import {other} any more: take that line out of {self.table}.")

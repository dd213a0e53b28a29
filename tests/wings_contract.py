"""The contract of ``lint-imports`` between core, application and wings: rooms of the package, by its settings."""

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from importlinter import Contract, ContractCheck, fields, output

Import = tuple[str, str]
CORE, APPLICATION = "the core", "the application"


class Rooms(NamedTuple):
    """Which rooms of the package are of what: the rest is the core."""

    application: frozenset[str]
    wings: frozenset[str]

    def subject(self, module: str) -> str:
        """Return the subject of a module by its dotted name below the package."""
        room = module.partition(".")[0]
        return room if room in self.wings else APPLICATION if room in self.application else CORE

    def may_import(self, one: str, other: str) -> bool:
        """Whether a module of one subject may import one of another."""
        return other in {CORE, one} or (other == APPLICATION and one != CORE)

    def breaches(self, imports: Mapping[str, Iterable[str]]) -> list[Import]:
        """Return the imports, by modules below the package, that should not be."""
        return sorted((one, other) for one, others in imports.items() for other in others
                      if not self.may_import(self.subject(one), self.subject(other)))  # fmt: skip


class WingsAreBlindToEachOther(Contract):
    """The core imports neither application nor wing, the application no wing, a wing no other.

    Attributes:
        package: the whole.
        application: its rooms that join subjects.
        wings: its rooms that are one subject each.
    """

    type_name = "wings"
    package = fields.StringField()
    application = fields.SetField(subfield=fields.StringField())
    wings = fields.SetField(subfield=fields.StringField())

    def check(self, graph: Any, verbose: bool) -> ContractCheck:
        rooms, top = Rooms(frozenset(self.application), frozenset(self.wings)), f"{self.package}."
        below = [module for module in graph.modules if module.startswith(top)]
        direct = {module: graph.find_modules_directly_imported_by(module) for module in below}
        imports = {module.removeprefix(top): {other.removeprefix(top) for other in others if other.startswith(top)}
                   for module, others in direct.items()}  # fmt: skip
        breaches = rooms.breaches(imports)
        return ContractCheck(kept=bool(imports) and not breaches, metadata={"breaches": breaches})

    def render_broken_contract(self, check: ContractCheck) -> None:
        for one, other in check.metadata["breaches"]:
            output.print_error(f"{one} imports {other}, of another subject. Move what both need, or {other} there.")

"""The contract of ``lint-imports`` that kinds do not import each other.

A kind is a package that has a module ``table``; what lies beside is what all kinds are made with, or what wings share.
import-linter's own contract of independence would take that for kinds too, and need exceptions.
"""

from typing import Any

from importlinter import Contract, ContractCheck, fields, output


class KindsAreBlindToEachOther(Contract):
    """No module of a kind imports one of another kind.

    Attributes:
        packages: whose packages are the kinds, where they have a table.
    """

    type_name = "blind kinds"
    packages = fields.ListField(subfield=fields.StringField())

    def check(self, graph: Any, verbose: bool) -> ContractCheck:
        beside = [package for each in self.packages for package in graph.find_children(each)]
        kinds = {package for package in beside if f"{package}.table" in graph.find_children(package)}
        wrong = [
            (module, other)
            for kind in sorted(kinds)
            for module in sorted({kind, *graph.find_descendants(kind)})
            for other in sorted(graph.find_modules_directly_imported_by(module))
            if owner(other, kinds) not in (None, kind)
        ]
        return ContractCheck(kept=bool(kinds) and not wrong, metadata={"wrong": wrong, "kinds": len(kinds)})

    def render_broken_contract(self, check: ContractCheck) -> None:
        if not check.metadata["kinds"]:
            output.print_error(f"{', '.join(self.packages)} have no kinds.")
        for module, other in check.metadata["wrong"]:
            output.print_error(f"{module} imports {other}, of another kind.")


def owner(module: str, kinds: set[str]) -> str | None:
    """Return the kind that a module belongs to, None for what stands beside them."""
    return next((kind for kind in kinds if module == kind or module.startswith(f"{kind}.")), None)

"""The contract of ``lint-imports`` that kinds do not import each other: each folder of ``polhode.kinds`` is one.

The files beside the folders are what all kinds are made with, and no kinds. import-linter's own contract of
independence would take them for some, and need exceptions.
"""

from typing import Any

from importlinter import Contract, ContractCheck, fields, output


class KindsAreBlindToEachOther(Contract):
    """No module of a kind imports one of another kind.

    Attributes:
        package: whose packages are the kinds.
    """

    type_name = "blind kinds"
    package = fields.StringField()

    def check(self, graph: Any, verbose: bool) -> ContractCheck:
        kinds = {kind for kind in graph.find_children(self.package) if graph.find_children(kind)}
        wrong = [
            (module, other)
            for kind in sorted(kinds)
            for module in sorted({kind, *graph.find_descendants(kind)})
            for other in sorted(graph.find_modules_directly_imported_by(module))
            if other.startswith(f"{self.package}.") and owner(other, kinds) not in (None, kind)
        ]
        return ContractCheck(kept=bool(kinds) and not wrong, metadata={"wrong": wrong, "kinds": len(kinds)})

    def render_broken_contract(self, check: ContractCheck) -> None:
        if not check.metadata["kinds"]:
            output.print_error(f"{self.package} has no packages.")
        for module, other in check.metadata["wrong"]:
            output.print_error(f"{module} imports {other}, of another kind.")


def owner(module: str, kinds: set[str]) -> str | None:
    """Return the kind that a module belongs to, None for what stands beside them."""
    return next((kind for kind in kinds if module == kind or module.startswith(f"{kind}.")), None)

"""Reads formulas: from Python as ``ast`` has it to the typed tree, with whatever they need of other modules.

What a printer could not say, such as a dictionary, a method or a comprehension, is refused with its file and line.
Types come from the annotations of parameters and fields; those of everything else follow.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator
from graphlib import TopologicalSorter
from typing import NamedTuple

from printing.sources import Source, source
from printing.statements import Body, NotAFormula, is_assignable
from printing.tree import (
    FLAG,
    NUMBER,
    ROW,
    SUM,
    WHOLE,
    Constant,
    Definition,
    Function,
    Module,
    Notes,
    Record,
    Section,
    Structure,
    Tuple,
    Type,
    records_in,
)
from printing.words import is_word

SCALARS: dict[str, Type] = {
    "float": NUMBER, "bool": FLAG, "int": WHOLE, "Number": NUMBER, "Truth": FLAG, "Any": NUMBER,
    "Sum": SUM,
}  # fmt: skip
Resolve = Callable[[str], tuple[Source, str] | None]


class Root(NamedTuple):
    """A function, or a constant, that is asked for.

    Attributes:
        module, name: where it stands.
        given: module whose functions take the place of those that are ``@given``; it then belongs to that module.
    """

    module: str
    name: str
    given: str | None = None


def read(roots: Iterable[Root]) -> tuple[Module, ...]:
    """Return the modules of functions and all that these need, each after those that it needs."""
    reader = Reader()
    for module, name, given in roots:
        reader.definition(source(module), name, source(given) if given else None)
    return tuple(reader.modules())


class Reader:
    """Keeps what it has read, by module and name."""

    def __init__(self) -> None:
        self.found: dict[tuple[str, str], Constant | Structure | Function] = {}

    def find(self, origin: Source, name: str) -> Constant | Record | Function:
        """Return what a formula meets in another place."""
        found = self.definition(origin, name)
        return found.record if isinstance(found, Structure) else found

    def definition(self, origin: Source, name: str, given: Source | None = None) -> Constant | Structure | Function:
        key = (given or origin).name, name
        if key not in self.found:
            match origin.defined[name]:
                case ast.FunctionDef() as node:
                    self.found[key] = self._function(origin, node, given)
                case ast.ClassDef() as node:
                    self.found[key] = self._structure(origin, node)
                case node:
                    self.found[key] = self._constant(origin, name, node)
        return self.found[key]

    # ------------------------------------------------------------------ types

    def type_of(self, origin: Source, node: ast.expr | None) -> Type | None:
        """Return the type that an annotation says, None where it leaves it open."""
        match node:
            case ast.Name(id=name) if name in SCALARS:
                return SCALARS[name]
            case ast.Name(id=name) if place := origin.origin(name):
                defined = place[0].defined[place[1]]
                if isinstance(defined, ast.ClassDef):
                    found = self.definition(*place)
                    return found.record if isinstance(found, Structure) else None
                return self.type_of(place[0], getattr(defined, "value", None))
            case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=elements)):
                items = [self.type_of(origin, x) for x in elements]
                return None if None in items else Tuple(tuple(x for x in items if x is not None))
        return None

    def _type_of_parameter(self, origin: Source, node: ast.arg, function: str) -> Type:
        if _is_any(node.annotation):
            return ROW
        return self._certain(origin, node.annotation, f"`{node.arg}` of {function}")

    def _certain(self, origin: Source, node: ast.expr | None, what: str) -> Type:
        found = self.type_of(origin, node)
        if found is None:
            raise NotAFormula(f"{origin.name}: {what} has no type that a printer could say")
        return found

    # ------------------------------------------------------------------ definitions

    def _function(self, origin: Source, node: ast.FunctionDef, given: Source | None) -> Function:
        arguments = node.args
        if arguments.vararg or arguments.kwonlyargs or arguments.kwarg or arguments.defaults:
            raise NotAFormula(f"{origin.name}, line {node.lineno}: {node.name} takes more than a list of parameters")

        def resolve(name: str) -> tuple[Source, str] | None:
            place = origin.origin(name)
            return (given, name) if given and place and _is_given(place[0].defined[place[1]]) else place

        parameters = {x.arg: self._type_of_parameter(origin, x, node.name) for x in arguments.args}
        if given:
            parameters |= self._asked_of(node, parameters, resolve)
        body = Body(origin, node, parameters, resolve, self.find)
        statements = body.statements(node.body, node.body[0].lineno - 1)
        kinds = set(body.returned)
        is_open = node.returns is None or any(_is_any(x) for x in ast.walk(node.returns))
        said = None if is_open else self.type_of(origin, node.returns)
        if len(kinds) != 1 or not (said is None or is_assignable(next(iter(kinds)), said)):
            raise NotAFormula(f"{origin.name}, line {node.lineno}: {node.name} returns {kinds}, not {said}")
        result = said if isinstance(said, Record) else kinds.pop()
        docstring, calls = ast.get_docstring(node) or "", frozenset(body.calls)
        return Function(node.name, docstring, tuple(parameters.items()), result, statements, calls)

    def _asked_of(
        self, node: ast.FunctionDef, parameters: dict[str, Type], resolve: Resolve
    ) -> Iterator[tuple[str, Type]]:
        """Yield the types of parameters that are ``Any``: what a function that they are handed to asks for."""
        for call in (x for x in ast.walk(node) if isinstance(x, ast.Call)):
            place = resolve(call.func.id) if isinstance(call.func, ast.Name) else None
            asked = self.find(*place) if place and not is_word(*place) else None
            if not isinstance(asked, Function):
                continue
            for value, (_, kind) in zip(call.args, asked.parameters, strict=False):
                if isinstance(value, ast.Name) and parameters.get(value.id) == ROW != kind:
                    yield value.id, kind

    def _structure(self, origin: Source, node: ast.ClassDef) -> Structure:
        fields, notes, after = [], [], node.body[0].end_lineno or node.lineno
        for line in node.body:
            if isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name):
                name = line.target.id
                fields.append((name, self._certain(origin, line.annotation, f"{node.name}.{name}")))
                notes.append(origin.notes(line, after))
                after = line.end_lineno or line.lineno
        record = Record(node.name, origin.name, tuple(fields))
        return Structure(record, ast.get_docstring(node) or "", tuple(notes))

    def _constant(self, origin: Source, name: str, node: ast.stmt) -> Constant:
        value = origin.value(name)
        kind = _type_of_value(value)
        if kind is None or not isinstance(node, ast.Assign | ast.AnnAssign) or node.value is None:
            raise NotAFormula(f"{origin.name}, line {node.lineno}: `{name}` is neither a number nor a tuple of these")
        target = node.targets[0] if isinstance(node, ast.Assign) else node.target
        is_first = name == next(x.id for x in ast.walk(target) if isinstance(x, ast.Name))
        notes = origin.notes(node, origin.line_above(node.lineno)) if is_first else Notes()
        return Constant(name, value, kind, _source_of(node, name), notes)

    # ------------------------------------------------------------------ modules

    def modules(self) -> Iterator[Module]:
        needed: dict[str, set[str]] = {module: set() for module, _ in self.found}
        for (module, _), found in self.found.items():
            needed[module] |= _modules_of(found) - {module}
        for name in TopologicalSorter(needed).static_order():
            origin = source(name)
            aliases = {
                alias: kind for alias, node in origin.defined.items()
                if isinstance(node, ast.Assign) and isinstance(kind := self.type_of(origin, node.value), Tuple)
            }  # fmt: skip
            yield Module(name, origin.docstring, tuple(self._definitions(origin)), aliases)

    def _definitions(self, origin: Source) -> Iterator[Definition]:
        """Yield what was asked for in the order of the source; copies of functions that stand elsewhere come last."""
        title, after = None, 0
        for name, node in origin.defined.items():
            title = origin.section(after, node.lineno) or title
            after = node.lineno
            if found := self.found.get((origin.name, name)):
                if title:
                    yield Section(title)
                    title = None
                yield found
        copies = (x for (module, name), x in self.found.items() if module == origin.name and name not in origin.defined)
        yield from copies


def _modules_of(found: Constant | Structure | Function) -> set[str]:
    match found:
        case Function(parameters=parameters, type=kind, calls=calls):
            kinds = (kind, *(each for _, each in parameters))
            return {there for there, _ in calls if there} | {x.module for each in kinds for x in records_in(each)}
        case Structure(record):
            return {x.module for x in records_in(record)}
    return set()


def _is_any(annotation: ast.AST | None) -> bool:
    return isinstance(annotation, ast.Name) and annotation.id == "Any"


def _is_given(node: ast.stmt) -> bool:
    decorators = node.decorator_list if isinstance(node, ast.FunctionDef) else []
    return any(isinstance(x, ast.Name) and x.id == "given" for x in decorators)


def _type_of_value(value: object) -> Type | None:
    match value:
        case bool():
            return FLAG
        case int():
            return WHOLE
        case float():
            return NUMBER
        case tuple() if value:
            items = [_type_of_value(x) for x in value]
            return None if None in items else Tuple(tuple(x for x in items if x is not None))
    return None


def _source_of(node: ast.Assign | ast.AnnAssign, name: str) -> str:
    """Return the arithmetic of a constant; nothing where it is written out, or comes from elsewhere."""
    value = node.value
    target = node.targets[0] if isinstance(node, ast.Assign) else node.target
    if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
        value = value.elts[[x.id for x in target.elts if isinstance(x, ast.Name)].index(name)]
    parts = {type(x) for x in ast.walk(value)} if value else set()
    return ast.unparse(value) if value and ast.BinOp in parts and ast.Name not in parts else ""

"""Rust from the tree of the formulas: tuples are tuples, records structs that are borrowed, names are shadowed.

A package of Python becomes a module, so that names need nothing before them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from printing.expressions import (
    ATOM,
    CHOICE,
    COUNTS,
    PAIR,
    STEP,
    Definitions,
    Language,
    all_of,
    as_asked,
    assigned,
    comment,
    field_of,
    lines_of,
    names_of,
    said,
)
from printing.layout import Document, Group, Line, Nest, enclosed
from printing.tree import (
    NUMBER,
    Assign,
    Call,
    Choice,
    Constant,
    Expression,
    Field,
    Function,
    If,
    Item,
    Leave,
    Make,
    Module,
    Name,
    Notes,
    Record,
    Repeat,
    Return,
    Row,
    Scalar,
    Statement,
    Structure,
    Target,
    Tuple,
    Type,
    items_of,
)

SCALARS = {"number": "f64", "flag": "bool", "whole": "i32", "sum": "Sum"}
RESERVED = {"as", "box", "fn", "in", "let", "loop", "match", "mod", "move", "ref", "self", "type", "use", "where"}
METHODS = {
    "square_root": "sqrt", "exponential": "exp", "floor": "floor", "abs": "abs",
    "arctangent": "atan", "angle_of": "atan2", "logarithm": "ln", "hyperbolic_sine": "sinh", "area_of_sine": "asinh",
}  # fmt: skip
"""Words by the names of a number's methods; the others are functions of the crate."""
CONSTANTS = {"pi": "std::f64::consts::PI", "nan": "f64::NAN", "inf": "f64::INFINITY"}


class Rust(Language):
    """A printer of definitions.

    Args:
        modules: that are printed.
        places: names of modules in Rust by those in Python.
    """

    def __init__(self, modules: Sequence[Module], places: Mapping[str, str]) -> None:
        super().__init__(modules)
        self.places = places
        self.aliases: dict[str, dict[str, str]] = {place: {} for place in places.values()}  # short names of types
        self.here = ""
        self.borrowed: set[str] = set()
        self.kept: set[str] = set()  # names whose value a branch or loop changes

    def short_names(self, place: str) -> Iterator[str]:
        """Print the short names of types that a module in Rust uses, once it has been printed."""
        return (f"type {name} = {text};" for name, text in self.aliases.get(place, {}).items())

    # ------------------------------------------------------------------ expressions

    def place(self, module: str, name: str) -> str:
        there = self.places[module]
        return name if there == self.here else f"{there}::{name}"

    def type(self, kind: Type) -> str:
        match kind:
            case Scalar():
                return SCALARS[kind.name]
            case Record():
                return self.place(kind.module, kind.name)
            case Tuple(items):
                text = f"({', '.join(self.type(item) for item in items)})"
                return self._alias(kind, text) if len(set(items)) == 1 else text
        raise TypeError(f"{kind} is no type of Rust")

    def _alias(self, kind: Tuple, text: str) -> str:
        """Return a short name for a tuple of items that are alike."""
        item, count = kind.items[0], COUNTS[len(kind.items)].capitalize()
        name = "Pair" if kind == PAIR else count if item == NUMBER else f"{count}{self.type(item)}s"
        self.aliases[self.here][name] = text
        return name

    def literal(self, value: float, kind: Type) -> str:
        if kind != NUMBER:
            return str(value).lower()
        text = repr(float(value))
        return {"nan": "f64::NAN", "inf": "f64::INFINITY", "-inf": "f64::NEG_INFINITY"}.get(text, text)

    def variable(self, name: str) -> str:
        return name + "_" if name in RESERVED else name

    def constant(self, module: str, name: str) -> str:
        return CONSTANTS[name] if module == "math" else self.place(module, name)

    def member(self, node: Item | Field) -> Document:
        index, name = field_of(node)
        row = f"[{index}]" if isinstance(node.of.type, Row) else f".{self.variable(name) if name else index}"
        return self.expression(node.of, ATOM), row

    def choice(self, node: Choice) -> tuple[Document, int]:
        test, yes, no = (self.expression(x) for x in (node.test, node.yes, node.no))
        inner = ("{", Nest((Line(), yes)), Line(), "} else {", Nest((Line(), no)), Line(), "}")
        return Group(("if ", test, " ", inner)), CHOICE

    def make(self, node: Make) -> Document:
        items = [self.expression(as_asked(x, kind)) for x, kind in zip(node.items, items_of(node.type), strict=True)]
        if not isinstance(node.type, Record):
            return enclosed("(", items, ")")
        names = [self.variable(name) for name, _ in node.type.fields]
        fields = [n if n == x else (f"{n}: ", x) for n, x in zip(names, items, strict=True)]
        return f"{self.type(node.type)} ", enclosed("{", fields, "}", " ")

    def call(self, node: Call) -> Document:
        if node.module:
            asked = self.asked[node.module, node.name]
            given = [self._handed_on(x, kind) for x, kind in zip(node.arguments, asked, strict=True)]
            return self.place(node.module, self.variable(node.name)), enclosed("(", given, ")")
        first, *rest = node.arguments
        if node.name not in METHODS:
            return node.name, enclosed("(", map(self.expression, node.arguments), ")")
        return self.expression(first, ATOM), f".{METHODS[node.name]}", enclosed("(", map(self.expression, rest), ")")

    def _handed_on(self, node: Expression, kind: Type) -> Document:
        text = self.expression(as_asked(node, kind))
        is_owned = not (isinstance(node, Name) and node.name in self.borrowed)
        return ("&", text) if isinstance(kind, Record) and is_owned else text

    # ------------------------------------------------------------------ statements

    def block(self, statements: Sequence[Statement], indent: int, is_last: bool) -> Iterator[str]:
        """Print statements; the last one of a function is its value."""
        for k, statement in enumerate(statements):
            yield from _comment(statement.notes, indent)
            yield from self._statement(statement, indent, is_last and k == len(statements) - 1)

    def _statement(self, statement: Statement, indent: int, is_last: bool) -> Iterator[str]:
        match statement:
            case Assign():
                value = self.expression(statement.value)
                yield from lines_of(assigned(self._target(statement), statement.value, value), indent)
            case Return(value):
                text = self.expression(value)
                yield from lines_of(text if is_last else ("return ", text, ";"), indent)
            case Leave():
                yield from lines_of("break;", indent)
            case If():
                yield from lines_of(("if ", self.expression(statement.test), " {"), indent)
                yield from self.block(statement.body, indent + STEP, is_last)
                if statement.otherwise:
                    yield from lines_of("} else {", indent)
                    yield from self.block(statement.otherwise, indent + STEP, is_last)
                yield from lines_of("}", indent)
            case Repeat(name=k):
                first, end = self.expression(statement.first), self.expression(statement.end)
                yield from lines_of((f"for {k} in ", first, "..", end, " {"), indent)
                yield from self.block(statement.body, indent + STEP, False)
                yield from lines_of("}", indent)

    def _target(self, node: Assign) -> str:
        names = {*names_of(node.target)}
        changed = (names & self.kept) - node.fresh
        if changed and changed != names:
            raise TypeError(f"{', '.join(sorted(names))}: of these a branch or loop changes only {', '.join(changed)}")
        return ("" if changed else "let ") + self._pattern(node.target, node.fresh)

    def _pattern(self, target: Target, fresh: frozenset[str]) -> str:
        if isinstance(target, str):
            return ("mut " if target in self.kept & fresh else "") + self.variable(target)
        return f"({', '.join(self._pattern(part, fresh) for part in target)})"

    # ------------------------------------------------------------------ definitions

    def definition(self, module: str, node: Definitions) -> Iterator[str]:
        self.here = self.places[module]
        match node:
            case Constant():
                yield from self._constant(node)
            case Structure():
                yield from self._structure(node)
            case Function():
                yield from self._function(node)

    def _constant(self, node: Constant) -> Iterator[str]:
        yield from _comment(node.notes, 0)
        text: Document = self.literal(node.value, node.type) if isinstance(node.value, float | int) else ""
        if isinstance(node.value, tuple):
            text = enclosed("(", [self.literal(x, NUMBER) for x in node.value], ")")
        yield from lines_of((f"pub const {node.name}: {self.type(node.type)} = ", text, ";"))

    def _structure(self, node: Structure) -> Iterator[str]:
        yield from comment(node.docstring, 0, "/// ", "/// ")
        yield "#[derive(Clone, Copy)]"
        yield f"pub struct {node.record.name} {{"
        for (name, kind), notes in zip(node.record.fields, node.notes, strict=True):
            yield from comment(said(notes), STEP, "/// ", "/// ")
            yield from lines_of(f"pub {self.variable(name)}: {self.type(kind)},", STEP)
        yield "}"
        yield ""

    def _function(self, node: Function) -> Iterator[str]:
        self.borrowed = {name for name, kind in node.parameters if isinstance(kind, Record)}
        inner = all_of([y for x in node.body for y in _inside(x)])
        self.kept = {name for x in inner if isinstance(x, Assign) for name in names_of(x.target) if name not in x.fresh}
        yield from comment(node.docstring, 0, "/// ", "/// ")
        given = [
            f"{self.variable(name)}: {'&' if name in self.borrowed else ''}{self.type(kind)}"
            for name, kind in node.parameters
        ]
        name = self.variable(node.name)
        yield from lines_of((f"pub fn {name}", enclosed("(", given, ")"), f" -> {self.type(node.type)} {{"))
        for name, _ in node.parameters:
            if name in self.kept:
                yield from lines_of(f"let mut {self.variable(name)} = {self.variable(name)};", STEP)
        yield from self.block(node.body, STEP, True)
        yield "}"
        yield ""


def _inside(node: Statement) -> Sequence[Statement]:
    return (*node.body, *node.otherwise) if isinstance(node, If) else node.body if isinstance(node, Repeat) else ()


def _comment(notes: Notes, indent: int) -> Iterator[str]:
    return comment(said(notes), indent, "// ", "// ")

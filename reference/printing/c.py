"""C from the tree of the formulas: C99 that C++ takes too, ``static inline`` functions and structs, nothing allocated.

A tuple becomes a struct: of two numbers ``hi`` and ``lo``, of more items that are alike an array ``at``, of different
ones ``first``, ``second`` and so on. A record becomes a struct with its fields and is handed on by its address.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator, Sequence

from printing.c_types import MATHEMATICS, global_name, maker, members, parameter, struct, type_name, variable
from printing.expressions import (
    ATOM,
    CHOICE,
    PAIR,
    STEP,
    Definitions,
    Language,
    as_asked,
    assigned,
    comment,
    field_of,
    filled,
    lines_of,
    names_of,
    rebound,
    said,
)
from printing.layout import Document, Group, Line, Nest
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
    Statement,
    Structure,
    Target,
    Tuple,
    Type,
    items_of,
)

WORDS = {
    "square_root": "sqrt", "exponential": "exp", "nearest": "rint", "abs": "fabs", "arctangent": "atan",
    "angle_of": "atan2", "logarithm": "log", "hyperbolic_sine": "sinh", "area_of_sine": "asinh",
}  # fmt: skip
"""Words by their names in <math.h>; what is not there is a function of the header itself."""
CONSTANTS = {"pi": repr(math.pi), "nan": "NAN", "inf": "INFINITY"}


class C(Language):
    """A printer of definitions; a struct is printed before the first one that needs it."""

    def __init__(self, modules: Sequence[Module]) -> None:
        super().__init__(modules)
        records = (x for m in modules for x in m.definitions if isinstance(x, Structure))
        self.described: dict[Type, Structure] = {x.record: x for x in records}
        self.structs: set[Type] = set()
        self.addresses: set[str] = set()  # names of what has come as an address
        self.rebound: set[str] = set()
        self.before: list[Document] = []  # what a statement needs before it
        self.taken: dict[str, int] = {}  # names that Python's text has not, and how often they are

    # ------------------------------------------------------------------ expressions

    def name(self, module: str, name: str) -> str:
        """Return the name of a function, without the underscore of a private one but told apart from a public one."""
        bare = name.lstrip("_")
        return global_name(module, f"{bare}_inside" if bare != name and (module, bare) in self.asked else bare)

    def literal(self, value: float, kind: Type) -> str:
        if kind != NUMBER:
            return str(int(value))
        text = repr(float(value))
        return {"nan": "NAN", "inf": "INFINITY", "-inf": "-INFINITY"}.get(text, text)

    def variable(self, name: str) -> str:
        return variable(name)

    def constant(self, module: str, name: str) -> str:
        return CONSTANTS[name] if module == "math" else global_name(module, name).upper()

    def member(self, node: Item | Field) -> Document:
        arrow = "->" if isinstance(node.of, Name) and node.of.name in self.addresses else "."
        return self.expression(node.of, ATOM), arrow + members(node.of.type)[field_of(node)[0]]

    def choice(self, node: Choice) -> tuple[Document, int]:
        yes, no = self.expression(node.yes, CHOICE + 1), self.expression(node.no)
        return Group((self.expression(node.test, CHOICE + 1), Nest((Line(), "? ", yes, Line(), ": ", no)))), CHOICE

    def make(self, node: Make) -> Document:
        return maker(node.type), "(", filled(self._handed_on(node.items, items_of(node.type))), ")"

    def call(self, node: Call) -> Document:
        if node.module:
            asked = self.asked[node.module, node.name]
            return self.name(node.module, node.name), "(", filled(self._handed_on(node.arguments, asked)), ")"
        name = WORDS.get(node.name, node.name)
        name = name if name in MATHEMATICS else global_name("", name)
        return name, "(", filled(map(self.expression, node.arguments)), ")"

    def _handed_on(self, nodes: Iterable[Expression], kinds: Iterable[Type]) -> Iterator[Document]:
        for node, kind in zip(nodes, kinds, strict=True):
            yield self._address(node) if isinstance(kind, Record) else self.expression(as_asked(node, kind))

    def _address(self, node: Expression) -> Document:
        if isinstance(node, Name) and node.name in self.addresses:
            return variable(node.name)
        if isinstance(node, Name | Field | Item):
            return "&", self.expression(node, ATOM)
        name = self._fresh(node.name.strip("_") if isinstance(node, Call) else "given")
        self.before.append((f"const {type_name(node.type)} {name} = ", self.expression(node), ";"))
        return f"&{name}"

    # ------------------------------------------------------------------ statements

    def block(self, statements: Sequence[Statement], indent: int) -> Iterator[str]:
        for statement in statements:
            yield from _comment(statement.notes, indent)
            lines = [*self._statement(statement, indent)]
            for document in self.before:
                yield from lines_of(document, indent)
            self.before = []
            yield from lines

    def _statement(self, statement: Statement, indent: int) -> Iterator[str]:
        match statement:
            case Assign():
                for document in self._assign(statement):
                    yield from lines_of(document, indent)
            case Return(value):
                yield from lines_of(("return ", self.expression(value), ";"), indent)
            case Leave():
                yield from lines_of("break;", indent)
            case If():
                yield from lines_of(("if (", self.expression(statement.test), ") {"), indent)
                yield from self.block(statement.body, indent + STEP)
                if statement.otherwise:
                    yield from lines_of("} else {", indent)
                    yield from self.block(statement.otherwise, indent + STEP)
                yield from lines_of("}", indent)
            case Repeat(name=k):
                first, end = self.expression(statement.first), self.expression(statement.end)
                yield from lines_of((f"for (int {k} = ", first, f"; {k} < ", end, f"; {k}++) {{"), indent)
                yield from self.block(statement.body, indent + STEP)
                yield from lines_of("}", indent)

    def _assign(self, node: Assign) -> Iterator[Document]:
        value = node.value
        if isinstance(node.target, str):
            yield assigned(self._declared(node.target, node), value, self.expression(value))
            return
        needed = {name for name in names_of(node.target) if name in self.rebound}
        if needed & _names_in(value) or not isinstance(value, Name | Field | Item):
            names = [*names_of(node.target)]
            whole = self._fresh(value.name.strip("_") if isinstance(value, Call) else "_".join(names[:3]))
            yield f"const {type_name(value.type)} {whole} = ", self.expression(value), ";"
            value = Name(whole, value.type)
        yield from self._items(node.target, value, node)

    def _declared(self, name: str, node: Assign) -> str:
        if name not in node.fresh:
            return variable(name)
        return ("" if name in self.rebound else "const ") + f"{type_name(node.types[name])} {variable(name)}"

    def _fresh(self, name: str) -> str:
        """Return a name for what is taken apart."""
        self.taken[name] = self.taken.get(name, 0) + 1
        return f"of_{name}" if self.taken[name] == 1 else f"of_{name}_{self.taken[name]}"

    def _items(self, target: tuple[Target, ...], value: Expression, node: Assign) -> Iterator[Document]:
        """Give the names of a target the items of a value that has a name."""
        constants: dict[str, list[Document]] = {}
        for k, (name, kind) in enumerate(zip(target, items_of(value.type), strict=True)):
            item = Item(value, k, kind)
            if not isinstance(name, str):
                yield from self._items(name, item, node)
            elif name in node.fresh and name not in self.rebound:
                constants.setdefault(type_name(kind), []).append((f"{variable(name)} = ", self.expression(item)))
            elif name != "_":
                yield f"{self._declared(name, node)} = ", self.expression(item), ";"
        for kind_name, values in constants.items():
            yield f"const {kind_name} ", filled(values), ";"

    # ------------------------------------------------------------------ definitions

    def definition(self, module: str, node: Definitions) -> Iterator[str]:
        match node:
            case Constant():
                yield from self._constant(module, node)
            case Structure():
                yield from self._structs([node.record])
            case Function():
                yield from self._function(module, node)

    def _constant(self, module: str, node: Constant) -> Iterator[str]:
        yield from self._structs([node.type])
        yield from _comment(node.notes, 0)
        text: Document = self.literal(node.value, node.type) if isinstance(node.value, float | int) else ""
        if isinstance(node.value, tuple):
            edges = ("{", "}") if node.type == PAIR else ("{{", "}}")
            text = (edges[0], filled(self.literal(x, NUMBER) for x in node.value), edges[1])
        name = self.constant(module, node.name)
        yield from lines_of((f"static const {type_name(node.type)} {name} = ", text, ";"))

    def _structs(self, kinds: Iterable[Type]) -> Iterator[str]:
        for kind in kinds:
            if isinstance(kind, Tuple | Record) and kind not in self.structs:
                yield from self._structs(items_of(kind))
                self.structs.add(kind)
                yield from struct(kind, self.described.get(kind))

    def _function(self, module: str, node: Function) -> Iterator[str]:
        yield from self._structs([*(kind for _, kind in node.parameters), *_types_in(node.body), node.type])
        self.addresses = {name for name, kind in node.parameters if isinstance(kind, Record)}
        self.rebound, self.taken = rebound(node), {}
        if self.addresses & self.rebound:
            raise TypeError(f"{node.name} changes a record that it is given")
        yield from comment(node.docstring, 0, "/* ", "   ", " */")
        given = [parameter(kind, variable(name)) for name, kind in node.parameters]
        head = f"static inline {type_name(node.type)} {self.name(module, node.name)}("
        yield from lines_of((head, filled(given), ")"))
        yield "{"
        used = {each.name for each in _parts_of(node.body) if isinstance(each, Name)}
        yield from (f"{' ' * STEP}(void){variable(name)};" for name, _ in node.parameters if name not in used)
        yield from self.block(node.body, STEP)
        yield "}"
        yield ""


def _comment(notes: Notes, indent: int) -> Iterator[str]:
    return comment(said(notes), indent, "/* ", "   ", " */")


def _names_in(node: Expression) -> set[str]:
    while isinstance(node, Field | Item):
        node = node.of
    return {node.name} if isinstance(node, Name) else set()


def _parts_of(node: object) -> Iterator[Expression]:
    """Return all expressions in a part of the tree."""
    if isinstance(node, tuple):
        for part in node:
            yield from _parts_of(part)
    elif dataclasses.is_dataclass(node) and not isinstance(node, Type):
        for part in dataclasses.fields(node):
            if part.name not in ("type", "types"):
                yield from _parts_of(getattr(node, part.name))
        if isinstance(node, Expression):
            yield node


def _types_in(node: object) -> Iterator[Type]:
    return (each.type for each in _parts_of(node))

"""What printers of C and Rust share: expressions without needless brackets, statements, comments, order."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Sequence

from printing.layout import WIDTH, Document, Group, Line, Loose, Nest, laid_out
from printing.tree import (
    NUMBER,
    Assign,
    Binary,
    Call,
    Choice,
    Constant,
    Expression,
    Field,
    Function,
    Global,
    If,
    Item,
    Literal,
    Make,
    Module,
    Name,
    Notes,
    Part,
    Record,
    Repeat,
    Section,
    Statement,
    Structure,
    Target,
    Tuple,
    Type,
    Unary,
    items_of,
)

STEP = 4
OPERATORS = {"and": "&&", "or": "||"}
STRENGTH = {"||": 1, "&&": 2, "==": 3, "!=": 3, "<": 4, ">": 4, "<=": 4, ">=": 4, "+": 5, "-": 5, "*": 6, "/": 6}
CHOICE, COMPARISON, SUM, UNARY, ATOM = 0, 3, 5, 7, 8
PAIR = Tuple((NUMBER, NUMBER))
COUNTS = {2: "two", 3: "three", 4: "four", 5: "five", 6: "six", 7: "seven", 8: "eight", 9: "nine", 10: "ten",
          16: "sixteen"}  # fmt: skip
Definitions = Constant | Structure | Function


class Language:
    """A printer of expressions; a language says how it writes names, members, tuples, choices and calls.

    Attributes:
        asked: (module, function) → types of its parameters.
    """

    def __init__(self, modules: Sequence[Module]) -> None:
        functions = {(m.name, x.name): x for m in modules for x in m.definitions if isinstance(x, Function)}
        self.asked = {key: tuple(kind for _, kind in x.parameters) for key, x in functions.items()}

    def expression(self, node: Expression, around: int = CHOICE) -> Document:
        """Return an expression, in brackets where it binds less than what is around it."""
        text, own = self._expression(node)
        return ("(", text, ")") if own < around else text

    def _expression(self, node: Expression) -> tuple[Document, int]:
        match node:
            case Literal():
                return self.literal(node.value, node.type), ATOM
            case Name():
                return self.variable(node.name), ATOM
            case Global():
                return self.constant(node.module, node.name), ATOM
            case Item(of=Make(items=items), index=index):
                return self._expression(items[index])
            case Item() | Field():
                return self.member(node), ATOM
            case Part(type=Tuple() as kind):
                places = range(node.low, node.high)
                parts = [Item(node.of, k, item) for k, item in zip(places, kind.items, strict=True)]
                return self._expression(Make(tuple(parts), kind))
            case Unary():
                return ("!" if node.operator == "not" else "-", self.expression(node.operand, ATOM)), UNARY
            case Binary():
                return self._binary(node)
            case Choice():
                return self.choice(node)
            case Make():
                return self.make(node), ATOM
            case Call():
                return self.call(node), ATOM
        raise TypeError(f"{node} is no expression")

    def _binary(self, node: Binary) -> tuple[Document, int]:
        sign = _sign(node)
        own = STRENGTH[sign]
        # comparisons are not chained, and compilers want brackets around joined conditions of another kind
        least = own if own >= SUM else SUM if own >= COMPARISON else COMPARISON
        is_same = isinstance(node.left, Binary) and _sign(node.left) == sign and own < COMPARISON
        left = self.expression(node.left, own if is_same else least)
        return (left, Loose((Line(), f"{sign} ", self.expression(node.right, max(least, own + 1))))), own

    def literal(self, value: float, kind: Type) -> str:
        raise NotImplementedError

    def variable(self, name: str) -> str:
        raise NotImplementedError

    def constant(self, module: str, name: str) -> str:
        raise NotImplementedError

    def member(self, node: Item | Field) -> Document:
        raise NotImplementedError

    def choice(self, node: Choice) -> tuple[Document, int]:
        raise NotImplementedError

    def make(self, node: Make) -> Document:
        raise NotImplementedError

    def call(self, node: Call) -> Document:
        raise NotImplementedError


def _sign(node: Binary) -> str:
    return OPERATORS.get(node.operator, node.operator)


def field_of(node: Item | Field) -> tuple[int, str]:
    """Return which item of its record, and its name; of a tuple the name is empty."""
    kind = node.of.type
    if not isinstance(kind, Record):
        assert isinstance(node, Item)
        return node.index, ""
    names = [name for name, _ in kind.fields]
    return (node.index, names[node.index]) if isinstance(node, Item) else (names.index(node.name), node.name)


def as_asked(node: Expression, kind: Type) -> Expression:
    """Return an argument as the type that is asked for: a record's items where that is a tuple."""
    if not isinstance(node.type, Record) or not isinstance(kind, Tuple):
        return node
    return Make(tuple(Item(node, k, item) for k, item in enumerate(items_of(node.type))), kind)


# ---------------------------------------------------------------------- lines


def lines_of(document: Document, indent: int = 0) -> Iterator[str]:
    yield from (" " * indent + laid_out(document, STEP, indent)).splitlines()


def filled(parts: Iterable[Document]) -> Document:
    """Return a list that is broken only where a line is full."""
    first, *rest = parts
    return Nest((first, *(Loose((",", Line(), part)) for part in rest)))


def assigned(target: Document, node: Expression, value: Document, end: str = ";") -> Document:
    """Return an assignment, which is broken after its sign where the value has no brackets of its own to break in."""
    if isinstance(node, Binary | Choice):
        return Group((target, " =", Nest((Line(), value, end))))
    return target, " = ", value, end


def comment(text: str, indent: int, first: str, rest: str, last: str = "") -> Iterator[str]:
    """Print a comment, with Python's names as they are."""
    lines: list[str] = []
    width = WIDTH - indent - len(first) - len(last)
    for line in text.replace("``", "").splitlines():
        blanks = " " * (len(line) - len(line.lstrip()))
        lines += textwrap.wrap(line, width, subsequent_indent=blanks) or [""]
    for k, line in enumerate(lines):
        end = last if k == len(lines) - 1 else ""
        yield f"{' ' * indent}{rest if k else first}{line}{end}".rstrip()


def said(notes: Notes) -> str:
    return "\n".join([*notes.above, *([notes.beside] if notes.beside else [])])


# ---------------------------------------------------------------------- functions and modules


def ordered(modules: Iterable[Module]) -> Iterator[tuple[str, Definitions]]:
    """Yield what modules define, each after all that it needs, with its module."""
    found: dict[tuple[str, str], Definitions] = {
        (module.name, name_of(x)): x for module in modules for x in module.definitions if not isinstance(x, Section)
    }
    done: set[tuple[str, str]] = set()

    def visit(key: tuple[str, str]) -> Iterator[tuple[str, Definitions]]:
        if key in done or key not in found:
            return
        done.add(key)
        for other in sorted(getattr(found[key], "calls", ())):
            yield from visit(other)
        yield key[0], found[key]

    for key in found:
        yield from visit(key)


def name_of(node: Definitions) -> str:
    return node.record.name if isinstance(node, Structure) else node.name


def names_of(target: Target) -> Iterator[str]:
    """Return the names of a target that are used."""
    if isinstance(target, tuple):
        for part in target:
            yield from names_of(part)
    elif target != "_":
        yield target


def all_of(statements: Sequence[Statement]) -> Iterator[Statement]:
    """Return statements with those inside of them."""
    for statement in statements:
        yield statement
        if isinstance(statement, If):
            yield from all_of((*statement.body, *statement.otherwise))
        elif isinstance(statement, Repeat):
            yield from all_of(statement.body)


def rebound(function: Function) -> set[str]:
    """Return the names of variables and parameters that get another value."""
    given = {name for name, _ in function.parameters}
    assigns = [x for x in all_of(function.body) if isinstance(x, Assign)]
    return {name for x in assigns for name in names_of(x.target) if name not in x.fresh or name in given}

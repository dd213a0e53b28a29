"""The tree of the formulas: what a printer walks. Every expression has its type; names are those of Python.

A program is modules; a module has constants, records and functions, in the order of its source; a function has
statements: assignments, ``if``, and a return in the end of every branch. There are no loops but ``Repeat``, no side
effects, and no types but numbers, flags, whole numbers, exact sums, and tuples and records of these.

What Python writes shortly is taken apart here: keyword arguments are in the order of the parameters, a star in a call
or tuple has become items, and ``a, b = x, y`` is two assignments where the second does not need the old ``a``.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

# ---------------------------------------------------------------------- types


@dataclass(frozen=True)
class Scalar:
    name: str


@dataclass(frozen=True)
class Tuple:
    items: tuple[Type, ...]


@dataclass(frozen=True)
class Record:
    """A ``NamedTuple``: what its items are called, with the comments beside them."""

    name: str
    module: str
    fields: tuple[tuple[str, Type], ...]


@dataclass(frozen=True)
class Row:
    """Numbers in a row, as many as are taken from it: what ``Any`` is as the type of a parameter."""


Type = Scalar | Tuple | Record | Row
NUMBER, FLAG, WHOLE, FUNCTION = Scalar("number"), Scalar("flag"), Scalar("whole"), Scalar("function")
SUM = Scalar("sum")  # of floats, never added up; only words look into it
ROW = Row()


def items_of(kind: Type) -> tuple[Type, ...]:
    """Return the types of the items of a tuple or record."""
    if isinstance(kind, Tuple):
        return kind.items
    if isinstance(kind, Record):
        return tuple(each for _, each in kind.fields)
    raise TypeError(f"{kind} has no items")


def records_in(kind: Type) -> Iterator[Record]:
    """Yield the records that a type is or has, each after those that it has."""
    for each in () if isinstance(kind, Scalar | Row) else items_of(kind):
        yield from records_in(each)
    if isinstance(kind, Record):
        yield kind


# ---------------------------------------------------------------------- expressions


@dataclass(frozen=True)
class Literal:
    """A number, flag or whole number as it is written, such as 0.5."""

    value: float | bool | int
    type: Type


@dataclass(frozen=True)
class Name:
    """A parameter or variable."""

    name: str
    type: Type


@dataclass(frozen=True)
class Global:
    """A constant of a module, or a function that is handed to another one."""

    name: str
    module: str
    type: Type  # FUNCTION for these


@dataclass(frozen=True)
class Item:
    of: Expression
    index: int
    type: Type


@dataclass(frozen=True)
class Part:
    """Items from ``low`` up to, without, ``high``, as a tuple."""

    of: Expression
    low: int
    high: int
    type: Type


@dataclass(frozen=True)
class Field:
    of: Expression
    name: str
    type: Type


@dataclass(frozen=True)
class Unary:
    operator: str  # "-" or "not"
    operand: Expression
    type: Type


@dataclass(frozen=True)
class Binary:
    """Arithmetic, a comparison, "and" or "or"; rounding makes the order of operations part of a formula."""

    operator: str
    left: Expression
    right: Expression
    type: Type


@dataclass(frozen=True)
class Choice:
    """``yes if test else no``."""

    test: Expression
    yes: Expression
    no: Expression
    type: Type


@dataclass(frozen=True)
class Call:
    """A call of a function of a module, or of one of ``WORDS``, whose module is ""."""

    name: str
    module: str
    arguments: tuple[Expression, ...]
    type: Type


@dataclass(frozen=True)
class Make:
    """A tuple or record of its items."""

    items: tuple[Expression, ...]
    type: Tuple | Record


Expression = Literal | Name | Global | Item | Part | Field | Unary | Binary | Choice | Call | Make

# ---------------------------------------------------------------------- statements

Target = str | tuple["Target", ...]
"""A name; names of a tuple's items, of which "_" is not used."""


@dataclass(frozen=True)
class Notes:
    """Comments above a statement, line by line, and beside it; empty lines above it."""

    above: tuple[str, ...] = ()
    beside: str = ""


@dataclass(frozen=True)
class Assign:
    """``fresh`` are the names of the target that have no value yet; ``types`` those of all its names."""

    target: Target
    value: Expression
    fresh: frozenset[str]
    types: dict[str, Type] = field(hash=False)
    notes: Notes = Notes()


@dataclass(frozen=True)
class Return:
    value: Expression
    notes: Notes = Notes()


@dataclass(frozen=True)
class If:
    test: Expression
    body: tuple[Statement, ...]
    otherwise: tuple[Statement, ...]
    notes: Notes = Notes()


@dataclass(frozen=True)
class Repeat:
    """``for name in range(first, end)``; a body may end it by ``Leave``."""

    name: str
    first: Expression
    end: Expression
    body: tuple[Statement, ...]
    notes: Notes = Notes()


@dataclass(frozen=True)
class Leave:
    """``break``."""

    notes: Notes = Notes()


Statement = Assign | Return | If | Repeat | Leave

# ---------------------------------------------------------------------- modules


@dataclass(frozen=True)
class Constant:
    """A number, or a tuple of numbers; ``source`` is what Python computes it from, if it is not written out."""

    name: str
    value: float | tuple[float, ...]
    type: Type
    source: str
    notes: Notes


@dataclass(frozen=True)
class Structure:
    """A record with its docstring and the comments beside its fields."""

    record: Record
    docstring: str
    notes: tuple[Notes, ...]


@dataclass(frozen=True)
class Function:
    name: str
    docstring: str
    parameters: tuple[tuple[str, Type], ...]
    type: Type
    body: tuple[Statement, ...]
    calls: frozenset[tuple[str, str]]  # (module, name) of functions and constants that it takes; module "" for words


@dataclass(frozen=True)
class Section:
    """A title between lines of a module."""

    title: str


Definition = Constant | Structure | Function | Section


@dataclass(frozen=True)
class Module:
    """``aliases`` are names of types, such as Pair."""

    name: str
    docstring: str
    definitions: tuple[Definition, ...]
    aliases: dict[str, Tuple] = field(hash=False)

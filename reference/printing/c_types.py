"""What tuples and records are in C: structs, and functions that make them, for C++ has no literals of structs."""

from __future__ import annotations

import re
from collections.abc import Iterator

from printing.expressions import COUNTS, PAIR, STEP, comment, filled, lines_of, said
from printing.layout import WIDTH, Line, Loose
from printing.tree import NUMBER, Notes, Record, Row, Scalar, Structure, Tuple, Type, items_of

PREFIX = "phd_"
SPACES = {".free_body": "free_", ".lagrange_top": "top_"}
"""Packages whose names need telling apart in C, which has one space of names."""
SCALARS = {"number": "double", "flag": "int", "whole": "int", "sum": "phd_sum"}
ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh",
            "twelfth")  # fmt: skip
RESERVED = {"double", "float", "int", "short", "long", "this", "new", "register", "class", "template", "I"}
MATHEMATICS = {"sqrt", "exp", "rint", "fabs", "floor", "atan", "atan2", "log", "sinh", "asinh", "ldexp", "frexp"}
"""Of <math.h>."""


def global_name(module: str, name: str) -> str:
    """Return the name in C of what a module has."""
    space = next((short for package, short in SPACES.items() if package in module), "")
    return PREFIX + space + re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower().lstrip("_")


def variable(name: str) -> str:
    return name + "_" if name in RESERVED | MATHEMATICS else name


def type_name(kind: Type) -> str:
    if isinstance(kind, Scalar):
        return SCALARS[kind.name]
    if isinstance(kind, Record):
        return global_name(kind.module, kind.name) + "_record"
    if kind == PAIR:
        return PREFIX + "pair"
    items = items_of(kind)
    if set(items) == {NUMBER}:
        return PREFIX + COUNTS[len(items)]
    runs: list[list[Type]] = []
    for item in items:
        if runs and runs[-1][0] == item:
            runs[-1].append(item)
        else:
            runs.append([item])
    return PREFIX + "_".join(_run(run) for run in runs)


def _run(items: list[Type]) -> str:
    name = items[0].name if isinstance(items[0], Scalar) else type_name(items[0]).removeprefix(PREFIX)
    return f"{COUNTS[len(items)]}_{name}s" if len(items) > 1 else name


def maker(kind: Type) -> str:
    """Return the name of the function that makes a struct of its items."""
    return f"{PREFIX}make_{type_name(kind).removeprefix(PREFIX)}"


def parameter(kind: Type, name: str) -> str:
    if isinstance(kind, Row):
        return f"const double *{name}"
    return f"const {type_name(kind)} *{name}" if isinstance(kind, Record) else f"{type_name(kind)} {name}"


def members(kind: Type) -> tuple[str, ...]:
    """Return what follows a value, after a dot, to reach each item."""
    if isinstance(kind, Record):
        return tuple(variable(name) for name, _ in kind.fields)
    if kind == PAIR:
        return "hi", "lo"
    items = items_of(kind)
    return tuple(f"at[{k}]" for k in range(len(items))) if len(set(items)) == 1 else ORDINALS[: len(items)]


def struct(kind: Tuple | Record, described: Structure | None) -> Iterator[str]:
    """Print the struct of a type, a record with its comments, and the function that makes one of its items."""
    items, name = items_of(kind), type_name(kind)
    if described:
        yield from comment(described.docstring, 0, "/* ", "   ", " */")
    if kind == PAIR:
        yield f"typedef struct {{ double hi, lo; }} {name};"
    elif isinstance(kind, Tuple) and len(set(items)) == 1:
        yield f"typedef struct {{ {type_name(items[0])} at[{len(items)}]; }} {name};"
    else:
        yield "typedef struct {"
        notes = described.notes if described else (Notes(),) * len(items)
        for x, item, note in zip(members(kind), items, notes, strict=True):
            yield from _field(f"{type_name(item)} {x};", said(note))
        yield f"}} {name};"
    yield ""
    yield from _maker(kind)


def _field(text: str, note: str) -> Iterator[str]:
    note = note.replace("``", "")
    beside = f"{' ' * STEP}{text} /* {note} */" if note else " " * STEP + text
    if len(beside) > WIDTH or "\n" in note:
        yield from comment(note, STEP, "/* ", "   ", " */")
        beside = " " * STEP + text
    yield beside


def _maker(kind: Tuple | Record) -> Iterator[str]:
    items, name = items_of(kind), type_name(kind)
    names = [f"x{k}" if "[" in x else x for k, x in enumerate(members(kind))]
    given = [parameter(item, x) for item, x in zip(items, names, strict=True)]
    yield from lines_of((f"static inline {name}", Loose((Line(), f"{maker(kind)}(")), filled(given), ")"))
    yield "{"
    yield f"    {name} all;"
    values = zip(members(kind), names, items, strict=True)
    first, *rest = (f"all.{x} = {'*' * isinstance(t, Record)}{n};" for x, n, t in values)
    yield from lines_of((first, *(Loose((Line(), x)) for x in rest)), STEP)
    yield "    return all;"
    yield "}"
    yield ""

"""Reads the body of a formula: statements and expressions of ``ast`` become those of the tree, with their types."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import NoReturn

from printing.sources import Source
from printing.tree import (
    FLAG,
    FUNCTION,
    NUMBER,
    ROW,
    WHOLE,
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
    Leave,
    Literal,
    Make,
    Name,
    Notes,
    Part,
    Record,
    Repeat,
    Return,
    Row,
    Statement,
    Target,
    Tuple,
    Type,
    Unary,
    items_of,
)
from printing.words import BUILT_IN, CONSTANTS, WORDS, is_word

ARITHMETIC_OF = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
COMPARISON_OF = {ast.Lt: "<", ast.Gt: ">", ast.LtE: "<=", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}


class NotAFormula(Exception):
    """What stands in a formula and has no place in the tree, with file and line."""


def is_assignable(given: Type, wanted: Type) -> bool:
    """Return whether a value of one type may stand where the other is asked for."""
    if given == wanted or wanted == ROW or (given == WHOLE and wanted == NUMBER):
        return True
    if isinstance(given, Tuple | Record) and isinstance(wanted, Tuple):
        mine, asked = items_of(given), items_of(wanted)
        return len(mine) == len(asked) and all(map(is_assignable, mine, asked))
    return False


class Body:
    """Reads one function.

    Args:
        origin: the module that it stands in.
        node: its Python.
        parameters: name → type.
        resolve: a name of the module → where it is defined.
        find: of a module and a name defined there what it is: a ``Function``, ``Record`` or ``Constant``.
    """

    def __init__(
        self,
        origin: Source,
        node: ast.FunctionDef,
        parameters: dict[str, Type],
        resolve: Callable[[str], tuple[Source, str] | None],
        find: Callable[[Source, str], Function | Record | Constant],
    ) -> None:
        self.origin, self.resolve, self.find = origin, resolve, find
        self.types = dict(parameters)
        self.calls: set[tuple[str, str]] = set()
        self.returned: list[Type] = []
        self.loops: list[Statement] = []  # that come before the statement that is being read
        self.names = {x.id for x in ast.walk(node) if isinstance(x, ast.Name)} | {*parameters}

    def refuse(self, node: ast.AST, why: str) -> NoReturn:
        line = getattr(node, "lineno", 0)
        raise NotAFormula(f"{self.origin.name}, line {line}: {why}: {ast.unparse(node)}")

    # ------------------------------------------------------------------ statements

    def statements(self, nodes: Sequence[ast.stmt], after: int) -> tuple[Statement, ...]:
        """Return the statements of a block, which begins after a line."""
        found: list[Statement] = []
        for node in nodes:
            statements = [*self._statement(node, after)]
            found += [*self.loops, *statements]
            self.loops.clear()
            after = node.end_lineno or node.lineno
        return tuple(found)

    def _statement(self, node: ast.stmt, after: int) -> Iterator[Statement]:
        match node:
            case ast.Expr(value=ast.Constant(value=str())) | ast.Pass():
                return
            case ast.Return(value=ast.expr() as value):
                returned = self.expression(value)
                self.returned.append(returned.type)
                yield Return(returned, self.origin.notes(node, after))
            case ast.Assign(targets=[target], value=value):
                yield from self._assignments(target, value, self.origin.notes(node, after))
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield from self._assignments(target, value, self.origin.notes(node, after))
            case ast.AugAssign(target=ast.Name() as target, op=op, value=value):
                more = ast.BinOp(ast.Name(target.id, ast.Load()), op, value)
                more = ast.fix_missing_locations(ast.copy_location(more, node))
                yield from self._assignments(target, more, self.origin.notes(node, after))
            case ast.If():
                yield self._if(node, after)
            case ast.For(target=ast.Name(id=name), iter=ast.Call(func=ast.Name(id="range"), args=bounds), orelse=[]):
                yield self._repeat(node, name, bounds, after)
            case ast.Break():
                yield Leave(self.origin.notes(node, after))
            case _:
                self.refuse(node, "neither assignment, if, for over a range, nor return")

    def _if(self, node: ast.If, after: int) -> If:
        test = self._condition(node.test)
        if self.loops:
            self.refuse(node.test, "a loop in a condition")
        notes = self._notes_of_head(node, node.test, after)
        known = dict(self.types)
        body = self.statements(node.body, node.test.end_lineno or node.lineno)
        self.types = dict(known)
        otherwise = self.statements(node.orelse, node.body[-1].end_lineno or node.lineno)
        self.types = known
        return If(test, body, otherwise, notes)

    def _repeat(self, node: ast.For, name: str, bounds: list[ast.expr], after: int) -> Repeat:
        notes = self._notes_of_head(node, node.iter, after)
        first, end = (Literal(0, WHOLE), *map(self.expression, bounds))[-2:]
        known = dict(self.types)
        self.types[name] = WHOLE
        body = self.statements(node.body, node.iter.end_lineno or node.lineno)
        self.types = known
        return Repeat(name, first, end, body, notes)

    def _notes_of_head(self, node: ast.stmt, head: ast.expr, after: int) -> Notes:
        only = ast.copy_location(ast.Pass(), node)
        only.end_lineno = head.end_lineno
        return self.origin.notes(only, after)

    def _assignments(self, target: ast.expr, value: ast.expr, notes: Notes) -> Iterator[Assign]:
        """Yield one assignment, or one for each item where these may follow each other."""
        if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple) and _may_follow(target.elts, value.elts):
            for one, its_value in zip(target.elts, value.elts, strict=True):
                yield self._assignment(one, self.expression(its_value), notes)
                notes = Notes()
        else:
            yield self._assignment(target, self.expression(value), notes)

    def _assignment(self, target: ast.expr, value: Expression, notes: Notes) -> Assign:
        types: dict[str, Type] = {}
        shape = self._target(target, value.type, types)
        fresh = frozenset(name for name in types if name not in self.types)
        for name, kind in types.items():
            if self.types.get(name, kind) != kind:
                self.refuse(target, f"`{name}` had another type before")
        self.types |= types
        return Assign(shape, value, fresh, types, notes)

    def _target(self, node: ast.expr, kind: Type, types: dict[str, Type]) -> Target:
        if isinstance(node, ast.Name):
            if node.id != "_":
                types[node.id] = kind
            return node.id
        if isinstance(node, ast.Tuple) and isinstance(kind, Tuple | Record):
            items = items_of(kind)
            if len(items) == len(node.elts):
                return tuple(self._target(x, each, types) for x, each in zip(node.elts, items, strict=True))
        self.refuse(node, f"cannot take what has the type {kind}")

    # ------------------------------------------------------------------ expressions

    def expression(self, node: ast.expr) -> Expression:
        match node:
            case ast.Constant(value=bool() as value):
                return Literal(value, FLAG)
            case ast.Constant(value=int() as value):
                return Literal(value, WHOLE)
            case ast.Constant(value=float() as value):
                return Literal(value, NUMBER)
            case ast.Name(id=name):
                found = self.types.get(name)
                return Name(name, found) if found else self._global(node, name)
            case ast.Attribute(value=ast.Name(id="math"), attr=name) if name in CONSTANTS:
                return Global(name, "math", NUMBER)
            case ast.Attribute(value=value, attr=name):
                return self._field(node, self.expression(value), name)
            case ast.Subscript(value=value, slice=index):
                return self._items(node, self.expression(value), index)
            case ast.Tuple(elts=elements):
                items = tuple(self._spread(elements))
                return Make(items, Tuple(tuple(x.type for x in items)))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                inner = self.expression(operand)
                return Unary("-", inner, inner.type)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return Unary("not", self._condition(operand), FLAG)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in ARITHMETIC_OF:
                return self._arithmetic(node, ARITHMETIC_OF[type(op)], self.expression(left), self.expression(right))
            case ast.BinOp(left=left, op=ast.BitAnd() | ast.BitOr() as op, right=right):
                word = "and" if isinstance(op, ast.BitAnd) else "or"
                return Binary(word, self._condition(left), self._condition(right), FLAG)
            case ast.BoolOp(op=op, values=values):
                return self._joined("and" if isinstance(op, ast.And) else "or", [self._condition(x) for x in values])
            case ast.Compare():
                return self._comparison(node)
            case ast.IfExp(test=test, body=body, orelse=otherwise):
                return self._choice(node, test, self.expression(body), self.expression(otherwise))
            case ast.Call():
                return self._call(node)
        self.refuse(node, "no expression of a formula")

    def _global(self, node: ast.expr, name: str) -> Global:
        place = self.resolve(name)
        found = self.find(*place) if place else None
        if place is None or isinstance(found, Record | None):
            self.refuse(node, "unknown")
        self.calls.add((place[0].name, place[1]))
        return Global(place[1], place[0].name, FUNCTION if isinstance(found, Function) else found.type)

    def _field(self, node: ast.expr, of: Expression, name: str) -> Field:
        if isinstance(of.type, Record) and name in dict(of.type.fields):
            return Field(of, name, dict(of.type.fields)[name])
        self.refuse(node, "no field of a record")

    def _items(self, node: ast.expr, of: Expression, index: ast.expr) -> Item | Part:
        match index:
            case ast.Constant(value=int() as k):
                return Item(of, k, NUMBER if isinstance(of.type, Row) else items_of(of.type)[k])
            case ast.Slice(lower=ast.Constant(value=int() as low), upper=ast.Constant(value=int() as high), step=None):
                row = isinstance(of.type, Row)
                return Part(of, low, high, Tuple((NUMBER,) * (high - low) if row else items_of(of.type)[low:high]))
        self.refuse(node, "items are taken by numbers that are written out")

    def _spread(self, nodes: Sequence[ast.expr]) -> Iterator[Expression]:
        """Yield expressions, those of a star one by one."""
        for node in nodes:
            if not isinstance(node, ast.Starred):
                yield self.expression(node)
                continue
            whole = self.expression(node.value)
            if isinstance(whole, Make):
                yield from whole.items
            elif isinstance(whole, Name | Field | Item):
                yield from (Item(whole, k, each) for k, each in enumerate(items_of(whole.type)))
            else:
                self.refuse(node, "give it a name first")

    def _condition(self, node: ast.expr) -> Expression:
        found = self.expression(node)
        if found.type != FLAG:
            self.refuse(node, "neither true nor false")
        return found

    def _arithmetic(self, node: ast.expr, operator: str, left: Expression, right: Expression) -> Binary:
        kinds = {left.type, right.type}
        if not kinds <= {NUMBER, WHOLE}:
            self.refuse(node, "arithmetic is with numbers")
        return Binary(operator, left, right, WHOLE if kinds == {WHOLE} and operator != "/" else NUMBER)

    def _joined(self, operator: str, parts: list[Expression]) -> Expression:
        first, *rest = parts
        for each in rest:
            first = Binary(operator, first, each, FLAG)
        return first

    def _comparison(self, node: ast.Compare) -> Expression:
        sides = [self.expression(x) for x in (node.left, *node.comparators)]
        if any(type(op) not in COMPARISON_OF for op in node.ops) or any(
            not isinstance(x, Name | Literal | Global) for x in sides[1:-1]
        ):
            self.refuse(node, "no comparison of a formula")
        return self._joined("and", [
            Binary(COMPARISON_OF[type(op)], *two, FLAG) for op, two in zip(node.ops, pairwise(sides), strict=True)
        ])  # fmt: skip

    def _choice(self, node: ast.expr, test: ast.expr, yes: Expression, no: Expression) -> Choice:
        if yes.type != no.type:
            self.refuse(node, "two types")
        return Choice(self._condition(test), yes, no, yes.type)

    def _call(self, node: ast.Call) -> Expression:
        match node.func:
            case ast.Attribute(value=ast.Name(id="math"), attr=name) if name in WORDS:
                return self._word(node, name)
            case ast.Name(id=name) if name in BUILT_IN:
                return self._word(node, name)
            case ast.Name(id=name) if place := self.resolve(name):
                if is_word(*place):
                    return self._word(node, place[1])
                return self._call_of(node, place)
        self.refuse(node, "no function of a formula")

    def _call_of(self, node: ast.Call, place: tuple[Source, str]) -> Expression:
        found = self.find(*place)
        if isinstance(found, Record):
            return Make(self._arguments(node, found.fields), found)
        if isinstance(found, Function):
            self.calls.add((place[0].name, place[1]))
            return Call(found.name, place[0].name, self._arguments(node, found.parameters), found.type)
        self.refuse(node, "no function")

    def _word(self, node: ast.Call, name: str) -> Expression:
        match name, node.args:
            case "where" | "choice", [test, yes, no]:
                return self._choice(node, test, self.expression(yes), self.expression(no))
            case "choose", [test, ast.Name() as yes, ast.Name() as no, values]:
                calls = (self.expression(ast.copy_location(ast.Call(f, [values], []), node)) for f in (yes, no))
                return self._choice(node, test, *calls)
            case "constant", [value, _]:
                return self.expression(value)
            case "negation", [operand]:
                return Unary("not", self._condition(operand), FLAG)
            case "iterate", [count, step, state]:
                return self._iterated(step, state, count)
            case "iterate_until", [step, finished, state, at_once, most]:
                return self._iterated(step, state, most, finished, at_once)
        parameters, result = WORDS[name]
        self.calls.add(("", name))
        return Call(name, "", self._arguments(node, tuple((str(k), x) for k, x in enumerate(parameters))), result)

    def _iterated(
        self, step: ast.expr, start: ast.expr, most: ast.expr,
        finished: ast.expr | None = None, at_once: ast.expr | None = None,
    ) -> Name:  # fmt: skip
        """Return the variable in which a loop leaves its state; the loop comes before the statement."""
        name, k = self._unused("running"), self._unused("k")
        state = ast.copy_location(ast.Name(name, ast.Load()), start)
        called = lambda function: ast.copy_location(ast.Call(function, [state], []), start)  # noqa: E731
        first = self._assignment(ast.copy_location(ast.Name(name, ast.Store()), start), self.expression(start), Notes())
        body: list[Statement] = []
        if finished and at_once:
            ended, first_time = self._condition(called(finished)), self.expression(at_once)
            if first_time != Literal(0, WHOLE):
                ended = Binary("and", Binary(">=", Name(k, WHOLE), first_time, FLAG), ended, FLAG)
            body.append(If(ended, (Leave(),), ()))
        body.append(self._assignment(ast.copy_location(ast.Name(name, ast.Store()), start),
                                     self.expression(called(step)), Notes()))  # fmt: skip
        self.loops += [first, Repeat(k, Literal(0, WHOLE), self.expression(most), tuple(body))]
        return Name(name, self.types[name])

    def _unused(self, name: str) -> str:
        while name in self.names:
            name += "_"
        self.names.add(name)
        return name

    def _arguments(self, node: ast.Call, parameters: tuple[tuple[str, Type], ...]) -> tuple[Expression, ...]:
        named = {str(x.arg): self.expression(x.value) for x in node.keywords}
        given = list(self._spread(node.args))
        given += [named.pop(name) for name, _ in parameters[len(given) :] if name in named]
        if named or len(given) != len(parameters):
            self.refuse(node, f"takes {len(parameters)} arguments")
        for value, (name, kind) in zip(given, parameters, strict=True):
            if not is_assignable(value.type, kind):
                self.refuse(node, f"`{name}` must be {kind}, not {value.type}")
        return tuple(given)


def _may_follow(targets: list[ast.expr], values: list[ast.expr]) -> bool:
    """Return whether assignments to several targets may be made one after the other."""
    if len(targets) != len(values) or any(isinstance(x, ast.Starred) for x in (*targets, *values)):
        return False
    taken: set[str] = set()
    for target, value in zip(targets, values, strict=True):
        if taken & {x.id for x in ast.walk(value) if isinstance(x, ast.Name)}:
            return False
        taken |= {x.id for x in ast.walk(target) if isinstance(x, ast.Name)}
    return True

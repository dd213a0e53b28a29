"""The formulas keep to the language that ``exact/_formulas.py`` describes, and records lie in stores as they say."""

import ast
import importlib
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

import polhode.exact
from polhode.exact._kernel_arithmetic import BLOCK, Number, Pair, Truth
from polhode.exact._kernel_records import rows_of, size_of

PLACE = Path(polhode.exact.__file__).parent
FILES = sorted(PLACE.rglob("_formulas*.py"))
CONTROL = {"choose": (1, 2), "iterate": (1,), "iterate_until": (0, 1)}
OPERATORS = ast.Add | ast.Sub | ast.Mult | ast.Div | ast.BitAnd | ast.BitOr
EXPRESSIONS = ast.Name | ast.Constant | ast.Attribute | ast.Tuple | ast.Slice | ast.Load


def faults(source: str, known: set[str]) -> list[str]:
    """Return what in functions is not of the language, by line."""
    tree, found = ast.parse(source), []
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    known = known | {node.name for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    for function in functions:
        body = function.body[1:] if ast.get_docstring(function) else function.body
        for statement in body:
            last = statement is body[-1]
            if not isinstance(statement, ast.Return if last else ast.Assign):
                found.append(f"{statement.lineno}: {type(statement).__name__}")
                continue
            found += [f"{node.lineno}: {ast.unparse(node)}" for node in wrong(statement.value, known)]
    return found


def wrong(node, known):
    """Yield the parts of an expression that are not of the language."""
    match node:
        case ast.BinOp():
            parts, right = [node.left, node.right], isinstance(node.op, OPERATORS)
        case ast.UnaryOp():
            parts, right = [node.operand], isinstance(node.op, ast.USub)
        case ast.Compare():
            parts, right = [node.left, *node.comparators], len(node.ops) == 1
        case ast.Call(func=ast.Name(id=name)):
            functions = [node.args[k] for k in CONTROL.get(name, ())]
            parts = [arg for arg in node.args if arg not in functions]
            right = not node.keywords and name in known and all(isinstance(f, ast.Name) for f in functions)
        case ast.Subscript():
            parts = [node.value]
            right = not any(isinstance(x, ast.Name | ast.Call) for x in ast.walk(node.slice))
        case ast.Name(id=name):
            parts, right = [], name not in known
        case _:
            parts, right = list(ast.iter_child_nodes(node)), isinstance(node, EXPRESSIONS)
    if not right:
        yield node
        return
    for part in parts:
        yield from wrong(part, known)


def words_of(path):
    """Return the functions and records that a file has imported, and what every language has."""
    name = ".".join(("polhode.exact", *path.relative_to(PLACE).with_suffix("").parts))
    return {name for name, x in vars(importlib.import_module(name)).items() if callable(x)} | {"abs"}


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_formulas_keep_to_it(path):
    assert not faults(path.read_text("utf-8"), words_of(path))


def test_there_are_formulas_of_both_motions():
    assert {path.parent.name for path in FILES} >= {"exact", "free_body", "lagrange_top"}


@pytest.mark.parametrize("line", [
    "if x > 0.0:\n        x = 1.0", "for k in x:\n        x = k", "x += 1.0", "x = x ** 2", "x = not x", "x = x and x",
    "x = x if x > 0.0 else x", "x = add(x, y=x)", "x = [x]", "x = x[x]", "x = 0.0 < x < 1.0", "x = lambda y: y",
    "x = add(*x)", "x = unheard(x)", "x = add", "x = x.real()", "return x", "x = f'{x}'", "x = add(add, x)",
    "x = choose(x, lambda y: y, add, x)",
])  # fmt: skip
def test_what_is_not_of_the_language_is_noticed(line):
    assert not faults("def f(x):\n    x = add(x, x)\n    return x", {"add"})
    assert faults(f"def f(x):\n    {line}\n    return x", {"add", "choose"})


# ---------------------------------------------------------------------- records in stores


class Inner(NamedTuple):
    pair: Pair
    holds: Truth


class Outer(NamedTuple):
    first: Number
    inner: Inner
    triple: tuple[Number, Number, Number]


def test_records_follow_each_other_without_gaps():
    assert (size_of(Inner), size_of(Outer)) == (3, 7)
    assert list(rows_of(Outer, Inner, tuple[float])) == [0, 7 * BLOCK, 10 * BLOCK, 11 * BLOCK]


@pytest.mark.long
def test_compiled_code_reads_what_it_has_stored():
    """In the order of the fields; a truth value is 1 or 0."""
    from polhode._base.compiled.compiling import compile_part
    from polhode.exact._compiled_arithmetic import FOR_NUMBA

    load, put_record, kind = FOR_NUMBA["load"], FOR_NUMBA["put_record"], Outer
    numba = pytest.importorskip("numba")

    @compile_part
    def again(w):
        put_record(w, 1, load(w, 0, kind))

    @numba.njit
    def run(w):
        again(w)

    w = np.zeros(7 * BLOCK)
    w[::BLOCK] = 1.5, 2.5, 3.5, 1.0, 4.5, 5.5, 6.5
    run(w)
    assert w[1::BLOCK].tolist() == w[::BLOCK].tolist() and (w[2:BLOCK] == 0.0).all()
    w[3 * BLOCK] = 0.0
    run(w)
    assert w[1 + 3 * BLOCK] == 0.0

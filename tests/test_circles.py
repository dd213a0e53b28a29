"""No file imports another that imports it, by whatever way round: imports inside functions, and by name, count too."""

import ast
from collections.abc import Iterator
from pathlib import Path

import networkx
import pytest

import polhode

ROOT = Path(polhode.__file__).parent


def modules(root: Path) -> dict[str, Path]:
    """Return the file of each module."""
    found = {}
    for path in root.rglob("*.py"):
        parts = path.relative_to(root.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imported(tree: ast.AST) -> Iterator[str]:
    """Yield what a file imports, but for types alone."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            continue
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield from (f"{node.module}.{name.name}" for name in node.names)
        elif isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            if getattr(node.func, "attr", getattr(node.func, "id", "")) in ("import_module", "__import__"):
                yield str(node.args[0].value)
        yield from imported(node)


def graph_of(root: Path) -> networkx.DiGraph:
    """Return which module imports which."""
    files, found = modules(root), networkx.DiGraph()
    for name, path in files.items():
        for other in imported(ast.parse(path.read_text("utf-8"))):
            while other and other not in files:
                other = other.rpartition(".")[0]
            if other and other != name:
                found.add_edge(name, other)
    return found


def circles(root: Path) -> list[list[str]]:
    """Return the modules that reach each other."""
    return [sorted(part) for part in networkx.strongly_connected_components(graph_of(root)) if len(part) > 1]


def test_there_is_none():
    assert len(modules(ROOT)) > 500 and not circles(ROOT)


@pytest.mark.parametrize(
    "back",
    ["from thing import b", "def f():\n    from thing.b import g", "import importlib as i\ni.import_module('thing.b')"],
)
def test_one_is_found(back, tmp_path):
    home = tmp_path / "thing"
    home.mkdir()
    (home / "__init__.py").write_text("")
    (home / "a.py").write_text(back)
    (home / "b.py").write_text("import thing.c")
    (home / "c.py").write_text("from thing.a import something")
    assert circles(home) == [["thing.a", "thing.b", "thing.c"]]
    (home / "a.py").write_text("from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from thing import b")
    assert not circles(home)

"""The table of twins is whole: every door, implementation and product has its column, every cell a test or a reason."""

import pytest

from polhode._base.plugins import GROUPS
from twins.families import KINDS
from twins.motions_implementations import IMPLEMENTATIONS
from twins.table import HERE, MADE_HERE, functions_of, named_tests, read_table, read_tables
from twins.test_seals import SEALED

TABLES = read_tables()


@pytest.mark.parametrize("title", TABLES)
def test_every_cell_has_a_test_or_a_reason(title):
    assert TABLES[title].cells and not find_gaps(TABLES[title])


def find_gaps(table):
    """Return what is missing: notes, tests that they name, and marks for them."""
    used = {cell.mark for cell in table.cells} - {MADE_HERE}
    gaps = [f"{mark} has no note" for mark in sorted(used - table.notes.keys())]
    gaps += [f"{mark} is not used" for mark in sorted(table.notes.keys() - used)]
    for mark, note in table.notes.items():
        names = named_tests(note)
        if mark.isalpha() and not names:
            gaps.append(f"{mark} names no test")
        gaps += [f"{mark}: {path.name} has no {name}" for path, name in names if name not in functions_of(path)]
    return gaps


def test_pairs_marked_as_made_here_have_their_tests():
    """A mark in a table that no file of this folder reads would promise tests that nobody makes."""
    texts = [path.read_text("utf-8") for path in HERE.glob("test_*.py")]
    for title, table in TABLES.items():
        if any(cell.mark == MADE_HERE for cell in table.cells):
            assert any(f'"{title}"' in text for text in texts), title


def test_gaps_in_a_table_are_seen():
    """A note that names no test, and a mark without a note."""
    table = read_table("""Title
| | one | two |
|---|---|---|
| row | ● | a |

* **b**: `cli/test_cli.py::no_such_test`
""")
    assert find_gaps(table) == ["a has no note", "b is not used", "b: test_cli.py has no no_such_test"]


def test_every_implementation_has_its_row():
    table = TABLES["Families and implementations"]
    assert set(table.rows) == IMPLEMENTATIONS.keys() | {"JAX, grad", "symbols"}
    text = (HERE / "TABLE.md").read_text("utf-8")
    for kind, families in KINDS.items():
        assert f"`families_of_{'bodies' if kind == 'body' else 'tops'}.py` ({len(families)})" in text


def test_every_contributor_and_product_has_its_row():
    """What another package may add, and what polhode keeps; test_seals.py finds what is kept in the sources."""
    assert set(TABLES["Contributors and products"].rows) == set(GROUPS)
    assert set(TABLES["Guards and what is kept"].rows) == SEALED.keys()
